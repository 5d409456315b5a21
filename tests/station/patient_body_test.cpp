// A body that moves on its own time between two hands: the probe presses it, the needle enters it as it is pressed.
#include "station/patient_body.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <thread>

#include "patient/prepared_body.h"
#include "session/replay.h"
#include "station/hand_session.h"
#include "station/second_hand.h"
#include "tests/fem/lattice_body.h"
#include "tests/session/session_samples.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fem/solid/patient_body.h"
#include "haptics/drivers/simulated.h"
#include "io/tissue_library_file.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::forces;
using namespace bodkin::haptics;
using namespace bodkin::io;
using namespace bodkin::patient;
using namespace bodkin::session;
using namespace bodkin::simulation;
using namespace bodkin::station;
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

struct PressedBlock {
  Case patient;
  std::shared_ptr<const BodyDescription> body;
  BodySolverSettings settings;
};

// A block of muscle, 120 x 50 x 80 mm below the plane y = 0, held at its bottom; the planned path goes down at
// x = -30, a probe with a face of 35 x 35 mm is at hand.
PressedBlock pressed_block() {
  PressedBlock made;
  Case& patient = made.patient;
  patient.library = default_tissue_library();
  Grid grid;
  grid.size = {60, 70, 40};
  grid.spacing = Vec3(2.0, 1.0, 2.0);
  grid.origin = Vec3(-59.0, -49.5, -39.0);
  patient.tissues = TissueVolume(grid, tissue::air);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < grid.size[0]; ++i) patient.tissues.at(i, j, k) = tissue::muscle;
  patient.ct = CtVolume(grid, 40);
  patient.description.device = {"strong", 100.0, 50.0, 1e6, 100.0, 0.0};
  patient.description.haptics.constraint = NoConstraint{};
  EmbeddedNeedleSettings needle;
  needle.capture_radius = 6.0;
  needle.spacing = 5.0;
  needle.body.corridor_radius = 15.0;
  needle.body.stiffness_scale = 1.0;
  needle.body.fix_cut = false;
  needle.body.fix_beyond = 45.0;
  patient.description.haptics.resistance = needle;
  patient.description.procedure.path = NeedlePath{Vec3(-30.0, 0.0, 0.0), Vec3(-30.0, -30.0, 0.0)};
  TetrahedralMesh mesh = kuhn_box({13, 6, 9}, Vec3(120.0, 50.0, 80.0));
  for (Vec3& node : mesh.nodes) node -= Vec3(60.0, 50.0, 40.0);
  std::fill(mesh.tissues.begin(), mesh.tissues.end(), tissue::muscle);
  const NeedlePath& path = *patient.description.procedure.path;
  made.body = std::make_shared<const BodyDescription>(describe_body(mesh, patient, needle.body, path).body);
  patient.corridor = {std::make_shared<const CondensedBody>(condense(*made.body)), path, {}};
  made.settings.probe.width = made.settings.probe.thickness = 35.0;
  return made;
}

std::unique_ptr<SecondHand> probe_hand(const PressedBlock& block, const std::string& settings,
                                       const std::shared_ptr<SecondLink>& link,
                                       const std::shared_ptr<PatientBody>& pressed) {
  DevicePort port(simulated_driver(), "", settings);
  const DeviceAbilities device = port.abilities();
  ServoSettings servo;
  servo.workspace = second_workspace(SecondRole::probe, *block.patient.description.procedure.path);
  return std::make_unique<SecondHand>(SecondRole::probe, std::move(port), device, servo,
                                      std::make_shared<const Case>(block.patient), link, pressed);
}

void arm(HandSession& session) {
  ServoCommand command;
  command.kind = ServoCommand::Kind::arm;
  session.servo().tick().command(command);
}

// A simulated hand that stays where it is until the gate opens. The hands have threads of their own, so without it
// the load of the machine would decide which of them comes first.
std::atomic<bool> gate_is_open{false};

int exchange_at_the_gate(void* handle, const bodkin_command* command, bodkin_state* state) {
  static bodkin_state first;
  static void* known = nullptr;
  if (gate_is_open) return simulated_driver().exchange(handle, command, state);
  if (known != handle) {
    known = handle;
    const int result = simulated_driver().exchange(handle, command, &first);
    if (result != BODKIN_OK) return result;
  }
  *state = first;
  return BODKIN_OK;
}

const bodkin_driver& gated_driver() {
  static const bodkin_driver driver = [] {
    bodkin_driver made = simulated_driver();
    made.exchange = exchange_at_the_gate;
    return made;
  }();
  return driver;
}

