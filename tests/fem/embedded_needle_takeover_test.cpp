// A needle that is in the tissue and moves to another corridor.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "tests/fem/needle_in_corridors.h"
#include "tests/fem/needle_rig.h"
#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using SharedBody = std::shared_ptr<const CondensedBody>;

// 3 x 3 x 16 nodes, 1 mm apart, the upper ones skin; stiffer at the side of positive x by `uneven`, as where a probe
// presses, and with its nodes moved by `sunk` along z.
SharedBody pressed_column(double modulus, double uneven = 0.0, double sunk = 0.0) {
  CondensedBody body = checks::kelvin_body(3, 16, 1.0, modulus);
  const auto count = static_cast<Eigen::Index>(body.nodes.size());
  Eigen::VectorXd scale(3 * count);
  for (Eigen::Index i = 0; i < count; ++i) {
    Vec3& node = body.nodes[static_cast<std::size_t>(i)];
    if (node.z() < 1.5) body.tissues[static_cast<std::size_t>(i)] = tissue::skin;
    scale.segment<3>(3 * i).setConstant(1.0 / (1.0 + uneven * (1.0 + 0.5 * node.x() + 0.05 * node.z())));
    node.z() += sunk;
  }
  body.compliance = (scale.asDiagonal() * body.compliance * scale.asDiagonal()).eval();
  return std::make_shared<const CondensedBody>(std::move(body));
}

SharedBody in_other_order(const CondensedBody& body) {
  CondensedBody turned = body;
  const std::size_t count = body.nodes.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = (i * 7 + 3) % count;  // 144 and 7 have no common divisor
    turned.nodes[i] = body.nodes[from];
    turned.mesh_nodes[i] = body.mesh_nodes[from];
    turned.tissues[i] = body.tissues[from];
    for (std::size_t j = 0; j < count; ++j) {
      const auto other = static_cast<Eigen::Index>((j * 7 + 3) % count);
      turned.compliance.block<3, 3>(3 * static_cast<Eigen::Index>(i), 3 * static_cast<Eigen::Index>(j)) =
          body.compliance.block<3, 3>(3 * static_cast<Eigen::Index>(from), 3 * other);
    }
  }
  return std::make_shared<const CondensedBody>(std::move(turned));
}

ContactTissues rubbing_tissues(double puncture_force = 0.15) {
  ContactTissues tissues = checks::plain_tissues(0.02);
  tissues[tissue::skin].puncture_force = puncture_force;
  return tissues;
}

EmbeddedNeedleSettings few_nodes() {
  EmbeddedNeedleSettings settings = checks::narrow_settings();
  settings.most_nodes = 24;
  return settings;
}

struct BegunNeedle : checks::NeedleInCorridors {
  BegunNeedle(SharedBody first, const ContactTissues& tissues)
      : NeedleInCorridors(std::move(first), tissues, few_nodes()) {
    begin(Vec3::Zero(), Vec3::UnitZ());
  }
};

// A hand that goes in and out and sideways and tilts, smoothly and never the same way.
class WanderingHand {
 public:
  explicit WanderingHand(std::uint64_t seed) {
    Random random(seed);
    for (double& phase : phases_) phase = 6.28 * random.uniform();
  }
  Pose at(int tick) const {
    const double t = 1e-3 * tick;
    const auto swing = [&](std::size_t i, double rate) { return std::sin(rate * t + phases_[i]); };
    const double depth = 6.5 + 4.0 * swing(0, 1.9) + 2.0 * swing(1, 7.3);
    const Vec3 axis(0.04 * swing(2, 2.3), 0.04 * swing(3, 3.1), 1.0);
    return needle_pose(Vec3(0.3 * swing(4, 4.1), 0.3 * swing(5, 2.9), std::min(depth, 0.01 * tick - 1.0)),
                       axis.normalized());
  }

 private:
  std::array<double, 6> phases_{};
};

// Goes on until the needle is in the newest corridor; ticks that it took.
int go_over(checks::NeedleInCorridors& corridors, const Pose& pose) {
  for (int ticks = 1; ticks < 100; ++ticks) {
    corridors.needle().step(pose);
    if (corridors.go_on_in_newest()) return ticks;
  }
  ADD_FAILURE() << "the needle stays in its corridor";
  return 0;
}

