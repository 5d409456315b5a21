#include "session/replay.h"

#include <bit>
#include <charconv>
#include <map>
#include <sstream>

#include "session/case_digest.h"
#include "session/operator_file.h"
#include "session/session_export.h"
#include "session/session_run.h"
#include "tests/io/scratch_folder.h"
#include "tests/session/session_samples.h"
#include "tests/session/slab_case.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulation/closed_loop.h"
#include "simulation/resistance_models.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::haptics;
using namespace bodkin::io;
using namespace bodkin::session;
using namespace bodkin::simulation;
namespace {

using ::testing::HasSubstr;

RunSettings settings_for(const Case& patient, const std::string& name, const std::filesystem::path& output) {
  RunSettings settings;
  settings.script = load_operator(name);
  settings.seed = 3;
  settings.path = *patient.description.procedure.path;
  settings.output = output;
  settings.overwrite = true;
  return settings;
}

SessionHeader header_for(const Case& patient, const RunSettings& settings) {
  SessionHeader header = sample_header();
  header.dt = 1.0 / patient.description.haptics.rate;
  header.seed = settings.seed;
  header.path = settings.path;
  header.haptics = patient.description.haptics;
  for (const DiagnosticName& one : diagnostic_names(header.haptics))
    header.diagnostics.push_back({std::string(one.name), std::string(one.title)});
  header.tissues.clear();
  for (const TissueProperties& tissue : patient.library.tissues()) {
    header.tissues.push_back({tissue.id, tissue.name, tissue.title});
  }
  return header;
}

// One recorded insertion, shared by the tests of this file.
class Recorded : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    patient_ = new Case(slab_case(lumbar_slabs()));
    const auto file =
        std::filesystem::temp_directory_path() / ("bodkin_recorded_" + std::to_string(getpid()) + ".bodkin");
    const RunSettings settings = settings_for(*patient_, "expert", file);
    const RunResult result = run_session(*patient_, header_for(*patient_, settings), settings, {});
    EXPECT_TRUE(result.operator_finished);
    session_ = new Session(read_session(file));
    std::filesystem::remove(file);
    EXPECT_EQ(result.ticks, session_->ticks.size());
  }
  static void TearDownTestSuite() {
    delete patient_;
    delete session_;
  }
  static Case* patient_;
  static Session* session_;
};

Case* Recorded::patient_ = nullptr;
Session* Recorded::session_ = nullptr;

using Replay = Recorded;
using Export = Recorded;

TEST_F(Replay, of_a_recorded_session_is_identical_to_the_bit) {
  EXPECT_TRUE(session_->finished);
  EXPECT_GT(session_->ticks.size(), 10000u);
  EXPECT_GT(session_->events.size(), 10u);
  const ReplayResult result = replay_session(*session_, *patient_);
  EXPECT_FALSE(result.difference.has_value());
  EXPECT_EQ(result.ticks, session_->ticks.size());
  EXPECT_EQ(result.digest, replay_session(*session_, *patient_).digest);
}

TEST_F(Replay, of_a_session_without_force_in_organs_is_identical_and_the_setting_is_recorded) {
  Case patient = slab_case(lumbar_slabs());
  patient.structures = LabelVolume(patient.tissues.grid);
  for (std::size_t i = 0; i < patient.tissues.voxels.size(); ++i)
    patient.structures.voxels[i] = patient.tissues.voxels[i] == tissue::interspinous_ligament ? 7 : 0;
  patient.description.structures = {{7, "organ", "", true}};
  patient.description.haptics.force_in_organs = ForceInOrgans::none;
  const auto file =
      std::filesystem::temp_directory_path() / ("bodkin_organs_" + std::to_string(getpid()) + ".bodkin");
  const RunSettings settings = settings_for(patient, "expert", file);
  run_session(patient, header_for(patient, settings), settings, {});
  Session recorded = read_session(file);
  std::filesystem::remove(file);
  EXPECT_EQ(recorded.header.haptics.force_in_organs, ForceInOrgans::none);
  EXPECT_FALSE(replay_session(recorded, patient).difference.has_value());
  int without = 0;
  for (const auto& tick : recorded.ticks)
    without += tick.output.in_contact && tick.output.requested.force.norm() == 0.0 ? 1 : 0;
  EXPECT_GT(without, 100);
  recorded.header.haptics.force_in_organs = ForceInOrgans::felt;
  EXPECT_TRUE(replay_session(recorded, patient).difference.has_value());
}