// Whether the probe's force has stayed the same, but for the hand's tremor, for 500 rounds of its hand and 100 steps
// of the body.
class Settled {
 public:
  bool look(SecondHand& hand, PatientBody& body) {
    const double force = hand.snapshot().force;
    const std::uint64_t rounds = hand.servo().rounds(), steps = body.snapshot().steps;
    if (force < 1.0 || std::abs(force - force_) > 0.15 * force) {
      force_ = force;
      rounds_ = rounds;
      steps_ = steps;
    }
    return force >= 1.0 && rounds >= rounds_ + 500 && steps >= steps_ + 100;
  }

 private:
  double force_ = 0.0;  // N
  std::uint64_t rounds_ = 0, steps_ = 0;
};

// The probe presses 12 mm at x = 5, 35 mm beside the needle, which enters when it has done so.
Session perform_on(const PressedBlock& block, const std::filesystem::path& file) {
  const auto pressed = std::make_shared<PatientBody>(block.patient, *block.body, block.settings);
  SessionHeader header = sample_header();
  header.path = *block.patient.description.procedure.path;
  header.haptics = block.patient.description.haptics;
  header.second = SecondHeader{SecondRole::probe, "{}"};
  header.moving_body = "{\"nodes\":702}";
  const auto link = std::make_shared<SecondLink>();
  gate_is_open = false;
  DevicePort port(gated_driver(), "", "speed_mm_s=15 start_mm=20 depth_mm=15 wait_s=0.3");
  const DeviceAbilities device = port.abilities();
  ServoSettings servo;
  servo.workspace = workspace_about(header.path);
  HandSession session(std::make_shared<const Case>(block.patient), header, file, true, std::move(port), device, servo,
                      link);
  const auto second = probe_hand(block, "speed_mm_s=40 depth_mm=12 lateral_mm=25 wait_s=600", link, pressed);
  session.press(pressed);
  second->start();
  session.start();
  arm(session);
  second->arm();
  Settled settled;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(240);  // so long only where it fails
  while (!session.servo().tick().snapshot().device.ended() && std::chrono::steady_clock::now() < end) {
    const std::optional<PreparedCorridor> corridor = pressed->take_corridor();
    EXPECT_TRUE(!corridor || session.body()->refresh_corridor(*corridor));
    EXPECT_TRUE(std::isfinite(pressed->snapshot().on_probe.force.norm()));
    if (!gate_is_open && settled.look(*second, *pressed)) gate_is_open = true;
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_TRUE(gate_is_open) << "the probe's force did not settle";
  EXPECT_TRUE(second->stop());
  EXPECT_TRUE(session.finish());
  EXPECT_FALSE(pressed->failed());
  return read_session(file);
}

TEST(PatientBody, the_probes_hand_feels_the_bodys_force_and_the_needle_enters_it_as_it_is_pressed) {
  const ScratchSession scratch;
  const PressedBlock block = pressed_block();
  const Session session = perform_on(block, scratch.path());
  EXPECT_EQ(session.header.moving_body, "{\"nodes\":702}");
  const auto entered = std::find_if(session.events.begin(), session.events.end(), [](const SessionEvent& event) {
    return event.event.kind == EventKind::corridor_refreshed;
  });
  ASSERT_NE(entered, session.events.end());
  EXPECT_GE(entered->event.value, 1.0);
  double greatest = 0.0;
  for (const TickRecord& record : session.ticks) greatest = std::max(greatest, record.output.resistance);
  EXPECT_GT(greatest, 0.05);
  // The probe, just before the needle came: the hand's spring and the body's own force, found by another way.
  const double time = static_cast<double>(entered->tick) * session.header.dt - 0.1;
  const auto sample = std::find_if(session.second.begin(), session.second.end(),
                                   [time](const SecondSample& one) { return one.time >= time; });
  ASSERT_NE(sample, session.second.end());
  EXPECT_GT(sample->force, 1.0);
  const Vec3 axis = sample->rotation * Vec3::UnitZ();
  Pose probe = Pose::Identity();
  probe.linear() = sample->rotation.toRotationMatrix();
  probe.translation() = sample->position - sample->force / 1.0 * axis;  // 1 N/mm, of the simulated device
  EXPECT_LT(probe.translation().y(), -4.0) << "deep";
  BodySolverSettings at_rest = block.settings;
  at_rest.motion.dt = 0.0;
  DeformableBodySolver reference(*block.body, at_rest);
  for (int step = 0; step < 60; ++step) reference.step(probe, {});
  const double expected = -reference.press().on_probe(reference.body()).force.dot(axis);
  EXPECT_NEAR(sample->force, expected, 0.1 * expected);

  try {
    replay_session(session, block.patient);
    FAIL() << "what another thread did cannot be recomputed";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot be recomputed"));
  }
}

Pose straight_down(double x, double depth) {
  return needle_pose(Vec3(x, -depth, 0.0), -Vec3::UnitY());
}

Pose flat_probe(double x, double depth) {
  Pose pose = Pose::Identity();
  pose.linear().col(0) = Vec3::UnitX();
  pose.linear().col(1) = Vec3::UnitZ();
  pose.linear().col(2) = -Vec3::UnitY();
  pose.translation() = Vec3(x, -depth, 0.0);
  return pose;
}

// The test is the needle's thread, and whoever watches.
struct NeedleInBlock {
  explicit NeedleInBlock(const PressedBlock& made)
      : block(made), pressed(block.patient, *block.body, block.settings), tick(block.patient) {}

  TickOutput step(const Pose& needle) {
    const TickOutput output = tick.step({needle});
    pressed.set_needle(time += tick.dt(), tick.body()->node_forces());
    return output;
  }
  // Goes on until a corridor comes; the pose stays.
  std::optional<PreparedCorridor> wait_for_corridor(const Pose& needle) {
    for (int look = 0; look < 20000; ++look) {
      for (int i = 0; i < 4; ++i) step(needle);
      if (std::optional<PreparedCorridor> corridor = pressed.take_corridor()) return corridor;
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    return {};
  }

  const PressedBlock& block;
  PatientBody pressed;
  HapticTick tick;
  double time = 0.0;
};

TEST(PatientBody, a_needle_that_is_in_feels_that_the_probe_presses_beside_it) {
  const PressedBlock block = pressed_block();
  NeedleInBlock rig(block);
  for (double depth = -2.0; depth < 22.0; depth += 0.05) rig.step(straight_down(-30.0, depth));
  const auto sideways = [&] {  // N by 0.5 mm
    const double before = rig.step(straight_down(-30.0, 22.0)).requested.force.x();
    const double there = rig.step(straight_down(-29.5, 22.0)).requested.force.x();
    rig.step(straight_down(-30.0, 22.0));
    return before - there;
  };
  const double at_rest = sideways();
  ASSERT_GT(at_rest, 0.001);
  rig.pressed.move_probe(flat_probe(-5.0, 14.0));
  const Vec3 force = rig.step(straight_down(-30.0, 22.0)).requested.force;
  bool told = false;
  for (int corridors = 0; corridors < 20 && !told; ++corridors) {
    const std::optional<PreparedCorridor> corridor = rig.wait_for_corridor(straight_down(-30.0, 22.0));
    ASSERT_TRUE(corridor);
    EXPECT_EQ(corridor->body->mesh_nodes, block.patient.corridor.body->mesh_nodes);
    ASSERT_TRUE(rig.tick.body()->refresh_corridor(*corridor));
    for (int i = 0; i < 100; ++i) {
      const TickOutput output = rig.step(straight_down(-30.0, 22.0));
      EXPECT_LT((output.requested.force - force).norm(), 1e-9);
      for (const Event& event : output.events) told = told || event.kind == EventKind::corridor_refreshed;
    }
  }
  EXPECT_TRUE(told);
  EXPECT_GT(std::abs(sideways() - at_rest), 0.02 * at_rest);
  EXPECT_FALSE(rig.pressed.failed());
}

TEST(PatientBody, leads_the_corridor_to_where_the_needle_aims_and_says_so) {
  const PressedBlock block = pressed_block();
  NeedleInBlock rig(block);
  EXPECT_FALSE(rig.pressed.follow(straight_down(-28.0, -10.0), block.patient)) << "that is covered";
  EXPECT_FALSE(rig.pressed.follow(straight_down(200.0, -10.0), block.patient)) << "there is no patient";
  const std::optional<std::string> sentence = rig.pressed.follow(straight_down(30.0, -10.0), block.patient);
  ASSERT_TRUE(sentence);
  EXPECT_THAT(*sentence, HasSubstr("aims where the deformable body is not prepared"));
  EXPECT_FALSE(rig.pressed.follow(straight_down(30.0, -10.0), block.patient)) << "it is said once";
  const std::optional<PreparedCorridor> corridor = rig.wait_for_corridor(straight_down(30.0, -10.0));
  ASSERT_TRUE(corridor);
  EXPECT_THAT(rig.pressed.follow(straight_down(30.0, -10.0), block.patient).value_or(""),
              HasSubstr("is prepared where the needle aimed"));
  EXPECT_NEAR(corridor->path.entry.x(), 30.0, 1e-9);
  for (const Vec3& node : corridor->at_rest) EXPECT_NEAR(node.x(), 30.0, 16.0);
  // As a static body would have it there.
  std::shared_ptr<const ContactBody> kept;
  const PreparedCorridor expected = another_corridor(*block.body, block.patient, corridor->path, 0, kept);
  EXPECT_EQ(corridor->body->mesh_nodes, expected.body->mesh_nodes);
  EXPECT_EQ(corridor->body->tissues, expected.body->tissues);
  EXPECT_EQ(corridor->at_rest, expected.body->nodes);
  EXPECT_LT((corridor->body->compliance - expected.body->compliance).norm(), 1e-9 * expected.body->compliance.norm());
  ASSERT_TRUE(rig.tick.body()->refresh_corridor(*corridor));
  std::uint32_t most = 0;
  for (double depth = -2.0; depth < 12.0; depth += 0.05) {
    const TickOutput output = rig.step(straight_down(30.0, depth));
    for (const Event& event : output.events) EXPECT_NE(event.kind, EventKind::corridor_left);
    most = std::max(most, static_cast<std::uint32_t>(rig.tick.body()->node_forces().count));
  }
  EXPECT_GE(most, 2U);
  // And back, once it is out again.
  EXPECT_THAT(rig.pressed.follow(straight_down(-30.0, -10.0), block.patient).value_or(""), HasSubstr("not prepared"));
}

// The test is the needle here, and does to the body what no needle does.
TEST(PatientBody, when_the_body_fails_the_probe_loses_its_force_and_no_corridor_comes_any_more) {
  const PressedBlock block = pressed_block();
  const auto pressed = std::make_shared<PatientBody>(block.patient, *block.body, block.settings);
  const auto hand =
      probe_hand(block, "speed_mm_s=80 depth_mm=8 lateral_mm=25 wait_s=60", std::make_shared<SecondLink>(), pressed);
  hand->start();
  hand->arm();
  double time = 0.0;
  NodeForces forces;
  const auto comes_true = [&](const auto& condition) {
    for (int look = 0; look < 20000 && !condition(); ++look) {
      pressed->set_needle(time += 0.002, forces);
      std::this_thread::sleep_for(milliseconds(1));
    }
    return condition();
  };
  ASSERT_TRUE(comes_true([&] { return hand->snapshot().force > 1.0; }));
  EXPECT_FALSE(pressed->failed());
  forces.count = 1;
  forces.nodes[0] = {block.patient.corridor.body->mesh_nodes[0], {3e38F, 3e38F, 0.0F}};
  ASSERT_TRUE(comes_true([&] { return pressed->failed(); }));
  EXPECT_TRUE(comes_true([&] { return hand->snapshot().force == 0.0; }));
  EXPECT_FALSE(pressed->take_corridor());
  EXPECT_EQ(hand->servo().tick().snapshot().state, GuardState::active) << "nothing is wrong with the device";
  EXPECT_TRUE(hand->stop());

  // A needle whose body has failed is told so, once, and goes on.
  const ScratchSession scratch;
  SessionHeader header = sample_header();
  header.path = *block.patient.description.procedure.path;
  DevicePort port(simulated_driver(), "", "speed_mm_s=100 depth_mm=5 wait_s=0");
  const DeviceAbilities device = port.abilities();
  ServoSettings servo;
  servo.workspace = workspace_about(header.path);
  HandSession session(std::make_shared<const Case>(block.patient), header, scratch.path(), true, std::move(port),
                      device, servo);
  session.press(pressed);
  session.start();
  arm(session);
  for (int look = 0; look < 2000 && !session.servo().tick().snapshot().device.ended(); ++look)
    std::this_thread::sleep_for(milliseconds(10));
  EXPECT_TRUE(session.finish());
  const Session read = read_session(scratch.path());
  EXPECT_EQ(
      std::count_if(read.events.begin(), read.events.end(),
                    [](const SessionEvent& event) { return event.event.kind == EventKind::moving_body_failed; }),
      1);
  EXPECT_TRUE(std::any_of(read.events.begin(), read.events.end(),
                          [](const SessionEvent& event) { return event.event.kind == EventKind::contact; }));
}

}  // namespace
}  // namespace bodkin
