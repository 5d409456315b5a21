// Relaxing tissue under a needle: RelaxingTissue alone, and in EmbeddedNeedle.
#include "fem/relaxing_tissue.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/fem/needle_rig.h"
#include "tests/sanitized.h"
#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using checks::NeedleRig;

const std::vector<PronyTerm> two_terms = {{.share = 0.3, .time = 0.1}, {.share = 0.2, .time = 1.0}};

// The remaining fraction of a force after a time, with the two terms.
double left_after(double time) {
  return 0.5 + 0.3 * std::exp(-time / 0.1) + 0.2 * std::exp(-time / 1.0);
}

const CondensedBody& relaxing_body() {
  static const CondensedBody body = checks::kelvin_body(1, 31, 1.0, 0.05);
  return body;
}

ContactTissues tough_tissues() {
  ContactTissues tissues = checks::plain_tissues(0.0);
  tissues[tissue::soft].puncture_force = 20.0;
  return tissues;
}

TEST(RelaxingNeedle, a_dimple_that_is_held_relaxes_as_its_series_says) {
  NeedleRig elastic(relaxing_body(), tough_tissues());
  NeedleRig relaxing(relaxing_body(), tough_tissues(), checks::narrow_settings(), {}, {two_terms});
  for (NeedleRig* each : {&elastic, &relaxing}) each->move(1.0, 1000.0);  // in two ticks
  const double at_first = elastic.force.resistance;
  ASSERT_GT(at_first, 0.1);
  for (int tick = 1; tick <= 3000; ++tick) {
    relaxing.to(1.0);
    if (tick % 100 == 0) {
      EXPECT_NEAR(relaxing.force.resistance, at_first * left_after(1e-3 * tick), 1e-2 * at_first) << tick;
    }
  }
  // The dimple stays as deep as the tip, however much its force has relaxed.
  EXPECT_NEAR(relaxing.model.elastic_forces().nodes[0].force[2], at_first, 1e-5 * at_first);
  EXPECT_NEAR(relaxing.model.node_forces().nodes[0].force[2], relaxing.force.resistance, 1e-5);
  // Pulled back at once, the tip leaves the tissue, which follows only slowly.
  relaxing.move(0.4, 1000.0);
  EXPECT_EQ(relaxing.force.resistance, 0.0);
  for (int tick = 0; tick < 3000; ++tick) relaxing.to(0.4);
  EXPECT_GT(relaxing.force.resistance, 0.15 * at_first);
  EXPECT_LT(relaxing.force.resistance, 0.2 * at_first);
}

TEST(RelaxingNeedle, a_shaft_that_sticks_relaxes_as_a_whole_along_and_across) {
  NeedleRig elastic(relaxing_body(), checks::plain_tissues(0.05));
  NeedleRig relaxing(relaxing_body(), checks::plain_tissues(0.05), checks::narrow_settings(), {}, {two_terms});
  const Vec3 deep(0.0, 0.0, 20.0), less(0.02, 0.0, 19.98);
  for (NeedleRig* each : {&elastic, &relaxing}) {
    each->move(deep, 20.0);
    for (int tick = 0; tick < 15000; ++tick) each->to(deep);
  }
  const Vec3 before = elastic.force.on_hand.force, relaxed = relaxing.force.on_hand.force;
  // Between the remainder of an instantaneous force and that after infinite creep.
  EXPECT_LT(std::abs(relaxed.z()), 0.9 * std::abs(before.z()));
  EXPECT_GT(std::abs(relaxed.z()), 0.5 * std::abs(before.z()));
  for (NeedleRig* each : {&elastic, &relaxing}) each->to(less);
  ASSERT_EQ(elastic.force.sticking, elastic.force.nodes);
  const Vec3 step = elastic.force.on_hand.force - before;
  ASSERT_GT(std::abs(step.z()), 0.01);
  ASSERT_GT(std::abs(step.x()), 0.01);
  for (int tick = 1; tick <= 1000; ++tick) {
    relaxing.to(less);
    if (tick % 100 != 0) continue;
    const Vec3 now = relaxing.force.on_hand.force - relaxed;
    EXPECT_NEAR(now.z(), step.z() * left_after(1e-3 * tick), 0.02 * std::abs(step.z())) << tick;
    EXPECT_NEAR(now.x(), step.x() * left_after(1e-3 * tick), 0.02 * std::abs(step.x())) << tick;
  }
}

