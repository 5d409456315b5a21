#include "fem/embedded_needle.h"

#include <vector>

#include "tests/fem/needle_rig.h"
#include "tests/sanitized.h"
#include "tests/simulation/real_time_guard.h"
#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/shortest_turn.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using checks::NeedleRig;

// Points 1 mm apart, 30 mm deep. So stiff that it hardly deforms.
CondensedBody stiff_body() {
  CondensedBody body = checks::kelvin_body(1, 31, 1.0, 20.0);
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    if (body.nodes[i].z() > 19.5) body.tissues[i] = tissue::interspinous_ligament;
  }
  return body;
}

const CondensedBody& soft_body() {
  static const CondensedBody body = checks::kelvin_body(1, sanitized ? 16 : 41, 1.0, 0.05);
  return body;
}

ContactTissues two_tissues() {
  ContactTissues tissues = checks::plain_tissues(0.02);
  tissues[tissue::interspinous_ligament].friction = 0.2;
  return tissues;
}

TEST(EmbeddedNeedle, twenty_mm_of_soft_tissue_and_five_of_ligament_rub_with_1400_mN) {
  const CondensedBody body = stiff_body();
  NeedleRig rig(body, two_tissues());
  rig.move(25.0, 10.0);
  EXPECT_NEAR(rig.force.resistance, 1.4, 1e-9);
  EXPECT_EQ(rig.force.nodes, 26u);
  const double before = rig.force.resistance;
  for (int tick = 0; tick < 200; ++tick) rig.to(25.0);
  EXPECT_LE(rig.force.resistance, 1.4 + 1e-9);
  EXPECT_NEAR(rig.force.resistance, before, 1e-9);  // held at rest
}

TEST(EmbeddedNeedle, withdrawal_turns_the_friction_round_without_a_jump) {
  const CondensedBody body = stiff_body();
  NeedleRig rig(body, two_tissues());
  rig.move(25.5, 10.0);
  const double deepest = rig.force.resistance;
  EXPECT_NEAR(deepest, 1.5, 1e-9);
  // 10 nm a tick, in tissue that is some 400 N/mm stiff along the shaft.
  EXPECT_LT(rig.move(25.49, 0.01), 0.01);
  rig.move(25.0, 10.0);
  EXPECT_NEAR(rig.force.resistance, -1.4, 1e-9);
  rig.move(-0.5, 20.0);
  EXPECT_EQ(rig.force.resistance, 0.0);
  EXPECT_EQ(rig.force.nodes, 0u);
}

TEST(EmbeddedNeedle, tip_is_held_back_until_the_puncture_force_and_for_30_ms_after) {
  ContactTissues tissues = checks::plain_tissues(0.0);
  tissues[tissue::soft].puncture_force = 1.5;
  NeedleRig rig(soft_body(), tissues);
  std::size_t first = 0;
  for (std::size_t i = 0; i < soft_body().nodes.size(); ++i) {
    if (soft_body().nodes[i].norm() < 1e-9) first = 3 * i + 2;
  }
  const double own = soft_body().compliance(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(first));
  double depth = 0.0;
  while (!rig.force.puncture && depth < 100.0) {
    depth += 0.01;
    rig.to(depth);
    ASSERT_NEAR(rig.force.resistance, depth / own, 1e-9) << depth;
  }
  ASSERT_TRUE(rig.force.puncture.has_value());
  EXPECT_NEAR(depth, 1.5 * own, 0.01);
  EXPECT_GE(rig.force.puncture->force, 1.5);
  EXPECT_EQ(rig.force.puncture->tissue, tissue::soft);
  double last = rig.force.resistance;
  for (int tick = 1; tick <= 32; ++tick) {
    rig.to(depth);
    EXPECT_LE(rig.force.resistance, last + 1e-9);
    EXPECT_GT(rig.force.resistance, last - 0.06) << tick;  // 1.5 N in 30 ms
    last = rig.force.resistance;
  }
  EXPECT_NEAR(last, 0.0, 1e-7);
  // Once punctured, it stays so until reset().
  rig.move(-1.0, 100.0);
  rig.begin();
  rig.move(10.0, 20.0);
  EXPECT_NEAR(rig.force.resistance, 0.0, 1e-7);
  rig.model.reset();
  rig.begin();
  rig.to(0.5);
  EXPECT_NEAR(rig.force.resistance, 0.5 / own, 1e-9);
}

TEST(EmbeddedNeedle, the_tip_never_pulls_on_the_tissue_in_front_of_it) {
  ContactTissues tissues = checks::plain_tissues(0.05);
  tissues[tissue::soft].puncture_force = 100.0;  // stays whole
  NeedleRig rig(soft_body(), tissues);
  for (int turn = 0; turn < 3; ++turn) {
    rig.move(2.0, 20.0);
    EXPECT_GT(rig.force.resistance, 0.1);
    for (double depth = 2.0; depth > -2.0; depth -= 0.02) EXPECT_GE(rig.to(depth).resistance, 0.0) << depth;
  }
}

