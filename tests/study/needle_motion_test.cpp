#include "study/needle_motion.h"

#include <algorithm>
#include <cmath>

#include "report/compare_plot.h"
#include "report/motion_plot.h"
#include "study/compare.h"
#include "study/profile.h"
#include "tests/session/slab_case.h"
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::report;
using namespace bodkin::simulation;
using namespace bodkin::study;
namespace {

// 60 mm of muscle, the target 30 mm deep, whose tracking wall follows at 1 N with 0.5 N/mm.
Case muscle_that_tracks() {
  Case patient = slab_case({{tissue::muscle, 60.0}});
  std::vector<TissueProperties> tissues = patient.library.tissues();
  for (TissueProperties& tissue : tissues) tissue.tracking_wall = {0.5, 1.0};
  patient.library = TissueLibrary(tissues);
  patient.description.haptics.resistance = TrackingWallSettings{.catch_up = 0.3};
  return patient;
}

std::string motion_refused(const std::string& text) {
  try {
    parse_motion(text, "--motion");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(NeedleMotion, is_read_from_words) {
  const NeedleMotion motion = parse_motion(" 25 at 10,hold 2, 10.5 ,target at 5; out", "--motion");
  ASSERT_EQ(motion.size(), 5U);
  EXPECT_EQ(motion[0].goal, MotionGoal::depth);
  EXPECT_EQ(motion[0].depth, 25.0);
  EXPECT_EQ(motion[0].speed, 10.0);
  EXPECT_EQ(motion[1].goal, MotionGoal::hold);
  EXPECT_EQ(motion[1].time, 2.0);
  EXPECT_EQ(motion[2].depth, 10.5);
  EXPECT_FALSE(motion[2].speed.has_value());
  EXPECT_EQ(motion[3].goal, MotionGoal::target);
  EXPECT_EQ(motion[3].speed, 5.0);
  EXPECT_EQ(motion[4].goal, MotionGoal::outside);
}

TEST(NeedleMotion, that_makes_no_sense_is_refused_with_a_sentence) {
  const auto refused = [](const std::string& text, const std::string& words) {
    EXPECT_NE(motion_refused(text).find(words), std::string::npos) << motion_refused(text);
  };
  refused("25 at 10, wait 2", "--motion: step 2 is 'wait 2', expected DEPTH, target or out");
  refused("25 at 10,", "step 2 is ''");
  refused("", "step 1 is ''");
  refused("deep", "a number from -10 to 500 mm below the skin for 'deep'");
  refused("25 at nan", "a number from 0.5 to 500 mm/s for 'nan'");
  refused("25 at 0.4", "mm/s for '0.4'");
  refused("hold -1, 20", "a number from 0 to 600 s for '-1'");
  refused("1e300", "for '1e300'");
  refused("-5, out", "no step goes below the skin");
  NeedleMotion slow = parse_motion("20 at 0.5, hold 500, out at 0.5, 20 at 0.5", "--motion");
  ProfileOptions options;
  options.motion = slow;
  EXPECT_THROW(insert_at_constant_speed(muscle_that_tracks(), options), InputError);
}

TEST(NeedleMotion, is_split_where_the_needle_has_been_before) {
  const StraightPath line = straight_path(muscle_that_tracks(), {}, {});
  const MotionTicks ticks =
      ticks_of(parse_motion("20, hold 1, 5 at 50, target", "--motion"), line, 10.0, 0.001, line.end);
  using enum MotionPhase;
  EXPECT_EQ(ticks.parts, (std::vector<MotionPhase>{insertion, stop, withdrawal, reinsertion, insertion}));
  const auto depth_before = [&](std::size_t part) { return ticks.places[ticks.first[part] - 1] - line.surface; };
  EXPECT_NEAR(depth_before(1), 20.0, 1e-9);
  EXPECT_EQ(ticks.first[2] - ticks.first[1], 1000U);
  EXPECT_NEAR(depth_before(3), 5.0, 1e-9);
  EXPECT_NEAR(depth_before(4), 20.0, 0.0101);
  EXPECT_NEAR(depth_before(5), 30.0, 1e-6);
  EXPECT_NEAR(static_cast<double>(ticks.first[3] - ticks.first[2]) * 0.001, 15.0 / 50.0, 0.0011);
  EXPECT_NEAR(duration_of(parse_motion("20, hold 1, 5 at 50, target", "--motion"), line, 10.0, line.end),
              3.0 + 1.0 + 0.3 + 2.5, 1e-6);
}

// Alamilla 2018, Fig. 5 to 7, on a body with a planned path: the force is 1 N during insertion, fades in a stop
// within the catch-up time, is 0 during withdrawal and re-insertion to the old depth, then 1 N again.
TEST(NeedleMotion, a_tracking_wall_stops_half_way_retreats_and_goes_on) {
  ProfileOptions options;
  options.motion = parse_motion("20 at 10, hold 2, 8 at 20, target at 10, 25", "--motion");
  const Profile profile = insert_at_constant_speed(muscle_that_tracks(), options);
  const auto force_at = [&](double time) {
    return profile.ticks[static_cast<std::size_t>(time / profile.dt)].output.resistance;
  };
  EXPECT_NEAR(force_at(2.5), 1.0, 1e-9);        // 15 mm deep
  EXPECT_NEAR(force_at(3.0 + 1.0), 0.0, 1e-3);  // 1 s into the stop at 3 s
  EXPECT_NEAR(force_at(5.3), 0.0, 1e-9);        // during the withdrawal, which ends at 5.6 s
  EXPECT_NEAR(force_at(6.5), 0.0, 1e-9);        // 17 mm deep, in the channel
  EXPECT_NEAR(force_at(7.5), 1.0, 1e-3);        // 27 mm deep
  EXPECT_EQ(profile.outcome, "the motion was deepest at 30.0 mm");
  EXPECT_NEAR(static_cast<double>(profile.ticks.size() - 1) * profile.dt, 3.0 + 2.0 + 0.6 + 2.2 + 0.5, 0.01);

  const std::vector<Plot> plots = profile_against_time(profile, muscle_that_tracks().library);
  ASSERT_EQ(plots.size(), 2U);
  ASSERT_GE(plots[0].series.size(), 3U) << "the tip, and the wall before and after the gap";
  EXPECT_EQ(plots[0].series[0].name, "tip");
  EXPECT_NEAR(plots[0].series[0].y.back(), 25.0, 1e-6);
  const PlotSeries& wall = plots[0].series[1];
  const auto at = static_cast<std::size_t>(std::lower_bound(wall.x.begin(), wall.x.end(), 2.5) - wall.x.begin());
  EXPECT_NEAR(wall.y[at], 15.0 - 1.0 / 0.5, 0.05) << "the wall trails the tip by f_R / K_t";
}

TEST(NeedleMotion, is_the_same_for_every_model_that_is_compared) {
  CompareOptions options;
  options.models = models_of({"tracking_wall catch_up_s=0.3", "layered"}, {});
  options.motion = parse_motion("20 at 10, hold 1, 8 at 20, 24, hold 0.5, out", "--motion");
  const Comparison comparison = compare_models(muscle_that_tracks(), options);
  using enum MotionPhase;
  EXPECT_EQ(comparison.parts,
            (std::vector<MotionPhase>{insertion, stop, withdrawal, reinsertion, insertion, stop, withdrawal}));
  const ModelRun& wall = comparison.models[0];
  EXPECT_NEAR(wall.end_of_stop, 0.0, 0.01);
  EXPECT_NEAR(wall.peak, 1.0, 1e-6);
  EXPECT_LT(wall.peak_again, 0.02);
  EXPECT_EQ(comparison.closed, comparison.depth.size());
  double whole = 0.0;
  for (const double work : wall.work) whole += work;
  EXPECT_NEAR(wall.closed_work, whole, 1e-9);
  EXPECT_NEAR(wall.closed_work, 24.0 - 3.0, 1.5);  // 1 N over 24 mm, less the two rises over 2 mm
  const std::vector<Plot> plots = comparison_plots(comparison, muscle_that_tracks().library, 6.0);
  ASSERT_EQ(plots.size(), 3U) << "over depth, over time, and the places of tip and wall";
  EXPECT_EQ(plots[1].dividers.size(), comparison.parts.size());

  options.motion = parse_motion("20, hold 1", "--motion");
  const Comparison open = compare_models(muscle_that_tracks(), options);
  EXPECT_EQ(open.closed, 0U) << "the needle stays in the body";
}

TEST(NeedleMotion, may_go_beyond_the_target_but_not_beyond_the_hub_nor_through_bone) {
  ProfileOptions options;
  options.motion = parse_motion("40 at 100, out at 100", "--motion");
  Profile profile = insert_at_constant_speed(muscle_that_tracks(), options);
  EXPECT_EQ(profile.outcome, "the motion was deepest at 40.0 mm");
  Case patient = muscle_that_tracks();
  patient.description.needle.length = 25.0;
  profile = insert_at_constant_speed(patient, options);
  EXPECT_EQ(profile.outcome, "the hub met the skin at 25.0 mm");
  options.motion = parse_motion("20 at 100, out at 100", "--motion");
  EXPECT_TRUE(insert_at_constant_speed(patient, options).notes.empty());

  Case bone = slab_case({{tissue::fat, 10.0}, {tissue::cortical_bone, 30.0}});
  options.motion = parse_motion("20 at 10, hold 1, 5, 20 at 10, out at 50", "--motion");
  profile = insert_at_constant_speed(bone, options);
  ASSERT_TRUE(profile.stopped_by_bone.has_value());
  EXPECT_EQ(profile.outcome.find("stopped by cortical bone at "), 0U) << profile.outcome;
  double deepest = 0.0;
  for (const TickRecord& record : profile.ticks) deepest = std::max(deepest, record.output.depth);
  EXPECT_NEAR(deepest, *profile.stopped_by_bone, 0.02);
  EXPECT_FALSE(profile.ticks.back().output.in_contact);
}

}  // namespace
}  // namespace bodkin