TEST_F(Replay, finds_a_single_flipped_bit_and_says_where) {
  Session tampered = *session_;
  double& force = tampered.ticks[7777].output.applied.force[1];
  force = std::bit_cast<double>(std::bit_cast<std::uint64_t>(force) ^ 1U);
  const ReplayResult result = replay_session(tampered, *patient_);
  ASSERT_TRUE(result.difference.has_value());
  EXPECT_EQ(result.difference->tick, 7777u);
  EXPECT_NEAR(result.difference->time, 7.777, 1e-12);
  EXPECT_EQ(result.difference->field, "applied_force_y");
  EXPECT_NE(result.difference->recorded, result.difference->recomputed);
}

TEST_F(Replay, finds_a_changed_event_a_missing_event_and_a_changed_flag) {
  Session tampered = *session_;
  tampered.events[2].event.value += 1e-12;
  ASSERT_TRUE(replay_session(tampered, *patient_).difference.has_value());
  EXPECT_EQ(replay_session(tampered, *patient_).difference->field, "events");
  tampered = *session_;
  tampered.events.pop_back();
  ASSERT_TRUE(replay_session(tampered, *patient_).difference.has_value());
  EXPECT_EQ(replay_session(tampered, *patient_).difference->field, "events");
  tampered = *session_;
  tampered.ticks[100].output.limits ^= 1;
  EXPECT_EQ(replay_session(tampered, *patient_).difference->field, "limits");
}

TEST_F(Replay, compares_the_diagnostics_that_were_recorded_under_the_same_names) {
  ASSERT_EQ(session_->header.diagnostics.size(), 2U);
  EXPECT_EQ(session_->header.diagnostics[1].name, "shaft_N");
  Session tampered = *session_;
  tampered.ticks[7777].output.diagnostics[1] += 1e-9;
  const ReplayResult result = replay_session(tampered, *patient_);
  ASSERT_TRUE(result.difference.has_value());
  EXPECT_EQ(result.difference->tick, 7777U);
  EXPECT_EQ(result.difference->field, "shaft_N");
  tampered.header.diagnostics[1].name = "another_N";
  EXPECT_FALSE(replay_session(tampered, *patient_).difference.has_value());
}

TEST_F(Replay, of_a_session_of_version_2_compares_all_but_the_losses_of_resistance) {
  Session old = *session_;
  old.version = 2;
  old.header.diagnostics.clear();
  for (TickRecord& record : old.ticks) record.output.diagnostics = {};
  std::erase_if(old.events, [](const SessionEvent& one) { return one.event.kind == EventKind::loss_of_resistance; });
  ASSERT_LT(old.events.size(), session_->events.size());
  EXPECT_FALSE(replay_session(old, *patient_).difference.has_value());
  old.version = 3;
  EXPECT_EQ(replay_session(old, *patient_).difference->field, "events");
  old.version = 2;
  old.events.pop_back();
  EXPECT_EQ(replay_session(old, *patient_).difference->field, "events");
}

TEST_F(Replay, a_different_patient_gives_a_difference) {
  Case other = *patient_;
  std::vector<TissueProperties> tissues = other.library.tissues();
  for (TissueProperties& tissue : tissues) {
    if (tissue.id == tissue::skin) tissue.layered.stiffness *= 1.0 + 1e-12;
  }
  other.library = TissueLibrary(tissues);
  EXPECT_NE(case_digest(other, "<case/>", ""), case_digest(*patient_, "<case/>", ""));
  EXPECT_TRUE(replay_session(*session_, other).difference.has_value());
}

// The body is given, as patient::prepare_body() gives it.
TEST_F(Replay, says_which_part_of_a_deformable_body_is_another_one) {
  Case with_body = *patient_;
  CondensedBody body{.nodes = {Vec3(1.0, 2.0, 3.0), Vec3(1.0, 2.0, 4.0)},
                     .mesh_nodes = {},
                     .tissues = {tissue::skin, tissue::fat},
                     .compliance = Eigen::MatrixXd::Identity(6, 6)};
  const auto said = [&](const CondensedBody& now) {
    with_body.prepared.body = std::make_shared<const CondensedBody>(now);
    return replay_session(*session_, with_body).body_difference;
  };
  Session recorded = *session_;
  with_body.prepared.body = std::make_shared<const CondensedBody>(body);
  recorded.header.body_digest = digest_of_body(with_body);
  recorded.header.body_points = digest_of_points(with_body);
  std::swap(*session_, recorded);
  EXPECT_EQ(said(body), "");
  CondensedBody softer = body;
  softer.compliance(5, 5) += 1e-15;
  EXPECT_THAT(said(softer), HasSubstr("has the contact points of the session, but another compliance of them"));
  CondensedBody elsewhere = body;
  elsewhere.nodes[1].z() += 1e-15;
  EXPECT_THAT(said(elsewhere), HasSubstr("has other contact points than in the session"));
  with_body.prepared.body = nullptr;
  EXPECT_THAT(replay_session(*session_, with_body).body_difference, HasSubstr("has not been prepared"));
  session_->header.body_points.clear();  // an older session
  EXPECT_THAT(said(softer), HasSubstr("has another compliance than in the session"));
  std::swap(*session_, recorded);
}

