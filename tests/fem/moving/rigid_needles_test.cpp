// Left needles in a moving body: force and energy by their definition, and for small displacements the equations of a
// body at rest.
#include "fem/moving/rigid_needles.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/fem/lattice_body.h"
#include "tests/fem/moving/rest.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "fem/moving/deformable_body_solver.h"
#include "fem/solid/contact_body.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

constexpr double needle_box = 40.0;  // mm, the side of a box whose bottom, z = 0, is held

const BodyDescription& box_with_needles() {
  static const BodyDescription body = lattice_body(7, needle_box, 0.15, 20);
  return body;
}

const std::vector<NeedlePath> stuck = {{Vec3(17.0, 18.0, 40.0), Vec3(22.0, 20.0, 11.0)},
                                       {Vec3(33.0, 9.0, 40.0), Vec3(28.0, 16.0, 22.0)}};

NodeVectors places_of_box() {
  const TetrahedralMesh& mesh = box_with_needles().mesh;
  NodeVectors places = NodeVectors::Zero(4, static_cast<Eigen::Index>(mesh.nodes.size()));
  for (Eigen::Index node = 0; node < places.cols(); ++node)
    places.col(node).head<3>() = mesh.nodes[static_cast<std::size_t>(node)];
  return places;
}

NodeVectors any_way(Random& random, double size) {
  NodeVectors way = NodeVectors::Zero(4, static_cast<Eigen::Index>(box_with_needles().mesh.nodes.size()));
  for (Eigen::Index node = 0; node < way.cols(); ++node)
    way.col(node).head<3>() = size * Vec3(random.normal(), random.normal(), random.normal());
  return way;
}

double energy_at(const RigidNeedles& needles, const NodeVectors& places, NodeVectors& forces) {
  forces = NodeVectors::Zero(4, places.cols());
  return needles.add_forces(places, forces);
}

TEST(RigidNeedles, rest_and_motions_of_the_whole_cost_nothing) {
  const BodyDescription& body = box_with_needles();
  const RigidNeedles needles(body.mesh, body.materials, stuck);
  NodeVectors forces;
  EXPECT_LT(energy_at(needles, places_of_box(), forces), 1e-20);
  const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  NodeVectors turned = places_of_box();
  for (Eigen::Index node = 0; node < turned.cols(); ++node)
    turned.col(node).head<3>() = turn * turned.col(node).head<3>() + Vec3(3.0, -20.0, 5.0);
  EXPECT_LT(energy_at(needles, turned, forces), 1e-20);
  EXPECT_LT(forces.cwiseAbs().maxCoeff(), 1e-10);
}

TEST(RigidNeedles, the_force_is_the_slope_of_the_energy_and_the_stiffness_no_less_than_its_bend) {
  const BodyDescription& body = box_with_needles();
  const RigidNeedles needles(body.mesh, body.materials, stuck);
  std::vector<double> diagonal(body.mesh.nodes.size(), 0.0);
  needles.add_stiffness(diagonal);
  Random random(4);
  for (const double jolt : {0.3, 3.0, 15.0}) {
    const NodeVectors places = places_of_box() + any_way(random, jolt);
    NodeVectors forces, unused;
    const double here = energy_at(needles, places, forces);
    EXPECT_GT(here, 0.0);
    constexpr double step = 1e-6;
    const NodeVectors way = any_way(random, 1.0);
    const double slope =
        (energy_at(needles, places + step * way, unused) - energy_at(needles, places - step * way, unused)) /
        (2.0 * step);
    EXPECT_NEAR(slope, -forces.cwiseProduct(way).sum(), 1e-6 * forces.norm() * way.norm());
    for (const double far : {0.1, 1.0, 10.0}) {
      const NodeVectors moved = any_way(random, far);
      double bound = here - forces.cwiseProduct(moved).sum();
      for (Eigen::Index node = 0; node < moved.cols(); ++node)
        bound += 0.5 * diagonal[static_cast<std::size_t>(node)] * moved.col(node).squaredNorm();
      EXPECT_LE(energy_at(needles, places + moved, unused), bound + 1e-9 * std::abs(bound));
    }
    // Only the tissue holds a needle.
    Vec3 sum = Vec3::Zero(), torque = Vec3::Zero();
    for (Eigen::Index node = 0; node < forces.cols(); ++node) {
      sum += forces.col(node).head<3>();
      torque += Vec3(places.col(node).head<3>()).cross(Vec3(forces.col(node).head<3>()));
    }
    EXPECT_LT(sum.norm(), 1e-9 * forces.norm());
    EXPECT_LT(torque.norm(), 1e-7 * forces.norm());
  }
}

