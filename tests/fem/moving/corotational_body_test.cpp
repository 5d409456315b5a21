#include "fem/moving/corotational_body.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/fem/lattice_body.h"
#include "tests/fem/moving/rest.h"
#include "tests/sanitized.h"
#include "tests/simulation/real_time_guard.h"
#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using ::testing::HasSubstr;

Mat3 some_rotation(Random& random) {
  const Vec3 axis(random.normal(), random.normal(), random.normal());
  return Eigen::AngleAxisd(random.uniform(-3.1, 3.1), axis.normalized()).toRotationMatrix();
}

// Places of all nodes after x -> gradient x + shift.
Eigen::Matrix3Xd moved_affinely(const TetrahedralMesh& mesh, const Mat3& gradient, const Vec3& shift) {
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(mesh.nodes.size()));
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    places.col(static_cast<Eigen::Index>(node)) = gradient * mesh.nodes[node] + shift;
  return places;
}

NodeVectors padded(const Eigen::Matrix3Xd& places) {
  NodeVectors result = NodeVectors::Zero(4, places.cols());
  result.topRows<3>() = places;
  return result;
}

TEST(CorotationalElements, a_rotation_of_the_whole_body_costs_nothing) {
  const BodyDescription body = lattice_body(5, 40.0, 0.2, 10);
  CorotationalElements elements(body.mesh, body.materials);
  NodeVectors forces = padded(moved_affinely(body.mesh, Mat3::Identity(), Vec3::Zero()));
  Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const double energy =
        elements.evaluate(padded(moved_affinely(body.mesh, some_rotation(random), Vec3(9.0, -5.0, 1.0))), forces);
    EXPECT_LT(forces.cwiseAbs().maxCoeff(), 1e-13);  // N; a strain of 1 is about 1 N
    EXPECT_LT(energy, 1e-20);
  }
}

TEST(CorotationalElements, forces_are_the_gradient_of_the_energy_inverted_or_not) {
  const BodyDescription body = lattice_body(4, 30.0, 0.1, 10);
  CorotationalElements elements(body.mesh, body.materials);
  Random random(2);
  const auto count = static_cast<Eigen::Index>(body.mesh.nodes.size());
  NodeVectors forces = NodeVectors::Zero(4, count), unused = forces;
  for (const double jolt : {0.5, 3.0, 20.0}) {  // mm; the edges are 10
    NodeVectors places = padded(moved_affinely(body.mesh, some_rotation(random), Vec3::Zero()));
    for (Eigen::Index node = 0; node < count; ++node)
      places.col(node).head<3>() += jolt * Vec3(random.normal(), random.normal(), random.normal());
    elements.evaluate(places, forces);
    for (int trial = 0; trial < 20; ++trial) {
      NodeVectors way = NodeVectors::Zero(4, count);
      for (Eigen::Index node = 0; node < count; ++node)
        way.col(node).head<3>() = Vec3(random.normal(), random.normal(), random.normal());
      constexpr double h = 1e-4;
      const double slope =
          (elements.evaluate(places + h * way, unused) - elements.evaluate(places - h * way, unused)) / (2.0 * h);
      EXPECT_NEAR(slope, -forces.cwiseProduct(way).sum(), 2e-6 * forces.norm() * way.norm()) << jolt;
    }
  }
}

BodyDescription patch(double poisson, std::vector<std::uint32_t>& border) {
  BodyDescription body;
  body.mesh = kuhn_lattice(5, 20.0, 0.2, 3);
  body.materials.set(tissue::soft, {0.05, poisson});
  for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node) {
    const Vec3& x = body.mesh.nodes[node];
    (x.minCoeff() == 0.0 || x.maxCoeff() == 20.0 ? border : body.corridor).push_back(node);
  }
  body.fixed = {0, 4, 24};  // on the bottom
  return body;
}

