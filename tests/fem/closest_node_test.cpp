#include "fem/closest_node.h"

#include <algorithm>
#include <vector>

#include "tests/fem/dense_body.h"
#include "tests/sanitized.h"
#include "tests/simulation/real_time_guard.h"
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

// Nodes 11 mm apart, as 2000 of them are in a block of 200 x 150 x 100 mm: skin, soft tissue, and ligamentum flavum
// from 44 mm on.
const CondensedBody& coarse_body() {
  static const CondensedBody body = [] {
    CondensedBody made = checks::kelvin_body(5, 7, 11.0);
    for (std::size_t i = 0; i < made.nodes.size(); ++i) {
      const double depth = made.nodes[i].z();
      made.tissues[i] = depth < 1.0 ? tissue::skin
                                    : (depth > 43.0 && depth < 45.0 ? tissue::ligamentum_flavum
                                       : depth > 45.0               ? tissue::epidural_fat
                                                                    : tissue::soft);
    }
    return made;
  }();
  return body;
}

ClosestNodeSettings coarse_settings() {
  ClosestNodeSettings settings;
  settings.capture_radius = 5.5;
  return settings;
}

struct ClosestBench {
  explicit ClosestBench(const ContactTissues& tissues, const ClosestNodeSettings& settings = coarse_settings())
      : model(coarse_body(), tissues, settings, 1e-3) {
    model.begin(Vec3::Zero(), Vec3::UnitZ());
    to(Vec3(0.0, 0.0, -5.6));
  }
  const ClosestNodeForce& to(const Vec3& tip) {
    force = model.step(tip);
    work += force.resistance * (tip - place).z();
    place = tip;
    return force;
  }
  const ClosestNodeForce& to(double depth) { return to(Vec3(place.x(), place.y(), depth)); }
  template <typename Each>
  void move(double depth, double step, Each&& each) {
    const double start = place.z();
    const int ticks = std::max(1, static_cast<int>(std::ceil(std::abs(depth - start) / step)));
    for (int tick = 1; tick <= ticks; ++tick) {
      to(start + (depth - start) * tick / ticks);
      each();
    }
  }
  void move(double depth, double step) {
    move(depth, step, [] {});
  }
  ClosestNodeContact model;
  ClosestNodeForce force;
  Vec3 place = Vec3::Zero();
  double work = 0.0;
};

TEST(ClosestNodeContact, one_insertion_meets_the_forces_of_sutherlands_run) {
  ClosestBench bench(default_contact_tissues());
  std::vector<TissuePuncture> punctures;
  double soft_peak = 0.0;
  bench.move(60.0, 0.01, [&] {
    if (bench.force.puncture) punctures.push_back(*bench.force.puncture);
    if (bench.place.z() > 8.0 && bench.place.z() < 38.0) soft_peak = std::max(soft_peak, bench.force.resistance);
  });
  ASSERT_GE(punctures.size(), 3u);
  EXPECT_EQ(punctures.front().tissue, tissue::skin);
  EXPECT_NEAR(punctures.front().force, 1.5, 0.01);
  double flavum = 0.0;
  for (const TissuePuncture& puncture : punctures) {
    if (puncture.tissue == tissue::ligamentum_flavum) flavum = puncture.force;
  }
  EXPECT_NEAR(flavum, 4.7, 0.02);
  EXPECT_GT(soft_peak, 0.5);
  EXPECT_LT(soft_peak, 1.8);  // 0.9 N at the tip and the friction of 38 mm
}

TEST(ClosestNodeContact, skin_is_punctured_5_mm_on_at_300_mN_per_mm) {
  ContactTissues tissues = default_contact_tissues();
  for (ContactTissue& each : tissues) each.friction = 0.0;
  ClosestBench bench(tissues);
  bench.to(-5.5);
  double last = 0.0;
  int ticks = 0;
  while (!bench.force.puncture && ticks < 2000) {
    bench.to(-5.5 + 0.01 * ++ticks);
    EXPECT_NEAR(bench.force.resistance, 0.3 * 0.01 * ticks, 1e-9);
    EXPECT_LT(bench.force.resistance - last, 0.0031);
    last = bench.force.resistance;
  }
  EXPECT_NEAR(0.01 * ticks, 5.0, 0.011);
  bench.to(bench.place.z());
  EXPECT_EQ(bench.force.resistance, 0.0);
  EXPECT_EQ(bench.model.node_forces().count, 1u);  // the one that goes back
  for (int tick = 0; tick < 32; ++tick) bench.to(bench.place.z());
  EXPECT_EQ(bench.model.node_forces().count, 0u);
}

