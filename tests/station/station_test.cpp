// A whole session assembled from options, without a person: as an application, a server or a test starts it.
#include "station/station.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "patient/meshing/mesh_record.h"
#include "patient/prepared_body.h"
#include "session/replay.h"
#include "tests/fem/lattice_body.h"
#include "tests/io/scratch_folder.h"
#include "tests/session/slab_case.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "haptics/drivers/simulated.h"
#include "io/probe_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::haptics;
using namespace bodkin::imaging;
using namespace bodkin::io;
using namespace bodkin::patient;
using namespace bodkin::session;
using namespace bodkin::station;
namespace {

using ::testing::HasSubstr;

constexpr const char* quick_hand = "speed_mm_s=80 start_mm=10 depth_mm=20 wait_s=0.3";

// A device that only measures: it moves straight down along the planned path, then 30 mm to the side, then ends.
struct PuckOnRails {
  std::uint64_t round = 0;
  static constexpr double ms_down = 800.0, ms_aside = 1200.0, ms_end = 1300.0;

  void read(bodkin_state& state) {
    const double ms = static_cast<double>(++round);
    state.position[2] = 10.0 - 0.07 * std::min(ms, ms_down);
    state.position[0] = 30.0 * std::clamp((ms - ms_down) / (ms_aside - ms_down), 0.0, 1.0);
    for (const int one : {0, 4, 8}) state.rotation[one] = one == 0 ? 1.0 : -1.0;  // points down
    state.held = 1;
    if (ms > ms_end) state.buttons = BODKIN_BUTTON_END;
  }
};

PuckOnRails puck_on_rails;

const bodkin_driver puck_driver = {BODKIN_DRIVER_ABI,
                                   "puck",
                                   "for tests",
                                   [](const char*, bodkin_found, void*, char*) { return int{BODKIN_OK}; },
                                   [](const char*, const char*, void** handle, bodkin_abilities* abilities, char*) {
                                     puck_on_rails = {};
                                     *handle = &puck_on_rails;
                                     abilities->rate = 1000.0;
                                     abilities->measures_rotation = 1;
                                     return int{BODKIN_OK};
                                   },
                                   [](void*, bodkin_tick, void*, char*) { return int{BODKIN_OK}; },
                                   [](void* handle, const bodkin_command*, bodkin_state* state) {
                                     static_cast<PuckOnRails*>(handle)->read(*state);
                                     return int{BODKIN_OK};
                                   },
                                   [](void*) { return int{BODKIN_OK}; },
                                   [](void*) {},
                                   nullptr};

// Stores the statuses and notes that it receives.
struct Watcher : StationObserver {
  void note(const std::string& sentence) override { notes.push_back(sentence); }
  std::vector<Vec3> prepare(const Case& patient, const BodyDescription* body) override {
    const NeedlePath& path = *patient.description.procedure.path;
    has_body = body != nullptr;
    return {path.entry, path.entry + 5.0 * path.direction()};
  }
  std::chrono::milliseconds interval() const override { return std::chrono::milliseconds(10); }
  void update(Station& station, const StationStatus& status) override {
    ++updates;
    greatest_force = std::max(greatest_force, status.needle.output.requested.force.norm());
    deepest = std::max(deepest, status.needle.output.depth);
    if (status.displacements.size() == 6) {
      for (const float moved : status.displacements) most_moved = std::max(most_moved, std::abs(moved));
    }
    if (status.ultrasound != nullptr) pictures = status.ultrasound->number;
    if (status.second) second_force = std::max(second_force, status.second->sample.force);
    if (updates == end_after) station.command(StationCommand::end);
  }