TEST(EmbeddedNeedleTakeover, to_a_corridor_that_is_the_same_changes_nothing) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const SharedBody body = pressed_column(0.05);
    BegunNeedle corridors(body, rubbing_tissues());
    EmbeddedNeedle alone(*body, rubbing_tissues(), few_nodes(), 1e-3);
    alone.begin(Vec3::Zero(), Vec3::UnitZ());
    const WanderingHand hand(seed);
    int taken = 0;
    for (int tick = 0; tick < 6000; ++tick) {
      const Pose pose = hand.at(tick);
      const EmbeddedNeedleForce expected = alone.step(pose), found = corridors.needle().step(pose);
      ASSERT_LT((found.on_hand.force - expected.on_hand.force).norm(), 1e-9) << seed << ' ' << tick;
      ASSERT_LT((found.on_hand.torque - expected.on_hand.torque).norm(), 1e-8) << seed << ' ' << tick;
      ASSERT_EQ(found.nodes, expected.nodes);
      ASSERT_EQ(found.puncture.has_value(), expected.puncture.has_value());
      if (tick % 150 == 0) corridors.offer(tick % 300 == 0 ? in_other_order(*body) : body);
      taken += corridors.go_on_in_newest() ? 1 : 0;
    }
    EXPECT_GT(taken, 20) << seed;
  }
}

TEST(EmbeddedNeedleTakeover, a_needle_that_bends_keeps_its_shape_and_its_force) {
  const SharedBody body = pressed_column(0.05);
  const NeedleBeam beam({.rigidity = 200.0, .length = 90.0, .hold = NeedleHold::clamped, .cut_offset = 0.02});
  EmbeddedNeedle alone(*body, rubbing_tissues(), few_nodes(), 1e-3, beam);
  auto now = std::make_unique<EmbeddedNeedle>(*body, rubbing_tissues(), few_nodes(), 1e-3, beam);
  std::unique_ptr<EmbeddedNeedle> next;
  alone.begin(Vec3::Zero(), Vec3::UnitZ());
  now->begin(Vec3::Zero(), Vec3::UnitZ());
  const WanderingHand hand(11);
  int taken = 0;
  for (int tick = 0; tick < 4000; ++tick) {
    const Vec3 expected = alone.step(hand.at(tick)).on_hand.force;
    ASSERT_LT((now->step(hand.at(tick)).on_hand.force - expected).norm(), 1e-9) << tick;
    ASSERT_LT((now->shaft_deflection(0.0) - alone.shaft_deflection(0.0)).norm(), 1e-9) << tick;
    if (next == nullptr && tick % 100 == 0) {
      next = std::make_unique<EmbeddedNeedle>(*body, rubbing_tissues(), few_nodes(), 1e-3, beam);
      if (!next->begin_to_follow(*now)) next.reset();
    }
    const FollowState state = next == nullptr ? FollowState::impossible : next->follow(*now);
    if (state == FollowState::done) now = std::move(next);
    if (state != FollowState::under_way) next.reset();
    taken += state == FollowState::done ? 1 : 0;
  }
  EXPECT_GT(taken, 10);
}

// Corridors as different as a deep press makes them, taken at any moment of any motion.
TEST(EmbeddedNeedleTakeover, no_force_jumps_whatever_the_needle_does) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    BegunNeedle corridors(pressed_column(0.05), rubbing_tissues());
    const WanderingHand hand(seed);
    double elsewhere = 0.0;
    EmbeddedNeedleForce before;
    int taken = 0, still = 0, waits = 0;
    bool took = false;
    for (int tick = 0; tick < 12000; ++tick) {
      waits += took && taken % 2 == 0 ? 1 : 0;  // every other time the hand rests in the next tick
      const EmbeddedNeedleForce found = corridors.needle().step(hand.at(tick - waits));
      const double change = (found.on_hand.force - before.on_hand.force).norm();
      if (took && taken % 2 == 0) {
        // A node that the tick before had no time to let slide may do so now, as in any tick.
        EXPECT_LT(change, found.sticking == before.sticking ? 1e-9 : 1e-3) << seed << ' ' << tick;
        ++still;
      } else if (!before.puncture) {
        elsewhere = std::max(elsewhere, change);
      }
      before = found;
      if (tick % 97 == 0)
        corridors.offer(pressed_column(0.03 + 0.05 * (tick % 3), 0.2 * (tick % 4), 0.2 * (tick % 5)));
      took = corridors.go_on_in_newest();
      taken += took ? 1 : 0;
    }
    EXPECT_GT(still, 50) << seed;
    EXPECT_LT(elsewhere, 0.1) << seed;  // take-overs of a hand that moves among them
  }
}

