// Numbers exactly as written, and the two truths of the cases typed in
// decimals.
#include "harness/truth/decimal.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "harness/measure/two_truths.h"
#include "harness/scenes/corpus.h"

namespace pitbench {
namespace {

TEST(DecimalTest, NumbersAreWhatIsWritten) {
  EXPECT_EQ(ParseExactly("0.1"), mpq_class(1, 10));
  EXPECT_NE(ParseExactly("0.1"), mpq_class(0.1));
  EXPECT_EQ(ParseExactly("-12.50"), mpq_class(-25, 2));
  EXPECT_EQ(ParseExactly("+.5"), mpq_class(1, 2));
  EXPECT_EQ(ParseExactly("7."), 7);
  EXPECT_EQ(ParseExactly("1.5e3"), 1500);
  EXPECT_EQ(ParseExactly("15E-1"), mpq_class(3, 2));
  EXPECT_EQ(ParseExactly("1e+2"), 100);
  EXPECT_EQ(ParseExactly("-0.0"), 0);
  EXPECT_EQ(ParseExactly("008"), 8);  // not octal
  EXPECT_EQ(ParseExactly("0x1.8p-3"), mpq_class(3, 16));
  EXPECT_EQ(ParseExactly("-0XAp+1"), -20);
  EXPECT_EQ(ParseExactly("0x1.999999999999ap-4"), mpq_class(0.1));
  EXPECT_EQ(ParseExactly("1e9999"), mpq_class("1" + std::string(9999, '0')));
}

TEST(DecimalTest, AnythingElseIsNoNumber) {
  for (const char* text :
       {"",      "-",     ".",     "e5",      "1e",       "1e+",
        "1e+-5", "1e-+5", "+-1",   "--1",     " 1",       "1 ",
        "1,5",   "0x",    "0x.p1", "0xg",     "1p3",      "0x1e5p",
        "nan",   "inf",   "1f",    "1e10000", "1e-10000", "1e99999999999999",
        "1..5",  "1.5.2"}) {
    EXPECT_FALSE(ParseExactly(text).has_value()) << '"' << text << '"';
  }
}

TEST(TwoTruthsTest, AreWhatTheFileSays) {
  const nlohmann::json verdicts = TwoTruths();
  const std::vector<TypedCase> cases = TypedDecimals();
  ASSERT_EQ(verdicts.size(), cases.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_EQ(verdicts[i]["id"], cases[i].id);
    EXPECT_EQ(verdicts[i]["source"], cases[i].source);
    EXPECT_EQ(verdicts[i]["scalar"], cases[i].scalar);
    EXPECT_EQ(verdicts[i]["binary"], cases[i].truth) << cases[i].id;
    EXPECT_EQ(verdicts[i]["decimal"], cases[i].decimal_truth) << cases[i].id;
    if (cases[i].truth != cases[i].decimal_truth) ++different;
  }
  EXPECT_GE(different, 3u);
}

// Where a case is in both files, the decimals are those of the binary numbers.
TEST(TwoTruthsTest, DecimalsRoundToTheNumbersOfTheCorpus) {
  std::size_t in_both = 0;
  for (const TypedCase& typed : TypedDecimals()) {
    for (const CorpusCase& binary : RealWorldCorpus()) {
      if (binary.id != typed.id) continue;
      ++in_both;
      EXPECT_EQ(binary.source, typed.source);
      EXPECT_EQ(binary.truth, typed.truth);
      ASSERT_EQ(typed.scalar, "f64");
      for (std::size_t k = 0; k < 8; ++k) {
        EXPECT_EQ(binary.Number<double>(k), typed.Number<double>(k))
            << typed.id;
      }
    }
  }
  EXPECT_GE(in_both, 3u);
}

}  // namespace
}  // namespace pitbench
