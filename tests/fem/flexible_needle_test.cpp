// EmbeddedNeedle with a shaft that bends.
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "tests/fem/bent_needle.h"
#include "tests/fem/hermite_beam.h"
#include "tests/fem/winkler_body.h"
#include <gtest/gtest.h>

#include "fem/embedded_needle.h"
#include "fem/shaft_constraints.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using checks::bending;
using checks::bent_rig;
using checks::flesh;
using checks::MonolithicNeedle;
using checks::NeedleRig;
using checks::steel_24g;
using checks::winkler_body;

TEST(FlexibleNeedle, one_firm_node_is_the_tip_of_a_cantilever) {
  const CondensedBody body = winkler_body(1, 1.0, 1e4);
  NeedleRig rig = bent_rig(body, checks::plain_tissues(0.0), bending(steel_24g));
  rig.move(0.9, 20.0);
  rig.move(Vec3(1.5, -0.5, 0.9), 20.0);
  const double outside = 90.0 - 0.9;
  const Vec3 expected = -Vec3(1.5, -0.5, 0.0) / (std::pow(outside, 3) / (3.0 * steel_24g) + 2e-4);
  EXPECT_LT((Vec3(rig.force.on_hand.force.x(), rig.force.on_hand.force.y(), 0.0) - expected).norm(),
            1e-9 * expected.norm());
}

TEST(FlexibleNeedle, held_at_both_ends_it_is_four_times_as_stiff) {
  // Two firm nodes hold the slope better the closer they are: 12 E I / L^3 (1 - O(spacing / L)).
  std::vector<double> stiffness;
  for (const double spacing : {2.0, 1.0, 0.5}) {
    const CondensedBody body = winkler_body(2, spacing, 1e7);
    EmbeddedNeedleSettings settings = checks::narrow_settings();
    settings.capture_radius = 0.4 * spacing;
    NeedleRig rig(body, checks::plain_tissues(0.0), settings, bending(steel_24g));
    rig.move(10.0, 20.0);
    rig.move(Vec3(1.0, 0.0, 10.0), 20.0);
    stiffness.push_back(-rig.force.on_hand.force.x());
  }
  const double guided = 12.0 * steel_24g / std::pow(80.0, 3);
  EXPECT_LT(std::abs(stiffness[2] - guided), 0.6 * std::abs(stiffness[1] - guided));
  const double at_none = (8.0 * stiffness[2] - 6.0 * stiffness[1] + stiffness[0]) / 3.0;
  EXPECT_NEAR(at_none, guided, 3e-4 * guided);
}

// A half-infinite beam on Winkler's foundation whose other end sticks out by `outside`, clamped and moved by 1 mm
// (Hetenyi, Beams on Elastic Foundation, 1946): e^(-bx) (A cos bx + B sin bx) inside, a cubic outside.
struct HetenyiNeedle {
  HetenyiNeedle(double rigidity, double foundation, double outside)
      : beta(std::pow(foundation / (4.0 * rigidity), 0.25)) {
    const double x = -outside, b = beta;
    // w = A + b (B - A) x - b^2 B x^2 + b^3 (A + B) x^3 / 3
    Eigen::Matrix2d matrix;
    matrix << 1.0 - b * x + b * b * b * x * x * x / 3.0, b * x - b * b * x * x + b * b * b * x * x * x / 3.0,
        -b + b * b * b * x * x, b - 2.0 * b * b * x + b * b * b * x * x;
    const Eigen::Vector2d found = matrix.fullPivLu().solve(Eigen::Vector2d(1.0, 0.0));
    a = found(0);
    c = found(1);
    force = 2.0 * rigidity * b * b * b * (a + c);
  }
  double deflection(double depth) const {
    return std::exp(-beta * depth) * (a * std::cos(beta * depth) + c * std::sin(beta * depth));
  }
  double beta, a = 0.0, c = 0.0, force = 0.0;
};

