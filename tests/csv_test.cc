// Reading CSV: what is accepted, to the last bit, and what each error says.
#include "harness/input/csv.h"

#include <gmpxx.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace pitbench {
namespace {

constexpr std::array<std::string_view, 3> kHeader = {"ax", "ay", "bx"};

void ExpectParts(const std::string& text,
                 std::initializer_list<std::string_view> parts) {
  for (const std::string_view part : parts) {
    EXPECT_NE(text.find(part), std::string::npos)
        << "no " << part << " in: " << text;
  }
}

class CsvTest : public testing::Test {
 protected:
  void SetUp() override {
    path_ = testing::TempDir() + "pitbench_csv_" + std::to_string(getpid());
  }
  void TearDown() override { std::filesystem::remove(path_); }

  std::string Written(const std::string& text) {
    std::ofstream(path_, std::ios::binary) << text;
    return path_;
  }
  template <class T>
  Table<T> Read(const std::string& text) {
    return ReadCsv<T>(Written(text), kHeader);
  }
  // What the error says, without the path at its beginning.
  template <class T = double>
  std::string Error(const std::string& text) {
    try {
      Read<T>(text);
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with(path_)) << message;
      return message.substr(std::min(path_.size(), message.size()));
    }
    return "no error";
  }

  std::string path_;
};

TEST_F(CsvTest, ColumnsAreInTheOrderOfTheHeader) {
  const Table<double> table = Read<double>("ax,ay,bx\n1,2,3\n4,5,6\n");
  EXPECT_EQ(table.rows, 2u);
  ASSERT_EQ(table.columns.size(), 3u);
  EXPECT_EQ(table.columns[0], (std::vector<double>{1, 4}));
  EXPECT_EQ(table.columns[1], (std::vector<double>{2, 5}));
  EXPECT_EQ(table.columns[2], (std::vector<double>{3, 6}));
}

TEST_F(CsvTest, DecimalAndHexadecimalFloatsAreExact) {
  const Table<double> table =
      Read<double>("ax,ay,bx\n0.1,-0x1.8p-1074,1e-320\n-0,+.5,1.E2\n");
  EXPECT_EQ(table.columns[0], (std::vector<double>{0x1.999999999999ap-4, 0}));
  EXPECT_TRUE(std::signbit(table.columns[0][1]));
  EXPECT_EQ(table.columns[1], (std::vector<double>{-0x1p-1073, 0.5}));
  EXPECT_EQ(table.columns[2], (std::vector<double>{1e-320, 100}));
}

// 1 + 2^-24 + 2^-60 lies above the middle of two floats; rounded to double
// first, it becomes the middle and then, to even, 1.
TEST_F(CsvTest, FloatsAreRoundedOnceAndNotByWayOfDouble) {
  const Table<float> table = Read<float>(
      "ax,ay,bx\n0x1.000001000000001p0,1.00000005960464477540,16777217\n");
  EXPECT_EQ(table.columns[0][0], 0x1.000002p0f);
  EXPECT_EQ(table.columns[1][0], 0x1.000002p0f);
  EXPECT_EQ(table.columns[2][0], 16777216.0f);
}

TEST_F(CsvTest, NanAndInfinityAreNumbers) {
  const Table<float> table = Read<float>("ax,ay,bx\nnan,inf,-inf\n");
  EXPECT_TRUE(std::isnan(table.columns[0][0]));
  EXPECT_EQ(table.columns[1][0], std::numeric_limits<float>::infinity());
  EXPECT_EQ(table.columns[2][0], -std::numeric_limits<float>::infinity());
}

TEST_F(CsvTest, IntegersReachBothEnds) {
  const Table<std::int32_t> table =
      Read<std::int32_t>("ax,ay,bx\n-2147483648,2147483647,0\n");
  EXPECT_EQ(table.columns[0][0], std::numeric_limits<std::int32_t>::min());
  EXPECT_EQ(table.columns[1][0], std::numeric_limits<std::int32_t>::max());
}

