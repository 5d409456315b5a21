// A needle in the hand and a probe that presses, coupled both ways: the force on the probe includes the needle's
// part, and the needle feels the probe's motion and hold of the tissue. Against one dense solution of the whole body.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tests/fem/needle_rig.h"
#include "tests/fem/solid/whole_body.h"
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "core/random.h"
#include "fem/contact_line.h"
#include "fem/solid/contact_body.h"
#include "fem/solid/line_points.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using checks::small_block;
using checks::WholeBody;
namespace {

const Vec3 entry_beside_probe(18.0, 12.0, checks::top);
constexpr double depth_beside_probe = 21.0;  // mm, of the tip, well past the last point

// A line beside pressed nodes, its points computed as a session does it: with these nodes held from the beginning, or
// `late`, when the needle is in.
class LineBesideProbe {
 public:
  explicit LineBesideProbe(const std::vector<NeedlePath>& left = {}, bool late = false)
      : body_(small_block()),
        held_(checks::pressed_nodes(body_.description().mesh)),
        left_(left),
        late_(late),
        line_(0.0, held_.size()) {
    std::vector<ContactSite> sites;
    for (int i = 0; i < 9; ++i) {
      const double depth = 2.1 * i;
      sites.push_back({entry_beside_probe - depth * Vec3::UnitZ(), depth, tissue::soft, false, false});
    }
    line_.request(entry_beside_probe, -Vec3::UnitZ(), late ? std::vector<std::uint32_t>() : held_);
    const ContactLine::Line asked = line_.next_line().value();
    bound_ = body_.bind(left, {asked.held.data(), asked.held_count});
    points_.emplace(body_, 1.0, bound_);
    points_->add(sites, -Vec3::UnitZ());
    points_->stream(0, [&](const ContactPoint& point) { return line_.append(asked, point); });
    line_.complete(asked);
  }
  const ContactBody& body() const { return body_; }
  const TetrahedralMesh& mesh() const { return body_.description().mesh; }
  const std::vector<std::uint32_t>& held() const { return held_; }
  const ContactLine& line() const { return line_; }
  int points() const { return static_cast<int>(line_.progress().points); }  // of two in an element at most
  // Straight in, without friction. A late probe takes its nodes then.
  EmbeddedNeedle needle() {
    EmbeddedNeedle needle(line_.body(), checks::plain_tissues(0.0), {}, 1e-3, {}, &line_.other());
    needle.begin_growing(entry_beside_probe, -Vec3::UnitZ());
    needle.extend(line_.progress().points, true);
    for (double depth = -0.5; depth < depth_beside_probe; depth += 0.05) needle.step(pose(depth));
    if (late_) take_nodes(needle);
    return needle;
  }
  static Pose pose(double depth, const Vec3& aside = Vec3::Zero(), const Vec3& lean = Vec3::Zero()) {
    return needle_pose(entry_beside_probe - depth * Vec3::UnitZ() + aside, (lean - Vec3::UnitZ()).normalized());
  }

 private:
  // While the needle is held aside. No force changes in these ticks.
  void take_nodes(EmbeddedNeedle& needle) {
    const Pose aside = pose(depth_beside_probe, Vec3(0.3, 0.2, 0.0));
    const Wrench before = needle.step(aside).on_hand;
    const double lateral = before.force.head<2>().norm();
    ASSERT_GT(lateral, 0.01);
    const auto count = static_cast<std::size_t>(points());
    line_.couple(held_, count);
    const ContactLine::Line asked = line_.next_line().value();
    ASSERT_TRUE(asked.is_coupling);
    EXPECT_EQ(line_.progress().points, count);
    EXPECT_TRUE(line_.progress().complete);
    EXPECT_FALSE(line_.is_coupled());
    bound_ = body_.bind(left_, {asked.held.data(), asked.held_count});
    points_->bind_again();
    for (std::size_t i = 0; i < count; ++i) ASSERT_TRUE(line_.put(asked, i, points_->point(i)));
    line_.end_coupling(asked, true);
    ASSERT_TRUE(line_.is_coupled());
    needle.exchange();
    int ticks = 0;
    for (; needle.exchanges(); ++ticks) {
      ASSERT_LT(ticks, 20);
      const Wrench now = needle.step(aside).on_hand;
      EXPECT_LT((now.force - before.force).norm(), 1e-9 * lateral) << ticks;
    }
    EXPECT_TRUE(needle.exchanged());
    EXPECT_GE(ticks, 4) << "a few points in a tick";
    EXPECT_LT((needle.step(aside).on_hand.force - before.force).norm(), 1e-9 * lateral);
    line_.apply_coupling();
  }