TEST(FlexibleNeedle, on_winklers_foundation_it_is_hetenyis_beam) {
  const HetenyiNeedle exact(steel_24g, 1.0, 30.0);
  double last = 0.0;
  for (const double spacing : {2.0, 1.0, 0.5}) {
    const CondensedBody body = winkler_body(static_cast<int>(60.0 / spacing), spacing, 1.0);
    EmbeddedNeedleSettings settings;
    settings.capture_radius = 0.4 * spacing;
    NeedleRig rig(body, checks::plain_tissues(0.0), settings, bending(steel_24g));
    rig.move(60.0, 50.0);
    rig.move(Vec3(1.0, 0.0, 60.0), 50.0);
    const double error = std::abs(rig.force.on_hand.force.x() + exact.force) / exact.force;
    if (last > 0.0) {
      EXPECT_NEAR(last / error, 4.0, 0.4) << spacing;
    }
    last = error;
    for (const double depth : {0.0, 5.0, 12.0, 30.0}) {
      const double there = 1.0 + rig.model.shaft_deflection(60.0 - depth).x();
      EXPECT_NEAR(there, exact.deflection(depth), 0.03 * spacing * spacing) << depth;
    }
  }
  EXPECT_LT(last, 1e-3);
}

// Random nodes of a body along and across a needle, some held, at any depth of it.
TEST(FlexibleNeedle, any_constraints_are_the_solution_of_all_equations_at_once) {
  Random random(1);
  double worst = 0.0;
  for (int trial = 0; trial < (sanitized ? 10 : 60); ++trial) {
    const NeedleHold hold = trial % 2 == 0 ? NeedleHold::clamped : NeedleHold::pinned;
    const double rigidity = std::pow(10.0, random.uniform(1.0, 4.0));
    const NeedleBeam beam({.rigidity = rigidity, .length = 90.0, .hold = hold});
    const Mat3 frame = checks::random_frame(random);
    ShaftConstraints constraints(flesh().compliance, 16, beam);
    constraints.begin(frame);
    const auto count = static_cast<std::size_t>(random.uniform(2.0, 15.0));
    std::vector<std::uint32_t> nodes;
    std::vector<double> depths;
    double depth = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      std::uint32_t node = 0;
      do {
        node = static_cast<std::uint32_t>(random.next() % flesh().nodes.size());
      } while (std::find(nodes.begin(), nodes.end(), node) != nodes.end());
      nodes.push_back(node);
      depths.push_back(depth);
      depth += random.uniform(0.3, 4.0);
      ASSERT_TRUE(constraints.push(nodes.back(), depths.back()));
      if (random.uniform() < 0.3) constraints.constrain_all_along();
    }
    const double softness = random.uniform(0.0, 30.0);
    ASSERT_TRUE(constraints.constrain_last_across(softness));
    for (std::size_t i = 0; i < count; ++i) {
      if (random.uniform() < 0.5) constraints.constrain_along(i);
      if (random.uniform() < 0.3) constraints.release_along(i);
    }
    const double tip = random.uniform(depth, 89.0);
    const double outside = 90.0 - tip;
    const MonolithicNeedle whole{rigidity, 90.0, hold == NeedleHold::pinned};
    std::vector<MonolithicNeedle::Row> rows;
    std::vector<std::size_t> place;
    std::vector<Vec3> directions;
    std::vector<double> displacements(3 * count), forces(3 * count, 0.0);
    for (double& displacement : displacements) displacement = random.normal();
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t c = constraints.constrained_along(i) ? 0 : 1; c < 3; ++c) {
        rows.push_back({static_cast<int>(c) - 1, outside + depths[i]});
        place.push_back(3 * i + c);
        directions.push_back(frame.col(static_cast<Eigen::Index>(c)));
      }
    }
    const auto size = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd compliance(size, size);
    Eigen::VectorXd moved(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const std::size_t at = place[static_cast<std::size_t>(i)];
      moved(i) = displacements[at];
      for (Eigen::Index j = 0; j < size; ++j) {
        const std::size_t other = place[static_cast<std::size_t>(j)];
        compliance(i, j) = directions[static_cast<std::size_t>(i)].dot(
            flesh().compliance.block<3, 3>(3 * nodes[at / 3], 3 * nodes[other / 3]) *
            directions[static_cast<std::size_t>(j)]);
      }
      if (at / 3 + 1 == count && at % 3 != 0) compliance(i, i) += softness;
    }
    const Eigen::VectorXd expected = whole.forces(rows, compliance, Eigen::Matrix2d::Zero(), moved);
    constraints.solve(displacements, forces, beam.root(tip));
    Eigen::VectorXd found(size);
    for (Eigen::Index i = 0; i < size; ++i) found(i) = forces[place[static_cast<std::size_t>(i)]];
    worst = std::max(worst, (found - expected).norm() / expected.norm());
  }
  EXPECT_LT(worst, 1e-9);
}

