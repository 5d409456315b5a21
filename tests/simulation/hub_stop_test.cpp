#include "simulation/hub_stop.h"

#include <gtest/gtest.h>

namespace bodkin::simulation {
namespace {

TEST(HubStop, gives_nothing_before_the_whole_length_is_in) {
  HubStop stop(90.0, 2.0);
  forces::TickEvents events;
  for (double depth = -5.0; depth < 90.0; depth += 0.7) EXPECT_EQ(stop.step(depth, 0.0, 1, events), 0.0);
  EXPECT_EQ(events.size(), 0u);
}

TEST(HubStop, is_a_spring_of_what_the_tissue_leaves_of_the_devices_stiffness) {
  HubStop stop(90.0, 2.0);
  forces::TickEvents events;
  EXPECT_DOUBLE_EQ(stop.step(93.0, 0.0, 1, events), 6.0);
  EXPECT_DOUBLE_EQ(stop.step(93.0, 0.5, 1, events), 4.5);
  EXPECT_DOUBLE_EQ(stop.step(93.0, 1.9, 1, events), 3.0) << "never less than half";
}

TEST(HubStop, tells_once_each_time_that_the_hub_comes_down) {
  HubStop stop(90.0, 2.0);
  forces::TickEvents events;
  for (const double depth : {89.9, 90.1, 91.0, 89.8, 90.2, 92.0}) stop.step(depth, 0.0, 5, events);
  ASSERT_EQ(events.size(), 1u);  // 89.8 is no lift
  EXPECT_EQ(events.begin()->kind, forces::EventKind::hub_contact);
  EXPECT_DOUBLE_EQ(events.begin()->depth, 90.1);
  for (const double depth : {89.0, 90.3}) stop.step(depth, 0.0, 5, events);
  EXPECT_EQ(events.size(), 2u);
  stop.begin();
  stop.step(90.3, 0.0, 5, events);
  EXPECT_EQ(events.size(), 3u);
}

// The work of a closed path is that of a spring: none.
TEST(HubStop, gives_back_no_more_than_it_took) {
  HubStop stop(90.0, 2.0);
  forces::TickEvents events;
  double work = 0.0;
  const auto move = [&](double from, double to) {
    constexpr int steps = 1000;
    for (int i = 0; i < steps; ++i) {
      const double a = from + (to - from) * i / steps, b = from + (to - from) * (i + 1) / steps;
      work += 0.5 * (stop.step(a, 0.3, 1, events) + stop.step(b, 0.3, 1, events)) * (b - a);
    }
  };
  move(85.0, 97.0);
  EXPECT_GT(work, 40.0);
  move(97.0, 85.0);
  EXPECT_NEAR(work, 0.0, 1e-9);
}

}  // namespace
}  // namespace bodkin::simulation
