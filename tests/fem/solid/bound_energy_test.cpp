// A needle that is pushed and drawn at any speed beside needles that were left and nodes that a probe holds never
// gives back more than went in.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/fem/lattice_body.h"
#include "tests/sanitized.h"
#include <gtest/gtest.h>

#include "fem/embedded_needle.h"
#include "fem/solid/contact_body.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

constexpr double skin_height = 28.0;  // mm
const Vec3 entry_beside_needles(17.0, 15.0, skin_height);

// A needle that goes straight down, or leans, and the work of its hand by the force at the end of each tick.
class WorkingHand {
 public:
  explicit WorkingHand(const CondensedBody& points) : needle_(points, default_contact_tissues(), {}, 1e-3) {
    needle_.begin(entry_beside_needles, -Vec3::UnitZ());
    to(pose_at(Vec3(0.0, 0.0, -1.0), Eigen::Vector2d::Zero()));
    work_ = most_ = greatest_fall_ = 0.0;
  }
  // `place`: mm aside, mm aside and mm deep; `lean`: of the axis.
  static Pose pose_at(const Vec3& place, const Eigen::Vector2d& lean) {
    Pose pose = Pose::Identity();
    pose.linear() =
        Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), Vec3(lean.x(), lean.y(), -1.0)).toRotationMatrix();
    pose.translation() = entry_beside_needles + Vec3(place.x(), place.y(), -place.z());
    return pose;
  }
  void move(const Vec3& goal, const Eigen::Vector2d& lean, double speed) {
    const Vec3 start = place_;
    const Eigen::Vector2d leant = lean_;
    constexpr double hub = 100.0;  // mm from the skin, which goes no faster either
    const double time = std::max((goal - start).norm(), hub * (lean - leant).norm()) / speed;
    const int ticks = std::max(1, static_cast<int>(std::ceil(time * 1e3)));
    for (int tick = 1; tick <= ticks; ++tick) {
      const double share = static_cast<double>(tick) / ticks;
      place_ = start + share * (goal - start);
      lean_ = leant + share * (lean - leant);
      to(pose_at(place_, lean_));
    }
  }
  double greatest_fall() const { return greatest_fall_; }
  double lost() const { return work_ - needle_.stored_energy(); }
  double greatest_force() const { return greatest_force_; }

 private:
  void to(const Pose& now) {
    const Wrench force = needle_.step(now).on_hand;
    const Eigen::AngleAxisd turn(now.linear() * last_.linear().transpose());
    if (moved_)
      work_ -=
          force.force.dot(now.translation() - last_.translation()) + turn.angle() * force.torque.dot(turn.axis());
    moved_ = true;
    last_ = now;
    greatest_force_ = std::max(greatest_force_, force.force.norm());
    most_ = std::max(most_, lost());
    greatest_fall_ = std::max(greatest_fall_, most_ - lost());
  }

  EmbeddedNeedle needle_;
  Pose last_ = Pose::Identity();
  bool moved_ = false;
  Vec3 place_ = Vec3(0.0, 0.0, -1.0);
  Eigen::Vector2d lean_ = Eigen::Vector2d::Zero();
  double work_ = 0.0, most_ = 0.0, greatest_fall_ = 0.0;  // N mm
  double greatest_force_ = 0.0;                           // N
};

// Skin, muscle and a ligament 10 mm deep, in three ways of being bound.
std::vector<CondensedBody> bodies_bound_and_not() {
  BodyDescription block;
  block.mesh = kuhn_box({7, 6, 6}, Vec3(36.0, 30.0, skin_height), 0.2, 3);
  block.materials.set(tissue::soft, {0.05, 0.3});
  block.fixed = nodes_beyond(block.mesh, Vec3::Zero(), Vec3(0.0, 0.0, -1.0));
  const ContactBody body(std::make_shared<const BodyDescription>(block));
  std::vector<NeedleStation> stations;
  for (int depth = 0; depth <= 20; ++depth) {
    const bool border = depth == 0 || depth == 2 || depth == 10;
    const TissueId tissue = depth < 2 ? tissue::skin : depth < 10 ? tissue::muscle : tissue::ligamentum_flavum;
    stations.push_back(
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
    bodies.push_back(body.contact_points(stations, -Vec3::UnitZ(), 1.0, 1, bound));
  return bodies;
}

struct Passivity {
  double fall = 0.0, force = 0.0, lost = 1e9;  // N mm and N, the greatest; N mm, the least of all ways
};

Passivity walk(const CondensedBody& points, double most_lean, double fastest, int trials) {
  Random random(18);
  Passivity found;
  for (int trial = 0; trial < trials; ++trial) {
    WorkingHand hand(points);
    for (int way = 0; way < 12; ++way) {
      const Vec3 goal(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-1.0, 18.0));
      const Eigen::Vector2d lean = most_lean * Eigen::Vector2d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      hand.move(goal, lean, fastest * std::pow(10.0, random.uniform(-2.0, 0.0)));
    }
    hand.move(Vec3(0.0, 0.0, -1.0), Eigen::Vector2d::Zero(), fastest);
    found.fall = std::max(found.fall, hand.greatest_fall());
    found.force = std::max(found.force, hand.greatest_force());
    found.lost = std::min(found.lost, hand.lost());
  }
  return found;
}

// A needle that keeps its direction wins nothing at all. Of one that is tilted the work in a tick is known to the
// first order alone, so that what seems to be won shrinks with the speed.
TEST(BoundEnergy, work_less_stored_energy_never_falls_at_any_speed) {
  const std::vector<CondensedBody> bodies = bodies_bound_and_not();
  EXPECT_GT((bodies[1].compliance - bodies[0].compliance).norm(), 0.01 * bodies[0].compliance.norm());
  EXPECT_GT((bodies[2].compliance - bodies[1].compliance).norm(), 0.01 * bodies[0].compliance.norm());
  for (const CondensedBody& points : bodies) {
    const Passivity straight = walk(points, 0.0, 500.0, sanitized ? 4 : 60);
    EXPECT_LT(straight.fall, 1e-9);
    EXPECT_GT(straight.lost, 0.0);
    EXPECT_GT(straight.force, 1.0) << "N: it has punctured and was pushed aside";
    const Passivity tilted = walk(points, 0.05, 20.0, sanitized ? 1 : 8);
    EXPECT_LT(tilted.fall, 1e-3);
    EXPECT_GT(tilted.lost, 0.0);
  }
}

}  // namespace
}  // namespace bodkin
