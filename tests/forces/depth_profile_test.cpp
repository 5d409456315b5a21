#include "forces/depth_profile.h"

#include "tests/forces/default_tissues.h"
#include "tests/forces/model_checks.h"

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

using checks::move;
using checks::rest;

TissueId body(double depth) {  // skin 2 mm, fat to 12, muscle to 40, then bone
  return depth < 0.0    ? tissue::air
         : depth < 2.0  ? tissue::skin
         : depth < 12.0 ? tissue::fat
         : depth < 40.0 ? tissue::muscle
                        : tissue::cortical_bone;
}

struct Bench {
  explicit Bench(const TissueLibrary& library = checks::default_tissues(), double tick = 1e-3)
      : model(library, {}, tick), dt(tick), hand(-1.0, tick) {}
  double operator()(const AxialMotion& motion) { return model.step(motion, tissue_at(motion.depth), events); }
  double to(double depth, double speed = 10.0) { return move(hand, depth, speed, *this, dt); }
  double still(int ticks) { return rest(hand, ticks, *this); }
  int count(EventKind kind) const {
    return static_cast<int>(
        std::count_if(events.begin(), events.end(), [&](const Event& e) { return e.kind == kind; }));
  }

  DepthProfile model;
  double dt;
  checks::Hand hand;
  TickEvents events;
  TissueId (*tissue_at)(double) = body;
};

constexpr double tick = 0.01;  // N, k v dt at 1 N/mm and 10 mm/s

TEST(DepthProfile, skin_peaks_at_its_puncture_and_falls_to_the_trailing_force) {
  Bench bench;
  EXPECT_NEAR(bench.to(4.99), 1.497, 1e-9);
  EXPECT_NEAR(bench.to(5.0), 0.8, 1e-9);
  ASSERT_EQ(bench.count(EventKind::puncture), 1);
  EXPECT_NEAR(bench.events.begin()[1].value, 1.5, 1e-9);
}

TEST(DepthProfile, advances_against_a_constant_force) {
  Bench bench;
  bench.to(5.0);
  for (double depth = 6.0; depth < 40.0; ++depth) EXPECT_NEAR(bench.to(depth), 0.8, 1e-9);
  EXPECT_NEAR(bench.still(1000), 0.8, 1e-9);
}

TEST(DepthProfile, falls_to_zero_within_20_milliseconds_of_a_withdrawal) {
  Bench bench;
  bench.to(20.0);
  EXPECT_EQ(bench.to(19.8), 0.0);  // 0.2 mm at 10 mm/s take 20 ms
  Bench slow;
  slow.to(20.0);
  EXPECT_GT(slow.to(19.9), 0.0);
  EXPECT_LT(slow.to(19.9, 1.0), 0.4);
  EXPECT_EQ(slow.to(19.89, 1.0), 0.0);
}

TEST(DepthProfile, rises_again_from_zero_when_the_needle_goes_on) {
  Bench bench;
  bench.to(20.0);
  bench.to(19.0);
  EXPECT_NEAR(bench.to(20.0), 0.4, 1e-9);
  EXPECT_NEAR(bench.to(21.0), 0.8, 1e-9);
}

TEST(DepthProfile, bone_is_a_spring_to_the_limit_and_back) {
  Bench bench;
  bench.to(40.0);
  EXPECT_NEAR(bench.to(41.0), 1.0, tick);
  EXPECT_NEAR(bench.to(43.0), 3.0, tick);
  EXPECT_NEAR(bench.to(46.0), 6.0, tick);
  EXPECT_NEAR(bench.to(50.0), 6.0, 1e-9);
  EXPECT_NEAR(bench.to(42.0), 2.0, tick);
  EXPECT_EQ(bench.to(39.0), 0.0);
  EXPECT_EQ(bench.count(EventKind::bone_contact), 1);
  EXPECT_EQ(bench.count(EventKind::bone_left), 1);
  EXPECT_NEAR(bench.to(42.0), 2.0, tick);  // met again where it was
}

TEST(DepthProfile, an_organ_gives_no_force_but_an_event) {
  Bench bench;
  bench.tissue_at = [](double depth) { return depth > 15.0 ? tissue::organ : body(depth); };
  bench.to(14.0);
  EXPECT_EQ(bench.to(16.0), 0.0);
  EXPECT_EQ(bench.to(20.0), 0.0);
  ASSERT_EQ(bench.count(EventKind::tissue_entered), 1);
  EXPECT_EQ((bench.events.end() - 1)->tissue, tissue::organ);
}

TEST(DepthProfile, a_flickering_border_is_one_change) {
  Bench bench(checks::with_tissue(tissue::fat, [](TissueProperties& t) { t.depth_profile.stiffness = 0.1; }));
  bench.tissue_at = [](double depth) {  // every other 0.05 mm mislabelled within 1 mm of the border
    const bool near = depth > 20.0 && depth < 20.9;
    return near && static_cast<int>(depth * 20.0) % 2 == 0 ? tissue::fat
                                                           : (depth < 20.0 ? tissue::fat : tissue::muscle);
  };
  bench.to(19.99);
  double before = 0.2;
  const auto rising = [&](const AxialMotion& motion) {
    const double force = bench(motion);
    EXPECT_GE(force, before - 1e-9);
    return before = force;
  };
  move(bench.hand, 23.0, 10.0, rising);
  EXPECT_NEAR(before, 0.8, 1e-3);
}

