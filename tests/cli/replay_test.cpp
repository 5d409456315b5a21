#include <bit>

#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;
using ReplayCommand = PatientCommand;

TEST_F(ReplayCommand, proves_identity_in_a_process_of_its_own) {
  ASSERT_EQ(bodkin("--quiet run patient --operator novice --seed 2 --output whole.bodkin").exit_code, 0);
  const Outcome replay = bodkin("--quiet replay whole.bodkin");
  EXPECT_EQ(replay.exit_code, 0) << replay.errors;
  EXPECT_THAT(replay.output, HasSubstr("identical: "));
  const auto json = nlohmann::json::parse(bodkin("--json replay whole.bodkin").output);
  EXPECT_TRUE(json["identical"].get<bool>());
  EXPECT_EQ(json["ticks"].get<std::size_t>(), ::bodkin::session::read_session(folder_ / "whole.bodkin").ticks.size());
  EXPECT_EQ(json["digest"].get<std::string>().size(), 16u);
}

TEST_F(ReplayCommand, of_a_session_with_other_force_models_needs_no_options) {
  const Outcome run = bodkin(
      "--json run patient --seed 2 --output models.bodkin --resistance 'tracking_wall catch_up_s=0.1' --constraint "
      "'rail torsion_N_mm_per_rad=333.3' --part 'relaxation share=0.3 time_s=2' --part shaft_friction");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(nlohmann::json::parse(run.output)["resistance"], "tracking_wall");
  const ::bodkin::anatomy::HapticSettings used =
      ::bodkin::session::read_session(folder_ / "models.bodkin").header.haptics;
  EXPECT_EQ(std::get<::bodkin::anatomy::TrackingWallSettings>(used.resistance).catch_up, 0.1);
  EXPECT_EQ(std::get<::bodkin::anatomy::RailSettings>(used.constraint).torsion, 333.3);
  EXPECT_EQ(used.parts.relaxation.size(), 1u);
  EXPECT_TRUE(used.parts.shaft_friction.has_value());
  const Outcome replay = bodkin("--json replay models.bodkin");
  ASSERT_EQ(replay.exit_code, 0) << replay.output << replay.errors;
  EXPECT_EQ(nlohmann::json::parse(replay.output)["constraint"], "rail");
  EXPECT_THAT(bodkin("export models.bodkin --csv models.csv").output,
              HasSubstr("tracking_wall + relaxation + shaft_friction, rail"));
  const auto exported = nlohmann::json::parse(bodkin("--json export models.bodkin --csv models.csv").output);
  EXPECT_EQ(exported["resistance"], "tracking_wall");
  EXPECT_EQ(exported["constraint"], "rail");
  const auto report = nlohmann::json::parse(bodkin("--json report models.bodkin -o models.html").output);
  EXPECT_EQ(report["resistance"], "tracking_wall");
  EXPECT_EQ(report["constraint"], "rail");
  const std::string html = text_of("models.html");
  EXPECT_THAT(html, HasSubstr("tracking_wall leash=false surface_mm=0 catch_up_s=0.1 "));
  EXPECT_THAT(html, HasSubstr("torsion_N_mm_per_rad=333.3"));
  EXPECT_THAT(html, HasSubstr("relaxation share=0.3 time_s=2"));
}

TEST_F(ReplayCommand, shows_the_first_difference_and_ends_with_3) {
  ASSERT_EQ(bodkin("--quiet run patient --max-time 8 --output true.bodkin").exit_code, 0);
  const ::bodkin::session::Session session = ::bodkin::session::read_session(folder_ / "true.bodkin");
  ::bodkin::session::SessionWriter writer(folder_ / "false.bodkin", session.header, true);
  auto event = session.events.begin();
  for (::bodkin::simulation::TickRecord record : session.ticks) {
    for (; event != session.events.end() && event->tick == record.tick; ++event)
      record.output.events.push(event->event);
    double& depth = record.output.depth;
    if (record.tick == 5000) depth = std::bit_cast<double>(std::bit_cast<std::uint64_t>(depth) ^ 1U);
    writer.append(record);
  }
  writer.finish();
  const Outcome replay = bodkin("--quiet replay false.bodkin");
  EXPECT_EQ(replay.exit_code, 3);
  EXPECT_THAT(replay.output, HasSubstr("different: tick 5000 at 5.000 s, depth"));
  const auto json = nlohmann::json::parse(bodkin("--json replay false.bodkin").output);
  EXPECT_FALSE(json["identical"].get<bool>());
  EXPECT_EQ(json["difference"]["field"], "depth");
}

TEST_F(ReplayCommand, needs_the_tissue_library_as_it_was) {
  namespace fs = std::filesystem;
  ASSERT_EQ(bodkin("--quiet run patient --max-time 1 --output library.bodkin").exit_code, 0);
  fs::copy(fs::path(BODKIN_REPOSITORY) / "share" / "bodkin", folder_ / "share", fs::copy_options::recursive);
  const fs::path file = folder_ / "share" / "tissues.xml";
  std::string text = text_of("share/tissues.xml");
  // Numbers used only by a deformable body count too: they belong to the patient.
  const std::string before = "puncture_force_N=\"0.9\"";
  ASSERT_NE(text.find(before), std::string::npos);
  ASSERT_EQ(setenv("BODKIN_SHARE", (folder_ / "share").c_str(), 1), 0);
  EXPECT_EQ(bodkin("--quiet replay library.bodkin").exit_code, 0) << "a library may move";
  text.replace(text.find(before), before.size(), "puncture_force_N=\"0.4\"");
  std::ofstream(file) << text;
  const Outcome replay = bodkin("--quiet replay library.bodkin");
  unsetenv("BODKIN_SHARE");
  EXPECT_EQ(replay.exit_code, 2) << replay.output;
  EXPECT_THAT(replay.errors, HasSubstr(": its tissues are not those of the session"));
}

TEST_F(ReplayCommand, needs_the_case_as_it_was) {
  ASSERT_EQ(bodkin("--quiet run patient --max-time 1 --output moved.bodkin").exit_code, 0);
  std::filesystem::copy(folder_ / "patient", folder_ / "changed", std::filesystem::copy_options::recursive);
  EXPECT_EQ(bodkin("--quiet replay moved.bodkin --case changed").exit_code, 0) << "a case may move";
  std::ofstream(folder_ / "changed" / "case.xml", std::ios::app) << "\n";
  const Outcome replay = bodkin("--quiet replay moved.bodkin --case changed");
  EXPECT_EQ(replay.exit_code, 2);
  EXPECT_THAT(replay.errors, HasSubstr("case.xml is not the one of the session"));
  EXPECT_EQ(bodkin("--quiet replay nothing.bodkin").exit_code, 2);
}

}  // namespace
}  // namespace bodkin_test