// The middle column of flesh(), firmly held without friction: forces on the hand by all equations at once.
Wrench monolithic_hand(const MonolithicNeedle& needle, std::size_t count, const Pose& pose) {
  std::vector<Eigen::Index> nodes;
  for (std::size_t i = 0; i < flesh().nodes.size() && nodes.size() < count; ++i) {
    if (flesh().nodes[i].head<2>().norm() < 1e-9) nodes.push_back(static_cast<Eigen::Index>(3 * i));
  }
  const Vec3 tip = pose.translation(), slope = needle_axis(pose) / needle_axis(pose).z();
  Eigen::Matrix2d hub;
  hub.row(0) = (tip - slope * needle.length).head<2>().transpose();
  hub.row(1) = slope.head<2>().transpose();
  std::vector<MonolithicNeedle::Row> rows;
  const auto size = static_cast<Eigen::Index>(2 * count);
  Eigen::MatrixXd compliance(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    rows.push_back({static_cast<int>(i % 2), needle.length - tip.z() + static_cast<double>(i / 2)});
    for (Eigen::Index j = 0; j < size; ++j) {
      compliance(i, j) = flesh().compliance(nodes[static_cast<std::size_t>(i / 2)] + i % 2,
                                            nodes[static_cast<std::size_t>(j / 2)] + j % 2);
    }
  }
  const Eigen::VectorXd forces = needle.forces(rows, compliance, hub, Eigen::VectorXd::Zero(size));
  Wrench hand;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();  // at the hub
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(count); ++i) {
    const Vec3 across(forces(2 * i), forces(2 * i + 1), 0.0);
    const double reach = static_cast<double>(i) - tip.z();
    const Vec3 square = across - Vec3(0.0, 0.0, across.dot(slope));
    hand.force -= square;
    hand.torque -= Vec3(reach * slope).cross(square);
    moment += (needle.length + reach) * across.head<2>();
  }
  if (!needle.pinned) hand.force.z() -= 0.5 * moment.squaredNorm() / needle.rigidity;
  return hand;
}

TEST(FlexibleNeedle, a_tilted_shaft_in_a_body_is_the_solution_of_all_equations_at_once) {
  Random random(2);
  for (const NeedleHold hold : {NeedleHold::clamped, NeedleHold::pinned}) {
    for (int trial = 0; trial < 10; ++trial) {
      const double rigidity = std::pow(10.0, random.uniform(1.0, 4.0));
      NeedleRig rig = bent_rig(flesh(), checks::plain_tissues(0.0), bending(rigidity, hold, 60.0));
      rig.move(10.9, 100.0);
      for (int state = 0; state < 3; ++state) {
        const Vec3 tip(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(10.65, 10.99));
        const Vec3 axis(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), 1.0);
        const Pose pose = needle_pose(tip, axis);
        const EmbeddedNeedleForce& force = rig.model.step(pose);
        ASSERT_EQ(force.nodes, 11u);
        const Wrench expected = monolithic_hand({rigidity, 60.0, hold == NeedleHold::pinned}, 11, pose);
        Vec3 difference = force.on_hand.force - expected.force;
        if (hold == NeedleHold::pinned) difference.z() = 0.0;  // the next test's
        EXPECT_LT(difference.norm(), 1e-9 * expected.force.norm());
        EXPECT_LT((force.on_hand.torque - expected.torque).norm(), 1e-9 * (expected.torque.norm() + 1.0));
      }
    }
  }
}

