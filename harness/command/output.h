// Files that are there whole or not at all.
#ifndef PITBENCH_HARNESS_COMMAND_OUTPUT_H_
#define PITBENCH_HARNESS_COMMAND_OUTPUT_H_

#include <string>

namespace pitbench {

// A file that is written beside its place and then renamed to it. Opened
// before the work starts, so that a place that cannot be written to is known
// before minutes are spent; gone again if Commit is never called.
class OutputFile {
 public:
  // Throws InputError if nothing can be written there.
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  // Throws InputError if it cannot all be written.
  void Commit(const std::string& text);

 private:
  std::string path_;
  std::string temporary_;
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_COMMAND_OUTPUT_H_
