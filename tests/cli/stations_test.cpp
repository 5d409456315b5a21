// bodkin stations: a teacher starts a procedure on a waiting station, and its result reaches the store.
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "link/station_watch.h"
#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include "tests/cli/serve_process.h"
#include <gmock/gmock.h>

namespace bodkin_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using StationsCommand = PatientCommand;

bool within_a_minute(const std::function<bool()>& is_so) {
  for (int i = 0; i < 3000 && !is_so(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  return is_so();
}

TEST_F(StationsCommand, a_teacher_starts_a_procedure_and_the_result_comes_to_the_store) {
  ServeProcess station(
      folder_,
      "serve . simulated --settings depth_mm=10 --max-time 3 --port 0 --wait --trainee t-01 --store r.sqlite");
  const std::string place = station.place();
  ASSERT_FALSE(place.empty()) << station.notes();
  const Outcome waits = bodkin("stations list --patience 20 " + place);
  EXPECT_EQ(waits.exit_code, 0) << waits.text();
  EXPECT_THAT(waits.output, HasSubstr("waits for a procedure"));
  for (const char* name : {"none", "../patient", "/etc"}) {
    const Outcome refused = bodkin("stations start --patience 20 --case '" + std::string(name) + "' " + place);
    EXPECT_EQ(refused.exit_code, 3) << refused.text();
    EXPECT_THAT(refused.output, HasSubstr("this station has no case")) << name;
  }
  EXPECT_EQ(bodkin("stations start --patience 20 " + place).exit_code, 3) << "the folder itself is no case";
  ServeProcess other(folder_,
                     "serve . simulated --settings depth_mm=10 --max-time 3 --port 0 --wait --trainee t-02 --store "
                     "r.sqlite -o other.bodkin",
                     "other.txt");
  const Outcome started = bodkin("stations start --patience 20 --case patient " + place + " " + other.place());
  EXPECT_EQ(started.exit_code, 0) << started.text();
  EXPECT_THAT(started.output, AllOf(HasSubstr(place), HasSubstr(other.place())));
  EXPECT_EQ(lines_of(started.output), 2);
  std::string list;
  const auto has_both = [&list] {
    return list.find("t-01") != std::string::npos && list.find("t-02") != std::string::npos;
  };
  for (int i = 0; i < 60 && !has_both(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    list = bodkin("-q results list --store r.sqlite").output;
  }
  EXPECT_TRUE(has_both()) << list << station.notes() << other.notes();
  EXPECT_EQ(other.end(), 0) << other.notes();
  EXPECT_TRUE(::bodkin::session::read_session(folder_ / "other.bodkin").finished);
  EXPECT_EQ(station.end(), 0) << station.notes();
  EXPECT_TRUE(::bodkin::session::read_session(folder_ / "session-by-hand.bodkin").finished);
}

// A client names the session's file, and its chosen case stays selected; no name leads out of the folder.
TEST_F(StationsCommand, a_client_names_the_session_and_chooses_the_case_for_all_starts) {
  using ::bodkin::link::StationWatch;
  ServeProcess station(folder_, "serve . simulated --settings depth_mm=10 --max-time 1 --port 0 --wait");
  const std::string place = station.place();
  ASSERT_FALSE(place.empty()) << station.notes();
  StationWatch watch(::bodkin::link::parse_server(place, "STATION"));
  const auto reply = [&](const std::string& name, const std::vector<std::pair<std::string, std::string>>& values) {
    EXPECT_TRUE(within_a_minute([&] { return watch.view().guard == "waiting"; })) << station.notes();
    watch.command(name, values);
    EXPECT_TRUE(within_a_minute([&] { return !watch.view().reply.empty(); }));
    return watch.view().reply;
  };
  EXPECT_EQ(reply("LoadCase", {{"Case", "patient"}}), "SUCCESS");
  for (const char* outside : {"../out", "/tmp/out", ".hidden", "-o"})
    EXPECT_THAT(reply("StartRecording", {{"OutputFilename", outside}}), HasSubstr("OutputFilename is")) << outside;
  for (const char* name : {"first", "second"}) {
    EXPECT_EQ(reply("StartRecording", {{"OutputFilename", name}}), "SUCCESS") << name;
    const std::filesystem::path file = folder_ / (std::string(name) + ".bodkin");
    EXPECT_TRUE(within_a_minute([&] {
      try {
        return ::bodkin::session::read_session(file).finished;
      } catch (const std::exception&) {
        return false;  // it is not there yet
      }
    })) << station.notes();
  }
  // All messages of a session have been sent when it waits again.
  EXPECT_TRUE(within_a_minute([&] { return watch.view().guard == "waiting"; })) << station.notes();
  EXPECT_EQ(station.end(), 0) << station.notes();
}

TEST_F(StationsCommand, a_client_changes_a_number_of_the_model_and_begins_again) {
  using ::bodkin::link::StationWatch;
  ServeProcess station(folder_, "serve patient simulated --settings 'depth_mm=10 wait_s=60' --port 0 -o s.bodkin");
  const std::string place = station.place();
  ASSERT_FALSE(place.empty()) << station.notes();
  StationWatch watch(::bodkin::link::parse_server(place, "STATION"));
  const auto does = [&](const std::string& name, const std::vector<std::pair<std::string, std::string>>& values) {
    watch.command(name, values);
    return within_a_minute([&] { return watch.view().reply == "SUCCESS"; });
  };
  ASSERT_TRUE(within_a_minute([&] { return watch.view().runs; })) << station.notes();
  ASSERT_TRUE(does("SetModelParameter", {{"Part", "compensation"}, {"Parameter", "weight_N"}, {"Value", "0.125"}}))
      << watch.view().reply;
  ASSERT_TRUE(does("Reset", {})) << watch.view().reply;
  ASSERT_TRUE(within_a_minute([&] { return std::filesystem::exists(folder_ / "s-2.bodkin") && watch.view().runs; }))
      << station.notes();
  ASSERT_TRUE(does("StopRecording", {})) << watch.view().reply;
  ASSERT_TRUE(within_a_minute([&] { return station.notes().find("messages sent") != std::string::npos; }))
      << station.notes();
  const ::bodkin::session::Session first = ::bodkin::session::read_session(folder_ / "s.bodkin");
  const ::bodkin::session::Session second = ::bodkin::session::read_session(folder_ / "s-2.bodkin");
  EXPECT_TRUE(first.finished);
  EXPECT_TRUE(second.finished);
  EXPECT_NE(first.header.haptics.compensation.weight, 0.125);
  EXPECT_EQ(second.header.haptics.compensation.weight, 0.125);
}

TEST_F(StationsCommand, a_station_that_is_not_there_is_told_in_one_sentence) {
  const Outcome lost = bodkin("stations list --patience 1 127.0.0.1:1");
  EXPECT_EQ(lost.exit_code, 3);
  EXPECT_THAT(lost.output, HasSubstr("no server answers at 127.0.0.1:1"));
  EXPECT_EQ(bodkin("stations start 127.0.0.1:0").exit_code, 2);
}

}  // namespace
}  // namespace bodkin_test