TEST(CorotationalElements, an_even_strain_leaves_nothing_out_of_balance_inside_however_it_is_turned) {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<std::uint32_t> border;
    const BodyDescription body = patch(random.uniform(-0.5, 0.49), border);
    CorotationalElements elements(body.mesh, body.materials);
    const Mat3 strain = 0.3 * Mat3::NullaryExpr([&random] { return random.normal(); });
    NodeVectors forces = NodeVectors::Zero(4, static_cast<Eigen::Index>(body.mesh.nodes.size()));
    elements.evaluate(
        padded(moved_affinely(body.mesh, some_rotation(random) * (Mat3::Identity() + strain), Vec3(1.0, 2.0, 3.0))),
        forces);
    EXPECT_GT(forces.norm(), 0.1);
    for (const std::uint32_t node : body.corridor) EXPECT_LT(forces.col(node).norm(), 1e-12 * forces.norm());
  }
}

TEST(CorotationalBody, an_even_shear_of_its_border_goes_on_inside) {
  for (const Vec3& shear : {Vec3(0.3, 0.0, 0.0), Vec3(1.5, 0.5, 0.0), Vec3(-0.4, 0.2, -0.2)}) {
    std::vector<std::uint32_t> border;
    const BodyDescription body = patch(0.4, border);
    CorotationalBody moving(body, checks::to_rest());
    const auto goal = [&](std::uint32_t node) -> Vec3 {
      return body.mesh.nodes[node] + shear * body.mesh.nodes[node].z();
    };
    for (const std::uint32_t node : border) moving.hold(node, goal(node));
    EXPECT_LE(checks::settle(moving, 1e-13), 100);
    for (const std::uint32_t node : body.corridor) EXPECT_LT((moving.position(node) - goal(node)).norm(), 1e-10);
  }
}

TEST(CorotationalBody, agrees_with_the_linear_body_the_better_the_smaller_the_force) {
  const BodyDescription body = lattice_body(sanitized ? 4 : 6, 40.0, 0.1, 10);
  const ElasticBody linear(body, plan_body(body));
  CorotationalBody moving(body, checks::to_rest());
  Random random(5);
  const auto count = static_cast<Eigen::Index>(body.mesh.nodes.size());
  Eigen::VectorXd loads = Eigen::VectorXd::NullaryExpr(3 * count, [&random] { return random.normal(); });
  const Eigen::VectorXd expected = linear.displacement(loads);
  std::vector<double> errors;
  for (const double scale : {1e-3, 5e-4, 2.5e-4}) {  // N
    moving.reset();
    for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node)
      moving.load(node, scale * loads.segment<3>(3 * Eigen::Index{node}));
    EXPECT_LE(checks::settle(moving, 1e-9 * scale), 100);
    double error = 0.0;
    for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node) {
      const Vec3 moved = moving.position(node) - moving.at_rest(node);
      error = std::max(error, (moved - scale * expected.segment<3>(3 * Eigen::Index{node})).norm());
    }
    errors.push_back(error);
    EXPECT_LT(error, 0.2 * scale * expected.cwiseAbs().maxCoeff());
  }
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.4);
  EXPECT_NEAR(errors[1] / errors[2], 4.0, 0.2);
}

TEST(CorotationalBody, steps_that_are_solved_loosely_go_where_exact_ones_go) {
  const BodyDescription body = lattice_body(6, 40.0, 0.1, 10);
  CorotationalSettings exactly;
  exactly.gradients = {1e-8, 1000};
  exactly.most_corrections = 30;
  exactly.balance = 1e-9;
  CorotationalBody loose(body, CorotationalSettings{}), exact(body, exactly);
  const auto top = nodes_beyond(body.mesh, Vec3(0.0, 0.0, 40.0), Vec3::UnitZ());
  double worst = 0.0;
  for (int step = 1; step <= 40; ++step) {
    for (std::size_t i = 0; i < 8; ++i) {
      const Vec3 place = body.mesh.nodes[top[i]] - Vec3(0.0, 0.0, std::min(8.0, 0.4 * step));
      loose.hold(top[i], place);
      exact.hold(top[i], place);
    }
    loose.step();
    exact.step();
    worst = std::max(worst, (loose.places() - exact.places()).colwise().norm().maxCoeff());
  }
  EXPECT_LT(worst, 0.15);                                                          // mm, of 8, while it moves
  EXPECT_LT((loose.places() - exact.places()).colwise().norm().maxCoeff(), 0.02);  // once it is held
}