 private:
  ContactBody body_;
  std::vector<std::uint32_t> held_;
  std::vector<NeedlePath> left_;
  bool late_;
  ContactLine line_;
  BoundPoints bound_;
  std::optional<LinePoints> points_;
};

// The probe's motion of its held nodes: it has come down, and tilts.
Eigen::VectorXd press_of(const LineBesideProbe& rig) {
  Eigen::VectorXd press(3 * static_cast<Eigen::Index>(rig.held().size()));
  for (std::size_t i = 0; i < rig.held().size(); ++i) {
    const Vec3 from = rig.mesh().nodes[rig.held()[i]] - Vec3(26.0, 10.0, checks::top);
    press.segment<3>(static_cast<Eigen::Index>(3 * i)) = Vec3(0.1, 0.0, -1.2) + Vec3(0.01, 0.02, 0.0).cross(from);
  }
  return press;
}

Vec3 middle_of(const LineBesideProbe& rig) {
  Vec3 middle = Vec3::Zero();
  for (const std::uint32_t node : rig.held())
    middle += rig.mesh().nodes[node] / static_cast<double>(rig.held().size());
  return middle;
}

// N, and N mm about the middle at rest of the held nodes, from the forces that hold them.
Wrench on_probe(const LineBesideProbe& rig, const Eigen::VectorXd& holding) {
  const Vec3 middle = middle_of(rig);
  Wrench sum;
  for (std::size_t i = 0; i < rig.held().size(); ++i) {
    const Vec3 force = -holding.segment<3>(static_cast<Eigen::Index>(3 * i));
    sum.force += force;
    sum.torque += (rig.mesh().nodes[rig.held()[i]] - middle).cross(force);
  }
  return sum;
}

void expect_coupled_as_in_a_dense_solution(const std::vector<NeedlePath>& left, bool late = false) {
  LineBesideProbe rig(left, late);
  WholeBody whole(rig.body().description());
  for (const NeedlePath& needle : left) whole.leave(needle.entry, needle.target);
  for (const std::uint32_t node : rig.held()) whole.hold(node);
  const CondensedBody& points = rig.line().body();
  const int count = rig.points();
  ASSERT_GE(count, 7);
  const std::size_t nodes = rig.mesh().nodes.size();
  const auto of_held = 3 * static_cast<Eigen::Index>(rig.held().size());
  // The last column: only the probe. The others: a force across the needle at each of its points.
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(nodes), 2 * count + 1);
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(of_held, loads.cols());
  moved.rightCols<1>() = press_of(rig);
  std::vector<PlaceInElement> places(points.in_mesh.begin(), points.in_mesh.begin() + count);
  const Eigen::MatrixXd spread = checks::spread_of(places, nodes);
  for (int i = 0; i < count; ++i)
    for (int axis = 0; axis < 2; ++axis) loads.col(2 * i + axis) = spread.col(3 * i + axis);
  const WholeBody::Solution dense = whole.solve(loads, moved);
  const Eigen::MatrixXd at_points = spread.transpose() * dense.moved;

  // The needle: pressed tissue has moved it aside; then it is moved and tilted.
  EmbeddedNeedle needle = rig.needle();
  const Eigen::VectorXf field = dense.moved.rightCols<1>().cast<float>();
  for (int tick = 0; tick < 1500; ++tick) {
    needle.move_with({field.data(), static_cast<std::size_t>(field.size())});
    needle.step(LineBesideProbe::pose(depth_beside_probe));
  }
  const Vec3 aside(0.4, -0.3, 0.0), lean(0.02, 0.01, 0.0);
  const Wrench on_hand = needle.step(LineBesideProbe::pose(depth_beside_probe, aside, lean)).on_hand;
  ASSERT_EQ(needle.node_forces().count, static_cast<std::size_t>(count));

  // Where the axis is at the depth to which the tissue of each point has come, there the tissue is.
  const Eigen::Index unknowns = 2 * count;
  Eigen::MatrixXd matrix(unknowns, unknowns);
  Eigen::VectorXd right(unknowns);
  const std::vector<PointInMesh> found =
      find_points(rig.mesh(), std::vector<Vec3>(points.nodes.begin(), points.nodes.begin() + count));
  for (int i = 0; i < count; ++i) {
    const double depth = checks::top - points.nodes[static_cast<std::size_t>(i)].z() - at_points(3 * i + 2, unknowns);
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Index row = 2 * i + axis;
      matrix.row(row) = at_points.row(3 * i + axis).head(unknowns);
      matrix(row, row) += whole.gain_at(found[static_cast<std::size_t>(i)]);
      right(row) = aside[axis] + lean[axis] * (depth - depth_beside_probe) - at_points(3 * i + axis, unknowns);
    }
  }
  const Eigen::VectorXd expected = matrix.fullPivLu().solve(right);
  Vec3 on_tissue = Vec3::Zero();
  for (int i = 0; i < count; ++i) {
    const NodeForce& force = needle.node_forces().nodes[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_NEAR(force.force[static_cast<std::size_t>(axis)], expected(2 * i + axis), 1e-6 * expected.norm());
      on_tissue[axis] += expected(2 * i + axis);
    }
  }
  EXPECT_LT((on_hand.force + on_tissue).head<2>().norm(), 1e-6 * on_tissue.norm());
  EXPECT_GT(on_tissue.norm(), 0.05);

  const Wrench by_press = on_probe(rig, dense.holding.rightCols<1>().tail(of_held));
  const Eigen::VectorXd holding =
      dense.holding.bottomRows(of_held) * (Eigen::VectorXd(unknowns + 1) << expected, 1.0).finished();
  const Wrench all = on_probe(rig, holding), by_needle = rig.line().on_held(needle.node_forces());
  EXPECT_GT(by_needle.force.norm(), 0.01 * by_press.force.norm()) << "it is to be felt";
  EXPECT_LT((by_press.force + by_needle.force - all.force).norm(), 1e-6 * by_needle.force.norm());
  EXPECT_LT((by_press.torque + by_needle.torque - all.torque).norm(), 1e-6 * by_needle.torque.norm());
}