  std::vector<std::string> notes;
  bool has_body = false;
  int updates = 0, end_after = 0;
  double greatest_force = 0.0, deepest = 0.0, second_force = 0.0;
  float most_moved = 0.0F;
  std::uint64_t pictures = 0;
};

// A case of flat layers in its own folder, with a mesh for a deformable body.
class StationTest : public ::testing::Test {
 protected:
  StationTest() : patient_(slab_case({{tissue::skin, 2.0}, {tissue::fat, 12.0}, {tissue::muscle, 36.0}})) {
    patient_.description.device.peak_force = 9.0;
    folder_.write("case.xml", "<case/>");
  }

  void make_deformable() {
    EmbeddedNeedleSettings needle;
    needle.capture_radius = 6.0;
    needle.body.stiffness_scale = 1.0;
    needle.body.fix_cut = false;
    needle.body.fix_beyond = 45.0;
    patient_.description.haptics.resistance = needle;
    patient_.description.haptics.constraint = NoConstraint{};
    TetrahedralMesh mesh = kuhn_box({9, 8, 9}, Vec3(60.0, 50.0, 60.0));
    for (Vec3& node : mesh.nodes) node -= Vec3(30.0, 50.0, 30.0);
    std::fill(mesh.tissues.begin(), mesh.tissues.end(), tissue::muscle);
    write_case_mesh(mesh, {}, folder_.path());
  }

  StationOptions options() const {
    StationOptions options;
    options.patient = patient_;
    options.case_folder = folder_.path();
    options.device = {&simulated_driver(), "", quick_hand};
    options.output = folder_.path() / "session.bodkin";
    options.longest = 60.0;
    return options;
  }

  static UltrasoundChoice ultrasound() {
    UltrasoundChoice choice;
    choice.probe = find_probe("L14-5");
    choice.settings.depth = 40.0;
    choice.settings.focus = 20.0;
    choice.detail.lines = choice.detail.samples = 64;
    choice.detail.width = choice.detail.height = 80;
    choice.request.view = ScanView::needle;
    return choice;
  }

  ReplayResult replay(const Case& performed) const {
    const Session session = read_session(folder_.path() / "session.bodkin");
    EXPECT_TRUE(session.finished);
    Case patient = performed;
    const auto body = prepare_body(patient, folder_.path(), {}, {}, {});
    return replay_session(session, patient, {}, body.get());
  }

