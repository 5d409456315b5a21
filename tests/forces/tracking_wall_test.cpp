#include "forces/tracking_wall.h"

#include <numbers>

#include "tests/forces/default_tissues.h"
#include "tests/forces/model_checks.h"

#include "core/error.h"
#include "core/motion_estimator.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

using checks::Hand;
using checks::move;
using checks::rest;

// One tissue, K_t 0.5 N/mm, f_R 1 N, stepped through checks::move.
struct WallBench {
  explicit WallBench(const TrackingWallSettings& settings = {}, double tick = 1e-3)
      : wall(checks::default_tissues(), settings, tick), dt(tick), hand(-1.0, tick) {}
  double operator()(const AxialMotion& motion) { return wall.step(motion, tissue::muscle, events); }
  double to(double depth, double speed = 10.0) { return move(hand, depth, speed, *this, dt); }
  double still(int ticks) { return rest(hand, ticks, *this); }

  TrackingWall wall;
  double dt;
  Hand hand;
  TickEvents events;
};

constexpr double wall_tick = 0.005 + 1e-9;  // N, K v dt at 0.5 N/mm and 10 mm/s

TrackingWallSettings shoulder() {  // Alamilla et al. 2018, section 3.4: nine layers of a hemisphere of 150 mm
  TrackingWallSettings settings;
  const double forces[] = {1.5, 1.0, 1.8, 2.0, 3.0, 3.5, 2.5, 4.0, 4.5};
  for (int i = 0; i < 9; ++i) settings.layers.push_back({150.0 / 9 * i, {0.5, forces[i]}});
  return settings;
}

TEST(TrackingWall, saturates_at_the_force_of_the_layer) {
  WallBench bench;
  const double depths[] = {0.5, 1.0, 1.5, 2.0, 5.0, 12.0}, forces[] = {0.25, 0.5, 0.75, 1.0, 1.0, 1.0};
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(bench.to(depths[i]), forces[i], 1e-9);
    if (depths[i] == 5.0) {
      EXPECT_NEAR(bench.wall.wall(), 3.0, 1e-9);
    }
  }
  EXPECT_NEAR(bench.wall.wall(), 10.0, 1e-9);
}

TEST(TrackingWall, catches_up_with_the_tip_at_rest) {
  WallBench bench;
  bench.to(12.0);
  const int ticks[] = {1, 124, 125, 125, 125};
  const double forces[] = {0.998, 0.75, 0.5, 0.25, 0.0}, walls[] = {10.004, 10.5, 11.0, 11.5, 12.0};
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(bench.still(ticks[i]), forces[i], 1e-9);
    EXPECT_NEAR(bench.wall.wall(), walls[i], 1e-9);
  }
}

// W after a motion at 10 mm/s to 12 mm, which is measured in steps of `resolution` mm, and `still` ms of rest.
double wall_after_a_stop(double resolution, int still) {
  TrackingWall wall(checks::default_tissues(), {.catch_up = 0.5, .layers = {{0.0, {0.5, 1.0}}}}, 1e-3, resolution);
  MotionEstimator estimator(1e-3, resolution);
  TickEvents events;
  wall.begin(Vec3::Zero(), Vec3::UnitZ());
  for (int tick = 0; tick <= 1200 + still; ++tick) {
    const double depth = 0.01 * std::min(tick, 1200);
    const double measured = resolution > 0.0 ? resolution * std::round(depth / resolution) : depth;
    wall.step(estimator.step(measured), tissue::muscle, events);
  }
  return wall.wall();
}

TEST(TrackingWall, catches_up_from_the_tick_of_the_stop_on) {
  for (const int still : {1, 10, 28, 100, 250, 499}) {
    EXPECT_NEAR(wall_after_a_stop(0.0, still), 10.0 + 2.0 * still / 500.0, 1e-6) << still << " ms without noise";
  }
  // With a device the rest is detected late, and the missed motion is made up.
  for (const int still : {100, 250, 499})
    EXPECT_NEAR(wall_after_a_stop(0.03, still), 10.0 + 2.0 * still / 500.0, 0.04) << still << " ms";
}

TEST(TrackingWall, the_wall_that_has_caught_up_waits_at_the_tip) {
  WallBench bench;
  bench.to(12.0);
  bench.still(2000);  // four times as long as it takes
  EXPECT_NEAR(bench.wall.wall(), 12.0, 1e-9);
  EXPECT_NEAR(bench.to(12.5), 0.25, 1e-9);
}

TEST(TrackingWall, layers_by_depth_count_from_the_surface) {
  TrackingWallSettings settings;
  settings.surface = 5.0;
  settings.layers = {{0.0, {0.5, 1.0}}, {10.0, {0.5, 2.0}}};
  WallBench bench(settings);
  EXPECT_NEAR(bench.to(14.9), 1.0, 1e-9);
  EXPECT_NEAR(bench.to(20.0), 2.0, 1e-9);
}

