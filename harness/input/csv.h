// Tables from CSV: for the command line, and the cases built into the program.
//
// A file is a header line and then one row a line, fields parted by commas,
// without quotes or blanks. Line ends may be LF or CRLF, the last one may be
// missing or followed by blank lines, and a UTF-8 byte order mark is skipped.
#ifndef PITBENCH_HARNESS_INPUT_CSV_H_
#define PITBENCH_HARNESS_INPUT_CSV_H_

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pitbench {

// What was wrong, where (file, line, field) and what to do about it.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

template <class T>
struct Table {
  std::vector<std::vector<T>> columns;  // as many as the header has names
  std::size_t rows = 0;                 // the size of every column
};

// Reads the table whose header is exactly `header` (not empty) from the file
// at `path`, or from standard input if that is "-". T is float, double,
// std::int32_t or one of those below.
//
// A float or double is written in decimal or hexadecimal (0x1.8p-3), or "nan",
// "inf", "-inf", and is rounded once, to T. A number that would round to an
// infinity or, without being 0, to 0 is out of range.
//
// T may also be mpq_class: then numbers are taken exactly as they are written,
// and there is no nan or inf; or std::string: fields as they stand.
//
// Throws InputError. A file without rows is no error.
template <class T>
Table<T> ReadCsv(const std::string& path,
                 std::span<const std::string_view> header);

// The same from text in memory, which errors call `name`.
template <class T>
Table<T> ReadCsvText(const std::string& name, std::string_view text,
                     std::span<const std::string_view> header);

// A number as it stands in a field. Throws InputError. T is one of the above
// but std::string.
template <class T>
T ParseNumber(const std::string& field);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_INPUT_CSV_H_
