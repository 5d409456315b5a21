// A needle enters next to a pressed probe: its equations include the nodes held by the probe.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "patient/prepared_body.h"
#include "tests/station/pressed_block.h"
#include <gtest/gtest.h>

#include "fem/solid/contact_body.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::forces;
using namespace bodkin::patient;
using namespace bodkin::simulation;
namespace {

// A probe that has come to rest over x = -10, on these nodes.
BodyField resting_probe(const PressedBlock& block) {
  BodyField pressed;
  pressed.moved.assign(3 * block.body->mesh.nodes.size(), 0.0F);
  pressed.held.assign(block.body->mesh.nodes.size(), 0);
  for (std::uint32_t node = 0; node < block.body->mesh.nodes.size(); ++node) {
    const Vec3& at = block.body->mesh.nodes[node];
    if (at.y() > -1e-6 && at.x() > -28.0 && at.x() < 8.0 && std::abs(at.z()) < 18.0)
      pressed.held[pressed.held_count++] = node;
  }
  pressed.step = 40;
  pressed.held_since = 10;
  return pressed;
}

// The points of the needle's line, even on the planned line, are those of a body whose pressed nodes are held: as
// stiff as a dense solution says (BoundPoints), and so stiffer than without the probe.
TEST(PressedLine, a_needle_beside_a_pressed_probe_is_coupled_with_the_nodes_that_it_holds) {
  const PressedBlock block = pressed_block();
  const BodyField pressed = resting_probe(block);
  ASSERT_GT(pressed.held_count, 8U);
  const std::vector<std::uint32_t> held(pressed.held_nodes().begin(), pressed.held_nodes().end());
  const auto motion = std::make_shared<BodyMotion>(pressed);
  HapticTick tick(block.patient), alone(block.patient);
  ASSERT_TRUE(tick.body()->move_with(motion));
  const std::shared_ptr<ContactLine> line = tick.body()->stream_points(BodyPort::PointTiming::as_known);
  std::shared_ptr<const ContactBody> whole = block.whole;
  const auto stream = contact_stream(*block.body, std::make_shared<const Case>(block.patient), 30.0, whole, line);
  std::vector<double> found, expected;
  bool own = false;
  for (double depth = -6.0; depth < 1.0; depth += 0.02) {
    const TickOutput output = tick.step({straight_down(-30.0, depth)});
    if (depth < 0.0) line->wait_for(ContactLine::most_points);
    for (const Event& event : output.events)
      own = own || (event.kind == EventKind::line_taken && event.value == BodyPort::own_line);
    found.push_back(output.resistance);
    expected.push_back(alone.step({straight_down(-30.0, depth)}).resistance);
  }
  EXPECT_TRUE(own) << "the planned line was prepared without the probe";
  EXPECT_EQ(tick.body()->applied_motion_step(), 40U);
  const auto& settings = std::get<EmbeddedNeedleSettings>(block.patient.description.haptics.resistance);
  // Where the needle's line meets the skin of the voxels.
  const Vec3 entry = line->body().nodes[0];
  EXPECT_LT((entry - Vec3(-30.0, 0.0, 0.0)).norm(), 1e-3);
  const NeedlePath path{entry, entry - 30.0 * Vec3::UnitY()};
  const auto sites = contact_sites_along(path, 30.0, settings.point_spacing, block.patient);
  const CondensedBody bound =
      block.whole->contact_points(sites, path.direction(), settings.tip_radius, 1, block.whole->bind({}, held));
  ASSERT_GE(line->progress().points, 3U);
  for (Eigen::Index i = 0; i < 9; ++i)
    for (Eigen::Index j = 0; j < 9; ++j)
      EXPECT_NEAR(line->body().compliance(i, j), bound.compliance(i, j), 1e-6 * bound.compliance(4, 4));
  const CondensedBody unbound = block.whole->contact_points(sites, path.direction(), settings.tip_radius);
  EXPECT_GT(unbound.compliance(1, 1), 1.01 * bound.compliance(1, 1)) << "along the needle, at the skin";
  ASSERT_GT(expected.back(), 0.01);
  EXPECT_NEAR(found.back() / expected.back(), block.patient.prepared.body->compliance(1, 1) / bound.compliance(1, 1),
              0.001);
}

// The needle's effect on the probe, tick by tick.
struct PushesOnProbe {
  std::vector<double> numbers;             // force and torque
  std::vector<std::pair<int, double>> at;  // ticks in which points were taken, with the event's value
  double greatest = 0.0;                   // N
};

PushesOnProbe push_beside_probe(const PressedBlock& block, const PushesOnProbe* recorded) {
  const auto motion = std::make_shared<BodyMotion>(resting_probe(block));
  HapticTick tick(block.patient);
  EXPECT_TRUE(tick.body()->move_with(motion));
  const std::shared_ptr<ContactLine> line = tick.body()->stream_points(
      recorded == nullptr ? BodyPort::PointTiming::as_known : BodyPort::PointTiming::as_recorded);
  std::shared_ptr<const ContactBody> whole = block.whole;
  const auto stream = contact_stream(*block.body, std::make_shared<const Case>(block.patient), 30.0, whole, line);
  PushesOnProbe found;
  const auto step = [&](int number, double depth, double aside) {
    if (recorded != nullptr)
      for (const auto& [at, value] : recorded->at)
        if (at == number) tick.body()->set_recorded_points(value);
    Pose needle = straight_down(-30.0, depth);
    needle.translation().x() += aside;
    for (const Event& event : tick.step({needle}).events)
      if (event.kind == EventKind::points_taken) found.at.emplace_back(number, event.value);
    if (recorded == nullptr && depth < 0.0 && number < 300) line->wait_for(3);  // the others arrive at any time
    const Wrench on_held = tick.body()->on_held();
    found.greatest = std::max(found.greatest, on_held.force.norm());
    for (const Vec3& part : {on_held.force, on_held.torque})
      found.numbers.insert(found.numbers.end(), {part.x(), part.y(), part.z()});
  };
  int number = 0;
  for (double depth = -6.0; depth < 20.0; depth += 0.02) step(++number, depth, 0.0);
  for (double aside = 0.0; aside < 1.0; aside += 0.01) step(++number, 20.0, aside);
  for (double depth = 20.0; depth > -3.0; depth -= 0.05) step(++number, depth, 1.0);
  return found;
}

// The probe feels the needle, which is pushed in and then towards it, only while it is inserted; a replay gives the
// same bits.
TEST(PressedLine, a_probe_feels_the_needle_and_replays_to_the_bit) {
  const PressedBlock block = pressed_block();
  const PushesOnProbe first = push_beside_probe(block, nullptr), again = push_beside_probe(block, &first);
  EXPECT_GT(first.greatest, 0.02);
  ASSERT_FALSE(first.at.empty());
  EXPECT_EQ(first.at, again.at);
  EXPECT_EQ(first.numbers, again.numbers);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(first.numbers[i], 0.0) << "before contact";
    EXPECT_EQ(first.numbers[first.numbers.size() - 1 - i], 0.0) << "withdrawn";
  }
}

