// Output files are there whole or not at all.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "harness/command/output.h"
#include "harness/input/csv.h"

namespace pitbench {
namespace {

class OutputFileTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("pitbench_output_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string Path() const { return folder_ / "run.json"; }
  std::ptrdiff_t FilesInFolder() const {
    return std::distance(std::filesystem::directory_iterator(folder_), {});
  }
  std::string Content() const {
    std::ifstream file(Path());
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::filesystem::path folder_;
};

TEST_F(OutputFileTest, NothingIsLeftBehindWithoutCommit) {
  { const OutputFile file(Path()); }
  EXPECT_EQ(FilesInFolder(), 0);
}

TEST_F(OutputFileTest, TheOldFileStaysUntilTheNewOneIsWhole) {
  std::ofstream(Path()) << "old";
  OutputFile file(Path());
  EXPECT_EQ(Content(), "old");
  file.Commit("new");
  EXPECT_EQ(Content(), "new");
}

TEST_F(OutputFileTest, CommitLeavesOneFile) {
  {
    OutputFile file(Path());
    file.Commit(std::string(1 << 20, 'x'));
  }
  EXPECT_EQ(FilesInFolder(), 1);
  EXPECT_EQ(Content().size(), std::size_t{1} << 20);
}

TEST_F(OutputFileTest, PlaceThatCannotBeWrittenIsNamedAtOnce) {
  const std::string missing = folder_ / "missing" / "run.json";
  const std::string folder = folder_;
  for (const std::string& path : {missing, folder}) {
    try {
      const OutputFile file(path);
      ADD_FAILURE() << "no error for " << path;
    } catch (const InputError& error) {
      EXPECT_TRUE(
          std::string(error.what()).starts_with("cannot write " + path + ": "))
          << error.what();
    }
  }
  EXPECT_EQ(FilesInFolder(), 0);
}

}  // namespace
}  // namespace pitbench
