// A needle that enters beside a pressed probe: the nodes that the probe holds are in the needle's equations.
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
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

// The points of its line are those of a body whose pressed nodes are held, on the planned line too: as stiff as a
// dense solution says (BoundPoints), so stiffer than without the probe.
TEST(PressedLine, a_needle_beside_a_pressed_probe_is_coupled_with_the_nodes_that_it_holds) {
  const PressedBlock block = pressed_block();
  BodyField pressed;
  pressed.moved.assign(3 * block.body->mesh.nodes.size(), 0.0F);
  pressed.held.assign(block.body->mesh.nodes.size(), 0);
  for (std::uint32_t node = 0; node < block.body->mesh.nodes.size(); ++node) {
    const Vec3& at = block.body->mesh.nodes[node];
    if (at.y() > -1e-6 && at.x() > -28.0 && at.x() < 8.0 && std::abs(at.z()) < 18.0)
      pressed.held[pressed.held_count++] = node;
  }
  ASSERT_GT(pressed.held_count, 8U);
  pressed.step = 40;
  pressed.held_since = 10;
  const std::vector<std::uint32_t> held(pressed.held_nodes().begin(), pressed.held_nodes().end());
  const auto motion = std::make_shared<BodyMotion>(pressed);
  HapticTick tick(block.patient), alone(block.patient);
  ASSERT_TRUE(tick.body()->move_with(motion));
  const std::shared_ptr<ContactLine> line = tick.body()->stream_points(false);
  std::shared_ptr<const ContactBody> whole = block.whole;
  const auto stream = contact_stream(*block.body, std::make_shared<const Case>(block.patient), 30.0, whole, line);
  std::vector<double> found, expected;
  bool own = false;
  for (double depth = -6.0; depth < 1.0; depth += 0.02) {
    const TickOutput output = tick.step({straight_down(-30.0, depth)});
    if (depth < 0.0) line->wait_for(ContactLine::most_points);
    for (const Event& event : output.events)
      own = own || (event.kind == EventKind::corridor_taken && event.value == BodyPort::own_line);
    found.push_back(output.resistance);
    expected.push_back(alone.step({straight_down(-30.0, depth)}).resistance);
  }
  EXPECT_TRUE(own) << "the planned line was prepared without the probe";
  EXPECT_EQ(tick.body()->motion_taken(), 40U);
  const auto& settings = std::get<EmbeddedNeedleSettings>(block.patient.description.haptics.resistance);
  // Where the voxels have the skin, exactly on the needle's line.
  const Vec3 entry = line->body().nodes[0];
  EXPECT_LT((entry - Vec3(-30.0, 0.0, 0.0)).norm(), 1e-3);
  const NeedlePath path{entry, entry - 30.0 * Vec3::UnitY()};
  const auto stations = stations_along(path, 30.0, settings.point_spacing, block.patient);
  const CondensedBody bound =
      block.whole->contact_points(stations, path.direction(), settings.tip_radius, 1, block.whole->bind({}, held));
  ASSERT_GE(line->progress().points, 3U);
  for (Eigen::Index i = 0; i < 9; ++i)
    for (Eigen::Index j = 0; j < 9; ++j)
      EXPECT_NEAR(line->body().compliance(i, j), bound.compliance(i, j), 1e-6 * bound.compliance(4, 4));
  const CondensedBody unbound = block.whole->contact_points(stations, path.direction(), settings.tip_radius);
  EXPECT_GT(unbound.compliance(1, 1), 1.01 * bound.compliance(1, 1)) << "along the needle, at the skin";
  ASSERT_GT(expected.back(), 0.01);
  EXPECT_NEAR(found.back() / expected.back(), block.patient.corridor.body->compliance(1, 1) / bound.compliance(1, 1),
              0.001);
}

// While a probe moves it takes and releases nodes in every step; a line is asked for again when it rests, as long as
// the needle is outside.
TEST(PressedLine, a_line_is_asked_for_again_when_the_probe_has_come_to_rest_on_other_nodes) {
  const PressedBlock block = pressed_block();
  BodyField field;
  field.moved.assign(3 * block.body->mesh.nodes.size(), 0.0F);
  field.held.assign(50, 7);
  const auto motion = std::make_shared<BodyMotion>(field);
  HapticTick tick(block.patient);
  ASSERT_TRUE(tick.body()->move_with(motion));
  const std::shared_ptr<ContactLine> line = tick.body()->stream_points(false);
  const auto look = [&](std::uint64_t step, std::size_t count, std::uint64_t since) {
    field.step = step;
    field.held_count = count;
    field.held_since = since;
    motion->write(field);
    for (int i = 0; i < 20; ++i) tick.step({straight_down(-30.0, -10.0)});
  };
  look(1, 0, 0);
  look(5, 3, 5);  // on the planned line, of which nothing is asked for without a probe
  std::optional<ContactLine::Line> asked = line->next_line();
  ASSERT_TRUE(asked.has_value());
  EXPECT_EQ(asked->number, 1U);
  EXPECT_EQ(asked->held_count, 3U);
  look(6, 4, 6);
  look(17, 5, 10);
  look(30, 6, 18);
  asked = line->next_line();
  ASSERT_TRUE(asked.has_value());
  EXPECT_EQ(asked->number, 2U) << "not while it moved";
  EXPECT_EQ(asked->held_count, 6U);
  look(31, 6, 18);
  tick.step({straight_down(-30.0, 0.5)});
  look(60, 7, 32);
  line->close();
  EXPECT_FALSE(line->next_line().has_value());
}

}  // namespace
}  // namespace bodkin