// A probe that comes down while the needle is inserted, and is lifted again.
struct LateProbe {
  std::vector<double> numbers;                       // forces on hand and probe
  std::vector<std::pair<int, Event>> events;         // of points, by tick
  std::vector<double> held_at;                       // nodes, of each coupling
  double before = 0.0, pressed = 0.0, lifted = 0.0;  // N on the probe, needle held to one side
};

LateProbe press_while_the_needle_is_in(const PressedBlock& block, const LateProbe* recorded) {
  const BodyField resting = resting_probe(block);
  BodyField field = resting;
  field.held_count = 0;
  field.step = field.held_since = 1;
  const auto motion = std::make_shared<BodyMotion>(field);
  HapticTick tick(block.patient);
  EXPECT_TRUE(tick.body()->move_with(motion));
  const std::shared_ptr<ContactLine> line = tick.body()->stream_points(
      recorded == nullptr ? BodyPort::PointTiming::as_known : BodyPort::PointTiming::as_recorded);
  std::shared_ptr<const ContactBody> whole = block.whole;
  const auto stream = contact_stream(*block.body, std::make_shared<const Case>(block.patient), 30.0, whole, line);
  LateProbe found;
  int number = 0;
  const auto step = [&](double depth, double aside) {
    ++number;
    if (recorded == nullptr && depth < 0.0 && number < 300) line->wait_for(ContactLine::most_points);
    if (recorded != nullptr) {
      for (const auto& [at, event] : recorded->events) {
        if (at != number) continue;
        if (event.kind == EventKind::points_taken)
          tick.body()->set_recorded_points(event.value);
        else
          tick.body()->set_recorded_coupling();
      }
    }
    Pose needle = straight_down(-30.0, depth);
    needle.translation().x() += aside;
    const TickOutput output = tick.step({needle});
    for (const Event& event : output.events) {
      if (event.kind == EventKind::points_taken || event.kind == EventKind::points_coupled)
        found.events.emplace_back(number, event);
      if (event.kind == EventKind::points_coupled) found.held_at.push_back(event.value);
    }
    const Wrench on_held = tick.body()->on_held();
    for (const Vec3& part : {output.requested.force, output.requested.torque, on_held.force, on_held.torque})
      found.numbers.insert(found.numbers.end(), {part.x(), part.y(), part.z()});
    return on_held.force.norm();
  };
  // The field has a probe long at rest; the tick requests points in this step, and they arrive before the next.
  const auto probe_comes_to_rest_on = [&](std::size_t held) {
    field.held_count = held;
    field.held_since = field.step + 1;
    field.step += 60;
    motion->write(field);
    step(12.0, 0.5);
    if (recorded == nullptr) {
      EXPECT_TRUE(line->wait_until_coupled());
    }
    double on_probe = 0.0;
    for (int i = 0; i < 300; ++i) on_probe = step(12.0, 0.5);
    return on_probe;
  };
  for (double depth = -6.0; depth < 12.0; depth += 0.02) step(depth, 0.0);
  for (double aside = 0.0; aside < 0.5; aside += 0.01) found.before = step(12.0, aside);
  found.pressed = probe_comes_to_rest_on(resting.held_count);
  found.lifted = probe_comes_to_rest_on(0);
  for (double depth = 12.0; depth > -3.0; depth -= 0.05) step(depth, 0.5);
  return found;
}

