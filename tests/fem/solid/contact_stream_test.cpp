// Contact points are computed ahead of a needle that enters anywhere.
#include "fem/solid/contact_stream.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/fem/lattice_body.h"
#include "tests/sanitized.h"
#include "tests/simulation/real_time_guard.h"
#include <Eigen/Eigenvalues>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "fem/embedded_needle.h"
#include "fem/solid/line_points.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr double box_side = 60.0;  // mm; the skin is at z = 60, the bottom is held

std::shared_ptr<const ContactBody> box_of(std::uint32_t nodes_along) {
  auto body = std::make_shared<BodyDescription>();
  body->mesh = kuhn_lattice(nodes_along, box_side, 0.15);
  body->materials.set(tissue::soft, {0.2, 0.3});
  body->fixed = nodes_beyond(body->mesh, Vec3::Zero(), Vec3(0.0, 0.0, -1.0));
  return std::make_shared<const ContactBody>(std::move(body));
}

// The same box in voxels of 1 mm: 2 mm of skin, muscle, and a ligament 20 to 24 mm deep.
std::shared_ptr<const Case> patient_in_box() {
  auto patient = std::make_shared<Case>();
  std::vector<TissueProperties> tissues(4);
  tissues[0].name = "air";
  const std::vector<std::pair<TissueId, double>> forces = {
      {tissue::skin, 1.5}, {tissue::muscle, 0.9}, {tissue::ligamentum_flavum, 4.7}};
  for (std::size_t i = 0; i < forces.size(); ++i) {
    tissues[i + 1].id = forces[i].first;
    tissues[i + 1].name = tissues[i + 1].title = "tissue " + std::to_string(i);
    tissues[i + 1].deformable.puncture_force = forces[i].second;
  }
  patient->library = TissueLibrary(tissues);
  Grid grid;
  grid.size = {60, 60, 70};
  grid.origin = Vec3(0.5, 0.5, 0.5);
  patient->tissues = TissueVolume(grid, tissue::air);
  for (int k = 0; k < 60; ++k) {
    const double depth = box_side - (k + 0.5);
    const TissueId here = depth < 2.0                    ? tissue::skin
                          : depth < 20.0 || depth > 24.0 ? tissue::muscle
                                                         : tissue::ligamentum_flavum;
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i) patient->tissues.at(i, j, k) = here;
  }
  return patient;
}

const Vec3 entry_in_box(29.3, 31.2, box_side);

CondensedBody complete_line(const ContactBody& body, const Case& patient, const Vec3& entry, const Vec3& direction) {
  const NeedlePath path{entry, entry + 40.0 * direction};
  return body.contact_points(contact_sites_along(path, 40.0, 1.0, patient), direction, 1.0);
}

EmbeddedNeedle needle_in(const CondensedBody& body) {
  return EmbeddedNeedle(body, default_contact_tissues(), {}, 1e-3);
}

// 50 mm/s down to `end` mm and back.
std::vector<double> depths_to(double end) {
  std::vector<double> depths;
  for (double depth = 0.0; depth <= end; depth += 0.05) depths.push_back(depth);
  for (double depth = end; depth >= 0.0; depth -= 0.05) depths.push_back(depth);
  return depths;
}

TEST(ContactStream, has_the_points_and_the_bits_of_a_complete_line_anywhere_and_at_any_angle) {
  const auto body = box_of(9);
  const auto patient = patient_in_box();
  const auto line = std::make_shared<ContactLine>();
  const ContactStream stream(body, patient, {.length = 40.0}, line);
  Random random(5);
  for (int i = 0; i < (sanitized ? 1 : 4); ++i) {
    const double x = random.uniform(15.0, 45.0), y = random.uniform(15.0, 45.0);
    const double right = random.uniform(-0.5, 0.5), up = random.uniform(-0.5, 0.5);
    const Vec3 entry(x, y, box_side), direction = Vec3(right, up, -1.0).normalized();
    const CondensedBody expected = complete_line(*body, *patient, entry, direction);
    line->request(entry, direction);
    const ContactLine::Progress found = line->wait_for(ContactLine::most_points);
    ASSERT_TRUE(found.complete);
    ASSERT_EQ(found.points, expected.nodes.size());
    const auto size = expected.compliance.rows();
    EXPECT_EQ(line->body().compliance.topLeftCorner(size, size), expected.compliance);
    EXPECT_TRUE(std::equal(expected.nodes.begin(), expected.nodes.end(), line->body().nodes.begin()));
    EXPECT_TRUE(std::equal(expected.tissues.begin(), expected.tissues.end(), line->body().tissues.begin()));
  }
}

