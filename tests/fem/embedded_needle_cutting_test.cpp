// A layer with a cutting force.
#include "tests/fem/needle_rig.h"
#include "tests/sanitized.h"
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using checks::NeedleRig;

constexpr double near_side = 5.0, far_side = 10.0;  // mm, of the layer
constexpr double puncture = 2.0, cutting = 1.5;     // N
constexpr double rubs = 0.02;                       // N/mm

// Points 1 mm apart; a ligament between 5 and 10 mm.
CondensedBody layered_body(double young) {
  CondensedBody body = checks::kelvin_body(1, 31, 1.0, young);
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const double depth = body.nodes[i].z();
    if (depth > near_side - 0.5 && depth < far_side - 0.5) body.tissues[i] = tissue::ligamentum_flavum;
  }
  return body;
}

const CondensedBody& firm_layers() {
  static const CondensedBody body = layered_body(20.0);
  return body;
}

// 2 N indent its border by some mm.
const CondensedBody& soft_layers() {
  static const CondensedBody body = layered_body(0.2);
  return body;
}

ContactTissues cut_tissues(double friction = rubs) {
  ContactTissues tissues = checks::plain_tissues(friction);
  tissues[tissue::ligamentum_flavum].puncture_force = puncture;
  tissues[tissue::ligamentum_flavum].cutting_force = cutting;
  return tissues;
}

TEST(EmbeddedNeedleCutting, the_tip_cuts_on_at_its_force_until_it_leaves_the_layer) {
  NeedleRig rig(firm_layers(), cut_tissues());
  rig.move(near_side - 0.1, 10.0);
  EXPECT_NEAR(rig.force.resistance, rubs * (near_side - 0.1), 1e-6);
  EXPECT_NEAR(rig.force.tip_force, 0.0, 1e-9);
  double own = 0.0;
  for (double depth = near_side - 0.1; depth < near_side + 0.5; depth += 0.01) {
    rig.to(depth);
    if (rig.force.puncture) own = rig.force.puncture->force;
    if (own > 0.0) {
      ASSERT_LT(rig.force.resistance, own + rubs * depth + 1e-6) << depth;
    }
  }
  EXPECT_GE(own, puncture);
  EXPECT_LT(own, puncture + 0.5);
  for (double depth = near_side + 0.5; depth < far_side - 0.2; depth += 0.01) {
    rig.to(depth);
    ASSERT_NEAR(rig.force.resistance, rubs * depth + cutting, 0.05) << depth;
    ASSERT_NEAR(rig.force.tip_force, cutting, 0.05) << depth;
    ASSERT_EQ(rig.force.inside, tissue::ligamentum_flavum) << depth;
  }
  // At 10 mm/s the force fades within 0.03 s.
  rig.move(far_side + 0.5, 10.0);
  EXPECT_NEAR(rig.force.resistance, rubs * (far_side + 0.5), 1e-3);
  EXPECT_EQ(rig.force.inside, tissue::soft);
}

TEST(EmbeddedNeedleCutting, what_has_been_cut_is_open_and_what_lies_deeper_is_not) {
  NeedleRig rig(firm_layers(), cut_tissues());
  rig.move(8.0, 10.0);
  rig.move(6.0, 10.0);
  EXPECT_NEAR(rig.force.resistance, -rubs * 6.0, 1e-3);
  rig.move(6.02, 0.02);  // slowly: tissue of 400 N/mm closes on the shaft
  double most = 0.0;
  for (double depth = 6.02; depth < 7.9; depth += 0.01) most = std::max(most, rig.to(depth).resistance);
  EXPECT_LT(most, rubs * 7.9 + 0.01);
  rig.move(8.3, 10.0);
  EXPECT_NEAR(rig.force.resistance, rubs * 8.3 + cutting, 0.05);
  // All the way out and in again, and in another insertion along the hole.
  rig.move(-1.0, 50.0);
  EXPECT_EQ(rig.force.resistance, 0.0);
  rig.move(7.9, 10.0);
  EXPECT_LT(rig.force.resistance, rubs * 7.9 + 0.01);
  rig.move(9.0, 10.0);
  EXPECT_NEAR(rig.force.resistance, rubs * 9.0 + cutting, 0.05);
  rig.move(-1.0, 50.0);
  rig.begin();
  rig.move(9.9, 10.0);
  EXPECT_LT(rig.force.resistance, rubs * 9.9 + 0.01);
}