TEST(PressedLine, a_needle_in_the_body_is_coupled_with_a_probe_that_comes_later) {
  const PressedBlock block = pressed_block();
  const LateProbe first = press_while_the_needle_is_in(block, nullptr);
  EXPECT_EQ(first.held_at, (std::vector<double>{static_cast<double>(resting_probe(block).held_count), 0.0}));
  EXPECT_EQ(first.before, 0.0);
  EXPECT_GT(first.pressed, 0.001);
  EXPECT_EQ(first.lifted, 0.0);
  const LateProbe again = press_while_the_needle_is_in(block, &first);
  EXPECT_EQ(first.numbers, again.numbers);
  ASSERT_EQ(first.events.size(), again.events.size());
  for (std::size_t i = 0; i < first.events.size(); ++i) EXPECT_EQ(first.events[i].first, again.events[i].first) << i;
}

// A moving probe takes and releases nodes in every step; a line is requested again when the probe rests, as long as
// the needle is outside.
TEST(PressedLine, a_line_is_asked_for_again_when_the_probe_has_come_to_rest_on_other_nodes) {
  const PressedBlock block = pressed_block();
  BodyField field;
  field.moved.assign(3 * block.body->mesh.nodes.size(), 0.0F);
  field.held.assign(50, 7);
  const auto motion = std::make_shared<BodyMotion>(field);
  HapticTick tick(block.patient);
  ASSERT_TRUE(tick.body()->move_with(motion));
  const std::shared_ptr<ContactLine> line = tick.body()->stream_points(BodyPort::PointTiming::as_known);
  const auto look = [&](std::uint64_t step, std::size_t count, std::uint64_t since) {
    field.step = step;
    field.held_count = count;
    field.held_since = since;
    motion->write(field);
    for (int i = 0; i < 20; ++i) tick.step({straight_down(-30.0, -10.0)});
  };
  look(1, 0, 0);
  look(5, 3, 5);  // on the planned line, which was requested first
  std::optional<ContactLine::Line> asked = line->next_line();
  ASSERT_TRUE(asked.has_value());
  EXPECT_EQ(asked->number, 2U);
  EXPECT_EQ(asked->held_count, 3U);
  look(6, 4, 6);
  look(17, 5, 10);
  look(30, 6, 18);
  asked = line->next_line();
  ASSERT_TRUE(asked.has_value());
  EXPECT_EQ(asked->number, 3U) << "not while it moved";
  EXPECT_EQ(asked->held_count, 6U);
  look(31, 6, 18);
  tick.step({straight_down(-30.0, 0.5)});
  look(60, 7, 32);
  line->close();
  EXPECT_FALSE(line->next_line().has_value());
}

}  // namespace
}  // namespace bodkin