TEST(ContactStream, a_line_beside_the_mesh_is_complete_and_empty) {
  const auto line = std::make_shared<ContactLine>();
  const ContactStream stream(box_of(5), patient_in_box(), {.length = 40.0}, line);
  line->request(Vec3(300.0, 0.0, 0.0), Vec3::UnitZ());
  const ContactLine::Progress found = line->wait_for(1);
  EXPECT_TRUE(found.complete);
  EXPECT_EQ(found.points, 0U);
}

TEST(ContactStream, a_new_line_takes_the_place_of_one_that_is_being_computed) {
  const auto body = box_of(7);
  const auto patient = patient_in_box();
  const auto line = std::make_shared<ContactLine>();
  const ContactStream stream(body, patient, {.length = 40.0}, line);
  for (int i = 0; i < 20; ++i) {
    const Vec3 entry = entry_in_box + Vec3(0.3 * i, 0.0, 0.0);
    line->request(entry, -Vec3::UnitZ());
    EXPECT_FALSE(line->progress().complete);
    const ContactLine::Progress found = line->wait_for(i % 3 == 0 ? 1 : 0);
    for (std::size_t point = 0; point < found.points; ++point)
      EXPECT_EQ(line->body().nodes[point].x(), entry.x()) << "of another line";
  }
  EXPECT_TRUE(line->wait_for(ContactLine::most_points).complete);
}

// The points of a line that turns are those of the same sites in one go: the new points are coupled with the
// remaining ones as if all had been known from the beginning.
TEST(ContactStream, a_line_that_turns_keeps_its_points_and_couples_the_new_ones_with_them) {
  const auto body = box_of(9);
  const auto patient = patient_in_box();
  const Vec3 down = -Vec3::UnitZ(), aside = Vec3(0.5, 0.2, -1.0).normalized();
  constexpr std::size_t kept = 9;
  const BoundPoints unbound;
  LinePoints whole(*body, 1.0, unbound);
  whole.add(contact_sites_along({entry_in_box, entry_in_box + 40.0 * down}, 40.0, 1.0, *patient), down);
  ASSERT_GT(whole.size(), kept);
  whole.compute(0, kept);
  const Vec3 turn = whole.point(kept - 1).place + 0.3 * down;
  whole.keep_first(kept);
  const double left = 40.0 - (turn - entry_in_box).norm();
  const auto ahead = contact_sites_ahead(turn, aside, left, 1.0, whole.tissue(kept - 1), *patient);
  EXPECT_TRUE(std::ranges::any_of(
      ahead, [](const ContactSite& site) { return site.resists && site.tissue == tissue::ligamentum_flavum; }));
  whole.add(ahead, aside);
  whole.compute(0, whole.size());

  const auto line = std::make_shared<ContactLine>();
  const ContactStream stream(body, patient, {.length = 40.0}, line);
  for (const std::size_t waited : {kept, ContactLine::most_points}) {  // while it is computed, and later
    line->request(entry_in_box, down);
    line->wait_for(waited);
    line->continue_from(turn, aside, kept);
    const ContactLine::Progress found = line->wait_for(ContactLine::most_points);
    ASSERT_TRUE(found.complete);
    ASSERT_EQ(found.points, whole.size());
    for (std::size_t j = 0; j < found.points; ++j) {
      const ContactPoint expected = whole.point(j);
      EXPECT_EQ(line->body().nodes[j], expected.place) << j;
      EXPECT_EQ(line->body().tissues[j], expected.tissue) << j;
      for (std::size_t i = 0; i <= j; ++i) {
        const auto row = static_cast<Eigen::Index>(3 * i), column = static_cast<Eigen::Index>(3 * j);
        EXPECT_EQ((line->body().compliance.block<3, 3>(row, column)), expected.between[i]) << i << " " << j;
      }
    }
  }
}