TEST(FlexibleNeedle, the_force_is_the_slope_of_the_stored_energy_in_every_direction) {
  Random random(3);
  for (const NeedleHold hold : {NeedleHold::clamped, NeedleHold::pinned}) {
    for (int trial = 0; trial < 10; ++trial) {
      NeedleRig rig =
          bent_rig(flesh(), checks::plain_tissues(0.0), bending(random.uniform(30.0, 1000.0), hold, 30.0));
      rig.move(10.9, 100.0);
      const Vec3 tip(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), random.uniform(10.7, 10.9));
      const Vec3 axis(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), 1.0);
      const auto energy = [&](const Vec3& at, const Vec3& along) {
        rig.model.step(needle_pose(at, along));
        return rig.model.stored_energy();
      };
      energy(tip, axis);
      const Wrench hand = rig.model.step(needle_pose(tip, axis)).on_hand;
      const double h = 1e-4;
      for (int i = 0; i < 3; ++i) {
        const Vec3 step = h * Vec3::Unit(i);
        const double slope = (energy(tip + step, axis) - energy(tip - step, axis)) / (2.0 * h);
        EXPECT_NEAR(hand.force(i), -slope, 1e-6 * (1.0 + std::abs(slope))) << i;
        const Eigen::AngleAxisd there(0.1 * h, Vec3::Unit(i)), back(-0.1 * h, Vec3::Unit(i));
        const double turned = (energy(tip, there * axis) - energy(tip, back * axis)) / (0.2 * h);
        EXPECT_NEAR(hand.torque(i), -turned, 1e-5 * (1.0 + std::abs(turned))) << i;
      }
    }
  }
}

TEST(FlexibleNeedle, a_pinned_hub_feels_no_torque) {
  NeedleRig rig = bent_rig(flesh(), checks::plain_tissues(0.0), bending(300.0, NeedleHold::pinned, 40.0));
  rig.move(10.9, 100.0);
  const Pose pose = needle_pose(Vec3(1.0, 0.5, 10.8), Vec3(0.03, 0.02, 1.0));
  const Wrench hand = rig.model.step(pose).on_hand;
  const Vec3 hub = -40.0 * needle_axis(pose);
  EXPECT_GT(hand.force.head<2>().norm(), 1e-3);
  // About the hub; along the line a force acts at the tip by definition, so only small terms of second order remain.
  const Vec3 about = hand.torque - hub.cross(hand.force - Vec3(0.0, 0.0, hand.force.z()));
  EXPECT_LT(about.norm(), 0.05 * hand.torque.norm());
}

TEST(FlexibleNeedle, one_that_does_not_bend_is_the_rigid_needle) {
  Random random(4);
  ContactTissues tissues = checks::plain_tissues(0.03);
  tissues[tissue::soft].puncture_force = 0.2;
  NeedleRig rigid(flesh(), tissues);
  NeedleRig beam = bent_rig(flesh(), tissues, bending(std::numeric_limits<double>::infinity()));
  for (int way = 0; way < (sanitized ? 5 : 60); ++way) {
    const Vec3 goal(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 14.0));
    const double speed = random.uniform(5.0, 200.0);
    rigid.move(goal, speed);
    beam.move(goal, speed);
    const double size = 1.0 + rigid.force.on_hand.force.norm();
    EXPECT_LT((rigid.force.on_hand.force - beam.force.on_hand.force).norm(), 1e-10 * size);
    EXPECT_LT((rigid.force.on_hand.torque - beam.force.on_hand.torque).norm(), 1e-10 * size);
    EXPECT_EQ(rigid.force.sticking, beam.force.sticking);
    EXPECT_LT(beam.force.tip_deflection.norm(), 1e-15);
  }
}

TEST(FlexibleNeedle, the_stiffer_the_nearer_to_the_rigid_needle) {
  const auto side_force = [](const std::optional<NeedleBeam>& beam) {
    NeedleRig rig(flesh(), checks::plain_tissues(0.0), checks::narrow_settings(), beam);
    rig.move(10.9, 20.0);
    rig.move(Vec3(0.5, 0.0, 10.9), 20.0);
    return -rig.force.on_hand.force.x();
  };
  const double rigid = side_force({});
  double last = rigid;
  for (const double rigidity : {1e8, 1e6, 1e4, 1e3, 1e2}) {
    const double force = side_force(bending(rigidity));
    EXPECT_LT(force, last);
    EXPECT_LT(std::abs(force - rigid), rigid * 3e6 / rigidity);
    last = force;
  }
}

}  // namespace
}  // namespace bodkin