// Forces of the nodes along the middle of a body whose nodes are where they are but for `moved`.
Eigen::VectorXd dense_answer(const CondensedBody& body, std::size_t nodes, const Mat3& directions, int first,
                             int columns, const Vec3& moved) {
  std::vector<Eigen::Index> held;
  for (std::size_t i = 0; i < body.nodes.size() && held.size() < nodes; ++i) {
    if (body.nodes[i].head<2>().norm() < 1e-9) held.push_back(static_cast<Eigen::Index>(3 * i));
  }
  const Eigen::MatrixXd basis = directions.middleCols(first, columns);
  const auto count = static_cast<Eigen::Index>(held.size());
  Eigen::MatrixXd matrix(columns * count, columns * count);
  Eigen::VectorXd wanted(columns * count);
  for (Eigen::Index i = 0; i < count; ++i) {
    wanted.segment(columns * i, columns) = basis.transpose() * moved;
    for (Eigen::Index j = 0; j < count; ++j) {
      matrix.block(columns * i, columns * j, columns, columns) =
          basis.transpose() *
          body.compliance.block<3, 3>(held[static_cast<std::size_t>(i)], held[static_cast<std::size_t>(j)]) * basis;
    }
  }
  Eigen::VectorXd answer = matrix.ldlt().solve(wanted);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(3);
  for (Eigen::Index i = 0; i < count; ++i) sum += basis * answer.segment(columns * i, columns);
  return sum;
}

TEST(EmbeddedNeedleTakeover, a_needle_that_is_in_feels_the_new_corridors_stiffness_at_its_side) {
  const SharedBody soft = pressed_column(0.05), firm = pressed_column(0.08, 0.3, 0.4);
  BegunNeedle corridors(soft, checks::plain_tissues(0.0));
  const auto at = [](double x, double depth) { return needle_pose(Vec3(x, 0.0, depth), Vec3::UnitZ()); };
  for (double depth = -1.0; depth < 8.99; depth += 0.01) corridors.needle().step(at(0.0, depth));
  const auto stiffness = [&] {  // N per 0.1 mm sideways, from where it is
    const Vec3 before = corridors.needle().step(at(0.2, 8.99)).on_hand.force;
    const Vec3 after = corridors.needle().step(at(0.3, 8.99)).on_hand.force;
    corridors.needle().step(at(0.2, 8.99));
    return Vec3(before - after);
  };
  const std::uint32_t nodes = corridors.needle().step(at(0.2, 8.99)).nodes;
  const Vec3 of_soft = stiffness();
  const Vec3 before = corridors.needle().step(at(0.2, 8.99)).on_hand.force;
  corridors.offer(firm);
  EXPECT_EQ(go_over(corridors, at(0.2, 8.99)), static_cast<int>(nodes) + 2);
  EXPECT_EQ(&corridors.body(), firm.get());
  const Vec3 after = corridors.needle().step(at(0.2, 8.99)).on_hand.force;
  EXPECT_LT((after - before).norm(), 1e-9);
  EXPECT_GT(before.norm(), 0.05);
  const Vec3 of_firm = stiffness();
  EXPECT_GT(of_firm.x(), 1.5 * of_soft.x());
  // All firmly held but the last node, which at 0.99 mm of its length is nearly so.
  const Eigen::VectorXd expected = dense_answer(*firm, nodes, Mat3::Identity(), 0, 2, 0.1 * Vec3::UnitX());
  EXPECT_NEAR(of_firm.x(), expected(0), 0.01 * expected(0));
}

