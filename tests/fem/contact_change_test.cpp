#include "tests/fem/needle_rig.h"
#include <gtest/gtest.h>

#include "fem/closest_node.h"
#include "fem/contact_numbers.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

TEST(ContactChange, goes_over_in_equal_steps_and_ends_exactly) {
  ContactNumbers from, to;
  from.tissues[tissue::soft] = {.friction = 0.1, .puncture_force = 2.0, .stiffness = 4.0};
  to.tissues[tissue::soft] = {.friction = 0.3, .puncture_force = 1.0, .stiffness = 8.0};
  to.capture_radius = 2.5;
  ContactChange change;
  EXPECT_FALSE(change.is_active());
  change.begin(from, to, 4);
  EXPECT_DOUBLE_EQ(change.next().tissues[tissue::soft].friction, 0.15);
  const ContactNumbers half = change.next();
  EXPECT_DOUBLE_EQ(half.tissues[tissue::soft].puncture_force, 1.5);
  EXPECT_DOUBLE_EQ(half.tissues[tissue::soft].stiffness, 6.0);
  EXPECT_DOUBLE_EQ(half.capture_radius, 2.0);
  change.next();
  EXPECT_TRUE(change.is_active());
  EXPECT_EQ(change.next().tissues[tissue::soft].friction, 0.3);
  EXPECT_FALSE(change.is_active());
  change.begin(to, from, 100);
  EXPECT_EQ(change.last().tissues[tissue::soft].friction, 0.1);
  EXPECT_FALSE(change.is_active());
}

// 25 mm of shaft rub with 0.02 N/mm, and then with 0.05 N/mm.
TEST(ContactChange, a_sliding_shaft_rubs_with_the_new_friction) {
  const CondensedBody body = checks::kelvin_body(1, 31, 1.0, 20.0);
  checks::NeedleRig rig(body, checks::plain_tissues(0.02));
  rig.move(25.0, 10.0);
  EXPECT_NEAR(rig.force.resistance, 0.5, 1e-9);
  ContactNumbers numbers = rig.model.numbers();
  EXPECT_EQ(numbers.tissues[tissue::soft].friction, 0.02);
  EXPECT_EQ(numbers.capture_radius, checks::narrow_settings().capture_radius);
  numbers.tissues = checks::plain_tissues(0.05);
  rig.model.set_numbers(numbers);
  EXPECT_NEAR(rig.force.resistance, 0.5, 1e-9) << "nothing is felt before the next tick";
  rig.move(25.4, 10.0);
  EXPECT_NEAR(rig.force.resistance, 0.05 * 25.4, 1e-6);
  numbers.tissues = checks::plain_tissues(0.01);
  rig.model.set_numbers(numbers);
  rig.move(25.6, 10.0);
  EXPECT_NEAR(rig.force.resistance, 0.01 * 25.6, 1e-6);
}

TEST(ContactChange, tissue_gives_way_at_the_new_force) {
  const CondensedBody body = checks::kelvin_body(1, 31, 1.0, 0.05);
  ContactTissues tissues = checks::plain_tissues(0.0);
  tissues[tissue::soft].puncture_force = 1.5;
  checks::NeedleRig rig(body, tissues);
  double depth = 0.0;
  while (rig.force.resistance < 0.6 && depth < 50.0) rig.to(depth += 0.01);
  ASSERT_FALSE(rig.force.puncture);
  ContactNumbers numbers = rig.model.numbers();
  numbers.tissues[tissue::soft].puncture_force = 0.9;
  rig.model.set_numbers(numbers);
  while (!rig.force.puncture && depth < 50.0) rig.to(depth += 0.01);
  ASSERT_TRUE(rig.force.puncture.has_value());
  EXPECT_NEAR(rig.force.puncture->force, 0.9, 0.02);
}

// The friction of the layers passed by the shaft is summed anew.
TEST(ContactChange, the_shaft_behind_the_closest_node_rubs_with_the_new_friction) {
  const CondensedBody body = checks::kelvin_body(3, 31, 1.0, 1.0);
  ContactTissues tissues = checks::plain_tissues(0.02);
  ClosestNodeSettings settings;
  ClosestNodeContact contact(body, tissues, settings, 1e-3);
  contact.begin(Vec3::Zero(), Vec3::UnitZ());
  ClosestNodeForce force;
  const auto push = [&](double from, double to) {
    for (double at = from; at < to; at += 0.01) force = contact.step(Vec3(0.0, 0.0, at));
  };
  push(-1.0, 20.0);
  const double before = force.friction;
  ContactNumbers numbers = contact.numbers();
  EXPECT_EQ(numbers.time, settings.relaxation);
  numbers.tissues = checks::plain_tissues(0.04);
  contact.set_numbers(numbers);
  push(20.0, 22.0);
  EXPECT_NEAR(before, 0.02 * 20.0, 0.02);
  EXPECT_NEAR(force.friction, 0.04 * 22.0, 0.04);
}

}  // namespace
}  // namespace bodkin