  ScratchFolder folder_;
  Case patient_;
};

TEST_F(StationTest, performs_on_a_rigid_patient_with_ultrasound_and_the_recording_replays_to_the_bit) {
  StationOptions wanted = options();
  wanted.ultrasound = ultrasound();
  Watcher watcher;
  Station station(std::move(wanted), watcher);
  const StationResult result = station.run();
  EXPECT_TRUE(result.run.operator_finished) << "the simulated hand ends the session";
  EXPECT_GT(result.run.ticks, 1000U);
  EXPECT_EQ(result.run.records_lost, 0U);
  EXPECT_GT(result.ultrasound_pictures, 3U);
  EXPECT_GE(result.ultrasound_pictures, watcher.pictures);
  EXPECT_FALSE(watcher.has_body);
  EXPECT_GT(watcher.deepest, 15.0);
  EXPECT_GT(watcher.greatest_force, 0.2);
  EXPECT_EQ(watcher.most_moved, 0.0F);
  const ReplayResult replayed = replay(station.patient());
  EXPECT_FALSE(replayed.difference.has_value());
  EXPECT_EQ(replayed.ticks, result.run.ticks);
}

TEST_F(StationTest, a_device_without_force_does_not_move_the_needle_sideways_in_tissue) {
  StationOptions wanted = options();
  wanted.device = {&puck_driver, "", ""};
  Watcher watcher;
  Station station(std::move(wanted), watcher);
  station.run();
  const Session session = read_session(folder_.path() / "session.bodkin");
  double sideways = 0.0, deepest = 0.0;
  std::optional<Vec3> entered;
  for (const simulation::TickRecord& tick : session.ticks) {
    if (tick.output.depth <= 0.0) continue;
    const Vec3 tip = tick.input.needle.translation();
    if (!entered) entered = tip;
    const Vec3 axis = tick.input.needle.linear().col(2);
    const Vec3 way = tip - *entered;
    sideways = std::max(sideways, (way - axis.dot(way) * axis).norm());
    deepest = std::max(deepest, tick.output.depth);
  }
  EXPECT_GT(deepest, 10.0);
  EXPECT_LT(sideways, 0.1) << "the hand went 30 mm aside";
}

TEST_F(StationTest, the_body_is_moved_while_the_needle_is_outside_and_stays_while_it_touches) {
  StationOptions wanted = options();
  wanted.device.settings = "speed_mm_s=20 start_mm=60 depth_mm=15 wait_s=0.5";
  const NeedlePath path = *patient_.description.procedure.path;
  const WorkspaceSettings usual = workspace_about(path);
  Watcher watcher;
  Station station(std::move(wanted), watcher);
  station.start();
  // The middle of the workspace moves 6 mm to one side: the needle enters 6 mm from the path.
  EXPECT_TRUE(station.move_body(usual.centre + 6.0 * Vec3::UnitX(), usual.rotation));
  bool was_refused = false;
  while (!station.ended()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (station.update().needle.output.depth > 8.0 && !was_refused)
      was_refused = !station.move_body(usual.centre, usual.rotation);
  }
  station.finish();
  EXPECT_TRUE(was_refused);
  const Session session = read_session(folder_.path() / "session.bodkin");
  double deepest = 0.0;
  for (const auto& tick : session.ticks) {
    if (!tick.output.in_contact || tick.output.depth <= 1.0) continue;
    deepest = std::max(deepest, tick.output.depth);
    const Vec3 tip = tick.input.needle.translation();
    const Vec3 aside = tip - path.entry - path.direction() * path.direction().dot(tip - path.entry);
    ASSERT_NEAR((aside - 6.0 * Vec3::UnitX()).norm(), 0.0, 0.6) << tick.output.depth;
  }
  EXPECT_GT(deepest, 8.0);
}

TEST_F(StationTest, performs_on_a_deformable_patient_whose_points_move_and_the_recording_replays_to_the_bit) {
  make_deformable();
  StationOptions wanted = options();
  wanted.ultrasound = ultrasound();
  Watcher watcher;
  Station station(std::move(wanted), watcher);
  const StationResult result = station.run();
  EXPECT_TRUE(watcher.has_body);
  EXPECT_GT(watcher.greatest_force, 0.05);
  EXPECT_GT(watcher.most_moved, 0.01F) << "mm, of the entry or a point below it";
  EXPECT_GT(result.ultrasound_pictures, 3U);
  const ReplayResult replayed = replay(station.patient());
  EXPECT_FALSE(replayed.difference.has_value());
  EXPECT_EQ(replayed.ticks, result.run.ticks);
}

// Slides the probe on the screen, as a mouse does in the window, and increases the depth.
struct ProbeMover : Watcher {
  void update(Station& station, const StationStatus& status) override {
    Watcher::update(station, status);
    if (status.ultrasound == nullptr || status.ultrasound->number == 0) return;
    if (!first) first = status.ultrasound->setup;
    if (updates < 8) return;
    moved = *first;
    moved.probe.translation().x() += 4.0;
    moved.settings.depth = 55.0;
    station.set_scan_setup(moved);
  }
  std::optional<ScanSetup> first;
  ScanSetup moved;
};

TEST_F(StationTest, a_probe_that_is_moved_on_the_screen_is_in_the_session) {
  StationOptions wanted = options();
  wanted.ultrasound = ultrasound();
  ProbeMover mover;
  Station station(std::move(wanted), mover);
  const StationResult result = station.run();
  ASSERT_TRUE(mover.first.has_value());
  const Session session = read_session(folder_.path() / "session.bodkin");
  ASSERT_TRUE(session.header.ultrasound.has_value());
  EXPECT_EQ(session.header.ultrasound->name, "L14-5");
  EXPECT_FALSE(session.header.second.has_value());
  ASSERT_EQ(session.scans.size(), 2U) << "only what has changed is kept";
  EXPECT_EQ(session.scans[0].probe.translation(), mover.first->probe.translation());
  EXPECT_EQ(session.scans[0].settings.depth, 40.0);
  EXPECT_EQ(session.scans[1].probe.translation(), mover.moved.probe.translation());
  EXPECT_LT((session.scans[1].probe.linear() - mover.moved.probe.linear()).norm(), 1e-12);
  EXPECT_EQ(session.scans[1].settings.depth, 55.0);
  EXPECT_GT(session.scans[1].time, session.scans[0].time);
  EXPECT_LT(session.scans[1].time, static_cast<double>(result.run.ticks) * session.header.dt);
  EXPECT_THAT(session.scanned, ::testing::Contains(::testing::Field(&ScannedPart::name, "skin")));
  EXPECT_FALSE(replay(station.patient()).difference.has_value());
}

TEST_F(StationTest, a_probe_in_the_second_hand_presses_a_moving_body) {
  make_deformable();
  StationOptions wanted = options();
  wanted.device.settings = "speed_mm_s=40 start_mm=60 depth_mm=10 wait_s=0.2";
  wanted.second =
      SecondChoice{{&simulated_driver(), "", "speed_mm_s=60 depth_mm=10 lateral_mm=40 wait_s=20"}, SecondRole::probe};
  ProbeFace face;
  face.width = face.thickness = 25.0;
  wanted.moving_body = face;
  Watcher watcher;
  Station station(std::move(wanted), watcher);
  const StationResult result = station.run();
  EXPECT_GT(watcher.second_force, 0.1);
  EXPECT_THAT(result.run.notes, ::testing::Contains(HasSubstr("the body moved ")));
  const Session session = read_session(folder_.path() / "session.bodkin");
  EXPECT_TRUE(session.header.second.has_value());
  EXPECT_THAT(session.header.moving_body, HasSubstr("\"width_mm\":25.0"));
  EXPECT_GT(session.second.size(), 50U);
}

TEST_F(StationTest, a_second_hand_on_the_plunger_is_the_thumb_of_the_syringe) {
  patient_.description.haptics.parts.syringe.emplace();
  StationOptions wanted = options();
  wanted.device.settings = "speed_mm_s=40 start_mm=5 depth_mm=15 wait_s=1";
  // A motion of 2 s, straight down from its place at arming.
  wanted.second = SecondChoice{{&simulated_driver(), "", "speed_mm_s=20 depth_mm=20 wait_s=20"}, SecondRole::plunger};
  Watcher watcher;
  Station station(std::move(wanted), watcher);
  station.run();
  const Session session = read_session(folder_.path() / "session.bodkin");
  double most = 0.0;
  for (const auto& record : session.ticks) {
    ASSERT_NE(record.input.thumb.byte(), 0) << "tick " << record.tick << ": not the case's constant thumb";
    most = std::max(most, *record.input.thumb.force());
  }
  double most_of_the_hand = 0.0;
  for (const SecondSample& sample : session.second) most_of_the_hand = std::max(most_of_the_hand, sample.force);
  EXPECT_GT(most, 0.5);
  EXPECT_NEAR(most, most_of_the_hand, 0.5) << "samples are a hundred a second";
  EXPECT_FALSE(replay(station.patient()).difference.has_value());
}

// Takes the thumb off the plunger and later puts it back.
struct Presser : Watcher {
  void update(Station& station, const StationStatus& status) override {
    Watcher::update(station, status);
    if (updates == 1) {
      EXPECT_TRUE(status.plunger_pressed) << "a simulated hand presses all the time";
      station.command(StationCommand::release_plunger);
    }
    if (updates == 3) {
      EXPECT_FALSE(status.plunger_pressed);
    }
    if (updates == 20) station.command(StationCommand::press_plunger);
  }
};

TEST_F(StationTest, a_command_presses_the_plunger_and_the_recording_keeps_when) {
  patient_.description.haptics.parts.syringe.emplace();
  StationOptions wanted = options();
  wanted.device.settings = "speed_mm_s=30 start_mm=5 depth_mm=15 wait_s=0.5";
  Presser presser;
  Station station(std::move(wanted), presser);
  station.run();
  const Session session = read_session(folder_.path() / "session.bodkin");
  int released = 0, pressed = 0;
  for (const auto& record : session.ticks) {
    if (record.input.thumb.byte() == 0) {
      ++pressed;
    } else {
      EXPECT_EQ(*record.input.thumb.force(), 0.0);
      ++released;
    }
  }
  EXPECT_GT(released, 100);
  EXPECT_GT(pressed, 100);
  EXPECT_EQ(session.ticks.back().input.thumb.byte(), 0);
  EXPECT_FALSE(replay(station.patient()).difference.has_value());
}

TEST_F(StationTest, ends_by_a_command_by_its_time_and_from_another_thread) {
  StationOptions wanted = options();
  wanted.device.settings = "speed_mm_s=1";
  wanted.overwrite = true;
  Watcher impatient;
  impatient.end_after = 5;
  EXPECT_TRUE(Station(wanted, impatient).run().run.operator_finished);
  EXPECT_EQ(impatient.updates, 5);
  wanted.longest = 0.3;
  Watcher patient;
  const StationResult late = Station(wanted, patient).run();
  EXPECT_FALSE(late.run.operator_finished);
  EXPECT_LT(late.run.wall_time, 10.0);
  // Without run(): the caller has its own loop.
  wanted.longest = 60.0;
  StationObserver nobody;
  Station station(wanted, nobody);
  station.start();
  EXPECT_FALSE(station.ended());
  while (station.update().needle.ticks < 50) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::thread([&station] { station.end(); }).join();
  EXPECT_TRUE(station.ended());
  EXPECT_GE(station.finish().run.ticks, 50U);
}

TEST_F(StationTest, works_about_another_path_than_the_planned_one) {
  StationOptions wanted = options();
  wanted.path = NeedlePath{Vec3(10.0, 0.0, 5.0), Vec3(10.0, -25.0, 5.0)};
  Watcher watcher;
  Station(std::move(wanted), watcher).run();
  const Session session = read_session(folder_.path() / "session.bodkin");
  EXPECT_EQ(session.header.path.entry, Vec3(10.0, 0.0, 5.0));
  EXPECT_NEAR(session.ticks.back().input.needle.translation().x(), 10.0, 2.0);
}

TEST_F(StationTest, what_cannot_be_put_together_is_one_sentence) {
  const auto refusal = [](StationOptions wanted) -> std::string {
    StationObserver nobody;
    try {
      Station station(std::move(wanted), nobody);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  StationOptions pathless = options();
  pathless.patient.description.procedure.path.reset();
  EXPECT_THAT(refusal(pathless), HasSubstr("no planned path, so there is no place to put the hand"));
  StationOptions probeless = options();
  probeless.moving_body = ProbeFace{};
  EXPECT_THAT(refusal(probeless), HasSubstr("but no second device holds one"));
  StationOptions rigid = options();
  rigid.moving_body = ProbeFace{};
  rigid.second = SecondChoice{{&simulated_driver(), "", ""}, SecondRole::probe};
  EXPECT_THAT(refusal(rigid), HasSubstr("add --resistance embedded_needle"));
  StationOptions other_rate = options();
  other_rate.device.settings = "rate_Hz=500";
  EXPECT_THAT(refusal(other_rate), HasSubstr("add --settings rate_Hz=1000"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "session.bodkin"));
}

}  // namespace
}  // namespace bodkin
