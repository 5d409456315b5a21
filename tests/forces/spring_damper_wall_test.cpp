#include "forces/spring_damper_wall.h"

#include "tests/forces/model_checks.h"

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

double wall_force(double depth, double velocity) {
  SpringDamperWall wall({.stiffness = 0.5, .damping = 0.002});
  TickEvents events;
  return wall.step({depth, velocity, velocity > 0 ? 1 : -1, false}, tissue::muscle, events);
}

auto make() {
  return [wall = SpringDamperWall({})](const AxialMotion& motion) mutable {
    TickEvents events;
    return wall.step(motion, tissue::muscle, events);
  };
}

TEST(SpringDamperWall, pushes_in_proportion_to_depth_and_speed) {
  EXPECT_DOUBLE_EQ(wall_force(2.0, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(wall_force(2.0, 10.0), 1.02);
  EXPECT_DOUBLE_EQ(wall_force(12.0, 0.0), 6.0);  // six times the 1 N wanted in a layer of 12 mm
}

TEST(SpringDamperWall, is_nothing_in_front_of_the_wall) {
  EXPECT_EQ(wall_force(-1.0, 50.0), 0.0);
  SpringDamperWallSettings settings;
  settings.wall = 2.0;
  settings.damping = 0.02;
  SpringDamperWall deep(settings);
  TickEvents events;
  EXPECT_EQ(deep.step({1.0, 90.0, 1, false}, tissue::muscle, events), 0.0);
}

TEST(SpringDamperWall, steps_by_the_damping_when_entered_at_speed) {
  EXPECT_DOUBLE_EQ(wall_force(0.0, 10.0), 0.02);
}

TEST(SpringDamperWall, never_pulls_the_hand_in) {
  EXPECT_EQ(wall_force(1.0, -300.0), 0.0);  // the printed form gives -0.1 N
}

TEST(SpringDamperWall, has_the_properties_of_every_model) {
  checks::finite_on_any_input([] { return make(); });
  // With damping the trapezium rule sees the step B v at the wall; the work is still never negative.
  checks::passive_on_random_closed_paths([] { return make(); }, 40.0, 50.0, 2.0);
  checks::same_bits_on_repetition([] { return make(); }, 40.0);
  checks::bounded_when_saturated([] { return make(); }, 8.5);
  checks::no_growth_under_reversal_at_every_tick([] { return make(); }, 5.0);
  checks::steady_force_is_the_same_at_half_the_tick([](double) { return make(); }, 5.0, 10.0, 1e-9);
}

TEST(SpringDamperWall, reports_a_motion_that_is_not_one) {
  SpringDamperWall wall({});
  TickEvents events;
  EXPECT_EQ(wall.step({NAN, 0.0, 0, true}, tissue::muscle, events), 0.0);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events.begin()->kind, EventKind::fault);
}

TEST(SpringDamperWall, refuses_settings_outside_their_ranges_by_name) {
  EXPECT_THROW(SpringDamperWall({.stiffness = -1.0}), InputError);
  EXPECT_THROW(SpringDamperWall({.damping = NAN}), InputError);
  try {
    SpringDamperWall wall({.limit = 0.0});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("spring_damper_wall: limit_N is 0 N, expected"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace bodkin
