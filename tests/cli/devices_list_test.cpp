#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string list_vendor = "--settings library=" BODKIN_MOCKS "/force_dimension/libdrd.so";
const std::string plug_in = BODKIN_MOCKS "/plug_in/example_driver.so";

using DevicesListCommand = BodkinCommand;

TEST_F(DevicesListCommand, says_of_every_driver_what_it_finds_or_lacks) {
  const Outcome outcome = bodkin("devices list");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text();
  for (const char* driver :
       {"openhaptics", "force_dimension", "haption", "haply", "spacemouse", "simulated", "recorded"}) {
    EXPECT_THAT(outcome.output, HasSubstr(driver));
  }
  const json found = json::parse(bodkin("devices list --json -q").output);
  EXPECT_GE(found.size(), 7u);
  for (const json& driver : found) {
    EXPECT_TRUE(driver.contains("fault") || driver.contains("devices")) << driver;
    if (driver.contains("fault")) {
      EXPECT_FALSE(driver.at("sentence").get<std::string>().empty()) << driver;
    }
  }
}

TEST_F(DevicesListCommand, finds_the_devices_of_one_driver) {
  const json found = json::parse(bodkin("devices list --json -q --driver force_dimension " + list_vendor).output);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_FALSE(found[0].at("devices").empty()) << found;
  const auto device = found[0].at("devices")[0].at("device").get<std::string>();
  EXPECT_EQ(device.rfind("force_dimension:", 0), 0u) << device;
}

TEST_F(DevicesListCommand, takes_a_driver_of_ones_own) {
  const json found = json::parse(bodkin("devices list --json -q --driver " + plug_in).output);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].at("devices").empty()) << found;
}

// A folder of drivers, copies of those built by the tests, while this lives.
class DriverFolder {
 public:
  explicit DriverFolder(const std::vector<std::pair<std::string, std::string>>& copies) {
    std::filesystem::create_directories(folder_);
    for (const auto& [from, to] : copies) {
      std::filesystem::copy_file(BODKIN_MOCKS "/plug_in/" + from + ".so", folder_ / (to + ".so"));
    }
    setenv("BODKIN_DRIVERS", folder_.c_str(), 1);
  }
  ~DriverFolder() {
    unsetenv("BODKIN_DRIVERS");
    std::filesystem::remove_all(folder_);
  }
  DriverFolder(const DriverFolder&) = delete;
  DriverFolder& operator=(const DriverFolder&) = delete;
  std::string file(const std::string& name) const { return (folder_ / (name + ".so")).string(); }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("bodkin_drivers_" + std::to_string(getpid()));
};

const json* answer_of(const json& list, const std::string& file) {
  for (const json& driver : list) {
    if (driver.value("file", "") == file) return &driver;
  }
  ADD_FAILURE() << file << " is not in the list";
  static const json nothing = {{"devices", {{{"device", ""}}}}, {"sentence", ""}, {"ambiguous", {""}}};
  return &nothing;
}

TEST_F(DevicesListCommand, finds_drivers_in_the_folder_and_outlives_those_that_break) {
  const DriverFolder drivers({{"example_driver", "good"},
                              {"crashes", "crashes"},
                              {"exits", "exits"},
                              {"hangs", "hangs"},
                              {"no_entry", "no_entry"}});
  const Outcome outcome = bodkin("devices list --json -q");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const json list = json::parse(outcome.output);
  EXPECT_EQ(answer_of(list, drivers.file("good"))->at("devices")[0].at("device"), "example:0");
  const auto sentence = [&](const std::string& name) {
    return answer_of(list, drivers.file(name))->at("sentence").get<std::string>();
  };
  EXPECT_THAT(sentence("crashes"),
              AllOf(HasSubstr(drivers.file("crashes")), HasSubstr("crashed"), HasSubstr("remove")));
  EXPECT_THAT(sentence("exits"), AllOf(HasSubstr(drivers.file("exits")), HasSubstr("exit code 7")));
  EXPECT_THAT(sentence("hangs"), AllOf(HasSubstr(drivers.file("hangs")), HasSubstr("has not answered within")));
  EXPECT_THAT(sentence("no_entry"), HasSubstr("bodkin_driver_entry"));
}

TEST_F(DevicesListCommand, drivers_in_the_folder_are_called_by_their_names) {
  const DriverFolder drivers({{"crashes", "a"}, {"example_driver", "b"}});
  const json found = json::parse(bodkin("devices list --json -q --driver example").output);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].at("file"), drivers.file("b"));
  const Outcome checked = bodkin("devices check example:0 --seconds 0.5 --json -q");
  EXPECT_TRUE(checked.exit_code == 0 || checked.exit_code == 3) << checked.text();
  EXPECT_EQ(json::parse(checked.output).at("name"), "Example");
  const Outcome unknown = bodkin("devices check exemple");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("recorded, example, or the path"));
}

TEST_F(DevicesListCommand, two_drivers_of_one_name_are_told_apart_by_their_paths) {
  const DriverFolder drivers({{"example_driver", "one"}, {"example_driver", "two"}});
  const json list = json::parse(bodkin("devices list --json -q").output);
  const json& one = *answer_of(list, drivers.file("one"));
  EXPECT_THAT(one.at("ambiguous")[0].get<std::string>(),
              AllOf(HasSubstr(drivers.file("two") + " has the same name"), HasSubstr("say " + drivers.file("one"))));
  EXPECT_EQ(one.at("devices")[0].at("device"), drivers.file("one") + ":0");
  const Outcome outcome = bodkin("devices check example");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr("2 drivers are called 'example'"), HasSubstr(drivers.file("two"))));
  EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
}

TEST_F(DevicesListCommand, two_devices_of_one_identity_are_told) {
  const json found = json::parse(bodkin("devices list --json -q --driver " BODKIN_MOCKS "/plug_in/twins.so").output);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].at("devices").size(), 2u);
  EXPECT_THAT(found[0].at("ambiguous")[0].get<std::string>(), HasSubstr("two devices have the identity '7': unplug"));
}

TEST_F(DevicesListCommand, of_one_driver_that_breaks_is_one_sentence) {
  const Outcome outcome = bodkin("devices list --driver " BODKIN_MOCKS "/plug_in/crashes.so");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("crashed"));
  EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
  EXPECT_EQ(bodkin("devices list --driver haply --settings colour=red").exit_code, 2);
}

}  // namespace
}  // namespace bodkin_test