TEST_F(Replay, names_the_part_of_the_case_that_is_another_one) {
  const ScratchFolder folder;
  folder.write("case.xml", "<case/>");
  Session recorded = *session_;
  recorded.header.case_xml = "<case/>";
  recorded.header.case_digest = case_digest(*patient_, "<case/>", "");
  recorded.header.case_parts = case_parts(*patient_, "");
  const auto refusal = [&](const Case& patient) -> std::string {
    try {
      check_same_case(recorded, patient, folder.path().string());
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(*patient_), "");
  Case other = *patient_;
  std::vector<TissueProperties> tissues = other.library.tissues();
  tissues.back().layered.stiffness *= 1.0 + 1e-12;
  other.library = TissueLibrary(tissues);
  EXPECT_THAT(refusal(other), HasSubstr(": its tissues are not those of the session"));
  recorded.header.case_parts.clear();  // an older session
  EXPECT_THAT(refusal(other), HasSubstr(": its voxels or tissues are not those of the session"));
  folder.write("case.xml", "<case></case>");
  EXPECT_THAT(refusal(*patient_), HasSubstr(": its case.xml is not the one of the session"));
}

// The session may have used other settings than the case: the session's own are replayed.
TEST(ReplayOfOtherModels, every_resistance_and_constraint_replays_on_the_case_as_it_is) {
  const Case patient = slab_case({{tissue::skin, 2.0}, {tissue::muscle, 20.0}});
  const ScratchSession file;
  const std::pair<ResistanceSettings, ConstraintSettings> choices[] = {
      {TrackingWallSettings{.catch_up = 0.1}, PivotSettings{}},
      {TrackingWallSettings{.leash = true, .layers = {{0.0, {0.5, 1.0 / 3.0}}}}, NoConstraint{}},
      {DepthProfileSettings{}, RailSettings{.torsion = 500.0}},
      {VolumeProxySettings{.variant = ProxyVariant::viscous}, RailSettings{}},
      {ThreeComponentSettings{}, BeamSettings{}},
      {FractureSettings{}, LineSpringSettings{.stiffness = 0.3}},
      {ShaftFrictionSettings{}, NoConstraint{}}};
  for (const auto& [resistance, constraint] : choices) {
    Case other = patient;
    other.description.haptics.resistance = resistance;
    other.description.haptics.constraint = constraint;
    RunSettings settings = settings_for(other, "expert", file.path());
    settings.longest = 4.0;
    run_session(other, header_for(other, settings), settings, {});
    const Session session = read_session(file.path());
    EXPECT_EQ(name_of(session.header.haptics.resistance), name_of(resistance));
    EXPECT_FALSE(replay_session(session, patient).difference.has_value()) << name_of(resistance);
    Session forgotten = session;
    forgotten.header.haptics = patient.description.haptics;
    EXPECT_TRUE(replay_session(forgotten, patient).difference.has_value()) << name_of(resistance);
  }
}

TEST_F(Replay, refuses_what_cannot_be_replayed) {
  Session tampered = *session_;
  tampered.ticks.erase(tampered.ticks.begin() + 50);
  EXPECT_THROW(replay_session(tampered, *patient_), InputError);
  tampered.ticks.clear();
  EXPECT_THROW(replay_session(tampered, *patient_), InputError);
  tampered = *session_;
  tampered.header.dt = 0.002;
  EXPECT_THROW(replay_session(tampered, *patient_), InputError);
}

// A small reader of RFC 4180, written for the test alone.
std::vector<std::map<std::string, std::string>> parse_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool in_quotes = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_quotes) {
      if (c != '"') {
        rows.back().back() += c;
      } else if (i + 1 < text.size() && text[i + 1] == '"') {
        rows.back().back() += text[++i];
      } else {
        in_quotes = false;
      }
    } else if (c == '"') {
      in_quotes = true;
    } else if (c == ',') {
      rows.back().emplace_back();
    } else if (c == '\n') {
      if (i + 1 < text.size()) rows.push_back({""});
    } else {
      rows.back().back() += c;
    }
  }
  std::vector<std::map<std::string, std::string>> table;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    EXPECT_EQ(rows[row].size(), rows[0].size());
    auto& entry = table.emplace_back();
    for (std::size_t column = 0; column < rows[0].size(); ++column) entry[rows[0][column]] = rows[row][column];
  }
  return table;
}