TEST(HeldProbe, needle_and_probe_are_coupled_both_ways_as_in_a_dense_solution) {
  expect_coupled_as_in_a_dense_solution({});
  expect_coupled_as_in_a_dense_solution({{Vec3(20.0, 14.0, checks::top), Vec3(23.0, 12.0, 6.0)}});
}

// A probe that arrives while the needle is in.
TEST(HeldProbe, nodes_that_a_probe_takes_later_are_coupled_as_in_a_dense_solution) {
  expect_coupled_as_in_a_dense_solution({}, true);
  expect_coupled_as_in_a_dense_solution({{Vec3(20.0, 14.0, checks::top), Vec3(23.0, 12.0, 6.0)}}, true);
}

// Reciprocity of needle and probe (Betti): the work of each one's force on the other's motion is the same.
TEST(HeldProbe, work_is_the_same_either_way) {
  const LineBesideProbe rig;
  WholeBody whole(rig.body().description());
  for (const std::uint32_t node : rig.held()) whole.hold(node);
  const std::size_t nodes = rig.mesh().nodes.size();
  Random random(7);
  for (int trial = 0; trial < 5; ++trial) {
    const Vec3 by(random.normal(), random.normal(), random.normal()), turn(random.normal(), random.normal(), 0.3);
    Eigen::VectorXd moved(3 * static_cast<Eigen::Index>(rig.held().size()));
    for (std::size_t i = 0; i < rig.held().size(); ++i)
      moved.segment<3>(static_cast<Eigen::Index>(3 * i)) =
          by + turn.cross(rig.mesh().nodes[rig.held()[i]] - middle_of(rig));
    const Eigen::MatrixXd dense =
        whole.solve(Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(nodes), 1), moved).moved;
    NodeForces forces;
    double of_tissue = 0.0;
    for (std::uint32_t point = 0; point < static_cast<std::uint32_t>(rig.points()); ++point) {
      const Vec3 force(random.normal(), random.normal(), random.normal());
      forces.nodes[forces.count++] = {
          point, {static_cast<float>(force.x()), static_cast<float>(force.y()), static_cast<float>(force.z())}};
      const PlaceInElement& place = rig.line().body().in_mesh[point];
      for (std::size_t corner = 0; corner < 4; ++corner)
        of_tissue +=
            place.weights[corner] * force.dot(dense.col(0).segment<3>(3 * Eigen::Index{place.nodes[corner]}));
    }
    const Wrench on_probe_now = rig.line().on_held(forces);
    EXPECT_NEAR(on_probe_now.force.dot(by) + on_probe_now.torque.dot(turn), of_tissue, 1e-5);
  }
}

TEST(HeldProbe, without_a_probe_nothing_is_pushed) {
  const ContactBody body(small_block());
  ContactLine line;
  line.request(entry_beside_probe, -Vec3::UnitZ());
  const ContactLine::Line asked = line.next_line().value();
  const std::vector<ContactSite> sites = {{entry_beside_probe - Vec3::UnitZ(), 1.0, tissue::soft, false, false}};
  const BoundPoints bound =
      body.bind(std::vector<NeedlePath>{{Vec3(20.0, 14.0, checks::top), Vec3(23.0, 12.0, 6.0)}}, {});
  LinePoints points(body, 1.0, bound);
  points.add(sites, -Vec3::UnitZ());
  points.stream(0, [&](const ContactPoint& point) { return line.append(asked, point); });
  NodeForces forces;
  forces.count = 1;
  forces.nodes[0] = {0, {1.0F, 2.0F, 3.0F}};
  ASSERT_EQ(line.progress().points, 1U);
  EXPECT_EQ(line.on_held(forces).force, Vec3::Zero());
  EXPECT_EQ(line.on_held(forces).torque, Vec3::Zero());
}

}  // namespace
}  // namespace bodkin