TEST(EmbeddedNeedleTakeover, a_sticking_shaft_goes_on_as_the_dense_solve_of_the_new_corridor_says) {
  const SharedBody soft = pressed_column(0.05), firm = pressed_column(0.08, 0.3, 0.0);
  BegunNeedle corridors(soft, checks::plain_tissues(5.0));
  const auto at = [](const Vec3& moved) { return needle_pose(Vec3(Vec3(0.0, 0.0, 9.7) + moved), Vec3::UnitZ()); };
  for (double depth = -1.0; depth < 0.0; depth += 0.005) corridors.needle().step(at(Vec3(0.0, 0.0, depth)));
  for (int i = 0; i < 50; ++i) corridors.needle().step(at(Vec3::Zero()));
  const std::uint32_t nodes = corridors.needle().step(at(Vec3::Zero())).nodes;
  ASSERT_EQ(nodes, 10U);
  corridors.offer(in_other_order(*firm));
  go_over(corridors, at(Vec3::Zero()));
  const EmbeddedNeedleForce before = corridors.needle().step(at(Vec3::Zero()));
  ASSERT_EQ(before.sticking, nodes);
  const Vec3 moved(0.002, -0.003, -0.001);
  const EmbeddedNeedleForce after = corridors.needle().step(at(moved));
  ASSERT_EQ(after.sticking, nodes);
  const Eigen::VectorXd expected = dense_answer(*firm, nodes, Mat3::Identity(), 0, 3, moved);
  // The tip draws back by a micrometre: the compliance of the last node, 0 beyond its radius, stays.
  EXPECT_LT((Vec3(before.on_hand.force - after.on_hand.force) - Vec3(expected)).norm(), 1e-9);
}

TEST(EmbeddedNeedleTakeover, after_it_the_needle_goes_into_nodes_that_lie_where_the_new_corridor_has_them) {
  const SharedBody first = pressed_column(0.05), sunk = pressed_column(0.05, 0.0, 0.5);
  BegunNeedle corridors(first, checks::plain_tissues(0.0));
  const auto nodes_at = [&](double depth) {
    return corridors.needle().step(needle_pose(Vec3(0.0, 0.0, depth), Vec3::UnitZ())).nodes;
  };
  for (double depth = -1.0; depth < 5.2; depth += 0.01) nodes_at(depth);
  EXPECT_EQ(nodes_at(5.2), 6U);
  corridors.offer(sunk);
  go_over(corridors, needle_pose(Vec3(0.0, 0.0, 5.2), Vec3::UnitZ()));
  EXPECT_EQ(nodes_at(6.4), 6U);
  EXPECT_EQ(nodes_at(6.51), 7U);
  EXPECT_EQ(nodes_at(7.51), 8U);
  for (double depth = 7.5; depth > -0.5; depth -= 0.01) nodes_at(depth);
  EXPECT_EQ(nodes_at(-0.5), 0U);
  EXPECT_FALSE(corridors.go_on_in_newest());
}

// What a take-over gives or takes is known: half the work of the held forces on the difference of the compliances.
TEST(EmbeddedNeedleTakeover, changes_the_stored_energy_by_what_the_compliances_differ) {
  const SharedBody soft = pressed_column(0.05), firm = pressed_column(0.08, 0.3, 0.0);
  BegunNeedle corridors(soft, rubbing_tissues());
  for (double depth = -1.0; depth < 9.99; depth += 0.01)
    corridors.needle().step(needle_pose(Vec3(0.02 * depth, 0.0, depth), Vec3::UnitZ()));
  const Pose pose = needle_pose(Vec3(0.2, 0.0, 9.99), Vec3::UnitZ());
  corridors.needle().step(pose);
  corridors.offer(firm);
  const double before = corridors.needle().stored_energy();
  const NodeForces forces = corridors.needle().node_forces();
  go_over(corridors, pose);
  double expected = 0.0;
  for (std::size_t i = 0; i < forces.count; ++i) {
    for (std::size_t j = 0; j < forces.count; ++j) {
      const auto vector = [&](std::size_t at) {
        const auto& force = forces.nodes[at].force;
        return Vec3(force[0], force[1], force[2]);
      };
      const auto row = 3 * Eigen::Index{forces.nodes[i].node}, column = 3 * Eigen::Index{forces.nodes[j].node};
      const Mat3 change = firm->compliance.block<3, 3>(row, column) - soft->compliance.block<3, 3>(row, column);
      expected += 0.5 * vector(i).dot(change * vector(j));
    }
  }
  EXPECT_LT(expected, -1e-4);
  EXPECT_NEAR(corridors.needle().stored_energy() - before, expected, 1e-2 * std::abs(expected));
}