// A small force moves another node according to the compliance of a body at rest (BoundPoints).
TEST(RigidNeedles, small_displacements_are_those_of_the_equations_of_a_needle_in_the_hand) {
  const BodyDescription& box = box_with_needles();
  const ContactBody whole(std::make_shared<const BodyDescription>(box));
  const BoundPoints bound = whole.bind(stuck, {});
  const PointFinder finder(box.mesh);
  const auto node_at = [&](const Vec3& place) {
    std::uint32_t nearest = 0;
    for (std::uint32_t node = 0; node < box.mesh.nodes.size(); ++node)
      if ((box.mesh.nodes[node] - place).norm() < (box.mesh.nodes[nearest] - place).norm()) nearest = node;
    return nearest;
  };
  const std::uint32_t pushed = node_at(Vec3(20.0, 20.0, 33.0)), seen = node_at(Vec3(20.0, 20.0, 13.0));
  std::vector<CarriedPoint> loads;
  for (const std::uint32_t node : {pushed, seen})
    loads.push_back(whole.carried({{node, node, node, node}, {1.0, 0.0, 0.0, 0.0}}));
  const std::vector<PointResponse> responses = whole.factor().respond(loads);
  const Eigen::MatrixXd shares = bound.shares(responses);
  const Vec3 force(2e-4, -1e-4, 1.5e-4);
  for (const std::size_t at : {0U, 1U}) {
    const Mat3 alone = compliance_between(responses[at], responses[0]);
    const Vec3 expected = (alone - bound.taken(shares, at, shares, 0)) * force, without = alone * force;
    CorotationalBody body(box, checks::to_rest(), stuck);
    body.load(pushed, force);
    ASSERT_GT(checks::settle(body, 1e-10, 400), 0);
    const std::uint32_t node = at == 0 ? pushed : seen;
    const Vec3 found = body.position(node) - body.at_rest(node);
    EXPECT_LT((found - expected).norm(), 2e-3 * expected.norm());
    EXPECT_GT((without - expected).norm(), 0.02 * expected.norm()) << "the needles are to be felt";
  }
}

TEST(RigidNeedles, a_probe_over_a_needle_that_was_left_is_pushed_back_harder) {
  const BodyDescription& box = box_with_needles();
  BodySolverSettings settings;
  settings.motion = checks::to_rest();
  settings.probe.width = settings.probe.thickness = 20.0;
  std::vector<double> forces;  // without and with a needle, N
  for (const bool left : {false, true}) {
    settings.left_needles.clear();
    if (left) settings.left_needles = {{Vec3(20.0, 20.0, 40.0), Vec3(20.0, 20.0, 8.0)}};
    DeformableBodySolver solver(box, settings);
    Pose probe = Pose::Identity();
    probe.linear() = Eigen::AngleAxisd(180.0 * degree, Vec3::UnitX()).toRotationMatrix();
    for (int step = 0; step < 80; ++step) {
      probe.translation() = Vec3(20.0, 20.0, needle_box - std::min(4.0, 0.1 * step));
      ASSERT_FALSE(solver.step(probe).fault);
    }
    forces.push_back(-solver.press().on_probe(solver.body()).force.dot(probe.linear().col(2)));
  }
  EXPECT_GT(forces[0], 0.1);
  EXPECT_GT(forces[1], 1.02 * forces[0]);
  EXPECT_LT(forces[1], 2.0 * forces[0]);
}

TEST(RigidNeedles, a_body_with_needles_that_is_left_alone_wins_no_energy) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    CorotationalBody body(box_with_needles(), {}, stuck);
    Random random(seed);
    Eigen::Matrix3Xd places = (places_of_box() + any_way(random, seed == 3U ? 12.0 : 2.0)).topRows<3>();
    ASSERT_TRUE(body.place(places));
    const double first = body.elastic_energy();
    double last = first;
    for (int step = 0; step < 240; ++step) {
      ASSERT_FALSE(body.step().fault);
      const double now = body.elastic_energy() + body.kinetic_energy();
      ASSERT_LE(now, last + 1e-9 * first) << step;
      last = now;
    }
    EXPECT_LT(last, 0.02 * first);
  }
}

TEST(RigidNeedles, one_beside_the_mesh_does_nothing_and_one_without_length_is_refused) {
  const BodyDescription& body = box_with_needles();
  EXPECT_TRUE(
      RigidNeedles(body.mesh, body.materials, std::vector<NeedlePath>{{Vec3(200.0, 0.0, 0.0), Vec3(250.0, 0.0, 0.0)}})
          .empty());
  EXPECT_THROW(RigidNeedles(body.mesh, body.materials, std::vector<NeedlePath>{{Vec3::Ones(), Vec3::Ones()}}),
               InputError);
}

}  // namespace
}  // namespace bodkin