double number(const std::string& text) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

TEST_F(Export, every_number_reads_back_to_the_same_bits) {
  std::string text;
  export_ticks(*session_, [&](std::string_view piece) { text += piece; });
  EXPECT_EQ(text.find('\r'), std::string::npos);
  const auto table = parse_csv(text);
  ASSERT_EQ(table.size(), session_->ticks.size());
  for (std::size_t row = 0; row < table.size(); row += 7) {
    const TickRecord& record = session_->ticks[row];
    const auto& line = table[row];
    EXPECT_EQ(line.at("tick"), std::to_string(record.tick));
    ASSERT_EQ(number(line.at("time_s")), static_cast<double>(record.tick) * 0.001);
    ASSERT_EQ(number(line.at("tip_y_mm")), record.input.needle.translation().y());
    ASSERT_EQ(number(line.at("axis_z")), needle_axis(record.input.needle).z());
    ASSERT_EQ(number(line.at("depth_mm")), record.output.depth);
    ASSERT_EQ(number(line.at("velocity_mm_per_s")), record.output.velocity);
    ASSERT_EQ(number(line.at("resistance_N")), record.output.resistance);
    ASSERT_EQ(number(line.at("requested_force_x_N")), record.output.requested.force.x());
    ASSERT_EQ(number(line.at("applied_force_y_N")), record.output.applied.force.y());
    EXPECT_EQ(line.at("tissue"), patient_->library.find(record.output.tissue)->name);
    EXPECT_EQ(line.at("limits"), std::to_string(record.output.limits));
  }
}

TEST_F(Export, events_stand_with_their_time_depth_and_kind) {
  std::string text;
  export_events(*session_, [&](std::string_view piece) { text += piece; });
  const auto table = parse_csv(text);
  ASSERT_EQ(table.size(), session_->events.size());
  bool lost_resistance = false;
  for (std::size_t row = 0; row < table.size(); ++row) {
    ASSERT_EQ(number(table[row].at("depth_mm")), session_->events[row].event.depth);
    ASSERT_EQ(number(table[row].at("value")), session_->events[row].event.value);
    lost_resistance = lost_resistance || table[row].at("kind") == "loss_of_resistance";
  }
  EXPECT_TRUE(lost_resistance);
}

TEST(ExportText, names_with_commas_and_quotes_are_quoted) {
  Session session;
  session.header = sample_header();
  session.header.tissues = {{tissue::skin, "skin, \"thick\"", "skin"}};
  session.ticks.emplace_back().output.tissue = tissue::skin;
  std::string text;
  export_ticks(session, [&](std::string_view piece) { text += piece; });
  EXPECT_THAT(text, ::testing::HasSubstr(",\"skin, \"\"thick\"\"\",0,0\n"));
  EXPECT_EQ(parse_csv(text).at(0).at("tissue"), "skin, \"thick\"");
}

TEST_F(Recorded, running_again_gives_the_same_session_and_another_seed_another) {
  RunSettings settings = settings_for(*patient_, "expert", {});
  ClosedLoop again(*patient_, settings.script, settings.path, settings.seed);
  ClosedLoop other(*patient_, settings.script, settings.path, settings.seed + 1);
  TickRecord record;
  bool differs = false;
  for (const TickRecord& recorded : session_->ticks) {
    again.step(record);
    ASSERT_EQ(bytes_of(record), bytes_of(recorded));
    other.step(record);
    differs = differs || bytes_of(record) != bytes_of(recorded);
  }
  EXPECT_TRUE(differs);
}

TEST_F(Recorded, on_the_clock_the_same_ticks_are_recorded) {
  const ScratchSession scratch;
  RunSettings settings = settings_for(*patient_, "expert", scratch.path());
  settings.realtime = true;
  settings.longest = 1.0;
  const RunResult result = run_session(*patient_, header_for(*patient_, settings), settings, {});
  EXPECT_GE(result.wall_time, 0.99);
  EXPECT_FALSE(result.operator_finished);
  EXPECT_EQ(result.last_phase, "approach");
  EXPECT_EQ(result.records_lost, 0u);
  const Session session = read_session(scratch.path());
  ASSERT_EQ(session.ticks.size(), 1000u);
  for (std::size_t tick = 0; tick < 1000; ++tick) {
    ASSERT_EQ(bytes_of(session.ticks[tick]), bytes_of(session_->ticks[tick]))
        << "the clock must not change what happens";
  }
}

}  // namespace
}  // namespace bodkin