// A body bent, jolted, and released.
void jolt(CorotationalBody& body, double by, std::uint64_t seed) {
  Random random(seed);
  Eigen::Matrix3Xd places = body.places().topRows<3>();
  for (Eigen::Index node = 0; node < places.cols(); ++node)
    places.col(node) += by * Vec3(random.normal(), random.normal(), random.normal());
  ASSERT_TRUE(body.place(places));
}

TEST(CorotationalBody, never_wins_energy_while_it_is_left_alone) {
  const BodyDescription body = lattice_body(5, 40.0, 0.1, 10);
  for (const double dt : {1e-3, 1.0 / 60.0}) {
    for (const double by : {0.3, 2.0, 8.0}) {  // mm; the edges are 10
      for (const int corrections : {1, 5}) {
        CorotationalSettings settings;
        settings.dt = dt;
        settings.mass_damping = settings.stiffness_damping = 0.0;
        settings.most_corrections = corrections;
        CorotationalBody moving(body, settings);
        jolt(moving, by, 6);
        const double first = moving.elastic_energy();
        double last = first;
        for (int step = 0; step < (sanitized ? 30 : 100); ++step) {
          ASSERT_FALSE(moving.step().fault);
          const double now = moving.elastic_energy() + moving.kinetic_energy();
          EXPECT_LE(now, last + 1e-9 * first) << dt << ", " << by << ", step " << step;
          last = now;
        }
        EXPECT_LT(last, 0.5 * first);
      }
    }
  }
}

TEST(CorotationalBody, swings_at_the_frequency_of_a_bar_and_damping_ends_it) {
  // A column held at its bottom and pressed from above, without Poisson's effect: L = 40 mm, E = 0.1 MPa,
  // 1000 kg/m^3. Its lowest longitudinal mode has the period 4 L sqrt(density / E) = 0.016 s.
  BodyDescription body;
  body.mesh = kuhn_box({2, 2, 21}, Vec3(4.0, 4.0, 40.0));
  body.materials.set(tissue::soft, {0.1, 0.0});
  body.fixed = nodes_beyond(body.mesh, Vec3::Zero(), Vec3(0.0, 0.0, -1.0));
  body.corridor = {4};
  CorotationalSettings settings;
  settings.dt = 2e-5;
  settings.mass_damping = settings.stiffness_damping = 0.0;
  for (const bool damped : {false, true}) {
    if (damped) settings.mass_damping = 200.0;
    CorotationalBody column(body, settings);
    Eigen::Matrix3Xd places = column.places().topRows<3>();
    for (Eigen::Index node = 0; node < places.cols(); ++node)
      places(2, node) += 0.01 * std::sin(0.5 * 3.14159265358979323846 * places(2, node) / 40.0);
    ASSERT_TRUE(column.place(places));
    const auto top = static_cast<std::uint32_t>(body.mesh.nodes.size() - 1);
    std::vector<double> crossings, heights;
    double before = 0.01;
    const int steps = sanitized ? 500 : 2000;
    for (int step = 1; step <= steps; ++step) {
      column.step();
      const double now = column.position(top).z() - 40.0;
      if ((now > 0.0) != (before > 0.0)) crossings.push_back(settings.dt * (step - now / (now - before)));
      before = now;
      heights.push_back(std::abs(now));
    }
    if (sanitized) continue;
    ASSERT_GE(crossings.size(), 4U);
    const double lowest = 2.0 * 3.14159265358979323846 / 0.016;
    const double period = damped ? 2.0 * 3.14159265358979323846 / std::sqrt(lowest * lowest - 1e4) : 0.016;
    EXPECT_NEAR(crossings[3] - crossings[1], period, 0.01 * period);
    if (!damped) continue;
    // exp(-mass_damping t / 2), a period apart: 800 steps.
    const auto peak = [&](int from) {
      return *std::max_element(heights.begin() + from, heights.begin() + from + 400);
    };
    EXPECT_NEAR(peak(1000) / peak(200), std::exp(-0.5 * 200.0 * 0.016), 0.03);
  }
}