// A spring behind the body takes more of the way as the tissue bears less.
TEST(RelaxingNeedle, the_spring_of_the_device_does_not_relax) {
  CondensedBody body = relaxing_body();
  const double spring = 0.4;
  for (Eigen::Index column = 0; column < body.compliance.cols(); ++column)
    for (Eigen::Index row = column % 3; row < body.compliance.rows(); row += 3)
      body.compliance(row, column) += spring;
  NeedleRig elastic(relaxing_body(), tough_tissues());
  elastic.move(1.0, 1000.0);
  const double tissue_gives = 1.0 / elastic.force.resistance;  // mm/N
  NeedleRig rig(body, tough_tissues(), checks::narrow_settings(), {}, {two_terms, spring});
  rig.move(1.0, 1000.0);
  EXPECT_NEAR(rig.force.resistance, 1.0 / (tissue_gives + spring), 0.01);
  for (int tick = 0; tick < 15000; ++tick) rig.to(1.0);
  EXPECT_NEAR(rig.force.resistance, 1.0 / (2.0 * tissue_gives + spring), 1e-4);
}

// The hand's total work is never negative, and while no point is released the loss only grows.
TEST(RelaxingNeedle, gives_no_energy) {
  Random random(11);
  int punctures = 0;
  for (int trial = 0; trial < (sanitized ? 4 : 40); ++trial) {
    const bool comes_out = trial % 2 == 1;
    ContactTissues tissues = checks::plain_tissues(0.05);
    const bool gives_way = trial % 4 >= 2;
    tissues[tissue::soft].puncture_force = gives_way ? 0.2 : 0.0;
    std::vector<PronyTerm> terms = {{.share = random.uniform(0.1, 0.5), .time = random.uniform(0.01, 0.1)},
                                    {.share = random.uniform(0.1, 0.5), .time = random.uniform(0.1, 2.0)}};
    NeedleRig rig(relaxing_body(), tissues, checks::narrow_settings(), {}, {terms});
    double lost = 0.0, most = 0.0, fall = 0.0, least = 0.0, depth = -1.0;
    for (int part = 0; part < 30; ++part) {
      const double goal = comes_out ? random.uniform(-1.0, 20.0) : depth + random.uniform(0.0, 1.0);
      const Vec3 from = Vec3(0.0, 0.0, depth);
      const double speed = std::pow(10.0, random.uniform(0.5, 2.7));
      const double aside = random.uniform(-0.5, 0.5);
      const int ticks =
          1 + static_cast<int>(1e3 * std::abs(goal - depth) / speed) + static_cast<int>(random.next() % 300);
      for (int tick = 1; tick <= ticks; ++tick) {
        const double share = static_cast<double>(tick) / ticks;
        rig.to(from + share * Vec3(0.0, 0.0, goal - depth) + Vec3(aside * std::sin(3.1415926 * share), 0.0, 0.0));
        least = std::min(least, rig.work);
        lost = rig.work - rig.model.stored_energy();
        most = std::max(most, lost);
        fall = std::max(fall, most - lost);
      }
      depth = goal;
    }
    if (!comes_out) {
      EXPECT_GT(rig.force.nodes, 3U);
    }
    punctures += rig.force.opened_depth >= 0.0 ? 1 : 0;
    EXPECT_GT(least, -1e-3) << trial;
    if (!comes_out) {
      EXPECT_LT(fall, 1e-3) << trial;
    }
  }
  EXPECT_GT(punctures, 0);
}

TEST(RelaxingNeedle, jumps_no_more_than_an_elastic_one_where_points_come_and_go) {
  NeedleRig elastic(relaxing_body(), checks::plain_tissues(0.05));
  NeedleRig relaxing(relaxing_body(), checks::plain_tissues(0.05), checks::narrow_settings(), {}, {two_terms});
  double largest[2] = {0.0, 0.0};
  NeedleRig* const rigs[2] = {&elastic, &relaxing};
  for (int which = 0; which < 2; ++which) {
    NeedleRig& rig = *rigs[which];
    for (const double depth : {15.0, 4.0, 12.5, -1.0, 9.0, 3.0, 15.0}) {
      largest[which] = std::max(largest[which], rig.move(depth, 20.0));
      for (int tick = 0; tick < 500; ++tick) rig.to(depth);
    }
  }
  EXPECT_GT(largest[0], 0.0);
  EXPECT_LT(largest[1], 1.2 * largest[0]);
}