// Between two corridors that are the same there is nothing to be won, so often it changes.
TEST(EmbeddedNeedleTakeover, no_way_gives_work_by_taking_over) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const SharedBody body = pressed_column(0.05);
    BegunNeedle corridors(body, checks::plain_tissues(0.02));
    Random random(seed);
    Vec3 place(0.0, 0.0, -1.0);
    double work = 0.0, way = 0.0;
    for (int leg = 0; leg < 40; ++leg) {
      const Vec3 goal(0.6 * random.uniform() - 0.3, 0.6 * random.uniform() - 0.3, 10.0 * random.uniform());
      const int ticks = 1 + static_cast<int>((goal - place).norm() / 0.02);
      const Vec3 stride = (goal - place) / ticks;
      for (int tick = 0; tick < ticks; ++tick) {
        place += stride;
        work -= corridors.needle().step(needle_pose(place, Vec3::UnitZ())).on_hand.force.dot(stride);
        way += stride.norm();
        if (!corridors.newer_waits()) corridors.offer(body);
        corridors.go_on_in_newest();
      }
      ASSERT_GT(work - corridors.needle().stored_energy(), -1e-9 * way) << seed;
    }
  }
}

TEST(EmbeddedNeedleTakeover, a_corridor_without_a_node_that_is_held_waits_until_the_needle_is_out) {
  const SharedBody whole = pressed_column(0.05);
  auto shallow = std::make_shared<CondensedBody>(checks::kelvin_body(3, 5, 1.0, 0.05));
  BegunNeedle corridors(whole, rubbing_tissues());
  const auto at = [](double depth) { return needle_pose(Vec3(0.0, 0.0, depth), Vec3::UnitZ()); };
  for (double depth = -1.0; depth < 7.5; depth += 0.01) corridors.needle().step(at(depth));
  corridors.offer(shallow);
  for (double depth = 7.5; depth > 5.0; depth -= 0.01) {
    corridors.needle().step(at(depth));
    EXPECT_FALSE(corridors.go_on_in_newest());
  }
  EXPECT_EQ(&corridors.body(), whole.get());
  EXPECT_TRUE(corridors.newer_waits());
  // A newer one that has them is taken nevertheless, and the other dropped.
  const SharedBody other = pressed_column(0.05, 0.1);
  corridors.offer(other);
  go_over(corridors, at(5.0));
  EXPECT_EQ(&corridors.body(), other.get());
  // One that cannot be followed is there for the next insertion.
  corridors.offer(shallow);
  corridors.go_on_in_newest();
  corridors.begin(Vec3::Zero(), Vec3::UnitZ());
  EXPECT_EQ(&corridors.body(), shallow.get());
}

TEST(EmbeddedNeedleTakeover, takes_no_memory_and_no_lock_in_the_tick) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer watches the heap";
  BegunNeedle corridors(pressed_column(0.05), rubbing_tissues());
  const WanderingHand hand(3);
  int tick = 0, taken = 0;
  for (int round = 0; round < 30; ++round) {
    corridors.offer(pressed_column(0.05, 0.05 * round));
    const RealTimeGuard guard;
    for (const int end = tick + 100; tick < end; ++tick) {
      corridors.needle().step(hand.at(tick));
      taken += corridors.go_on_in_newest() ? 1 : 0;
    }
    EXPECT_EQ(RealTimeGuard::heap_calls(), 0U);
    EXPECT_EQ(RealTimeGuard::lock_calls(), 0U);
  }
  EXPECT_GT(taken, 20);
}

}  // namespace
}  // namespace bodkin