// Points of the planned line belong to the patient, and a needle can turn away from them.
TEST(ContactStream, the_planned_line_is_known_and_can_be_left) {
  const auto body = box_of(9);
  const auto patient = std::make_shared<Case>(*patient_in_box());
  const Vec3 down = -Vec3::UnitZ(), aside = Vec3(0.5, 0.2, -1.0).normalized();
  const NeedlePath planned{entry_in_box, entry_in_box + 40.0 * down};
  CondensedBody marked = complete_line(*body, *patient, entry_in_box, down);
  marked.compliance(0, 0) += 1.0;  // to be told from what is computed
  patient->prepared = {std::make_shared<const CondensedBody>(marked), planned};
  const auto line = std::make_shared<ContactLine>();
  const ContactStream stream(body, patient, {.length = 40.0}, line);
  line->request_planned(planned.entry, planned.direction());
  const ContactLine::Progress known = line->wait_for(ContactLine::most_points);
  ASSERT_EQ(known.points, marked.nodes.size());
  const auto size = marked.compliance.rows();
  EXPECT_EQ(line->body().compliance.topLeftCorner(size, size), marked.compliance);
  constexpr std::size_t kept = 5;
  const Vec3 turn = marked.nodes[kept - 1] + 0.4 * down;
  line->continue_from(turn, aside, kept);
  const ContactLine::Progress found = line->wait_for(ContactLine::most_points);
  ASSERT_TRUE(found.complete);
  ASSERT_GT(found.points, kept + 10);
  constexpr Eigen::Index fixed = 3 * kept;
  EXPECT_EQ(line->body().compliance.topLeftCorner(fixed, fixed), marked.compliance.topLeftCorner(fixed, fixed));
  for (std::size_t i = kept; i < found.points; ++i) {
    const Vec3 from = line->body().nodes[i] - turn;
    EXPECT_LT((from - from.dot(aside) * aside).norm(), 1e-9) << i;
  }
  const auto all = static_cast<Eigen::Index>(3 * found.points);
  Eigen::MatrixXd compliance = line->body().compliance.topLeftCorner(all, all);
  compliance(0, 0) -= 1.0;
  EXPECT_GT(
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(compliance, Eigen::EigenvaluesOnly).eigenvalues().minCoeff(),
      0.0);
}

// A left needle without length: nothing can be bound to it.
TEST(ContactStream, says_why_there_are_no_points_and_says_it_once) {
  const auto line = std::make_shared<ContactLine>();
  ContactStream stream(box_of(5), patient_in_box(), {.length = 40.0, .left = {{entry_in_box, entry_in_box}}}, line);
  line->request(entry_in_box, -Vec3::UnitZ());
  EXPECT_EQ(line->wait_for(1).points, 0U);
  EXPECT_TRUE(line->progress().complete) << "the needle does not wait for them";
  EXPECT_THAT(stream.take_failures(),
              ElementsAre(AllOf(StartsWith("contact points of the needle's line could not be computed"),
                                HasSubstr("is 0 mm long"), Not(HasSubstr("memory")))));
  line->request(entry_in_box + Vec3::UnitX(), -Vec3::UnitZ());
  line->wait_for(1);
  EXPECT_TRUE(stream.take_failures().empty());
  EXPECT_NO_THROW(stream.throw_failure());
}

TEST(ContactStream, says_that_memory_ended_and_goes_on_when_there_is_some_again) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "the sanitizer has the memory";
  const auto line = std::make_shared<ContactLine>(0.0, 8);
  ContactStream stream(box_of(9), patient_in_box(), {.length = 40.0}, line);
  {
    const ScarceMemory little(2048);
    line->request(entry_in_box, -Vec3::UnitZ());
    line->wait_for(ContactLine::most_points);
  }
  EXPECT_TRUE(line->progress().complete);
  EXPECT_THAT(stream.take_failures(), ElementsAre(AllOf(StartsWith("contact points of the needle's line could not"),
                                                        HasSubstr(": the memory is exhausted"))));
  line->request(entry_in_box, -Vec3::UnitZ());
  const std::size_t points = line->wait_for(ContactLine::most_points).points;
  EXPECT_GT(points, 15U);
  EXPECT_TRUE(stream.take_failures().empty());
  const std::vector<std::uint32_t> held = {700, 701};
  {
    const ScarceMemory little(2048);
    line->couple(held, points);
    EXPECT_FALSE(line->wait_until_coupled());
  }
  try {
    stream.throw_failure();
    FAIL() << "nothing was said";
  } catch (const SystemError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("could not be coupled with"), HasSubstr("the memory is exhausted")));
  }
}