TEST_F(CsvTest, LineEndsMayBeCrlfMissingOrFollowedByBlankLines) {
  for (const char* text :
       {"ax,ay,bx\r\n1,2,3\r\n", "ax,ay,bx\n1,2,3", "ax,ay,bx\r\n1,2,3",
        "ax,ay,bx\n1,2,3\n\n", "ax,ay,bx\r\n1,2,3\r\n\r\n\r\n",
        "\xEF\xBB\xBF"
        "ax,ay,bx\n1,2,3\n"}) {
    const Table<double> table = Read<double>(text);
    EXPECT_EQ(table.rows, 1u) << text;
    EXPECT_EQ(table.columns[2], (std::vector<double>{3})) << text;
  }
}

TEST_F(CsvTest, HeaderAloneIsATableWithoutRows) {
  const Table<float> table = Read<float>("ax,ay,bx\n");
  EXPECT_EQ(table.rows, 0u);
  EXPECT_EQ(table.columns.size(), 3u);
}

TEST_F(CsvTest, EmptyFileSaysWhichHeaderItWants) {
  EXPECT_EQ(Error(""), ": is empty; its first line must be \"ax,ay,bx\"");
}

TEST_F(CsvTest, WrongHeaderIsShownBesideTheRightOne) {
  for (const char* header : {"ax,ay", "ax,ay,bx,by", "ax,ay,by", "1,2,3", ""}) {
    EXPECT_EQ(Error(header + std::string("\n1,2,3\n")),
              ", line 1: the header is \"" + std::string(header) +
                  "\"; it must be \"ax,ay,bx\"");
  }
}

TEST_F(CsvTest, BinaryFileIsShownShortAndPrintable) {
  const std::string error = Error(std::string(5000, '\x01'));
  ExpectParts(error, {"\"" + std::string(60, '?') + "...\""});
}

TEST_F(CsvTest, TruncatedRowNamesTheFieldThatIsMissing) {
  EXPECT_EQ(Error("ax,ay,bx\n1,2,3\n4,5"),
            ", line 3: the line ends with field \"ay\", and \"bx\" is missing; "
            "write 3 fields a line");
  ExpectParts(Error("ax,ay,bx\n1,2,3\n4,5,"), {"line 3", "field \"bx\": \"\""});
}

TEST_F(CsvTest, TooManyFieldsAreAnError) {
  EXPECT_EQ(Error("ax,ay,bx\n1,2,3,4\n"),
            ", line 2: there is more after field \"bx\", the last one; write 3 "
            "fields a line");
  ExpectParts(Error("ax,ay,bx\n1,2,3,\n"), {"there is more"});
}

TEST_F(CsvTest, WhatIsNotANumberIsNamedWithLineAndField) {
  EXPECT_EQ(Error("ax,ay,bx\n1,2,3\n1,zwei,3\n"),
            ", line 3: field \"ay\": \"zwei\" is not a number; write a decimal "
            "(0.5) or hexadecimal (0x1p-1) number in the range of f64, nan or "
            "inf");
  for (const char* field : {"", " 1", "1 ", "1x", "0x", "1e", "--1", "\t1",
                            "\"1\"", "1;2", "-", "."}) {
    for (const std::string& row :
         {field + std::string(",2,3"), std::string("1,2,") + field}) {
      ExpectParts(Error("ax,ay,bx\n" + row + "\n7,8,9\n"),
                  {"line 2", "is not a number"});
    }
  }
  ExpectParts(Error(std::string("ax,ay,bx\n1\0,2,3\n", 17)),
              {"\"1?\" is not a number"});
}

TEST_F(CsvTest, WhatTheTypeCannotHoldIsOutOfRange) {
  const std::string out = "is out of range";
  ExpectParts(Error("ax,ay,bx\n1e400,2,3\n"), {out});
  ExpectParts(Error("ax,ay,bx\n-0x1p1024,2,3\n"), {out});
  ExpectParts(Error("ax,ay,bx\n1e-400,2,3\n"), {out});
  ExpectParts(Error<float>("ax,ay,bx\n1e39,2,3\n"), {out});
  ExpectParts(Error<std::int32_t>("ax,ay,bx\n2147483648,2,3\n"), {out});
  ExpectParts(Error<std::int32_t>("ax,ay,bx\n1.0,2,3\n"),
              {"is not a number; write an integer"});
}