// Forces of a straight needle moved sideways, by a dense solve over its points.
Eigen::VectorXd dense_forces(const CondensedBody& body, std::size_t nodes, const Mat3& directions, int first,
                             int columns, const Vec3& moved) {
  std::vector<Eigen::Index> held;
  for (std::size_t i = 0; i < body.nodes.size() && held.size() < nodes; ++i) {
    if (body.nodes[i].head<2>().norm() < 1e-9) held.push_back(static_cast<Eigen::Index>(3 * i));
  }
  const Eigen::MatrixXd basis = directions.middleCols(first, columns);
  const Eigen::Index rows = columns * static_cast<Eigen::Index>(held.size());
  Eigen::MatrixXd matrix(rows, rows);
  Eigen::VectorXd right(rows);
  for (std::size_t i = 0; i < held.size(); ++i) {
    const Eigen::Index at = columns * static_cast<Eigen::Index>(i);
    right.segment(at, columns) = basis.transpose() * moved;
    for (std::size_t j = 0; j < held.size(); ++j) {
      matrix.block(at, columns * static_cast<Eigen::Index>(j), columns, columns) =
          basis.transpose() * body.compliance.block<3, 3>(held[i], held[j]) * basis;
    }
  }
  return matrix.ldlt().solve(right);
}

TEST(EmbeddedNeedle, a_sliding_shaft_pushed_sideways_is_the_dense_solve) {
  NeedleRig rig(soft_body(), checks::plain_tissues(0.0));
  rig.move(10.9, 20.0);
  const Vec3 aside(0.3, -0.2, 0.0);
  rig.move(aside + Vec3(0.0, 0.0, 10.9), 20.0);
  ASSERT_EQ(rig.force.nodes, 11u);
  EXPECT_EQ(rig.force.sticking, 0u);
  const Eigen::VectorXd forces = dense_forces(soft_body(), 11, Mat3::Identity(), 0, 2, aside);
  Vec3 total = Vec3::Zero();
  for (Eigen::Index i = 0; i < 11; ++i) total += Vec3(forces(2 * i), forces(2 * i + 1), 0.0);
  EXPECT_LT((rig.force.on_hand.force + total).norm(), 1e-10 * total.norm());
  Vec3 torque = Vec3::Zero();
  for (Eigen::Index i = 0; i < 11; ++i) {
    torque += Vec3(0.0, 0.0, static_cast<double>(i) - 10.9).cross(Vec3(forces(2 * i), forces(2 * i + 1), 0.0));
  }
  EXPECT_LT((rig.force.on_hand.torque + torque).norm(), 1e-10 * torque.norm());
}

TEST(EmbeddedNeedle, a_sticking_shaft_changes_its_force_as_the_dense_solve_says) {
  NeedleRig rig(soft_body(), checks::plain_tissues(5.0));
  rig.move(10.9, 20.0);
  for (int tick = 0; tick < 100; ++tick) rig.to(10.9);
  rig.to(10.899);  // all of it turns round and sticks
  const Vec3 before = rig.force.on_hand.force;
  ASSERT_EQ(rig.force.sticking, 11u);
  const Vec3 moved(0.002, 0.001, -0.001);
  rig.to(Vec3(moved + Vec3(0.0, 0.0, 10.899)));
  ASSERT_EQ(rig.force.sticking, 11u);
  const Eigen::VectorXd forces = dense_forces(soft_body(), 11, Mat3::Identity(), 0, 3, moved);
  Vec3 total = Vec3::Zero();
  for (Eigen::Index i = 0; i < 11; ++i) total += forces.segment<3>(3 * i);
  EXPECT_LT((rig.force.on_hand.force - before + total).norm(), 1e-9 * total.norm());
}

TEST(EmbeddedNeedle, forces_are_continuous_wherever_nothing_is_punctured) {
  NeedleRig rig(soft_body(), checks::plain_tissues(0.02));
  Random random(1);
  double largest = 0.0;
  for (int way = 0; way < (sanitized ? 6 : 40); ++way) {
    largest = std::max(
        largest,
        rig.move(Vec3(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(0.0, 14.0)), 2.0));
  }
  // 2 um a tick; the shaft sticking in 14 mm of this tissue is about 2 N/mm stiff in any direction.
  EXPECT_LT(largest, 0.012);
  EXPECT_GT(largest, 1e-4);
}

