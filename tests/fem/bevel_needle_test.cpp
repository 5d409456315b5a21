// EmbeddedNeedle with a flexible bevelled needle: its path.
#include <cmath>
#include <vector>

#include "tests/fem/needle_rig.h"
#include "tests/fem/winkler_body.h"
#include "tests/sanitized.h"
#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "fem/embedded_needle.h"
#include "forces/bevel_tip.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::forces;
namespace {

constexpr double steel_27g = 257.0;  // N mm^2

// Pushed straight in by a hand that turns it about its axis.
class BevelRig {
 public:
  BevelRig(const CondensedBody& body, double spacing, double offset, double friction = 0.02,
           double rigidity = steel_27g)
      : model_(body, checks::plain_tissues(friction), settings(spacing), 1e-3,
               NeedleBeam({.rigidity = rigidity, .length = 120.0, .cut_offset = offset})) {
    model_.begin(Vec3::Zero(), Vec3::UnitZ());
    step(-0.5, 0.0);
  }
  const EmbeddedNeedleForce& step(double depth, double roll) {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::AngleAxisd(roll, Vec3::UnitZ()).toRotationMatrix();
    pose.translation() = Vec3(0.0, 0.0, depth);
    const EmbeddedNeedleForce before = force;
    force = model_.step(pose);
    work -= 0.5 * (force.on_hand.force.z() + before.on_hand.force.z()) * (depth - depth_);
    depth_ = depth;
    return force;
  }
  // At 20 mm/s; the tip every tick.
  void go(double depth, double roll = 0.0) {
    const int ticks = std::max(1, static_cast<int>(std::abs(depth - depth_) / 0.02));
    const double start = depth_;
    for (int tick = 1; tick <= ticks; ++tick) {
      step(start + (depth - start) * tick / ticks, roll);
      depths.push_back(depth_);
      sides.push_back(force.tip_deflection);
    }
  }
  // 1/mm, of the way of the tip between two depths, towards -y: that of the parabola through it.
  double curvature(double from, double to, int axis = 1) const {
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < depths.size(); ++i) {
      if (depths[i] >= from && depths[i] <= to) used.push_back(i);
    }
    Eigen::MatrixXd powers(static_cast<Eigen::Index>(used.size()), 3);
    Eigen::VectorXd values(powers.rows());
    for (Eigen::Index i = 0; i < powers.rows(); ++i) {
      const double z = depths[used[static_cast<std::size_t>(i)]] - from;
      powers.row(i) << 1.0, z, z * z;
      values(i) = sides[used[static_cast<std::size_t>(i)]](axis);
    }
    return -2.0 * Mat3(powers.transpose() * powers).inverse().row(2).dot(powers.transpose() * values);
  }

  EmbeddedNeedleForce force;
  std::vector<double> depths;  // mm
  std::vector<Vec3> sides;     // mm, of the tip
  double work = 0.0;           // N mm, of the hand

  const EmbeddedNeedle& model() const { return model_; }

 private:
  static EmbeddedNeedleSettings settings(double spacing) {
    EmbeddedNeedleSettings settings;
    settings.capture_radius = 0.9 * spacing;
    settings.most_nodes = 160;
    return settings;
  }

  EmbeddedNeedle model_;
  double depth_ = -0.5;
};

constexpr double even_foundation = 0.5;  // N/mm^2

CondensedBody even_tissue(double spacing) {
  return checks::winkler_body(static_cast<int>(65.0 / spacing), spacing, even_foundation);
}

// A beam on Winkler's foundation whose hole is cut `offset` beside its axis and whose tip is free: w = y - c follows
// e^(-bz) (A cos bz + B sin bz), z from the tip; w(0) = -offset, no shear force, no moment: y'' = 0 there. That
// leaves c'' = 2 b^2 offset. As a bicycle (bevel_curvature): wheel base 1/b, steering angle 2 b offset.
double curvature_to_be(double offset, double rigidity = steel_27g) {
  const double beta = winkler_tip(rigidity, even_foundation, 0.0).beta;
  return bevel_curvature(std::atan(2.0 * beta * offset), 1.0 / beta);
}

TEST(BevelNeedle, bends_with_the_curvature_of_a_beam_on_a_foundation) {
  EXPECT_NEAR(curvature_to_be(0.1), 0.00441, 1e-5);
  std::vector<double> found;
  for (const double spacing : {1.6, 0.8, 0.4}) {
    if (sanitized && spacing < 0.5) continue;
    const CondensedBody body = even_tissue(spacing);
    BevelRig rig(body, spacing, 0.1);
    rig.go(56.0);
    found.push_back(rig.curvature(30.0, 56.0));
    EXPECT_LT(std::abs(rig.force.tip_deflection.x()), 1e-9);
    EXPECT_FALSE(rig.force.full);
  }
  // The shaft is held by its hole only from about one node behind the tip: an error that shrinks with the spacing.
  EXPECT_GT(found[1], found[0]);
  if (sanitized) return;
  EXPECT_LT(found[2], curvature_to_be(0.1));
  EXPECT_NEAR(2.0 * found[2] - found[1], curvature_to_be(0.1), 0.03 * curvature_to_be(0.1));
}