// Skin of 2 mm and a membrane at 16 mm, between nodes 11 mm apart, none of which lies in them.
TEST(ClosestNodeContact, a_layer_between_two_nodes_gives_way_at_its_own_force) {
  ContactTissues tissues = default_contact_tissues();
  CondensedBody body = coarse_body();
  std::fill(body.tissues.begin(), body.tissues.end(), tissue::soft);
  ClosestNodeContact model(body, tissues, coarse_settings(), 1e-3);
  std::vector<TissueId> line(160, tissue::soft);
  std::fill_n(line.begin(), 8, tissue::skin);
  std::fill_n(line.begin() + 64, 2, tissue::ligamentum_flavum);
  model.begin(Vec3::Zero(), Vec3::UnitZ(), line);
  std::vector<TissuePuncture> punctures;
  for (double depth = -2.0; depth < 45.0; depth += 0.01) {
    const ClosestNodeForce force = model.step(Vec3(0.0, 0.0, depth));
    if (force.puncture) punctures.push_back(*force.puncture);
  }
  ASSERT_GE(punctures.size(), 2U);
  EXPECT_EQ(punctures[0].tissue, tissue::skin);
  EXPECT_NEAR(punctures[0].force, 1.5, 0.01);
  const auto firm = std::find_if(punctures.begin(), punctures.end(), [](const TissuePuncture& puncture) {
    return puncture.tissue == tissue::ligamentum_flavum;
  });
  ASSERT_NE(firm, punctures.end());
  EXPECT_NEAR(firm->force, 4.7, 0.02);
  const std::size_t before = punctures.size();
  model.begin(Vec3::Zero(), Vec3::UnitZ(), line);  // the same way again: it is open
  for (double depth = -2.0; depth < 44.0; depth += 0.01) {
    const ClosestNodeForce force = model.step(Vec3(0.0, 0.0, depth));
    EXPECT_FALSE(force.puncture && force.puncture->tissue == tissue::ligamentum_flavum) << depth;
    if (force.puncture) punctures.push_back(*force.puncture);
  }
  EXPECT_EQ(punctures.size(), before);
}

TEST(ClosestNodeContact, another_node_takes_over_at_the_same_force) {
  Random random(1);
  ContactTissues tissues = default_contact_tissues();
  for (ContactTissue& each : tissues) each = {.friction = 0.0, .puncture_force = 100.0, .stiffness = 0.4};
  ClosestNodeSettings settings = coarse_settings();
  settings.capture_radius = 12.0;
  int switches = 0;
  for (int trial = 0; trial < 200; ++trial) {
    ClosestBench bench(tissues, settings);
    bench.to(Vec3(random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0), 0.0));
    bench.move(random.uniform(3.0, 8.0), 0.02);
    const auto node = bench.force.node;
    for (int tick = 0; tick < 400 && bench.force.node == node; ++tick) {
      const Vec3 onward = bench.place + Vec3(0.02, 0.01, 0.005);
      const double before = bench.force.tip_force;
      bench.to(onward);
      if (bench.force.node == node) continue;
      ++switches;
      EXPECT_NEAR(bench.force.tip_force, before, 0.01);  // the tick's own motion
      const double met = bench.force.tip_force;
      bench.to(bench.place);
      EXPECT_LT(std::abs(bench.force.tip_force - met), 1e-9);
    }
  }
  EXPECT_GT(switches, 50);
}

