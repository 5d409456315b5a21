#include "haptics/driver_folder.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace bodkin {

using namespace bodkin::haptics;
namespace {

namespace fs = std::filesystem;

class DriverFolder : public testing::Test {
 protected:
  DriverFolder() { fs::create_directories(folder_ / "a_folder.so"); }
  ~DriverFolder() override {
    unsetenv("BODKIN_DRIVERS");
    fs::remove_all(folder_);
  }
  const fs::path folder_ = fs::temp_directory_path() / ("bodkin_drivers_" + std::to_string(getpid()));
};

TEST_F(DriverFolder, holds_the_libraries_in_the_order_of_their_names) {
  setenv("BODKIN_DRIVERS", folder_.c_str(), 1);
  for (const char* name : {"b.so", "a.so", "c.so.1", "notes.txt"}) std::ofstream(folder_ / name) << "x";
  EXPECT_EQ(driver_folder(), folder_);
  EXPECT_THAT(driver_files(), testing::ElementsAre((folder_ / "a.so").string(), (folder_ / "b.so").string()));
}

TEST_F(DriverFolder, may_be_missing) {
  setenv("BODKIN_DRIVERS", "/no/such/folder", 1);
  EXPECT_TRUE(driver_files().empty());
}

TEST_F(DriverFolder, is_never_the_working_folder) {
  for (const char* named : {"", ".", "drivers", "~/drivers"}) {
    setenv("BODKIN_DRIVERS", named, 1);
    EXPECT_TRUE(driver_folder().is_absolute()) << named;
    EXPECT_THAT(driver_folder().string(), testing::EndsWith("/bodkin/drivers")) << named;
  }
}

}  // namespace
}  // namespace bodkin