TEST(EmbeddedNeedle, a_node_comes_and_goes_without_a_jump) {
  NeedleRig rig(soft_body(), checks::plain_tissues(0.02));
  rig.move(4.5, 10.0);
  rig.move(Vec3(0.4, 0.0, 4.5), 10.0);
  // Back and forth over two nodes, 0.1 um a tick where they are met.
  for (const double node : {4.0, 5.0, 4.0, 3.0, 5.0}) {
    rig.move(node - 0.01, 10.0);
    EXPECT_LT(rig.move(node + 0.01, 0.1), 1e-3) << node;
    EXPECT_LT(rig.move(node - 0.01, 0.1), 1e-3) << node;
  }
}

TEST(EmbeddedNeedle, no_way_gives_more_work_than_went_in) {
  Random random(2);
  ContactTissues tissues = checks::plain_tissues(0.05);
  tissues[tissue::soft].puncture_force = 0.2;
  double least = 1e9;
  for (int trial = 0; trial < 100; ++trial) {
    tissues[tissue::soft].friction = trial % 3 == 0 ? 0.0 : random.uniform(0.001, 0.5);
    NeedleRig rig(soft_body(), tissues);
    for (int way = 0; way < 12; ++way) {
      rig.move(Vec3(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 14.0)),
               random.uniform(5.0, 400.0));
      ASSERT_GT(rig.work - rig.model.stored_energy(), -1e-9 * (1.0 + rig.way)) << trial << ", " << way;
    }
    rig.move(-1.0, 50.0);
    ASSERT_GT(rig.work, -1e-9 * rig.way) << trial;
    EXPECT_EQ(rig.force.on_hand.force.norm(), 0.0);
    least = std::min(least, rig.work);
  }
  EXPECT_LT(least, 1.0);  // N mm: with little friction, little is lost
}

// Indented tissue closes on the shaft within a few ticks.
TEST(EmbeddedNeedle, work_less_stored_energy_never_falls_behind_a_border_that_has_given_way) {
  ContactTissues tissues = checks::plain_tissues(0.05);
  tissues[tissue::soft].puncture_force = 0.3;
  for (const double speed : {50.0, 120.0, 230.0, 480.0}) {
    NeedleRig rig(soft_body(), tissues);
    double most = 0.0;
    std::size_t punctures = 0;
    for (double depth = -1.0; depth < 14.0; depth += speed * 1e-3) {
      rig.to(depth);
      punctures += rig.force.puncture.has_value() ? 1 : 0;
      const double left = rig.work - rig.model.stored_energy();
      ASSERT_GT(left, most - 1e-9) << speed << " mm/s at " << depth;
      most = std::max(most, left);
    }
    EXPECT_EQ(punctures, 1u);
    EXPECT_GT(rig.force.nodes, 8u);
  }
}

TEST(EmbeddedNeedle, tilting_needles_give_no_work_either) {
  Random random(3);
  for (int trial = 0; trial < (sanitized ? 3 : 30); ++trial) {
    EmbeddedNeedle model(soft_body(), checks::plain_tissues(0.05), checks::narrow_settings(), 1e-3);
    model.begin(Vec3::Zero(), Vec3::UnitZ());
    Pose last = needle_pose(Vec3(0.0, 0.0, -1.0), Vec3::UnitZ());
    EmbeddedNeedleForce before = model.step(last);
    double work = 0.0;
    const double speed = random.uniform(1.0, 4.0), phase = random.uniform(0.0, 6.0);
    const double lean = random.uniform(0.0, 0.1);
    const int ticks = 4000;
    for (int tick = 1; tick <= ticks; ++tick) {
      const double t = static_cast<double>(tick) / ticks;
      const double swing = std::sin(3.14159265358979323846 * t);
      const Vec3 tip(0.8 * swing * std::sin(speed * 9.0 * t + phase), 0.8 * swing * std::sin(speed * 5.0 * t),
                     -1.0 + 13.0 * swing * std::abs(std::sin(speed * 4.0 * t + phase)));
      Vec3 axis(lean * std::sin(speed * 6.0 * t), lean * std::sin(speed * 8.0 * t + phase), 1.0);
      Pose now = Pose::Identity();  // the least turn from z, so that turning is what it seems
      now.linear() = shortest_turn(Vec3::UnitZ(), axis).toRotationMatrix();
      now.translation() = tip;
      const EmbeddedNeedleForce force = model.step(now);
      const Eigen::AngleAxisd turn(now.linear() * last.linear().transpose());
      const Vec3 turned = turn.angle() * turn.axis();
      // The mean of both ends; the torque is about the tip, which is what the force moves.
      work -= 0.5 * (force.on_hand.force + before.on_hand.force).dot(now.translation() - last.translation()) +
              0.5 * (force.on_hand.torque + before.on_hand.torque).dot(turned);
      before = force;
      last = now;
    }
    EXPECT_GT(work, -2e-3) << trial;
  }
}

