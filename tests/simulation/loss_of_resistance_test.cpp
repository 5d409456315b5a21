#include "simulation/loss_of_resistance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "tests/simulation/slab_patient.h"
#include <gtest/gtest.h>

#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::simulation;
namespace {

using tissue::epidural_fat, tissue::ligamentum_flavum, tissue::muscle;

// A needle along a line of muscle to 10 mm, flavum to 14 mm, then epidural fat or what is chosen, with forces that a
// function gives.
class Line {
 public:
  explicit Line(TissueId behind = epidural_fat) : behind_(behind) {}

  void go(double to, double speed, const std::function<double(double)>& force) {
    const double step = (to < depth_ ? -1.0 : 1.0) * speed * 0.001;
    while ((to - depth_) * step > 1e-9) {
      depth_ = std::abs(to - depth_) < std::abs(step) ? to : depth_ + step;
      tick({depth_, step / 0.001, step > 0.0 ? 1 : -1, false}, force(depth_));
    }
  }
  void rest(double force) { tick({depth_, 0.0, 0, true}, force); }

  std::vector<Event> losses;

 private:
  void tick(const AxialMotion& motion, double force) {
    TickEvents events;
    const TissueId here = motion.depth < 10.0 ? muscle : motion.depth < 14.0 ? ligamentum_flavum : behind_;
    loss_.step(motion, here, force, events);
    losses.insert(losses.end(), events.begin(), events.end());
  }
  TissueId behind_;
  LossOfResistance loss_;
  double depth_ = 0.0;
};

TEST(LossOfResistance, is_told_once_with_the_drop_and_the_tissue_behind_at_any_speed) {
  for (const double speed : {0.5, 5.0, 50.0, 500.0}) {
    Line line;
    line.go(20.0, speed, [](double depth) { return depth < 10.0 ? 1.0 : depth < 14.0 ? 4.0 : 1.5; });
    ASSERT_EQ(line.losses.size(), 1U) << speed;
    EXPECT_EQ(line.losses[0].kind, EventKind::loss_of_resistance);
    EXPECT_EQ(line.losses[0].tissue, epidural_fat);
    EXPECT_NEAR(line.losses[0].depth, 14.0, speed * 0.001 + 1e-9) << speed;
    EXPECT_DOUBLE_EQ(line.losses[0].value, 2.5);
  }
}

TEST(LossOfResistance, counts_into_every_tissue_of_the_canal_and_into_no_other) {
  const auto force = [](double depth) { return depth < 14.0 ? 4.0 : 1.0; };
  for (const TissueId behind :
       {epidural_fat, tissue::dura, tissue::cerebrospinal_fluid, tissue::nerve, tissue::spinal_cord}) {
    Line line(behind);
    line.go(20.0, 10.0, force);
    ASSERT_EQ(line.losses.size(), 1U) << int{behind};
    EXPECT_EQ(line.losses[0].tissue, behind);
  }
  for (const TissueId behind : {muscle, tissue::fat, tissue::cortical_bone, tissue::disc, ligamentum_flavum}) {
    Line line(behind);
    line.go(20.0, 10.0, force);
    EXPECT_TRUE(line.losses.empty()) << int{behind};
  }
}

TEST(LossOfResistance, a_drop_that_fades_over_a_millimetre_counts) {
  Line line;
  line.go(20.0, 2.0, [](double depth) { return depth < 14.0 ? 2.0 : std::max(1.0, 2.0 - (depth - 14.0)); });
  ASSERT_EQ(line.losses.size(), 1U);
  EXPECT_NEAR(line.losses[0].value, 0.2, 0.01);  // as soon as a tenth is gone
  EXPECT_NEAR(line.losses[0].depth, 14.2, 0.01);
}

TEST(LossOfResistance, a_ligament_that_tents_gives_way_when_the_tip_is_beyond_its_far_side) {
  Line line;
  line.go(22.0, 10.0, [](double depth) { return depth < 18.0 ? 0.3 * depth : 1.0; });
  ASSERT_EQ(line.losses.size(), 1U);
  EXPECT_NEAR(line.losses[0].depth, 18.0, 0.02);

  Line too_far;
  too_far.go(30.0, 10.0, [](double depth) { return depth < 14.0 + LossOfResistance::reach + 1.0 ? 3.0 : 0.0; });
  EXPECT_TRUE(too_far.losses.empty());
}

TEST(LossOfResistance, a_drop_too_small_for_a_hand_or_none_is_no_loss) {
  Line absolute, relative, rising;
  absolute.go(20.0, 10.0, [](double depth) { return depth < 14.0 ? 0.3 : 0.21; });
  relative.go(20.0, 10.0, [](double depth) { return depth < 14.0 ? 5.0 : 4.55; });
  rising.go(20.0, 10.0, [](double depth) { return 0.1 * depth; });
  EXPECT_TRUE(absolute.losses.empty());
  EXPECT_TRUE(relative.losses.empty());
  EXPECT_TRUE(rising.losses.empty());
}

TEST(LossOfResistance, relaxation_at_rest_and_unloading_are_no_loss) {
  Line line;
  line.go(15.0, 10.0, [](double) { return 4.0; });
  for (int tick = 0; tick < 1000; ++tick) line.rest(4.0 - 0.003 * tick);
  line.go(15.5, 10.0, [](double) { return 1.0; });
  EXPECT_TRUE(line.losses.empty());
  line.go(14.5, 10.0, [](double depth) { return 1.0 - (15.5 - depth); });
  line.go(15.5, 10.0, [](double) { return 0.0; });
  EXPECT_TRUE(line.losses.empty());
}

TEST(LossOfResistance, a_needle_that_is_drawn_back_behind_a_flavum_that_holds_has_lost_nothing) {
  Line line;
  line.go(14.5, 5.0, [](double) { return 4.0; });  // the tip is beyond the far side at rest, the flavum still tents
  line.go(14.1, 5.0, [](double) { return 1.0; });
  line.rest(0.5);
  EXPECT_TRUE(line.losses.empty());
}

TEST(LossOfResistance, a_flavum_that_was_passed_is_not_lost_again_on_the_same_line) {
  Line line;
  const auto force = [](double depth) { return depth < 14.0 ? 4.0 : 1.0; };
  line.go(18.0, 10.0, force);
  line.go(11.0, 10.0, force);
  line.go(18.0, 10.0, force);
  EXPECT_EQ(line.losses.size(), 1U);
}

// Every resistance whose force falls behind the ligament, in the tick.
TEST(LossOfResistance, is_found_for_models_that_never_told_it_themselves) {
  for (const double speed : {3.0, 30.0}) {
    Case patient = slab_patient();
    std::vector<TissueProperties> tissues = patient.library.tissues();
    for (TissueProperties& one : tissues) {
      const bool is_flavum = one.id == ligamentum_flavum;
      one.tracking_wall = {.stiffness = 0.5, .force = is_flavum ? 3.0 : 1.0};
    }
    patient.library = TissueLibrary(tissues);
    patient.description.haptics.resistance = TrackingWallSettings{};
    HapticTick haptics(patient);
    std::vector<Event> losses;
    for (double depth = -2.0; depth < 42.0; depth += speed * haptics.dt()) {
      for (const Event& event : haptics.step(needle_at(depth)).events)
        if (event.kind == EventKind::loss_of_resistance) losses.push_back(event);
    }
    ASSERT_EQ(losses.size(), 1U) << speed;
    EXPECT_EQ(losses[0].tissue, epidural_fat);
    EXPECT_NEAR(losses[0].depth, 36.0, 0.2);
    EXPECT_NEAR(losses[0].value, 2.0, 0.1);
  }
}

}  // namespace
}  // namespace bodkin