TEST(TrackingWall, a_cut_channel_is_free_to_its_old_depth) {
  WallBench bench;
  bench.to(12.0);
  bench.still(500);
  for (double depth = 11.0; depth >= 7.0; --depth) EXPECT_EQ(bench.to(depth), 0.0);
  for (double depth = 8.0; depth <= 12.0; ++depth) EXPECT_EQ(bench.to(depth), 0.0);
  const double depths[] = {12.5, 13.0, 14.0, 15.0}, forces[] = {0.25, 0.5, 1.0, 1.0};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(bench.to(depths[i]), forces[i], 1e-9);
}

TEST(TrackingWall, unloads_along_its_own_line_without_a_stop) {
  WallBench bench;
  bench.to(12.0);
  const double depths[] = {11.5, 11.0, 10.5, 10.0, 9.0}, forces[] = {0.75, 0.5, 0.25, 0.0, 0.0};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(bench.to(depths[i]), forces[i], 1e-9);
  EXPECT_EQ(bench.to(11.999), 0.0);
  EXPECT_NEAR(bench.to(12.5), 0.25, 1e-9);
}

TEST(TrackingWall, takes_11_newton_millimetres_for_12_millimetres_and_returns_1) {
  WallBench bench;
  double work = 0.0, before = 0.0;
  const auto measure = [&](const AxialMotion& motion) {
    const double force = bench(motion);
    work += 0.5 * (force + before) * motion.velocity * 1e-3;
    before = force;
    return force;
  };
  Hand hand(0.0);
  move(hand, 12.0, 10.0, measure);
  EXPECT_NEAR(work, 11.0, 1e-3);
  work = 0.0;
  move(hand, 9.0, 10.0, measure);
  EXPECT_NEAR(work, -1.0, 1e-3);
}

TEST(TrackingWall, passes_the_nine_layers_of_the_shoulder) {
  WallBench bench(shoulder());
  const struct {
    double depth, force;
  } marks[] = {{1.0, 0.5},    {16.617, 1.5}, {16.717, 1.0},   {33.383, 1.025}, {34.333, 1.5}, {49.95, 1.8},
               {83.283, 3.0}, {100.05, 2.5}, {116.717, 2.53}, {134.333, 4.5},  {149.95, 4.5}};
  for (const auto& mark : marks) EXPECT_NEAR(bench.to(mark.depth), mark.force, wall_tick) << mark.depth;
  bench.still(500);
  const auto none = [&](const AxialMotion& motion) {
    EXPECT_EQ(bench(motion), 0.0);
    return 0.0;
  };
  move(bench.hand, 0.0, 50.0, none);
}

TEST(TrackingWall, follows_the_tip_at_the_distance_of_each_layer_of_the_shoulder) {
  WallBench bench(shoulder());
  const double distances[] = {3.0, 2.0, 3.6, 4.0, 6.0, 7.0, 5.0, 8.0, 9.0};  // mm, f_R / K_t, eq. 4
  for (int i = 0; i < 9; ++i) {
    bench.to(150.0 / 9 * (i + 1) - 0.05);  // the end of the layer, where every force has saturated
    EXPECT_NEAR(bench.hand.depth() - bench.wall.wall(), distances[i], 1e-9) << i;
  }
}

TEST(TrackingWall, never_asks_for_more_than_its_limit) {
  TrackingWallSettings settings;
  settings.limit = 0.75;  // N, less than f_R
  WallBench bench(settings);
  EXPECT_NEAR(bench.to(1.0), 0.5, 1e-9);
  EXPECT_EQ(bench.to(2.0), 0.75);
  EXPECT_EQ(bench.to(12.0), 0.75);
  EXPECT_NEAR(bench.wall.wall(), 10.0, 1e-9);  // the limit is the hand's: the wall moves as without it
}

TEST(TrackingWall, a_channel_is_as_deep_as_it_was_cut_wherever_the_surface_lies) {
  TrackingWallSettings settings;
  settings.surface = 5.0;
  WallBench bench(settings);
  EXPECT_EQ(bench.to(5.0), 0.0);
  EXPECT_NEAR(bench.to(6.0), 0.5, 1e-9);
  bench.to(17.0);
  bench.still(500);
  bench.to(4.0);
  for (double depth = 6.0; depth <= 17.0; ++depth) EXPECT_EQ(bench.to(depth), 0.0) << depth;
  EXPECT_NEAR(bench.to(17.5), 0.25, 1e-9);
  EXPECT_NEAR(bench.to(18.0), 0.5, 1e-9);
}

TEST(TrackingWall, holds_when_the_catch_up_is_infinite) {
  TrackingWallSettings settings;
  settings.catch_up = std::numeric_limits<double>::infinity();
  WallBench bench(settings);
  bench.to(12.0);
  EXPECT_NEAR(bench.still(60000), 1.0, 1e-12);
}

TEST(TrackingWall, catches_up_in_seconds_whatever_the_rate) {
  WallBench coarse, fine({}, 2.5e-4);
  coarse.to(12.0);
  fine.to(12.0);
  EXPECT_NEAR(coarse.still(250), 0.5, 1e-9);
  EXPECT_NEAR(fine.still(1000), 0.5, 1e-9);
}