TEST(CorotationalBody, inverted_elements_come_back_to_rest) {
  const BodyDescription body = lattice_body(5, 40.0, 0.1, 10);
  for (const double dt : {0.0, 1.0 / 60.0}) {
    CorotationalSettings settings;
    settings.dt = dt;
    CorotationalBody moving(body, settings);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      jolt(moving, 8.0, seed);
      for (int step = 0; step < 120; ++step) ASSERT_FALSE(moving.step().fault);
      for (std::uint32_t node = 0; node < moving.nodes(); ++node)
        EXPECT_LT((moving.position(node) - moving.at_rest(node)).norm(), 1e-3) << dt << ", " << seed;
    }
    // All free nodes in one place.
    Eigen::Matrix3Xd places = moving.places().topRows<3>();
    places.setConstant(20.0);
    ASSERT_TRUE(moving.place(places));
    for (int step = 0; step < 200; ++step) {
      ASSERT_FALSE(moving.step().fault);
      ASSERT_TRUE(moving.places().allFinite());
    }
    for (std::uint32_t node = 0; node < moving.nodes(); ++node)
      EXPECT_LT((moving.position(node) - moving.at_rest(node)).norm(), 1e-3) << dt;
  }
}

TEST(CorotationalBody, held_nodes_go_where_they_are_told_and_what_holds_them_holds_the_body) {
  const BodyDescription body = lattice_body(5, 40.0, 0.1, 10);
  CorotationalBody moving(body, checks::to_rest());
  const auto top = nodes_beyond(body.mesh, Vec3(0.0, 0.0, 40.0), Vec3::UnitZ());
  for (const std::uint32_t node : top) moving.hold(node, body.mesh.nodes[node] - Vec3(0.0, 0.0, 10.0));
  ASSERT_LE(checks::settle(moving, 1e-10), 100);
  Vec3 above = Vec3::Zero(), below = Vec3::Zero();
  for (std::uint32_t node = 0; node < moving.nodes(); ++node) {
    if (moving.fixed(node))
      below += moving.holding_force(node);
    else if (moving.held(node))
      above += moving.holding_force(node);
  }
  EXPECT_LT(above.z(), -1.0);
  EXPECT_LT((above + below).norm(), 1e-8);
  for (const std::uint32_t node : top) {
    EXPECT_LT((moving.position(node) - body.mesh.nodes[node] + Vec3(0.0, 0.0, 10.0)).norm(), 1e-12);
    moving.release(node);
  }
  moving.hold(body.fixed[0], Vec3::Zero());  // fixed it stays
  moving.hold(999999, Vec3::Zero());
  moving.hold(top[0], Vec3(0.0, 0.0, std::nan("")));
  moving.load(top[0], Vec3(0.0, 0.0, std::nan("")));
  ASSERT_LE(checks::settle(moving, 1e-10), 100);
  for (std::uint32_t node = 0; node < moving.nodes(); ++node)
    EXPECT_LT((moving.position(node) - moving.at_rest(node)).norm(), 1e-6);
}

TEST(CorotationalBody, what_cannot_be_computed_is_a_fault_and_leaves_it_where_it_was) {
  const BodyDescription body = lattice_body(4, 40.0, 0.1, 10);
  CorotationalBody moving(body, CorotationalSettings{});
  const std::uint32_t top = nodes_beyond(body.mesh, Vec3(0.0, 0.0, 40.0), Vec3::UnitZ())[0];
  moving.load(top, Vec3(0.0, 0.0, -0.01));
  for (int step = 0; step < 10; ++step) ASSERT_FALSE(moving.step().fault);
  const Vec3 before = moving.position(top);
  for (const double force : {1e300, 1e100}) {
    moving.load(top, Vec3(force, force, 0.0));
    EXPECT_TRUE(moving.step().fault);
    EXPECT_EQ(moving.position(top), before);
    EXPECT_EQ(moving.velocity(top), Vec3::Zero());
    moving.clear_loads();
  }
  for (int step = 0; step < 100; ++step) ASSERT_FALSE(moving.step().fault);
  EXPECT_LT((moving.position(top) - moving.at_rest(top)).norm(), 1e-3);
}

