#include <gmpxx.h>

#include <array>
#include <iostream>
#include <string>
#include <vector>

#include "harness/command/commands.h"
#include "harness/command/find_kernel.h"
#include "harness/input/csv.h"
#include "harness/measure/answers.h"

namespace pitbench {
namespace {

constexpr std::array<std::string_view, 8> kHeader = {"ax", "ay", "bx", "by",
                                                     "cx", "cy", "px", "py"};

template <class T>
Table<T> ReadCases(const std::string& path) {
  Table<T> table = ReadCsv<T>(path, kHeader);
  if (table.rows == 0) {
    throw InputError((path == "-" ? "standard input" : path) +
                     ": no cases after the header: give one case a line");
  }
  return table;
}

// T may be mpq_class too: the truth about the numbers as they are written.
template <class T>
std::string TruthOfRows(const std::string& path) {
  const Table<T> table = ReadCases<T>(path);
  const auto& c = table.columns;
  std::string words;
  for (std::size_t i = 0; i < table.rows; ++i) {
    const Triangle<T> triangle{
        {c[0][i], c[1][i]}, {c[2][i], c[3][i]}, {c[4][i], c[5][i]}};
    words.append(Name(Classify(triangle, Point<T>{c[6][i], c[7][i]})));
    words.push_back('\n');
  }
  return words;
}

template <class T>
std::string AnswersToRows(const Kernel& kernel, const std::string& path) {
  const Table<T> table = ReadCases<T>(path);
  const auto& c = table.columns;
  for (std::size_t i = 0; kernel.method.finite_only && i < table.rows; ++i) {
    const Triangle<T> triangle{
        {c[0][i], c[1][i]}, {c[2][i], c[3][i]}, {c[4][i], c[5][i]}};
    if (!IsFinite(triangle, Point<T>{c[6][i], c[7][i]})) {
      throw InputError(path + ": case " + std::to_string(i + 1) + ": method '" +
                       std::string(kernel.method.key) +
                       "' must not be asked about NaN and infinity");
    }
  }
  const Batch<T> batch{c[0].data(), c[1].data(), c[2].data(),
                       c[3].data(), c[4].data(), c[5].data(),
                       c[6].data(), c[7].data(), table.rows};
  std::vector<std::uint8_t> bits(BitBytes(table.rows));
  AskCases(kernel, batch, bits.data());
  std::string words;
  for (std::size_t i = 0; i < table.rows; ++i) {
    words.append((bits[i / 8] >> (i % 8) & 1) != 0 ? "inside\n" : "outside\n");
  }
  return words;
}

struct ClassifyArguments {
  std::string method;
  std::string isa;
  std::string scalar = "f64";
  std::string file;
  bool decimal = false;
};

std::string Words(const ClassifyArguments& a) {
  const Scalar scalar = FloatScalar(a.scalar);
  const bool f32 = scalar == Scalar::kF32;
  if (a.method == "truth") {
    if (!a.isa.empty()) {
      throw InputError(
          "--isa goes with a method, not with truth: leave it out");
    }
    if (a.decimal) return TruthOfRows<mpq_class>(a.file);
    return f32 ? TruthOfRows<float>(a.file) : TruthOfRows<double>(a.file);
  }
  if (a.decimal) {
    throw InputError(
        "--decimal goes with --method truth: methods compute with rounded "
        "numbers");
  }
  const Kernel& kernel = FindCaseKernel(a.method, scalar, a.isa, {"truth"});
  return f32 ? AnswersToRows<float>(kernel, a.file)
             : AnswersToRows<double>(kernel, a.file);
}

}  // namespace

void AddClassify(CLI::App& app) {
  const auto a = std::make_shared<ClassifyArguments>();
  CLI::App* classify = app.add_subcommand(
      "classify",
      "One word a line for each case of a CSV file with the header\n"
      "ax,ay,bx,by,cx,cy,px,py (decimal or hexadecimal floats): inside or\n"
      "outside, and for --method truth also boundary or degenerate");
  classify->add_option("--method", a->method, "a method, or truth")->required();
  classify->add_option("--isa", a->isa,
                       "an ISA; the widest that runs here unless given");
  classify->add_option("--scalar", a->scalar, "f32 or f64")
      ->capture_default_str();
  classify->add_flag("--decimal", a->decimal,
                     "with --method truth: the numbers exactly as they are "
                     "written, not rounded to a scalar");
  classify->add_option("FILE", a->file, "the cases; - for standard input")
      ->required();
  classify->callback([a] {
    // All words or none: a bad line is an error before the first is printed.
    std::cout << Words(*a) << std::flush;
    if (!std::cout) throw InputError("cannot write to standard output");
  });
}

}  // namespace pitbench
