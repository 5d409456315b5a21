#include "training/simulated_probe.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace bodkin::training {
namespace {

// A needle that advances along the path at 10 mm/s for 5 s, `aside` mm from the slice, then rests for 5 s.
session::Session needle_beside(double aside, std::uint64_t ticks = 10000) {
  session::Session session;
  session.header.dt = 0.001;
  session.header.path.entry = Vec3(0.0, 80.0, 0.0);
  session.header.path.target = Vec3(0.0, 20.0, 0.0);
  for (std::uint64_t tick = 0; tick < ticks; ++tick) {
    simulation::TickRecord record;
    record.tick = tick;
    const double depth = std::min(0.01 * static_cast<double>(tick), 50.0);
    record.input.needle.translation() = Vec3(aside, 80.0 - depth, 0.0);
    session.ticks.push_back(record);
  }
  return session;
}

Vec3 normal_of(const session::SecondSample& sample) {
  return sample.rotation * Vec3::UnitY();
}

double tip_to_slice(const session::Session& session, std::size_t i) {
  const session::SecondSample& sample = session.second[i];
  const auto tick = static_cast<std::size_t>(std::lround(sample.time / session.header.dt));
  return std::abs((session.ticks[tick].input.needle.translation() - sample.position).dot(normal_of(sample)));
}

TEST(SimulatedProbe, a_steady_hand_holds_the_path_in_its_slice) {
  session::Session session = needle_beside(0.0);
  hold_probe(session, {.aim_position = 0.0, .aim_angle = 0.0, .wander = 0.0}, 1);
  ASSERT_EQ(session.second.size(), 1000U);
  ASSERT_TRUE(session.header.second);
  EXPECT_EQ(session.header.second->role, session::SecondRole::probe);
  for (std::size_t i = 0; i < session.second.size(); ++i) {
    EXPECT_NEAR(session.second[i].time, 0.01 * static_cast<double>(i), 1e-12);
    EXPECT_LT(tip_to_slice(session, i), 1e-9);
    EXPECT_NEAR(std::abs(normal_of(session.second[i]).dot(session.header.path.direction())), 0.0, 1e-12);
  }
}

TEST(SimulatedProbe, a_tip_that_is_lost_is_followed_after_a_reaction) {
  session::Session session = needle_beside(6.0);
  hold_probe(session, {.aim_position = 0.0, .aim_angle = 0.0, .reaction = 0.3, .wander = 0.0}, 1);
  EXPECT_NEAR(tip_to_slice(session, 20), 6.0, 1e-9);  // 0.2 s
  EXPECT_LT(tip_to_slice(session, 999), 2.01);
  // 4 mm at 5 mm/s after 0.3 s.
  EXPECT_GT(tip_to_slice(session, 100), 2.0);
  EXPECT_LT(tip_to_slice(session, 125), 2.1);
}

TEST(SimulatedProbe, aim_and_wander_spread_as_they_say) {
  double squares = 0.0, angles = 0.0;
  constexpr int hands = 400;
  for (int seed = 0; seed < hands; ++seed) {
    session::Session session = needle_beside(0.0, 1);
    hold_probe(session, {.aim_position = 0.5, .aim_angle = 0.02, .wander = 0.0}, static_cast<std::uint64_t>(seed));
    const double beside = (session.second[0].position - session.header.path.entry).dot(normal_of(session.second[0]));
    squares += beside * beside;
    const double angle = std::asin(normal_of(session.second[0]).dot(session.header.path.direction()));
    angles += angle * angle;
  }
  // Standard error of a standard deviation: 3.5 %.
  EXPECT_NEAR(std::sqrt(angles / hands), 0.02, 0.003);
  EXPECT_GT(std::sqrt(squares / hands), 0.4);
  session::Session session = needle_beside(0.0);
  hold_probe(session, {.aim_position = 0.0, .aim_angle = 0.0, .wander = 0.8}, 3);
  double drift = 0.0;
  for (std::size_t i = 0; i < session.second.size(); ++i) drift = std::max(drift, tip_to_slice(session, i));
  EXPECT_GT(drift, 0.2);
  EXPECT_LT(drift, 5.0);
}

TEST(SimulatedProbe, the_same_seed_holds_the_same_way) {
  session::Session one = needle_beside(0.0), same = one, other = one;
  const simulation::OperatorScript script{.aim_position = 1.0, .wander = 1.0};
  hold_probe(one, script, 5);
  hold_probe(same, script, 5);
  hold_probe(other, script, 6);
  EXPECT_EQ(one.second[700].position, same.second[700].position);
  EXPECT_NE(one.second[700].position, other.second[700].position);
  session::Session empty;
  hold_probe(empty, script, 5);
  EXPECT_TRUE(empty.second.empty());
}

}  // namespace
}  // namespace bodkin::training