TEST(EmbeddedNeedle, a_hundred_thousand_ticks_at_random_are_all_finite_and_take_no_memory_and_no_lock) {
  Random random(4);
  ContactTissues tissues = default_contact_tissues();
  EmbeddedNeedle model(soft_body(), tissues, checks::narrow_settings(), 1e-3);
  model.begin(Vec3::Zero(), Vec3::UnitZ());
  bool finite = true;
  Vec3 tip(0.0, 0.0, -1.0);
  std::uint32_t most = 0;
  {
    const RealTimeGuard guard;
    for (int tick = 0; tick < (sanitized ? 3000 : 100000); ++tick) {
      if (random.uniform() < 0.001) tip = Vec3(random.normal(), random.normal(), random.uniform(-5.0, 50.0));
      if (random.uniform() < 0.0005) model.begin(Vec3(0.1, 0.0, 0.0), Vec3(0.05, 0.0, 1.0).normalized());
      if (random.uniform() < 0.0002) model.reset();
      tip += 0.1 * Vec3(random.normal(), random.normal(), random.normal() + 0.01);
      const Vec3 axis = Vec3(0.1 * random.normal(), 0.1 * random.normal(), 1.0).normalized();
      const EmbeddedNeedleForce& force = model.step(needle_pose(tip, axis));
      finite = finite && std::isfinite(force.on_hand.force.sum() + force.on_hand.torque.sum());
      most = std::max(most, force.nodes);
    }
    if (RealTimeGuard::available()) {
      EXPECT_EQ(RealTimeGuard::heap_calls(), 0u);
      EXPECT_EQ(RealTimeGuard::lock_calls(), 0u);
    }
  }
  EXPECT_TRUE(finite);
  EXPECT_GT(most, 5u);
}

TEST(EmbeddedNeedle, the_same_motion_gives_the_same_bits) {
  NeedleRig rig(soft_body(), default_contact_tissues());
  std::vector<double> first;
  for (const bool again : {false, true}) {
    Random random(5);
    rig.model.reset();
    rig.begin();
    for (int way = 0; way < 10; ++way) {
      rig.move(Vec3(random.uniform(-1.0, 1.0), 0.0, random.uniform(-1.0, 14.0)), 50.0);
      if (again) {
        EXPECT_EQ(first[static_cast<std::size_t>(way)], rig.force.on_hand.force.sum());
      } else {
        first.push_back(rig.force.on_hand.force.sum());
      }
    }
  }
}

TEST(EmbeddedNeedle, says_when_its_room_and_when_its_points_end) {
  EmbeddedNeedleSettings settings = checks::narrow_settings();
  settings.most_nodes = 5;
  NeedleRig rig(soft_body(), checks::plain_tissues(0.02), settings);
  rig.move(4.2, 20.0);
  EXPECT_FALSE(rig.force.full);
  rig.move(9.0, 20.0);
  EXPECT_TRUE(rig.force.full);
  EXPECT_EQ(rig.force.nodes, 5u);
  EXPECT_FALSE(rig.force.beyond);
  rig.move(60.0, 50.0);
  EXPECT_TRUE(rig.force.beyond);
}

TEST(EmbeddedNeedle, no_needle_no_force_and_the_state_stays) {
  NeedleRig rig(soft_body(), checks::plain_tissues(0.02));
  rig.move(8.0, 20.0);
  const double before = rig.force.resistance;
  Pose wrong = needle_pose(Vec3(0.0, 0.0, std::nan("")), Vec3::UnitZ());
  EXPECT_TRUE(rig.model.step(wrong).fault);
  wrong = needle_pose(Vec3(0.0, 0.0, 8.0), Vec3::UnitX());
  EXPECT_TRUE(rig.model.step(wrong).fault);
  EXPECT_EQ(rig.model.step(wrong).on_hand.force.norm(), 0.0);
  EXPECT_NEAR(rig.to(8.0).resistance, before, 1e-12);
}

TEST(EmbeddedNeedle, refuses_settings_out_of_range_and_bodies_that_do_not_fit) {
  const ContactTissues tissues = checks::plain_tissues(0.02);
  EmbeddedNeedleSettings settings;
  settings.capture_radius = -1.0;
  EXPECT_THROW(EmbeddedNeedle(soft_body(), tissues, settings, 1e-3), InputError);
  settings = {};
  settings.most_nodes = 161;
  EXPECT_THROW(EmbeddedNeedle(soft_body(), tissues, settings, 1e-3), InputError);
  EXPECT_THROW(EmbeddedNeedle(soft_body(), tissues, {}, 0.0), InputError);
  CondensedBody body = soft_body();
  body.tissues.pop_back();
  EXPECT_THROW(EmbeddedNeedle(body, tissues, {}, 1e-3), InputError);
  ContactTissues bad = tissues;
  bad[7].friction = std::nan("");
  EXPECT_THROW(EmbeddedNeedle(soft_body(), bad, {}, 1e-3), InputError);
}

}  // namespace
}  // namespace bodkin
