// A cantilever with large deflection, against the elastica.
#include <array>
#include <cmath>
#include <vector>

#include "tests/fem/lattice_body.h"
#include "tests/fem/moving/rest.h"
#include "tests/sanitized.h"
#include <gtest/gtest.h>

#include "fem/moving/corotational_body.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

// Tip of an inextensible bar of length 1, held at one end, under a transverse force of constant direction: theta'' =
// -force cos(theta), theta(0) = 0, theta'(1) = 0. By shooting with Runge and Kutta's method.
struct Elastica {
  double along = 0.0, across = 0.0;
};

Elastica elastica(double force) {
  double bend = 0.0;  // at the end that is left over
  Elastica tip;
  const auto shoot = [&](double curvature) {
    constexpr int steps = 2000;
    constexpr double h = 1.0 / steps;
    std::array<double, 4> state{0.0, curvature, 0.0, 0.0};  // theta, theta', along, across
    const auto slope = [force](const std::array<double, 4>& s) {
      return std::array<double, 4>{s[1], -force * std::cos(s[0]), std::cos(s[0]), std::sin(s[0])};
    };
    const auto moved = [](const std::array<double, 4>& s, const std::array<double, 4>& by, double factor) {
      std::array<double, 4> sum{};
      for (std::size_t i = 0; i < 4; ++i) sum[i] = s[i] + factor * by[i];
      return sum;
    };
    for (int step = 0; step < steps; ++step) {
      const auto a = slope(state), b = slope(moved(state, a, 0.5 * h)), c = slope(moved(state, b, 0.5 * h)),
                 d = slope(moved(state, c, h));
      for (std::size_t i = 0; i < 4; ++i) state[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
    }
    bend = state[1];
    tip = {1.0 - state[2], state[3]};
  };
  double low = 0.0, high = force;  // the curvature of the straight bar at its root
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    shoot(middle);
    (bend > 0.0 ? high : low) = middle;
  }
  return tip;
}

TEST(CorotationalBeam, the_elastica_that_it_is_compared_with_is_that_of_the_tables) {
  // Mattiasson, Int. J. Numer. Methods Eng. 17, 145 (1981), from elliptic integrals.
  const std::array<std::array<double, 3>, 4> table = {
      {{1.0, 0.05643, 0.30172}, {2.0, 0.16064, 0.49346}, {5.0, 0.38763, 0.71379}, {10.0, 0.55500, 0.81061}}};
  for (const auto& row : table) {
    const Elastica tip = elastica(row[0]);
    EXPECT_NEAR(tip.along, row[1], 1e-5);
    EXPECT_NEAR(tip.across, row[2], 1e-5);
  }
}

// Where the tip of a bar goes, by its length; 40 mm long, 4 mm high, 2 mm wide and `cells` cells high, held at one
// end, with a force across at the other. load = force length^2 / (E I).
Elastica bent_bar(double load, std::uint32_t cells) {
  constexpr double length = 40.0, height = 4.0, width = 2.0, young = 0.1;
  BodyDescription body;
  body.mesh = kuhn_box({10 * cells + 1, cells + 1, 2}, Vec3(length, height, width));
  body.materials.set(tissue::soft, {young, 0.0});
  std::vector<std::uint32_t> tip;
  for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node) {
    if (body.mesh.nodes[node].x() == 0.0) body.fixed.push_back(node);
    if (body.mesh.nodes[node].x() > length - 1e-6) tip.push_back(node);
  }
  body.corridor = {tip.front()};
  CorotationalSettings settings = checks::to_rest();
  settings.gradients.tolerance = 1e-2;
  CorotationalBody beam(body, settings);
  const double force = load * young * width * std::pow(height, 3) / 12.0 / (length * length);
  const auto ends = static_cast<double>(tip.size());
  for (const std::uint32_t node : tip) beam.load(node, Vec3(0.0, force / ends, 0.0));
  EXPECT_LE(checks::settle(beam, 1e-5 * force, 300), 300);
  Vec3 moved = Vec3::Zero();
  for (const std::uint32_t node : tip) moved += (beam.position(node) - beam.at_rest(node)) / ends;
  return {-moved.x() / length, moved.y() / length};
}

// Linear tetrahedra are too stiff when they bend; what is missing shrinks with the square of their size, and what
// that leaves over is the bar's own: it is thick, and gives way in shear by about 1 %.
TEST(CorotationalBeam, bends_to_the_elastica_as_it_is_refined) {
  for (const double load : {2.0, 5.0}) {
    const Elastica expected = elastica(load);
    const Elastica coarse = bent_bar(load, 2), middle = bent_bar(load, 4);
    EXPECT_LT(coarse.across, middle.across);
    EXPECT_GT(expected.across - coarse.across, 2.0 * (expected.across - middle.across));
    EXPECT_GT(expected.along - coarse.along, 2.0 * (expected.along - middle.along));
    if (sanitized || load > 2.0) continue;
    const Elastica fine = bent_bar(load, 8);
    EXPECT_GT(expected.across - middle.across, 2.5 * (expected.across - fine.across));
    EXPECT_NEAR(fine.across, expected.across, 0.07 * expected.across) << load;
    EXPECT_NEAR(fine.along, expected.along, 0.14 * expected.along) << load;
    // Extrapolated to zero cell size.
    EXPECT_NEAR(fine.across + (fine.across - middle.across) / 3.0, expected.across, 0.02 * expected.across) << load;
    EXPECT_NEAR(fine.along + (fine.along - middle.along) / 3.0, expected.along, 0.04 * expected.along) << load;
  }
}

}  // namespace
}  // namespace bodkin
