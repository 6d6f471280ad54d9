#include "harness/input/csv.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>

#include "harness/truth/decimal.h"

namespace pitbench {
namespace {

// Input as it may stand in a message: one short printable line.
std::string Quoted(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string shown = "\"";
  for (const char c : text.substr(0, kLongest)) {
    shown += c >= ' ' && c <= '~' ? c : '?';
  }
  return shown + (text.size() > kLongest ? "...\"" : "\"");
}

std::string Joined(std::span<const std::string_view> names) {
  std::string joined;
  for (const std::string_view name : names) {
    if (!joined.empty()) joined += ',';
    joined += name;
  }
  return joined;
}

// The lines of a file or a text, without their ends, counted from 1.
class Lines {
 public:
  explicit Lines(const std::string& path)
      : name_(path == "-" ? "standard input" : path),
        file_(path == "-" ? stdin : std::fopen(path.c_str(), "rb")) {
    if (file_ == nullptr) {
      throw InputError(name_ + ": cannot be opened: " + std::strerror(errno) +
                       "; check the path, or write - for standard input");
    }
  }
  // `text` is only read, though fmemopen does not say so.
  Lines(const std::string& name, std::string_view text)
      : name_(name),
        file_(fmemopen(const_cast<char*>(text.data()), text.size(), "r")) {
    if (file_ == nullptr) {
      throw InputError(name_ + ": cannot be read: " + std::strerror(errno));
    }
  }
  ~Lines() {
    std::free(buffer_);
    if (file_ != stdin) std::fclose(file_);
  }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  // The next line, or nothing at the end. It holds until the next call and is
  // followed by a byte that belongs to no number, as strtod needs.
  std::optional<std::string_view> Next() {
    const ssize_t length = getline(&buffer_, &capacity_, file_);
    if (length < 0) {
      if (std::feof(file_) == 0) {
        throw InputError(name_ + ": cannot be read: " + std::strerror(errno) +
                         "; give a text file");
      }
      return std::nullopt;
    }
    ++number_;
    std::string_view line(buffer_, static_cast<std::size_t>(length));
    if (line.ends_with('\n')) line.remove_suffix(1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  // An error about the line that Next gave last.
  [[noreturn]] void Fail(const std::string& what) const {
    throw InputError(name_ + ", line " + std::to_string(number_) + ": " + what);
  }

  [[noreturn]] void FailAsAWhole(const std::string& what) const {
    throw InputError(name_ + ": " + what);
  }

 private:
  std::string name_;
  std::FILE* file_;
  char* buffer_ = nullptr;
  std::size_t capacity_ = 0;
  std::size_t number_ = 0;
};

enum class Parsed { kNumber, kNotANumber, kOutOfRange };

// strtof for float and strtod for double: through the other type a decimal
// would be rounded twice.
float StringTo(const char* text, char** end, float /*type*/) {
  return std::strtof(text, end);
}
double StringTo(const char* text, char** end, double /*type*/) {
  return std::strtod(text, end);
}

// Parses all of `field`, which a byte that belongs to no number follows.
template <std::floating_point T>
Parsed Parse(std::string_view field, T* value) {
  // strtod would skip blanks, and over an empty field into the next line.
  if (field.empty() || field.front() == ' ' ||
      (field.front() >= '\t' && field.front() <= '\r')) {
    return Parsed::kNotANumber;
  }
  char* end = nullptr;
  errno = 0;
  *value = StringTo(field.data(), &end, T{});
  if (end != field.data() + field.size()) return Parsed::kNotANumber;
  // Subnormal results set ERANGE too, and are welcome.
  return errno == ERANGE && (*value == 0 || std::isinf(*value))
             ? Parsed::kOutOfRange
             : Parsed::kNumber;
}

Parsed Parse(std::string_view field, std::int32_t* value) {
  const char* last = field.data() + field.size();
  const auto [end, error] = std::from_chars(field.data(), last, *value);
  if (error == std::errc::invalid_argument || end != last) {
    return Parsed::kNotANumber;
  }
  return error == std::errc::result_out_of_range ? Parsed::kOutOfRange
                                                 : Parsed::kNumber;
}

Parsed Parse(std::string_view field, mpq_class* value) {
  std::optional<mpq_class> number = ParseExactly(field);
  if (!number) return Parsed::kNotANumber;
  *value = std::move(*number);
  return Parsed::kNumber;
}

Parsed Parse(std::string_view field, std::string* value) {
  *value = field;
  return Parsed::kNumber;
}

template <class T>
std::string_view WhatToWrite() {
  if constexpr (std::integral<T>) {
    return "write an integer from -2147483648 to 2147483647";
  } else if constexpr (std::same_as<T, mpq_class>) {
    return "write a decimal (0.1, 1e-3) or hexadecimal (0x1p-1) number with an "
           "exponent from -9999 to 9999";
  } else if constexpr (std::same_as<T, float>) {
    return "write a decimal (0.5) or hexadecimal (0x1p-1) number in the range "
           "of f32, nan or inf";
  } else {
    return "write a decimal (0.5) or hexadecimal (0x1p-1) number in the range "
           "of f64, nan or inf";
  }
}

void CheckHeader(Lines& lines, std::span<const std::string_view> header) {
  const std::string expected = Joined(header);
  std::optional<std::string_view> line = lines.Next();
  if (!line) {
    lines.FailAsAWhole("is empty; its first line must be \"" + expected + "\"");
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line->starts_with(kByteOrderMark)) {
    line->remove_prefix(kByteOrderMark.size());
  }
  if (*line != expected) {
    lines.Fail("the header is " + Quoted(*line) + "; it must be \"" + expected +
               "\"");
  }
}

// What is wrong with a field that is no number.
template <class T>
std::string Complaint(std::string_view field, Parsed parsed) {
  return Quoted(field) +
         (parsed == Parsed::kOutOfRange ? " is out of range; "
                                        : " is not a number; ") +
         std::string(WhatToWrite<T>());
}

template <class T>
void ReadRow(const Lines& lines, std::string_view line,
             std::span<const std::string_view> header, Table<T>& table) {
  std::string_view rest = line;
  for (std::size_t column = 0; column < header.size(); ++column) {
    const std::size_t comma = rest.find(',');
    const bool last = column + 1 == header.size();
    if (last != (comma == std::string_view::npos)) {
      const std::string count = std::to_string(header.size());
      if (last) {
        lines.Fail("there is more after field \"" +
                   std::string(header[column]) + "\", the last one; write " +
                   count + " fields a line");
      }
      lines.Fail("the line ends with field \"" + std::string(header[column]) +
                 "\", and \"" + std::string(header[column + 1]) +
                 "\" is missing; write " + count + " fields a line");
    }
    const std::string_view field = rest.substr(0, comma);
    T value{};
    const Parsed parsed = Parse(field, &value);
    if (parsed != Parsed::kNumber) {
      lines.Fail("field \"" + std::string(header[column]) +
                 "\": " + Complaint<T>(field, parsed));
    }
    table.columns[column].push_back(std::move(value));
    if (!last) rest.remove_prefix(comma + 1);
  }
  ++table.rows;
}

template <class T>
Table<T> ReadTable(Lines& lines, std::span<const std::string_view> header) {
  CheckHeader(lines, header);
  Table<T> table;
  table.columns.resize(header.size());
  bool blank = false;
  while (const std::optional<std::string_view> line = lines.Next()) {
    if (line->empty()) {
      blank = true;
      continue;
    }
    if (blank) lines.Fail("follows a blank line; remove the blank line");
    ReadRow(lines, *line, header, table);
  }
  return table;
}

}  // namespace

template <class T>
Table<T> ReadCsv(const std::string& path,
                 std::span<const std::string_view> header) {
  Lines lines(path);
  return ReadTable<T>(lines, header);
}

template <class T>
Table<T> ReadCsvText(const std::string& name, std::string_view text,
                     std::span<const std::string_view> header) {
  Lines lines(name, text);
  return ReadTable<T>(lines, header);
}

template <class T>
T ParseNumber(const std::string& field) {
  T value{};
  const Parsed parsed = Parse(field, &value);
  if (parsed != Parsed::kNumber) throw InputError(Complaint<T>(field, parsed));
  return value;
}

#define PITBENCH_INSTANTIATE(T)                                       \
  template Table<T> ReadCsv(const std::string&,                       \
                            std::span<const std::string_view>);       \
  template Table<T> ReadCsvText(const std::string&, std::string_view, \
                                std::span<const std::string_view>)
PITBENCH_INSTANTIATE(float);
PITBENCH_INSTANTIATE(double);
PITBENCH_INSTANTIATE(std::int32_t);
PITBENCH_INSTANTIATE(mpq_class);
PITBENCH_INSTANTIATE(std::string);
#undef PITBENCH_INSTANTIATE
template float ParseNumber(const std::string&);
template double ParseNumber(const std::string&);
template mpq_class ParseNumber(const std::string&);

}  // namespace pitbench
