#include "harness/command/output.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "harness/input/csv.h"

namespace pitbench {
namespace {

[[noreturn]] void Fail(const std::string& path) {
  throw InputError("cannot write " + path + ": " + std::strerror(errno) +
                   "; give a file in a folder that exists and may be written "
                   "to");
}

}  // namespace

OutputFile::OutputFile(std::string path)
    : path_(std::move(path)),
      temporary_(path_ + ".tmp" + std::to_string(getpid())) {
  if (std::filesystem::is_directory(path_)) {
    errno = EISDIR;
    Fail(path_);
  }
  errno = 0;
  if (!std::ofstream(temporary_)) Fail(path_);
}

OutputFile::~OutputFile() { std::remove(temporary_.c_str()); }

void OutputFile::Commit(const std::string& text) {
  errno = 0;
  std::ofstream file(temporary_, std::ios::binary);
  file << text;
  file.close();
  if (!file) Fail(path_);
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) Fail(path_);
}

}  // namespace pitbench