TEST(ContactStream, waiting_ends_when_the_stream_does) {
  const auto line = std::make_shared<ContactLine>();
  std::thread waiting([&] { EXPECT_TRUE(line->wait_for(1).complete); });
  line->request(Vec3::Zero(), Vec3::UnitZ());  // there is no stream
  line->close();
  waiting.join();
  line->request(Vec3::Zero(), Vec3::UnitZ());
  EXPECT_TRUE(line->progress().complete);
}

TEST(GrowingLine, points_that_come_in_time_change_no_bit) {
  const auto body = box_of(9);
  const CondensedBody points = complete_line(*body, *patient_in_box(), entry_in_box, -Vec3::UnitZ());
  EmbeddedNeedle whole = needle_in(points), growing = needle_in(points);
  whole.begin(entry_in_box, -Vec3::UnitZ());
  growing.begin_growing(entry_in_box, -Vec3::UnitZ());
  int punctures = 0;
  for (const double depth : depths_to(30.0)) {
    const auto ahead = std::count_if(points.nodes.begin(), points.nodes.end(),
                                     [&](const Vec3& node) { return entry_in_box.z() - node.z() <= depth + 3.0; });
    growing.extend(static_cast<std::size_t>(ahead) + 2);  // the next one is farther where elements are large
    const Pose pose = needle_pose(entry_in_box - depth * Vec3::UnitZ(), -Vec3::UnitZ());
    const EmbeddedNeedleForce expected = whole.step(pose), found = growing.step(pose);
    ASSERT_EQ(found.resistance, expected.resistance) << depth;
    ASSERT_EQ(found.on_hand.force, expected.on_hand.force) << depth;
    ASSERT_EQ(found.puncture.has_value(), expected.puncture.has_value()) << depth;
    punctures += found.puncture ? 1 : 0;
  }
  EXPECT_GE(punctures, 2);
}

// The tip is up to 3 mm past a point before the point arrives.
TEST(GrowingLine, points_that_come_late_are_felt_from_there_on_without_a_jump) {
  const auto body = box_of(9);
  const CondensedBody points = complete_line(*body, *patient_in_box(), entry_in_box, -Vec3::UnitZ());
  EmbeddedNeedle needle = needle_in(points);
  needle.begin_growing(entry_in_box, -Vec3::UnitZ());
  std::vector<TissueId> punctures;
  double before = 0.0;
  bool punctured = false;
  for (const double depth : depths_to(38.0)) {
    const auto there = std::count_if(points.nodes.begin(), points.nodes.end(), [&](const Vec3& node) {
      return 4.0 * std::floor((entry_in_box.z() - node.z()) / 4.0) + 3.0 <= depth;
    });
    needle.extend(static_cast<std::size_t>(there));
    const EmbeddedNeedleForce force = needle.step(needle_pose(entry_in_box - depth * Vec3::UnitZ(), -Vec3::UnitZ()));
    ASSERT_FALSE(force.fault);
    if (!punctured) {
      ASSERT_LT(std::abs(force.resistance - before), 0.3) << depth;
    }
    before = force.resistance;
    punctured = force.puncture.has_value();
    if (force.puncture) punctures.push_back(force.puncture->tissue);
  }
  EXPECT_NE(std::find(punctures.begin(), punctures.end(), tissue::ligamentum_flavum), punctures.end());
}