TEST_F(CsvTest, BlankLineBetweenRowsIsAnError) {
  ExpectParts(Error("ax,ay,bx\n1,2,3\n\n4,5,6\n"), {"line 4", "blank line"});
}

TEST_F(CsvTest, MissingFileAndFolderAreNamed) {
  const auto error = [](const std::string& path) -> std::string {
    try {
      ReadCsv<double>(path, kHeader);
    } catch (const InputError& e) {
      return e.what();
    }
    return "no error";
  };
  EXPECT_EQ(error("/nowhere/at/all.csv"),
            "/nowhere/at/all.csv: cannot be opened: No such file or directory; "
            "check the path, or write - for standard input");
  ExpectParts(error(testing::TempDir()), {"cannot be read"});
}

TEST_F(CsvTest, DashIsStandardInput) {
  const int kept = dup(STDIN_FILENO);
  ASSERT_NE(
      std::freopen(Written("ax,ay,bx\n1,2,3\n1,2,x\n").c_str(), "rb", stdin),
      nullptr);
  try {
    ReadCsv<double>("-", kHeader);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string_view(error.what())
                    .starts_with("standard input, line 3: field \"bx\""));
  }
  dup2(kept, STDIN_FILENO);
  close(kept);
}

TEST_F(CsvTest, TextInMemoryIsReadLikeAFile) {
  const auto table = ReadCsvText<double>(
      "cases.csv", "ax,ay,bx\r\n1,2,3\n4,0x1p-1,6", kHeader);
  ASSERT_EQ(table.rows, 2u);
  EXPECT_EQ(table.columns[1][1], 0.5);
  try {
    ReadCsvText<double>("cases.csv", "ax,ay,bx\n1,2", kHeader);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string_view(error.what())
                    .starts_with("cases.csv, line 2: the line ends with"));
  }
}

TEST_F(CsvTest, ExactNumbersAreNotRounded) {
  const auto table = Read<mpq_class>("ax,ay,bx\n0.1,0x1p-1,1e3\n");
  EXPECT_EQ(table.columns[0][0], mpq_class(1, 10));
  EXPECT_EQ(table.columns[1][0], mpq_class(1, 2));
  EXPECT_EQ(table.columns[2][0], 1000);
  ExpectParts(Error<mpq_class>("ax,ay,bx\n1,nan,3\n"),
              {"line 2", "\"ay\"", "\"nan\" is not a number"});
}

TEST_F(CsvTest, TextFieldsStandAsTheyAre) {
  const auto table = Read<std::string>("ax,ay,bx\n a b ,,0.10\n");
  EXPECT_EQ(table.columns[0][0], " a b ");
  EXPECT_EQ(table.columns[1][0], "");
  EXPECT_EQ(ParseNumber<float>(table.columns[2][0]), 0.1f);
  EXPECT_EQ(ParseNumber<mpq_class>(table.columns[2][0]), mpq_class(1, 10));
  EXPECT_THROW(ParseNumber<double>(table.columns[0][0]), InputError);
  EXPECT_THROW(ParseNumber<double>("1e999"), InputError);
}

TEST_F(CsvTest, AMillionLinesAreRead) {
  std::string text = "ax,ay,bx\n";
  for (int i = 0; i < 1'000'000; ++i) {
    text += std::to_string(i) + ",0.1,-0x1.8p3\n";
  }
  const Table<float> table = Read<float>(text);
  ASSERT_EQ(table.rows, 1'000'000u);
  EXPECT_EQ(table.columns[0].back(), 999'999.0f);
  EXPECT_EQ(table.columns[1].back(), 0.1f);
  EXPECT_EQ(table.columns[2].back(), -12.0f);
}

}  // namespace
}  // namespace pitbench