TEST(TrackingWall, strict_falls_to_zero_one_count_behind_the_stop_and_jumps_back) {
  TrackingWallSettings settings;
  settings.strict = true;
  settings.catch_up = std::numeric_limits<double>::infinity();
  WallBench bench(settings);
  bench.to(12.0);
  EXPECT_NEAR(bench.still(10), 1.0, 1e-9);
  EXPECT_EQ(bench.to(11.95), 0.0);
  EXPECT_NEAR(bench.to(12.0), 1.0, wall_tick);
}

TEST(TrackingWall, remembers_channels_by_place_and_tilt) {
  const auto tilted = [](double degrees) {
    const double a = degrees * std::numbers::pi / 180.0;
    return Vec3(std::sin(a), 0.0, std::cos(a));
  };
  struct Entry {
    Vec3 place;
    double tilt;
    double force;  // at 2 mm
  };
  const Entry entries[] = {{{0, 0, 0}, 0.0, 1.0},   {{0.9, 0, 0}, 0.0, 0.0}, {{0, 0, 0}, 2.9, 0.0},
                           {{1.1, 0, 0}, 0.0, 1.0}, {{0, 0, 0}, 4.0, 1.0},   {{0, 0, 0}, 0.0, 0.0}};
  WallBench bench;
  for (const Entry& entry : entries) {
    bench.wall.begin(entry.place, tilted(entry.tilt));
    EXPECT_NEAR(bench.to(2.0), entry.force, 1e-9) << entry.place.transpose() << ", " << entry.tilt;
    bench.to(5.0);
    bench.to(-1.0);
  }
  EXPECT_EQ(bench.wall.channels().size(), 3u);
  for (int i = 0; i < 200; ++i) bench.wall.begin(Vec3(10.0 * i, 50.0, 0.0), tilted(0.0));
  EXPECT_EQ(bench.wall.channels().size(), ChannelMemory::capacity);
  bench.wall.reset();
  EXPECT_NEAR(bench.to(2.0), 1.0, 1e-9);
}

TEST(TrackingWall, is_continuous_where_the_spring_changes) {
  TrackingWallSettings settings;
  settings.layers = {{0.0, {0.5, 1.0}}, {10.0, {1.0, 3.0}}, {20.0, {0.25, 3.0}}};
  WallBench bench(settings);
  double before = 0.0;
  const auto smooth = [&](const AxialMotion& motion) {
    const double force = bench(motion);
    EXPECT_LE(std::abs(force - before), 0.01 + 1e-9) << motion.depth;
    return before = force;
  };
  move(bench.hand, 10.5, 10.0, smooth);
  EXPECT_NEAR(before, 1.5, 0.01);
  move(bench.hand, 9.0, 10.0, smooth);
  move(bench.hand, 25.0, 10.0, smooth);
  EXPECT_NEAR(before, 3.0, 1e-9);
}

TEST(TrackingWall, tells_of_contact_and_withdrawal_once) {
  WallBench bench;
  bench.to(5.0);
  bench.to(-1.0);
  ASSERT_EQ(bench.events.size(), 2u);
  EXPECT_EQ(bench.events.begin()[0].kind, EventKind::contact);
  EXPECT_EQ(bench.events.begin()[1].kind, EventKind::withdrawn);
}

TEST(TrackingWall, has_the_properties_of_every_model) {
  const auto make = [] { return WallBench(shoulder()); };
  checks::finite_on_any_input(make);
  checks::passive_on_random_closed_paths(make, 60.0, 50.0, 1.0);
  checks::same_bits_on_repetition(make, 60.0);
  checks::bounded_when_saturated(make, 8.5);
  checks::no_growth_under_reversal_at_every_tick(make, 12.0);
  checks::steady_force_is_the_same_at_half_the_tick([](double dt) { return WallBench({}, dt); }, 12.0, 10.0, 1e-9);
}

TEST(TrackingWall, stays_passive_where_springs_differ_from_layer_to_layer) {
  TrackingWallSettings settings;
  settings.layers = {{0.0, {0.3, 1.0}}, {4.0, {2.0, 3.0}}, {9.0, {0.2, 0.5}}, {13.0, {1.0, 4.0}}};
  checks::passive_on_random_closed_paths([&] { return WallBench(settings); }, 20.0, 20.0, 8.0);
}

TEST(TrackingWall, refuses_settings_outside_their_ranges) {
  const TissueLibrary& library = checks::default_tissues();
  TrackingWallSettings settings;
  settings.catch_up = 0.0;
  EXPECT_THROW((TrackingWall{library, settings, 1e-3}), InputError);
  settings = {};
  settings.layers = {{5.0, {}}, {2.0, {}}};
  EXPECT_THROW((TrackingWall{library, settings, 1e-3}), InputError);
  const auto soft = checks::with_tissue(tissue::muscle, [](TissueProperties& t) { t.tracking_wall.stiffness = 0.0; });
  EXPECT_THROW((TrackingWall{soft, {}, 1e-3}), InputError);
}

}  // namespace
}  // namespace bodkin
