// A needle pushed and withdrawn at any speed beside left needles and nodes held by a probe never returns more energy
// than was put in.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/fem/lattice_body.h"
#include "tests/fem/working_hand.h"
#include "tests/sanitized.h"
#include <gtest/gtest.h>

#include "fem/solid/contact_body.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using checks::HandWork;
using checks::WorkingHand;
namespace {

constexpr double skin_height = 28.0;  // mm
const Vec3 entry_beside_needles(17.0, 15.0, skin_height);

// Skin, muscle and a ligament 10 mm deep, bound in three ways.
std::vector<CondensedBody> bodies_bound_and_not() {
  BodyDescription block;
  block.mesh = kuhn_box({7, 6, 6}, Vec3(36.0, 30.0, skin_height), 0.2, 3);
  block.materials.set(tissue::soft, {0.05, 0.3});
  block.fixed = nodes_beyond(block.mesh, Vec3::Zero(), Vec3(0.0, 0.0, -1.0));
  const ContactBody body(std::make_shared<const BodyDescription>(block));
  std::vector<ContactSite> sites;
  for (int depth = 0; depth <= 20; ++depth) {
    const bool border = depth == 0 || depth == 2 || depth == 10;
    const TissueId tissue = depth < 2 ? tissue::skin : depth < 10 ? tissue::muscle : tissue::ligamentum_flavum;
    sites.push_back(
        {entry_beside_needles - depth * Vec3::UnitZ(), 1.0 * depth, tissue, border, depth == 0 || depth == 10});
  }
  const std::vector<NeedlePath> left = {{Vec3(18.5, 15.0, skin_height), Vec3(18.0, 15.5, 6.0)},
                                        {Vec3(8.0, 20.0, skin_height), Vec3(16.0, 17.0, 12.0)}};
  std::vector<std::uint32_t> held;
  for (std::uint32_t node = 0; node < block.mesh.nodes.size(); ++node) {
    const Vec3& at = block.mesh.nodes[node];
    if (at.z() > skin_height - 1e-6 && at.x() > 20.0 && at.x() < 33.0) held.push_back(node);
  }
  std::vector<CondensedBody> bodies;
  for (const BoundPoints& bound : {BoundPoints(), body.bind(left, {}), body.bind(left, held)})
    bodies.push_back(body.contact_points(sites, -Vec3::UnitZ(), 1.0, 1, bound));
  return bodies;
}

struct Passivity {
  HandWork fall;                              // N mm, the greatest
  double lost = 1e9;                          // N mm, the least of all ways
  double force = 0.0, of_other_forces = 0.0;  // N, the greatest
};

Passivity walk(const CondensedBody& points, double most_lean, int trials) {
  constexpr double fastest = 500.0;  // mm/s
  Random random(18);
  Passivity found;
  for (int trial = 0; trial < trials; ++trial) {
    WorkingHand hand(points, default_contact_tissues(),
                     {entry_beside_needles, entry_beside_needles - 20.0 * Vec3::UnitZ()});
    for (int way = 0; way < 12; ++way) {
      const Vec3 goal(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-1.0, 18.0));
      const Eigen::Vector2d lean = most_lean * Eigen::Vector2d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      const double speed = fastest * std::pow(10.0, random.uniform(-2.0, 0.0));
      hand.move(goal, lean, speed, most_lean * random.uniform(-1.0, 1.0));
    }
    hand.move(Vec3(0.0, 0.0, -1.0), Eigen::Vector2d::Zero(), fastest);
    found.fall.turning = std::max(found.fall.turning, hand.greatest_fall().turning);
    found.fall.at_end = std::max(found.fall.at_end, hand.greatest_fall().at_end);
    found.lost = std::min(found.lost, hand.lost().turning);
    found.force = std::max(found.force, hand.greatest_force());
    found.of_other_forces = std::max(found.of_other_forces, hand.greatest_difference());
  }
  return found;
}

TEST(BoundEnergy, work_less_stored_energy_never_falls_at_any_speed) {
  const std::vector<CondensedBody> bodies = bodies_bound_and_not();
  EXPECT_GT((bodies[1].compliance - bodies[0].compliance).norm(), 0.01 * bodies[0].compliance.norm());
  EXPECT_GT((bodies[2].compliance - bodies[1].compliance).norm(), 0.01 * bodies[0].compliance.norm());
  for (const CondensedBody& points : bodies) {
    const Passivity straight = walk(points, 0.0, sanitized ? 4 : 60);
    EXPECT_LT(straight.fall.at_end, 1e-9);
    EXPECT_LT(straight.fall.turning, 1e-5) << "contact forces are published in single precision";
    EXPECT_GT(straight.lost, 0.0);
    EXPECT_GT(straight.force, 1.0) << "N: it has punctured and was pushed aside";
    const Passivity tilted = walk(points, 0.05, sanitized ? 4 : 60);
    EXPECT_LT(tilted.fall.turning, 1e-3);
    EXPECT_LT(tilted.of_other_forces, 1e-5) << "it is the hand's work";
    EXPECT_GT(tilted.lost, 0.0);
  }
}

}  // namespace
}  // namespace bodkin