TEST(RelaxingNeedle, another_compliance_is_taken_over_without_a_jump) {
  const CondensedBody& body = relaxing_body();
  const Eigen::MatrixXd stiffer = 0.8 * body.compliance;
  const std::vector<PronyTerm> quick = {{.share = 0.5, .time = 0.05}};
  EmbeddedNeedle needle(body, checks::plain_tissues(0.05), checks::narrow_settings(), 1e-3, {}, &stiffer, {quick});
  needle.begin(Vec3::Zero(), Vec3::UnitZ());
  for (int tick = 0; tick <= 1000; ++tick) needle.step(needle_pose(Vec3(0.0, 0.0, 0.01 * tick), Vec3::UnitZ()));
  const Pose held = needle_pose(Vec3(0.3, 0.0, 10.0), Vec3::UnitZ());
  for (int tick = 0; tick < 4000; ++tick) needle.step(held);
  const Wrench before = needle.step(held).on_hand;
  ASSERT_GT(before.force.norm(), 0.1);
  needle.exchange();
  while (needle.exchanges()) EXPECT_LT((needle.step(held).on_hand.force - before.force).norm(), 1e-6);
  EXPECT_TRUE(needle.exchanged());
  // Nothing draws the tissue back: it continues unchanged.
  EXPECT_LT((needle.step(held).on_hand.force - before.force).norm(), 1e-3 * before.force.norm());
}

TEST(RelaxingNeedle, is_the_same_again_forgets_at_a_reset_and_takes_no_memory) {
  Random random(5);
  std::vector<Vec3> way;
  for (double depth = -1.0; way.size() < 3000;) {
    depth = std::clamp(depth + 0.1 * (random.normal() + 0.05), -2.0, 25.0);
    way.emplace_back(0.05 * random.normal(), 0.0, depth);
  }
  EmbeddedNeedle needle(relaxing_body(), default_contact_tissues(), checks::narrow_settings(), 1e-3, {}, nullptr,
                        {two_terms});
  std::vector<double> first, again;
  for (std::vector<double>* felt : {&first, &again}) {
    felt->reserve(way.size());
    needle.reset();
    needle.begin(Vec3::Zero(), Vec3::UnitZ());
    const RealTimeGuard guard;
    for (const Vec3& tip : way) felt->push_back(needle.step(needle_pose(tip, Vec3::UnitZ())).resistance);
    if (RealTimeGuard::available()) {
      EXPECT_EQ(RealTimeGuard::heap_calls(), 0U);
    }
  }
  EXPECT_EQ(first, again);
}

TEST(RelaxingNeedle, refuses_shares_of_more_than_all_and_times_out_of_range) {
  const auto refused = [](std::vector<PronyTerm> terms) {
    EXPECT_THROW(EmbeddedNeedle(relaxing_body(), checks::plain_tissues(0.0), {}, 1e-3, {}, nullptr, {terms}),
                 InputError);
  };
  refused({{.share = 0.6, .time = 1.0}, {.share = 0.6, .time = 2.0}});
  refused({{.share = 1.5, .time = 1.0}});
  refused({{.share = 0.5, .time = 0.0}});
}

// A point removed and added again acts, for itself and the others, as one without load meanwhile.
TEST(RelaxingTissue, a_point_that_was_removed_goes_on_moving_the_others) {
  const CondensedBody& body = relaxing_body();
  ShaftCompliance whole(body.compliance, 8), changing(body.compliance, 8);
  RelaxingTissue all(two_terms, 1e-3, 8), some(two_terms, 1e-3, 8);
  for (ShaftCompliance* each : {&whole, &changing}) each->begin(Mat3::Identity());
  for (std::uint32_t point = 0; point < 4; ++point) {
    whole.push(point);
    all.added(whole);
    changing.push(point);
    some.added(changing);
  }
  std::vector<double> forces = {0.1, 0.2, 1.0, -0.3, 0.1, 0.7, 0.0, 0.4, 0.9, 0.2, -0.2, 1.3};
  forces.resize(24, 0.0);
  const auto expect_same = [&](std::size_t points) {
    for (std::size_t p = 0; p < points; ++p) EXPECT_LT((all.moved(p) - some.moved(p)).norm(), 1e-12) << p;
  };
  const auto both = [&](int ticks) {
    for (int tick = 0; tick < ticks; ++tick) {
      all.step(whole, forces);
      some.step(changing, forces);
    }
  };
  both(300);
  EXPECT_GT(all.moved(0).norm(), 0.01);
  for (int removed = 0; removed < 2; ++removed) {
    some.removing_last(changing);
    changing.pop();
    expect_same(changing.size());
  }
  std::fill(forces.begin() + 6, forces.end(), 0.0);
  both(200);
  expect_same(2);
  for (std::uint32_t point = 2; point < 4; ++point) {
    changing.push(point);
    some.added(changing);
    expect_same(point + 1);
  }
  both(200);
  expect_same(4);

  // If other points follow, the last ones are gone for good; their effect on the others fades as usual.
  some.removing_last(changing);
  changing.pop();
  some.drop_removed();
  both(100);
  expect_same(3);
  changing.push(9);
  some.added(changing);
  EXPECT_LT((some.faded(3)).norm(), 1e-15);
}

}  // namespace
}  // namespace bodkin