TEST(CorotationalBody, a_step_takes_no_memory_and_no_lock_and_the_same_steps_give_the_same_bits) {
  const BodyDescription body = lattice_body(5, 40.0, 0.1, 10);
  CorotationalBody moving(body, CorotationalSettings{});
  const std::uint32_t top = nodes_beyond(body.mesh, Vec3(0.0, 0.0, 40.0), Vec3::UnitZ())[3];
  Eigen::Matrix3Xd jumbled = moving.places().topRows<3>();
  Random random(7);
  for (double& value : jumbled.reshaped()) value += 20.0 * random.normal();
  NodeVectors first;
  for (const bool again : {false, true}) {
    moving.reset();
    {
      const RealTimeGuard guard;
      for (int step = 0; step < 30; ++step) {
        if (step == 10) moving.place(jumbled);  // beyond Newton's method
        moving.hold(top, moving.at_rest(top) - Vec3(0.0, 0.0, 0.3 * step));
        moving.load(top - 1, Vec3(0.001, 0.0, 0.0));
        moving.step();
        if (step == 20) moving.release(top);
      }
      if (RealTimeGuard::available()) {
        EXPECT_EQ(RealTimeGuard::heap_calls(), 0U);
        EXPECT_EQ(RealTimeGuard::lock_calls(), 0U);
      }
    }
    if (again) {
      EXPECT_EQ(first, moving.places());
    }
    first = moving.places();
  }
}

TEST(CorotationalBody, refuses_settings_out_of_range_and_bodies_that_are_none) {
  const BodyDescription body = lattice_body(4, 40.0, 0.1, 10);
  const auto refuses = [&body](const CorotationalSettings& settings, const char* sentence) {
    try {
      const CorotationalBody moving(body, settings);
      ADD_FAILURE() << sentence;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(sentence));
    }
  };
  CorotationalSettings settings;
  settings.dt = -0.01;
  refuses(settings, "step is -0.01 s, expected 1e-05 to 1 s");
  settings = {};
  settings.density = 0.0;
  refuses(settings, "density is 0 kg/m^3, expected 1 to 30000 kg/m^3");
  settings = {};
  settings.stiffness_damping = std::nan("");
  refuses(settings, "damping by stiffness is nan");
  settings = {};
  settings.most_corrections = 0;
  refuses(settings, "corrections is 0");
  BodyDescription loose = body;
  loose.fixed.clear();
  EXPECT_THROW(CorotationalBody(loose, CorotationalSettings{}), InputError);
}

// Its law has no fibres: it would be softer along them than the needle's body.
TEST(CorotationalBody, refuses_a_tissue_with_fibres) {
  BodyDescription body = lattice_body(4, 40.0, 0.1, 10);
  const TissueId tissue = body.mesh.tissues.front();
  ElasticMaterial material = *body.materials.find(tissue);
  EXPECT_FALSE(tissue_with_fibres(body.mesh, body.materials).has_value());
  material.fibre = Vec3::UnitZ();
  material.young_along = 20.0 * material.young;
  material.shear_along = material.young;
  body.materials.set(tissue, material);
  EXPECT_EQ(tissue_with_fibres(body.mesh, body.materials), tissue);
  try {
    const CorotationalBody moving(body, CorotationalSettings{});
    ADD_FAILURE() << "it was made";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("has fibres, which a moving body does not support"));
    EXPECT_THAT(error.what(), HasSubstr("without --body moving"));
  }
}

}  // namespace
}  // namespace bodkin
