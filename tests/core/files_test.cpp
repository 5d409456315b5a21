#include "core/files.h"

#include <array>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/error.h"

namespace bodkin {
namespace {

namespace fs = std::filesystem;

class WriteFile : public ::testing::Test {
 protected:
  void TearDown() override { fs::remove_all(folder_); }
  static std::string content_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  fs::path folder_ = fs::temp_directory_path() / ("bodkin_files_" + std::to_string(getpid()));
};

TEST_F(WriteFile, makes_the_folders_and_replaces_what_was_there) {
  const fs::path file = folder_ / "a" / "b.txt";
  write_file(file, "one");
  EXPECT_EQ(content_of(file), "one");
  write_file(file, std::string("t\0o", 3));
  EXPECT_EQ(content_of(file), std::string("t\0o", 3));
  EXPECT_EQ(std::distance(fs::directory_iterator(file.parent_path()), {}), 1) << "nothing else lies beside it";
}

TEST_F(WriteFile, writes_pieces_one_after_another) {
  const fs::path file = folder_ / "pieces";
  write_file(file, std::array<std::string_view, 3>{"one", "", " and two"});
  EXPECT_EQ(content_of(file), "one and two");
}

TEST_F(WriteFile, says_which_file_cannot_be_written_and_leaves_nothing) {
  write_file(folder_ / "file", "x");
  for (const fs::path& impossible : {folder_ / "file" / "below", folder_}) {
    try {
      write_file(impossible, "y");
      FAIL() << impossible;
    } catch (const SystemError& error) {
      EXPECT_EQ(std::string(error.what()).find(impossible.string()), 0U) << error.what();
    }
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
  EXPECT_EQ(content_of(folder_ / "file"), "x");
}

}  // namespace
}  // namespace bodkin
