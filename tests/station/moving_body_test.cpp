// A body that moves on its own thread between two hands: the probe presses it, and it takes the needle along.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <thread>

#include "patient/prepared_body.h"
#include "session/body_displacement.h"
#include "session/case_digest.h"
#include "session/replay.h"
#include "station/hand_session.h"
#include "station/released_needle.h"
#include "station/second_hand.h"
#include "tests/session/session_samples.h"
#include "tests/station/pressed_block.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fem/moving/body_thread.h"
#include "fem/solid/contact_body.h"
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

std::unique_ptr<SecondHand> probe_hand(const PressedBlock& block, const std::string& settings,
                                       const std::shared_ptr<SecondLink>& link,
                                       const std::shared_ptr<BodyThread>& pressed) {
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

// A simulated hand that stays at its place until the gate opens. The hands have threads of their own, so without the
// gate the load of the computer would decide which hand comes first.
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

// Whether the probe's force has stayed the same, except for the hand's tremor, for 500 rounds of its hand and 100
// steps of the body.
class Settled {
 public:
  bool look(SecondHand& hand, BodyThread& body) {
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

// The probe presses 12 mm at x = 5, 35 mm from the needle; then the needle enters.
Session perform_on(const PressedBlock& block, const std::filesystem::path& file) {
  const auto pressed = std::make_shared<BodyThread>(*block.body, block.settings);
  SessionHeader header = sample_header();
  header.path = *block.patient.description.procedure.path;
  header.haptics = block.patient.description.haptics;
  header.second = SecondHeader{SecondRole::probe, "{}"};
  header.moving_body = moving_body_text(block.settings, block.body->mesh.nodes.size());
  header.left_needles = block.settings.left_needles;
  header.body_digest = digest_of_body(block.patient);
  const auto link = std::make_shared<SecondLink>();
  gate_is_open = false;
  DevicePort port(gated_driver(), "", "speed_mm_s=15 start_mm=20 depth_mm=15 wait_s=0.3");
  const DeviceAbilities device = port.abilities();
  ServoSettings servo;
  servo.workspace = workspace_about(header.path);
  HandSession session(std::make_shared<const Case>(block.patient), header, file, true, std::move(port), device, servo,
                      link);
  const auto second = probe_hand(block, "speed_mm_s=40 depth_mm=12 lateral_mm=25 wait_s=600", link, pressed);
  session.move_with(pressed);
  std::shared_ptr<const ContactBody> whole = block.whole;
  const auto stream =
      contact_stream(*block.body, std::make_shared<const Case>(block.patient), header.path.length(), whole,
                     session.body()->stream_points(simulation::BodyPort::PointTiming::as_known));
  second->start();
  session.start();
  arm(session);
  second->arm();
  Settled settled;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(240);  // reached only when the test fails
  while (!session.servo().tick().snapshot().device.ended() && std::chrono::steady_clock::now() < end) {
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

std::string refusal_of_replay(const Session& session, const PressedBlock& block, const BodyDescription* body) {
  try {
    replay_session(session, block.patient, {}, body);
  } catch (const InputError& refused) {
    return refused.what();
  }
  return "it was replayed";
}

// To the bit, though the body moved on a thread of its own; missing or altered steps are detected.
void expect_replay_of_moved_body(const Session& session, const PressedBlock& block) {
  const BodyDescription* const body = block.body.get();
  const ReplayResult same = replay_session(session, block.patient, {}, body);
  EXPECT_FALSE(same.difference) << same.difference->field << " at tick " << same.difference->tick;
  EXPECT_EQ(same.ticks, session.ticks.size());
  EXPECT_EQ(same.body_difference, "");
  ASSERT_GT(session.applied_body_steps.size(), 10U);

  // The first body that the needle takes at or after its greatest resistance: altering that body changes the forces.
  const auto deepest = std::max_element(
      session.ticks.begin(), session.ticks.end(),
      [](const TickRecord& a, const TickRecord& b) { return a.output.resistance < b.output.resistance; });
  const auto inside = std::find_if(session.applied_body_steps.begin(), session.applied_body_steps.end(),
                                   [&](const AppliedBodyStep& applied) { return applied.tick >= deepest->tick; });
  ASSERT_NE(inside, session.applied_body_steps.end());

  Session altered = session;
  ASSERT_TRUE(altered.body_steps[inside->step - 1].probe.has_value());
  altered.body_steps[inside->step - 1].probe->translation().y() -= 0.5;
  const ReplayResult pressed_deeper = replay_session(altered, block.patient, {}, body);
  EXPECT_TRUE(pressed_deeper.difference.has_value());
  EXPECT_THAT(pressed_deeper.body_difference, HasSubstr("step " + std::to_string(inside->step)));

  altered = session;
  altered.applied_body_steps[static_cast<std::size_t>(inside - session.applied_body_steps.begin())].tick += 1;
  EXPECT_TRUE(replay_session(altered, block.patient, {}, body).difference.has_value()) << "met one tick later";

  EXPECT_THAT(refusal_of_replay(session, block, nullptr), HasSubstr("no deformable body"));
  altered = session;
  altered.header.left_needles[0].target.y() += 4.0;
  EXPECT_THAT(replay_session(altered, block.patient, {}, body).body_difference, HasSubstr("step"))
      << "a needle that was left is part of the body that moves";
  altered = session;
  altered.body_steps.erase(altered.body_steps.begin() + 3);
  EXPECT_THAT(refusal_of_replay(altered, block, body), HasSubstr("not every step was kept"));
  altered.body_steps.clear();
  altered.applied_body_steps.clear();
  EXPECT_THAT(refusal_of_replay(altered, block, body), HasSubstr("not every step was kept"));
}

TEST(MovingBody, the_probes_hand_feels_the_bodys_force_and_the_needle_enters_it_as_it_is_moved) {
  const ScratchSession scratch;
  PressedBlock block = pressed_block();
  block.settings.left_needles = block.patient.left_needles = {{Vec3(7.0, 0.0, 3.0), Vec3(2.0, -28.0, 0.0)}};
  const Session session = perform_on(block, scratch.path());
  EXPECT_THAT(session.header.moving_body, HasSubstr("\"left_needles\":1"));
  EXPECT_THAT(session.header.moving_body, HasSubstr("\"nodes\":702,\"width_mm\":35.0"));
  const auto entered = std::find_if(session.events.begin(), session.events.end(), [](const SessionEvent& event) {
    return event.event.kind == EventKind::moving_body_met;
  });
  ASSERT_NE(entered, session.events.end());
  EXPECT_GE(entered->event.value, 1.0);
  double greatest = 0.0;
  for (const TickRecord& record : session.ticks) greatest = std::max(greatest, record.output.resistance);
  EXPECT_GT(greatest, 0.05);
  // The probe, just before the needle came: the hand's spring against the body's force, computed independently.
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
  for (int step = 0; step < 60; ++step) reference.step(probe);
  const double expected = -reference.press().on_probe(reference.body()).force.dot(axis);
  EXPECT_NEAR(sample->force, expected, 0.1 * expected);

  expect_replay_of_moved_body(session, block);
}

// The tissue at the needle is moved by `by` mm: all nodes of the block by the same vector.
std::vector<float> moved_alike(const PressedBlock& block, const Vec3& by) {
  std::vector<float> moved;
  for (std::size_t node = 0; node < block.body->mesh.nodes.size(); ++node)
    for (Eigen::Index axis = 0; axis < 3; ++axis) moved.push_back(static_cast<float>(by[axis]));
  return moved;
}

// Tissue that moves aside as a whole drags a held needle: the force is that on a needle moved the opposite way in
// tissue at rest.
TEST(MovingBody, tissue_that_moves_aside_takes_the_needle_along) {
  const PressedBlock block = pressed_block();
  HapticTick moved(block.patient), aside(block.patient);
  const auto motion = std::make_shared<BodyMotion>();
  ASSERT_TRUE(moved.body()->move_with(motion));
  for (double depth = -2.0; depth < 24.0; depth += 0.05) {
    const TickInput input{straight_down(-30.0, depth)};
    ASSERT_EQ(moved.step(input).resistance, aside.step(input).resistance) << "nothing moves yet";
  }
  motion->write({1, moved_alike(block, Vec3(0.5, 0.0, 0.0))});
  Vec3 found = Vec3::Zero(), expected = Vec3::Zero(),
       before = moved.step({straight_down(-30.0, 24.0)}).requested.force;
  double largest = 0.0;
  int told = 0;
  for (int tick = 0; tick < 400; ++tick) {
    const TickOutput output = moved.step({straight_down(-30.0, 24.0)});
    found = output.requested.force;
    largest = std::max(largest, (found - before).norm());
    before = found;
    for (const Event& event : output.events) told += event.kind == EventKind::moving_body_met ? 1 : 0;
    expected = aside.step({straight_down(-30.0 - 0.5 * std::min(1.0, 0.01 * tick), 24.0)}).requested.force;
  }
  EXPECT_LE(told, 1);
  EXPECT_GT(expected.x(), 0.01);
  EXPECT_NEAR(found.x(), expected.x(), 0.02 * expected.x());
  EXPECT_LT(largest, 0.1 * expected.x() + 0.005) << "it goes there gradually";
  // Back to rest, as when the body has failed. Tissue that has begun to slide stays at its new place.
  motion->write({});
  Vec3 back = Vec3::Zero();
  for (int tick = 0; tick < 400; ++tick) {
    found = moved.step({straight_down(-30.0, 24.0)}).requested.force;
    back = aside.step({straight_down(-30.5 + 0.5 * std::min(1.0, 0.01 * tick), 24.0)}).requested.force;
  }
  EXPECT_NEAR(found.x(), back.x(), 0.05 * expected.x());
}

// A released needle moves with the tissue; no force acts between them.
TEST(MovingBody, a_needle_that_was_let_go_goes_with_the_tissue) {
  const PressedBlock block = pressed_block();
  HapticTick tick(block.patient);
  const auto motion = std::make_shared<BodyMotion>();
  ASSERT_TRUE(tick.body()->move_with(motion));
  Pose needle = Pose::Identity();
  for (double depth = -2.0; depth < 24.0; depth += 0.05) tick.step({needle = straight_down(-30.0, depth)});
  const Pose held = needle;
  const TickOutput before = tick.step({needle});
  EXPECT_EQ(tick.body()->tissue_motion().matrix(), Pose::Identity().matrix());
  const Vec3 by(0.5, -2.0, 0.3);
  ReleasedNeedle released;
  EXPECT_EQ(released.step(true, needle, tick.body()->tissue_motion()).by, Vec3::Zero());
  motion->write({1, moved_alike(block, by)});
  Vec3 force = before.requested.force;
  for (int i = 0; i < 400; ++i) {
    force = tick.step({needle}).requested.force;
    needle.translation() += released.step(true, needle, tick.body()->tissue_motion()).by;
    // The body jumps by 0.1 mm in the first tick; the needle follows in the next.
    ASSERT_LT((force - before.requested.force).norm(), 0.1) << i;
  }
  EXPECT_LT((force - before.requested.force).norm(), 0.01);
  EXPECT_LT((needle.translation() - held.translation() - by).norm(), 1e-4);
  EXPECT_LT((tick.body()->tissue_motion().translation() - by).norm(), 1e-4);
  EXPECT_LT((tick.body()->tissue_motion().linear() - Mat3::Identity()).norm(), 1e-6);
  // A hand that takes it holds it in its present place.
  Pose elsewhere = Pose::Identity();
  elsewhere.translation() = Vec3(9.0, 9.0, 9.0);
  EXPECT_EQ(released.step(false, needle, elsewhere).by, Vec3::Zero());
  EXPECT_LT(released.step(true, needle, elsewhere).by.norm(), 1e-12);
}

// When the tissue is pressed down by 3 mm, skin contact and every puncture come 3 mm deeper.
TEST(MovingBody, a_surface_that_is_pressed_deeper_is_met_deeper) {
  const PressedBlock block = pressed_block();
  HapticTick pressed(block.patient), rest(block.patient);
  const auto motion = std::make_shared<BodyMotion>(BodyField{1, moved_alike(block, Vec3(0.0, -3.0, 0.0))});
  ASSERT_TRUE(pressed.body()->move_with(motion));
  double greatest = 0.0;
  int told = 0;
  std::vector<double> found, expected;
  for (double depth = -4.0; depth < 15.0; depth += 0.05) {
    const TickOutput output = pressed.step({straight_down(-30.0, depth + 3.0)});
    found.push_back(output.resistance);
    for (const Event& event : output.events) told += event.kind == EventKind::moving_body_met ? 1 : 0;
    expected.push_back(rest.step({straight_down(-30.0, depth)}).resistance);
    greatest = std::max(greatest, expected.back());
  }
  EXPECT_EQ(told, 1);
  EXPECT_GT(greatest, 0.1);
  int apart = 0;  // except in single ticks with a puncture or a contact
  for (std::size_t i = 0; i < found.size(); ++i) apart += std::abs(found[i] - expected[i]) > 0.05 * greatest ? 1 : 0;
  EXPECT_LE(apart, 8);
}

TEST(MovingBody, when_the_body_fails_the_needle_is_told_so_and_meets_it_at_rest) {
  const PressedBlock block = pressed_block();
  const auto pressed = std::make_shared<BodyThread>(*block.body, block.settings);
  Pose probe = Pose::Identity();
  probe.linear().col(0) = Vec3::UnitX();
  probe.linear().col(1) = Vec3::UnitZ();
  probe.linear().col(2) = -Vec3::UnitY();
  probe.translation() = Vec3(0.0, -8.0, 0.0);
  double time = 0.0;
  const auto comes_true = [&](const auto& condition) {
    for (int look = 0; look < 20000 && !condition(); ++look) {
      pressed->set_time(time += 0.002);
      std::this_thread::sleep_for(milliseconds(1));
    }
    return condition();
  };
  pressed->move_probe(probe);
  ASSERT_TRUE(comes_true([&] { return pressed->reading().nodes > 0; }));
  EXPECT_FALSE(pressed->failed());
  probe.translation().y() = -5e4;  // 50 m: beyond any hand
  pressed->move_probe(probe);
  ASSERT_TRUE(comes_true([&] { return pressed->failed(); }));

  // A failed body is reported to the needle once; the needle continues.
  const ScratchSession scratch;
  SessionHeader header = sample_header();
  header.path = *block.patient.description.procedure.path;
  DevicePort port(simulated_driver(), "", "speed_mm_s=100 depth_mm=5 wait_s=0");
  const DeviceAbilities device = port.abilities();
  ServoSettings servo;
  servo.workspace = workspace_about(header.path);
  HandSession session(std::make_shared<const Case>(block.patient), header, scratch.path(), true, std::move(port),
                      device, servo);
  session.move_with(pressed);
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