// The surface is half, and twice, as compliant as its later point.
TEST(GrowingLine, the_first_point_takes_the_force_of_the_provisional_surface_over) {
  const auto body = box_of(9);
  const CondensedBody points = complete_line(*body, *patient_in_box(), entry_in_box, -Vec3::UnitZ());
  const double own = points.compliance(2, 2);
  for (const double part : {0.5, 1.0, 2.0}) {
    EmbeddedNeedle needle = needle_in(points), whole = needle_in(points);
    needle.begin_growing(entry_in_box, -Vec3::UnitZ(), {.compliance = part * own, .strength = 1.5});
    whole.begin(entry_in_box, -Vec3::UnitZ());
    double before = 0.0, work = 0.0;
    for (double depth = 0.05; depth < 3.0; depth += 0.05) {
      if (depth > 1.5) needle.extend(points.nodes.size(), true);
      const Pose pose = needle_pose(entry_in_box - depth * Vec3::UnitZ(), -Vec3::UnitZ());
      const EmbeddedNeedleForce found = needle.step(pose);
      const double exact = whole.step(pose).resistance;
      work += 0.05 * found.resistance;
      EXPECT_NEAR(found.on_hand.force.z(), found.resistance, 1e-12);
      EXPECT_EQ(found.tip_force, found.resistance) << depth;  // nothing is punctured yet
      if (depth <= 1.5) {
        EXPECT_NEAR(found.resistance, depth / (part * own), 1e-9);
      } else if (part == 1.0) {
        EXPECT_NEAR(found.resistance, exact, 0.05 / own + 1e-9)
            << depth;  // that one begins at its first tick's depth
      }
      // If the point is softer than the surface was, the tip is not deep enough for the previous force.
      if (part >= 1.0) {
        EXPECT_LT(std::abs(found.resistance - before), 1.5 * 0.05 / own) << depth;
      }
      EXPECT_LE(needle.stored_energy(), work + 1e-9);
      before = found.resistance;
    }
  }
}

TEST(GrowingLine, a_provisional_surface_fades_where_there_is_no_point) {
  const CondensedBody points = complete_line(*box_of(5), *patient_in_box(), entry_in_box, -Vec3::UnitZ());
  EmbeddedNeedle needle = needle_in(points);
  needle.begin_growing(entry_in_box, -Vec3::UnitZ(), {.compliance = 2.0, .strength = 1.5});
  const Pose pose = needle_pose(entry_in_box - 2.0 * Vec3::UnitZ(), -Vec3::UnitZ());
  double before = needle.step(pose).resistance;
  EXPECT_NEAR(before, 1.0, 1e-12);
  needle.extend(0, true);
  for (int tick = 0; tick < 500; ++tick) {
    const double now = needle.step(pose).resistance;
    EXPECT_LE(now, before);
    EXPECT_GT(now, before - 0.1);
    before = now;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(GrowingLine, holes_stay_open) {
  const auto body = box_of(7);
  const CondensedBody points = complete_line(*body, *patient_in_box(), entry_in_box, -Vec3::UnitZ());
  EmbeddedNeedle needle = needle_in(points);
  needle.begin_growing(entry_in_box, -Vec3::UnitZ());
  needle.extend(points.nodes.size());
  needle.open(points.nodes[0] + Vec3(0.5, 0.0, 0.0), tissue::skin);
  for (double depth = 0.0; depth < 15.0; depth += 0.05) {
    const EmbeddedNeedleForce force = needle.step(needle_pose(entry_in_box - depth * Vec3::UnitZ(), -Vec3::UnitZ()));
    EXPECT_FALSE(force.puncture) << depth;
  }
}

// Time of the first point, and points per second: only printed, as they depend on the machine's load.
TEST(ContactStream, first_point_and_points_per_second) {
  const auto body = box_of(sanitized ? 7 : 19);
  const auto patient = patient_in_box();
  const auto line = std::make_shared<ContactLine>();
  const ContactStream stream(body, patient, {.length = 40.0}, line);
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point from) {
    return 1e3 * std::chrono::duration<double>(Clock::now() - from).count();
  };
  for (int i = 0; i < (sanitized ? 1 : 3); ++i) {
    const auto began = Clock::now();
    line->request(entry_in_box + Vec3(2.3 * i, -1.7 * i, 0.0), Vec3(0.1 * i, 0.0, -1.0).normalized());
    line->wait_for(1);
    const double first = since(began);
    const ContactLine::Progress all = line->wait_for(ContactLine::most_points);
    std::cout << "first point after " << first << " ms, " << all.points << " points in " << since(began) << " ms\n";
    EXPECT_GT(all.points, 10U);
  }
}

}  // namespace
}  // namespace bodkin
