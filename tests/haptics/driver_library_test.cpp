#include "haptics/driver_library.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "haptics/bodkin_driver.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

const std::string plug_ins = std::string(BODKIN_MOCKS) + "/plug_in";

LibraryPlaces places(std::vector<std::string> where) {
  return {
      .product = "Example", .chosen = "", .places = std::move(where), .advice = "install it", .share_symbols = false};
}

std::string refusal(const LibraryPlaces& where, bool absent) {
  try {
    const DriverLibrary library(where);
  } catch (const LibraryError& error) {
    EXPECT_EQ(error.absent(), absent) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "the library was loaded";
  return {};
}

class ScratchFolder {
 public:
  ScratchFolder() : path_(fs::temp_directory_path() / ("bodkin_library_" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~ScratchFolder() { fs::remove_all(path_); }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

TEST(DriverLibrary, is_the_first_that_is_there) {
  const DriverLibrary library(places({"libbodkin_nowhere.so", "/nowhere/at_all.so", plug_ins + "/no_entry.so"}));
  EXPECT_EQ(library.path(), plug_ins + "/no_entry.so");
}

TEST(DriverLibrary, names_every_place_when_there_is_none) {
  EXPECT_THAT(
      refusal(places({"libbodkin_nowhere.so", "/nowhere/at_all.so"}), true),
      AllOf(HasSubstr("Example"), HasSubstr("libbodkin_nowhere.so, /nowhere/at_all.so"), HasSubstr("install it")));
}

TEST(DriverLibrary, that_the_user_chose_is_the_only_one_looked_for) {
  LibraryPlaces where = places({plug_ins + "/no_entry.so"});
  where.chosen = "/nowhere/chosen.so";
  EXPECT_THAT(refusal(where, true), HasSubstr("/nowhere/chosen.so"));
}

TEST(DriverLibrary, is_found_below_an_environment_variable_unless_that_is_relative) {
  setenv("BODKIN_TEST_PLACE", BODKIN_MOCKS, 1);
  EXPECT_EQ(DriverLibrary(places({"$BODKIN_TEST_PLACE/plug_in/no_entry.so"})).path(), plug_ins + "/no_entry.so");
  setenv("BODKIN_TEST_PLACE", ".", 1);
  EXPECT_THAT(refusal(places({"$BODKIN_TEST_PLACE/plug_in/no_entry.so", "libbodkin_nowhere.so"}), true),
              testing::Not(HasSubstr("no_entry")));
  unsetenv("BODKIN_TEST_PLACE");
}

TEST(DriverLibrary, is_the_newest_of_its_versions) {
  const ScratchFolder scratch;
  for (const char* version : {"3.9.1", "3.16.0", "3.2"}) {
    fs::copy_file(plug_ins + "/no_entry.so", scratch / ("libversions.so." + std::string(version)));
  }
  EXPECT_EQ(DriverLibrary(places({scratch / "libversions.so.*"})).path(), scratch / "libversions.so.3.16.0");
}

TEST(DriverLibrary, that_is_damaged_is_told_in_the_systems_words) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "damaged.so") << "this is no library";
  EXPECT_THAT(refusal(places({scratch / "damaged.so", "libbodkin_nowhere.so"}), false),
              AllOf(HasSubstr("damaged.so"), HasSubstr("does not load")));
}

TEST(DriverLibrary, names_itself_and_the_symbol_that_it_lacks) {
  const DriverLibrary library(places({plug_ins + "/no_entry.so"}));
  int (*present)() = nullptr;
  library.need(present, "nothing_of_interest");
  EXPECT_EQ(present(), 0);
  int (*missing)() = present;
  library.take(missing, "something_else");
  EXPECT_EQ(missing, nullptr);
  try {
    library.need(missing, "something_else");
    FAIL();
  } catch (const LibraryError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("something_else"), HasSubstr(plug_ins + "/no_entry.so")));
    EXPECT_FALSE(error.absent());
  }
}

TEST(DriverLibrary, can_be_unloaded_and_loaded_again) {
  for (int round = 0; round < 3; ++round) {
    DriverLibrary library(places({plug_ins + "/no_entry.so"}));
    library.unload();
  }
}

}  // namespace
}  // namespace bodkin
