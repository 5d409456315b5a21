#include <chrono>
#include <thread>

#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <signal.h>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;
using RunCommand = PatientCommand;

TEST_F(RunCommand, of_the_expert_reaches_the_fluid_and_leaves_a_session) {
  const Outcome run = bodkin("--json run patient --seed 5");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto json = nlohmann::json::parse(run.output);
  EXPECT_TRUE(json["reached"].get<bool>());
  EXPECT_TRUE(json["operator_finished"].get<bool>());
  EXPECT_EQ(json["bone_contacts"], 0);
  EXPECT_GT(json["speed_factor"].get<double>(), 1.0);
  const std::filesystem::path file = json["session"].get<std::string>();
  EXPECT_EQ(file.parent_path(), std::filesystem::canonical(folder_));
  const bodkin::session::Session session = bodkin::session::read_session(file);
  EXPECT_TRUE(session.finished);
  EXPECT_EQ(session.header.seed, 5u);
  EXPECT_EQ(session.header.operator_name, "expert");
  EXPECT_NEAR(json["time_s"].get<double>(), static_cast<double>(session.ticks.size()) * session.header.dt, 1e-9);
  EXPECT_EQ(nlohmann::json::parse(session.header.operator_settings)["name"], "expert");
}

TEST_F(RunCommand, says_on_one_screen_what_happened) {
  const Outcome run = bodkin("--quiet run patient --output shown.bodkin");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  for (const char* part : {"times real time", "peak force", "bone contacts", "layered, line_spring",
                           "ligamentum flavum", "shown.bodkin"}) {
    EXPECT_THAT(run.output, HasSubstr(part));
  }
  EXPECT_LT(std::count(run.output.begin(), run.output.end(), '\n'), 60);
}

TEST_F(RunCommand, does_not_overwrite_unless_asked_and_numbers_its_own_names) {
  ASSERT_EQ(bodkin("run patient --output once.bodkin --max-time 1").exit_code, 0);
  const Outcome again = bodkin("run patient --output once.bodkin --max-time 1");
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.errors, HasSubstr("exists already"));
  EXPECT_EQ(bodkin("run patient --output once.bodkin --max-time 1 --overwrite").exit_code, 0);
  const auto name = [](const Outcome& run) {
    return std::filesystem::path(nlohmann::json::parse(run.output)["session"].get<std::string>()).filename().string();
  };
  const std::string first = name(bodkin("--json run patient --seed 77 --max-time 1"));
  const std::string second = name(bodkin("--json run patient --seed 77 --max-time 1"));
  EXPECT_THAT(first, HasSubstr("expert-77.bodkin"));
  EXPECT_THAT(second, HasSubstr("expert-77-2.bodkin"));
}

TEST_F(RunCommand, of_a_biopsy_is_the_expert_s_who_follows_a_plan_and_ends_at_the_lesion) {
  ASSERT_EQ(bodkin("-q case synthesize lumbar lesion --spacing 2 --lesion 20 --procedure ct_guided_biopsy --target "
                   "lesion --needle 18,150,chiba")
                .exit_code,
            0);
  const Outcome run = bodkin("--json run lesion --seed 3 --output lesion.bodkin");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.errors, HasSubstr("the tip touched the lesion"));
  EXPECT_THAT(run.errors, HasSubstr("the attempt is complete"));
  const auto json = nlohmann::json::parse(run.output);
  EXPECT_EQ(json.at("operator"), "expert_to_target");
  EXPECT_TRUE(json.at("reached").get<bool>());
  const bodkin::session::Session session = bodkin::session::read_session(folder_ / "lesion.bodkin");
  EXPECT_TRUE(session.finished);
  EXPECT_NEAR(session.ticks.back().output.depth, json.at("completed_at_mm").get<double>(), 1e-9);
  const auto mass = std::find_if(session.header.tissues.begin(), session.header.tissues.end(),
                                 [](const auto& each) { return each.name == "mass"; });
  ASSERT_NE(mass, session.header.tissues.end());
  const auto in_lesion = std::count_if(session.ticks.begin(), session.ticks.end(),
                                       [&](const auto& tick) { return tick.output.tissue == mass->id; });
  EXPECT_EQ(in_lesion, 1);
}

TEST_F(RunCommand, ends_at_the_longest_time) {
  const Outcome run = bodkin("--json run patient --max-time 2 --output short.bodkin");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto json = nlohmann::json::parse(run.output);
  EXPECT_FALSE(json["operator_finished"].get<bool>());
  EXPECT_NEAR(json["time_s"].get<double>(), 2.0, 1e-9);
}

TEST_F(RunCommand, refuses_bad_arguments_in_one_sentence) {
  const auto refused = [](const std::string& arguments, const std::string& part) {
    const Outcome run = bodkin("--quiet run " + arguments + " --output refused.bodkin");
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_THAT(run.errors, HasSubstr(part));
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "refused.bodkin")) << arguments;
  };
  refused("patient --operator nobody",
          "expected 'expert', 'expert_acupuncture', 'expert_epidural', 'expert_lumbar_puncture', 'expert_to_target', "
          "'novice' or the name");
  refused("patient --max-time 0", "--max-time is '0'; expected a number from 1 to 3600");
  refused("patient --max-time nan", "--max-time is 'nan'; expected");
  refused("patient --seed -1", "--seed is '-1'; expected a whole number from 0");
  refused("patient --entry 1,2", "--entry is '1,2'");
  refused("patient --entry 1,2,3 --target 1,2,3", "same point");
  refused("patient --resistance 'layered layer_mm=9'",
          "--resistance: layered layer_mm is '9', expected a number from");
  refused("patient --constraint 'none x=1'", "--constraint: <none> has the unknown attribute 'x'; it takes none");
  refused("patient --part relaxation", "relaxation does not go with layered");
  refused("nowhere", "nowhere");
  std::ofstream(folder_ / "bad.xml") << "<operator name=\"x\" version=\"1\"><hands/></operator>";
  refused("patient --operator bad.xml", "bad.xml, line 1");
}

TEST_F(RunCommand, on_the_clock_survives_a_kill_with_all_but_the_last_second) {
  const std::string command = "cd '" + folder_.string() +
                              "' && exec '" BODKIN_BUILD
                              "/bin/bodkin' --quiet run patient --realtime --output killed.bodkin > /dev/null 2>&1";
  const std::filesystem::path file = folder_ / "killed.bodkin";
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(120);
  std::size_t seen = 0;
  while (seen < 500 && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    try {
      seen = bodkin::session::read_session(file).ticks.size();
    } catch (const std::exception&) {
      // not yet there
    }
  }
  ASSERT_GE(seen, 500u);
  const auto since = std::chrono::steady_clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(2500));
  ASSERT_EQ(kill(child, SIGKILL), 0);
  const double lived = std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
  waitpid(child, nullptr, 0);
  const bodkin::session::Session session = bodkin::session::read_session(file);
  EXPECT_FALSE(session.finished);
  // A stalled machine delays ticks, which is not a loss of the recording: half a second of grace.
  EXPECT_GE(static_cast<double>(session.ticks.size()), static_cast<double>(seen) + (lived - 1.5) * 1000.0);
  EXPECT_EQ(bodkin("--quiet replay killed.bodkin").exit_code, 0) << "what was saved replays";
}

}  // namespace
}  // namespace bodkin_test