TEST(ClosestNodeContact, the_force_is_that_of_the_node_held_alone_in_the_whole_body) {
  ContactTissues tissues;
  tissues.fill({.puncture_force = 100.0});  // c_i = 1: as the mesh has it
  ClosestBench bench(tissues);
  const Vec3 met = bench.to(Vec3(0.0, 0.0, -5.5)).node ? bench.place : Vec3::Zero();
  const Vec3 tip(0.4, -0.3, 1.5);
  bench.to(tip);
  ASSERT_TRUE(bench.force.node.has_value());
  const auto at = static_cast<Eigen::Index>(3 * *bench.force.node);
  const Vec3 expected = coarse_body().compliance.block<3, 3>(at, at).inverse() * (tip - met);
  EXPECT_NEAR(bench.force.tip_force, expected.z(), 1e-9 * expected.norm());
  EXPECT_EQ(bench.model.stiffness_scale(*bench.force.node), 1.0);
}

TEST(ClosestNodeContact, friction_is_1400_mN_on_the_way_in_and_the_same_on_the_way_out) {
  ContactTissues tissues;
  tissues.fill({.friction = 0.02});
  tissues[tissue::ligamentum_flavum].friction = 0.2;
  tissues[tissue::epidural_fat].friction = 0.2;
  ClosestBench bench(tissues);
  // Ligament begins half-way between the nodes at 33 and 44 mm.
  bench.move(43.5, 0.01);
  EXPECT_NEAR(bench.force.resistance, 38.5 * 0.02 + 5.0 * 0.2, 1e-9);
  const double stopped = bench.to(43.5).resistance;
  EXPECT_NEAR(stopped, 1.77, 1e-9);
  double last = stopped, jump = 0.0;
  bench.move(38.5, 0.01, [&] {
    jump = std::max(jump, std::abs(bench.force.resistance - last));
    last = bench.force.resistance;
  });
  EXPECT_LT(jump, 0.0121);  // 1 N/mm and the shaft that leaves the ligament
  EXPECT_NEAR(bench.force.resistance, -38.5 * 0.02, 1e-9);
}

TEST(ClosestNodeContact, no_way_along_the_line_gives_work) {
  Random random(2);
  for (int trial = 0; trial < (sanitized ? 5 : 50); ++trial) {
    ClosestBench bench(default_contact_tissues());
    bench.work = 0.0;
    for (int way = 0; way < 8; ++way) bench.move(random.uniform(-6.0, 60.0), random.uniform(0.01, 0.2));
    bench.move(-20.0, 0.05);
    EXPECT_GT(bench.work, -1e-9);
    EXPECT_EQ(bench.force.tip_force, 0.0);
  }
}

TEST(ClosestNodeContact, ticks_at_random_are_finite_and_take_no_memory_and_no_lock) {
  Random random(3);
  ClosestNodeContact model(coarse_body(), default_contact_tissues(), coarse_settings(), 1e-3);
  model.begin(Vec3::Zero(), Vec3::UnitZ());
  bool finite = true;
  const RealTimeGuard guard;
  for (int tick = 0; tick < (sanitized ? 2000 : 50000); ++tick) {
    const ClosestNodeForce force =
        model.step(Vec3(4.0 * random.normal(), 4.0 * random.normal(), random.uniform(-10.0, 400.0)));
    finite = finite && std::isfinite(force.resistance);
    if (random.uniform() < 0.001) model.reset();
    if (random.uniform() < 0.01) model.begin(Vec3::Zero(), Vec3::UnitZ());
  }
  EXPECT_TRUE(model.step(Vec3(0.0, 0.0, std::nan(""))).fault);
  if (RealTimeGuard::available()) {
    EXPECT_EQ(RealTimeGuard::heap_calls(), 0u);
    EXPECT_EQ(RealTimeGuard::lock_calls(), 0u);
  }
  EXPECT_TRUE(finite);
}

TEST(ClosestNodeContact, refuses_settings_out_of_range) {
  ClosestNodeSettings settings;
  settings.layer = 0.0;
  EXPECT_THROW(ClosestNodeContact(coarse_body(), default_contact_tissues(), settings, 1e-3), InputError);
  EXPECT_THROW(ClosestNodeContact({}, default_contact_tissues(), {}, 1e-3), InputError);
  EXPECT_THROW(ClosestNodeContact(coarse_body(), default_contact_tissues(), {}, 1.0), InputError);
}

}  // namespace
}  // namespace bodkin