TEST(BevelNeedle, a_stiffer_needle_bends_less_and_a_symmetric_point_not_at_all) {
  const CondensedBody body = even_tissue(0.5);
  double last = 1.0;
  for (const double rigidity : {100.0, 257.0, 878.0, 1e5}) {
    BevelRig rig(body, 0.5, 0.1, 0.02, rigidity);
    rig.go(50.0);
    const double side = -rig.force.tip_deflection.y();
    EXPECT_GT(side, 0.0);
    EXPECT_LT(side, last * 20.0);
    last = side / 20.0;
  }
  BevelRig straight(body, 0.5, 0.0);
  straight.go(50.0);
  EXPECT_LT(straight.force.tip_deflection.norm(), 1e-12);
}

TEST(BevelNeedle, goes_where_its_point_is) {
  const CondensedBody body = even_tissue(0.5);
  BevelTip path(0.005, 100.0);  // both go the same way
  EXPECT_LT(path.step(40.0, 0.0).translation().y(), 0.0);
  Vec3 first = Vec3::Zero();
  for (const double roll : {0.0, 90.0, 180.0, 215.0}) {
    BevelRig rig(body, 0.5, 0.1);
    rig.go(40.0, roll * degree);
    const Vec3 side = Eigen::AngleAxisd(-roll * degree, Vec3::UnitZ()) * rig.force.tip_deflection;
    EXPECT_LT(side.y(), -0.5);
    if (roll == 0.0) first = side;
    EXPECT_LT((side - first).norm(), 1e-9) << roll;
  }
}

TEST(BevelNeedle, turned_by_180_degrees_half_way_it_bends_back) {
  const CondensedBody body = even_tissue(0.5);
  BevelRig once(body, 0.5, 0.1), twice(body, 0.5, 0.1), mirrored(body, 0.5, 0.1);
  once.go(60.0);
  twice.go(25.0);
  const Vec3 half_way = twice.force.tip_deflection;
  twice.go(60.0, 180.0 * degree);
  mirrored.go(25.0, 180.0 * degree);
  mirrored.go(60.0, 0.0);
  EXPECT_LT(half_way.y(), -0.2);
  EXPECT_GT(twice.curvature(10.0, 25.0), 0.5 * curvature_to_be(0.1));
  EXPECT_NEAR(twice.curvature(45.0, 60.0), -curvature_to_be(0.1), 0.25 * curvature_to_be(0.1));
  // It ends between the ends of a straight and of an unturned insertion.
  EXPECT_GT(twice.force.tip_deflection.y(), 0.7 * once.force.tip_deflection.y());
  EXPECT_LT((twice.force.tip_deflection + mirrored.force.tip_deflection).norm(), 1e-9);
}

TEST(BevelNeedle, at_rest_and_on_the_way_back_nothing_is_cut) {
  const CondensedBody body = even_tissue(0.5);
  BevelRig rig(body, 0.5, 0.1);
  rig.go(30.2);
  const Vec3 side = rig.force.tip_deflection;
  for (int tick = 0; tick < 200; ++tick) rig.step(30.2, 0.5 * tick * degree);  // turned in place
  EXPECT_LT((rig.force.tip_deflection - side).norm(), 1e-9);
  rig.go(25.2, 180.0 * degree);
  const double energy = rig.model().stored_energy();
  rig.go(25.0, 90.0 * degree);
  EXPECT_LE(rig.model().stored_energy(), energy + 1e-6);
}

TEST(BevelNeedle, without_friction_nothing_pays_for_a_bend) {
  const CondensedBody body = even_tissue(0.5);
  BevelRig rig(body, 0.5, 0.1, 0.0);
  rig.go(40.0);
  EXPECT_LT(rig.force.tip_deflection.norm(), 1e-12);
}

TEST(BevelNeedle, what_is_stored_in_a_bend_came_from_the_hand) {
  const CondensedBody body = even_tissue(0.5);
  for (const double friction : {0.0005, 0.002, 0.02}) {
    BevelRig rig(body, 0.5, 0.3, friction);
    double least = 1.0;
    for (const double depth : {5.0, 20.0, 15.0, 35.0, 20.0, 50.0, 5.0, 30.0, -0.5}) {
      rig.go(depth, depth * 10.0 * degree);
      least = std::min(least, rig.work - rig.model().stored_energy());
    }
    EXPECT_GT(least, -1e-4) << friction;
  }
}

}  // namespace
}  // namespace bodkin