TEST(DepthProfile, stiffness_grows_with_depth_where_the_table_says_so) {
  Bench bench(checks::with_tissue(tissue::muscle, [](TissueProperties& t) {
    t.depth_profile = {DepthProfileKind::soft, 0.3, 0.01};
  }));
  EXPECT_NEAR(bench.to(30.0, 2.0), 2.0 * (0.3 + 0.01 * 30.0), 5e-3);
}

TEST(DepthProfile, stiffens_no_faster_than_it_may) {
  Bench bench(checks::with_tissue(tissue::muscle, [](TissueProperties& t) {
    t.depth_profile.stiffness = 2.4;  // fat has 0.4
  }));
  double before = bench.to(11.9), steepest = 0.0;
  const auto measure = [&](const AxialMotion& motion) {
    const double force = bench(motion);
    steepest = std::max(steepest, force - before);
    return before = force;
  };
  // From 0.4 N/mm at 20 N/mm per s: after 50 ms 1.4 N/mm, and 0.8 N + 0.45 N along the way.
  move(bench.hand, 12.5, 10.0, measure);
  EXPECT_NEAR(before, 1.25, 0.05);
  move(bench.hand, 16.0, 10.0, measure);
  EXPECT_NEAR(before, 4.8, 0.01);
  EXPECT_LE(steepest, 2.4 * 10e-3 + 1e-9);  // never more than the new spring alone would give
}

TEST(DepthProfile, bone_whose_label_flickers_by_less_than_a_voxel_stays_where_it_was_met) {
  Bench bench;
  bench.to(40.5);
  EXPECT_EQ(bench.count(EventKind::bone_contact), 1);
  bench.to(39.0);
  EXPECT_EQ(bench.count(EventKind::bone_left), 1);
  bench.tissue_at = [](double depth) { return depth < 39.3 ? body(depth) : tissue::cortical_bone; };
  bench.to(39.9);
  EXPECT_EQ(bench.count(EventKind::bone_contact), 1);
  bench.to(40.5);
  EXPECT_EQ(bench.count(EventKind::bone_contact), 2);
}

TEST(DepthProfile, remembers_that_the_skin_is_punctured_at_an_entry) {
  Bench bench;
  bench.model.begin(Vec3::Zero(), Vec3::UnitZ());
  bench.to(10.0);
  bench.to(-1.0);
  bench.model.begin(Vec3(0.5, 0.0, 0.0), Vec3::UnitZ());
  EXPECT_NEAR(bench.to(4.0), 0.8, 1e-9);
  bench.to(-1.0);
  bench.model.begin(Vec3(5.0, 0.0, 0.0), Vec3::UnitZ());
  EXPECT_NEAR(bench.to(4.0), 1.2, 1e-9);
}

TEST(DepthProfile, the_digital_filter_answers_a_step_as_a_one_pole_of_30_hertz) {
  OnePole filter(30.0, 1e-3);
  EXPECT_NEAR(filter.gain(), 0.171796, 5e-7);
  const int at[] = {1, 5, 10, 20, 40};
  const double expected[] = {0.171796, 0.610339, 0.848164, 0.976946, 0.999469};
  int done = 0;
  for (int tick_number = 1; tick_number <= 40; ++tick_number) {
    const double value = filter.step(1.0);
    if (tick_number != at[done]) continue;
    EXPECT_NEAR(value, expected[done++], 5e-7);
  }
}

TEST(DepthProfile, has_the_properties_of_every_model) {
  const auto make = [] { return Bench(); };
  checks::finite_on_any_input(make);
  checks::passive_on_random_closed_paths(make, 45.0, 50.0, 1.0);
  checks::same_bits_on_repetition(make, 45.0);
  checks::bounded_when_saturated(make, 6.0);
  checks::no_growth_under_reversal_at_every_tick(make, 12.0);
  checks::no_growth_under_reversal_at_every_tick(make, 41.0);
  checks::steady_force_is_the_same_at_half_the_tick([](double dt) { return Bench(checks::default_tissues(), dt); },
                                                    30.0, 10.0, 1e-9);
}

TEST(DepthProfile, stays_passive_where_stiffness_changes_everywhere) {
  const TissueLibrary fat = checks::with_tissue(tissue::fat, [](TissueProperties& t) {
    t.depth_profile = {DepthProfileKind::soft, 2.0, -0.1};
  });
  const TissueLibrary both = checks::with_tissue(
      tissue::muscle,
      [](TissueProperties& t) {
        t.depth_profile = {DepthProfileKind::soft, 0.1, 0.05};
      },
      fat);
  checks::passive_on_random_closed_paths([&] { return Bench(both); }, 45.0, 20.0, 10.0);
}

TEST(DepthProfile, refuses_settings_outside_their_ranges) {
  EXPECT_THROW(DepthProfile(checks::default_tissues(), {.trailing = 6.0}, 1e-3), InputError);
  EXPECT_THROW(DepthProfile(checks::default_tissues(), {.bone_stiffness = 0.0}, 1e-3), InputError);
  EXPECT_THROW(DepthProfile(checks::default_tissues(), {}, 0.0), InputError);
}

}  // namespace
}  // namespace bodkin