// The hand is ahead of the tip by the dimple, so leaving the layer, and losing its resistance, come later by as much.
TEST(EmbeddedNeedleCutting, the_layer_is_left_at_its_far_side_in_the_tissue_as_it_has_moved) {
  NeedleRig rig(soft_layers(), cut_tissues());
  double gives_way = 0.0, left = 0.0, before = 0.0;
  for (double depth = 0.0; depth < 25.0 && left == 0.0; depth += 0.01) {
    before = rig.force.resistance;
    rig.to(depth);
    if (rig.force.puncture) gives_way = depth;
    if (gives_way > 0.0 && rig.force.inside == tissue::soft) left = depth;
    if (gives_way == 0.0) continue;
    ASSERT_LE(rig.force.material_depth, left == 0.0 ? far_side : far_side + 0.2) << depth;
  }
  ASSERT_GT(gives_way, near_side + 0.5);
  EXPECT_GT(left, far_side + 0.5);  // the next point, 1 mm ahead, has moved by less than that at the tip
  EXPECT_LT(left, far_side + (gives_way - near_side));
  EXPECT_GT(before, cutting);
  for (int tick = 0; tick < 60; ++tick) rig.to(left);
  EXPECT_LT(rig.force.resistance, before - 0.9 * cutting + rubs * far_side);
  EXPECT_GT(rig.force.material_depth, far_side + 0.5);
}

TEST(EmbeddedNeedleCutting, the_force_does_not_jump_but_where_a_border_gives_way) {
  NeedleRig rig(soft_layers(), cut_tissues());
  rig.move(12.0, 10.0);
  rig.begin();  // along the open hole
  double largest = rig.move(20.0, 2.0);
  rig.model.reset();
  rig.begin();
  bool punctured = false;
  Random random(3);
  double goal = 0.0, before = rig.force.resistance;
  for (int way = 0; way < (sanitized ? 6 : 60); ++way) {
    const double from = goal;
    goal = random.uniform(0.0, 9.0 + 0.1 * way);
    const int ticks = static_cast<int>(std::ceil(std::abs(goal - from) / 0.002));
    for (int tick = 1; tick <= ticks; ++tick) {
      rig.to(from + (goal - from) * tick / ticks);
      punctured = punctured || rig.force.puncture.has_value();
      largest = std::max(largest, std::abs(rig.force.resistance - before));
      before = rig.force.resistance;
    }
  }
  EXPECT_TRUE(punctured);
  // 2 N in 30 ms, and 2 um of some N/mm.
  EXPECT_LT(largest, puncture / 30.0 + 0.02);
}

TEST(EmbeddedNeedleCutting, no_way_gives_more_work_than_went_in) {
  Random random(7);
  for (int trial = 0; trial < (sanitized ? 10 : 150); ++trial) {
    NeedleRig rig(trial % 2 == 0 ? soft_layers() : firm_layers(),
                  cut_tissues(trial % 3 == 0 ? 0.0 : random.uniform(0.001, 0.3)));
    double lowest = 0.0;
    for (int way = 0; way < 14; ++way) {
      rig.move(Vec3(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 18.0)),
               random.uniform(5.0, 400.0));
      lowest = std::min(lowest, rig.work - rig.model.stored_energy());
    }
    ASSERT_GT(lowest, -1e-9 * (1.0 + rig.way)) << trial;
    rig.move(-1.0, 50.0);
    ASSERT_GT(rig.work, -1e-9 * rig.way) << trial;
    EXPECT_EQ(rig.force.on_hand.force.norm(), 0.0);
  }
}

}  // namespace
}  // namespace bodkin
