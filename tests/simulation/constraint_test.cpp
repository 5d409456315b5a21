#include "simulation/constraint.h"

#include <cmath>

#include "tests/simulation/model_pairs.h"
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::simulation;
namespace {

Case body(const ConstraintSettings& settings) {
  return patient_for({"layered", LayeredSettings{}, {}}, {"", settings});
}

TEST(Constraint, forces_at_the_hub_reach_the_tip_with_the_torque_that_they_make) {
  for (const ConstraintSettings& settings :
       {ConstraintSettings(PivotSettings{}), ConstraintSettings(BeamSettings{})}) {
    Case patient = body(settings);
    patient.description.needle.length = 90.0;
    Constraint constraint(patient, 1e-3);
    constraint.begin(Vec3::Zero(), Vec3::UnitZ(), Vec3::Zero());
    const Vec3 axis = Vec3(0.0, std::sin(0.05), std::cos(0.05));
    const Wrench wrench = constraint.step(40.0 * axis, axis, false);
    ASSERT_GT(wrench.force.norm(), 0.0) << name_of(settings);
    // The torque about the hub is zero: M_tip = r x F with r from tip to hub.
    EXPECT_NEAR((wrench.torque - (-90.0 * axis).cross(wrench.force)).norm(), 0.0, 1e-9) << name_of(settings);
    // The hub leans to -y and is pushed back towards +y.
    EXPECT_GT(wrench.force.y(), 0.0) << name_of(settings);
  }
}

TEST(Constraint, a_rail_leaves_the_lateral_force_to_a_resistance_that_has_one) {
  const Case patient = body(RailSettings{});
  Constraint constraint(patient, 1e-3);
  constraint.begin(Vec3::Zero(), Vec3::UnitZ(), Vec3::Zero());
  const Vec3 axis = Vec3(0.1, 0.0, 1.0).normalized();
  const Wrench both = constraint.step(Vec3(2.0, 0.0, 20.0), axis, false);
  const Wrench turning = constraint.step(Vec3(2.0, 0.0, 20.0), axis, true);
  EXPECT_NEAR(both.force.x(), -1.0, 1e-12);
  EXPECT_EQ(turning.force, Vec3(0.0, 0.0, 0.0));
  EXPECT_GT(turning.torque.norm(), 0.0);
  EXPECT_EQ(turning.torque, both.torque);
}

TEST(Constraint, none_lets_the_needle_go_where_it_wants) {
  const Case patient = body(NoConstraint{});
  Constraint constraint(patient, 1e-3);
  constraint.begin(Vec3::Zero(), Vec3::UnitZ(), Vec3::Zero());
  EXPECT_EQ(constraint.step(Vec3(5.0, 5.0, 20.0), Vec3::UnitX(), false).force, Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(constraint.rail(), nullptr);
}

TEST(Constraint, a_spring_that_the_device_cannot_render_is_refused) {
  EXPECT_THROW(Constraint(body(RailSettings{.stiffness = 2.0}), 1e-3), InputError);
  EXPECT_THROW(Constraint(body(BeamSettings{.largest_stiffness = 2.0}), 1e-3), InputError);
}

}  // namespace
}  // namespace bodkin
