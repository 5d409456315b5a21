#include "core/mapped_file.h"

#include <cstring>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "core/files.h"

namespace bodkin {
namespace {

namespace fs = std::filesystem;

class MappedFiles : public ::testing::Test {
 protected:
  void TearDown() override { fs::remove_all(folder_); }
  static std::string text_of(const MappedFile& file) {
    return {reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()};
  }
  fs::path folder_ = fs::temp_directory_path() / ("bodkin_mapped_" + std::to_string(getpid()));
};

TEST_F(MappedFiles, are_what_was_written_also_when_they_are_replaced_meanwhile) {
  const fs::path file = folder_ / "a";
  write_file(file, "first");
  MappedFile first(file);
  write_file(file, "second, and longer");
  EXPECT_EQ(text_of(first), "first");
  fs::remove(file);
  MappedFile moved = std::move(first);
  EXPECT_EQ(text_of(moved), "first");
  write_file(file, "");
  first = MappedFile(file);
  EXPECT_TRUE(first.bytes().empty());
  std::swap(first, moved);
  EXPECT_EQ(text_of(first), "first");
}

TEST_F(MappedFiles, need_a_file) {
  fs::create_directories(folder_);
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  for (const fs::path& file : {folder_ / "none", folder_, folder_ / "pipe"}) {
    try {
      const MappedFile mapped(file);
      ADD_FAILURE() << file;
    } catch (const InputError& error) {
      EXPECT_NE(std::strstr(error.what(), file.c_str()), nullptr) << error.what();
    }
  }
}

}  // namespace
}  // namespace bodkin
