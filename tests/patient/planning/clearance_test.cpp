#include "patient/planning/clearance.h"

#include <random>

#include "tests/patient/planning/made_up_patient.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bodkin::patient {
namespace {

using ::testing::HasSubstr;

const Obstacle* kind_named(const Obstacles& obstacles, const std::string& name) {
  for (const Obstacle& kind : obstacles.kinds)
    if (kind.name == name) return &kind;
  return nullptr;
}

// Every voxel against every 0.05 mm of the path.
double brute_force(const Obstacles& obstacles, std::size_t kind, const anatomy::NeedlePath& path) {
  const anatomy::Grid& grid = obstacles.at.grid;
  double least = 1e9;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        if (obstacles.at.at(i, j, k) != kind + 1) continue;
        const Vec3 centre = grid.to_patient(Vec3(i, j, k));
        const int steps = static_cast<int>(path.length() / 0.05);
        for (int step = 0; step <= steps; ++step) {
          const Vec3 point = path.entry + (static_cast<double>(step) / steps) * (path.target - path.entry);
          least = std::min(least, (centre - point).norm());
        }
      }
    }
  }
  return std::max(0.0, least - 0.5 * grid.spacing.minCoeff());
}

TEST(Clearance, equals_the_brute_force_over_all_voxels) {
  MadeUpPatient made;
  made.paint({10, 20, 5}, {2, 2, 2}, anatomy::tissue::cortical_bone);
  made.paint({-14, 0, -10}, {1, 2, 3}, anatomy::tissue::vessel);
  made.paint({3, -22, 0}, {2, 1, 2}, anatomy::tissue::organ, 7);
  made.name(7, "kidney_left", true);
  PlanningRules rules;
  rules.avoid = {{"vessel", "", "a large vessel", 0.0}};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-30.0, 30.0);
  for (int trial = 0; trial < 12; ++trial) {
    const Vec3 target(place(random), place(random), place(random));
    const anatomy::NeedlePath path{Vec3(place(random), 49.0, place(random)), target};
    const Obstacles obstacles = find_obstacles(made.view(), rules, target);
    for (const Clearance& each : clearances(obstacles, path, 60.0)) {
      if (each.distance == 0.0) continue;  // through it, see the next test
      EXPECT_NEAR(each.distance, brute_force(obstacles, each.kind, path), 0.01)
          << obstacles.kinds[each.kind].name << ", trial " << trial;
    }
  }
}

TEST(Clearance, a_path_through_bone_has_none_and_says_where) {
  MadeUpPatient made;
  made.paint({0, 20, 0}, {5, 3, 5}, anatomy::tissue::cortical_bone);
  const Vec3 target(0, -10, 0);
  const Obstacles obstacles = find_obstacles(made.view(), {}, target);
  const PathReport report = report_on(made.view(), obstacles, straight_to(target));
  EXPECT_TRUE(report.room.blocked);
  ASSERT_EQ(report.blocked.size(), 1U);
  // Bone from y = 23.5 to 16.5; the entry is at 49.5.
  EXPECT_NEAR(report.blocked[0].from, 26.0, 0.3);
  EXPECT_NEAR(report.blocked[0].to, 33.0, 0.3);
  EXPECT_EQ(report.near.front().distance, 0.0);
  EXPECT_EQ(nearest_text(obstacles, report, 1), "into bone");
  ASSERT_EQ(report.crosses.size(), 3U);
  EXPECT_EQ(report.crosses[1].tissue, anatomy::tissue::cortical_bone);
}

TEST(Clearance, is_told_by_name_the_worst_for_its_margin_first) {
  MadeUpPatient made;
  made.paint({9.5, 20, 0}, {4, 4, 4.6}, anatomy::tissue::organ, 7);  // voxels from x = 6 on
  made.name(7, "kidney_left", true);
  made.paint({-8, 20, 0}, {2, 4, 4}, anatomy::tissue::cortical_bone);  // voxels up to x = -6
  const Obstacles obstacles = find_obstacles(made.view(), {}, {0, 0, 0});
  const PathReport report = report_on(made.view(), obstacles, straight_to({0, 0, 0}));
  // Both are 5.5 mm away; the organ's margin is wider.
  EXPECT_EQ(nearest_text(obstacles, report, 2), "kidney left 5.5 mm, bone 5.5 mm");
  EXPECT_NEAR(report.room.spare, 2.5, 1e-6);
  EXPECT_EQ(obstacles.kinds[report.room.kind].title, "kidney left");
}

TEST(Obstacles, the_organ_that_holds_the_lesion_may_be_entered_and_others_not) {
  MadeUpPatient made;
  made.paint({0, 0, 0}, {20, 20, 20}, anatomy::tissue::organ, 1);
  made.paint({0, 0, 0}, {5, 5, 5}, anatomy::tissue::mass, 2);
  made.paint({-30, 30, 0}, {5, 5, 5}, anatomy::tissue::organ, 3);
  made.name(1, "liver", true);
  made.name(2, "liver_tumour", false);
  made.name(3, "kidney_left", true);
  PlanningRules rules;
  rules.avoid = {{"organ", "", "an organ", 0.0}};
  const Obstacles obstacles = find_obstacles(made.view(), rules, {0, 0, 0});
  EXPECT_EQ(kind_named(obstacles, "liver"), nullptr);
  EXPECT_NE(kind_named(obstacles, "kidney_left"), nullptr);
  EXPECT_FALSE(clearance_along(obstacles, straight_to({0, 0, 0}), 8.0).blocked);
  EXPECT_TRUE(clearance_along(obstacles, straight_to({-30, 0, 0}), 8.0).blocked);
}

TEST(Obstacles, a_target_close_to_something_lowers_its_margin_but_never_the_cords) {
  MadeUpPatient made;
  made.paint({0, -4, 0}, {10, 2, 10}, anatomy::tissue::vessel);  // 1.5 mm before a target at y = 0
  made.paint({0, -14, 0}, {10, 2, 10}, anatomy::tissue::spinal_cord);
  PlanningRules rules;
  rules.avoid = {{"vessel", "", "", 4.0}, {"spinal_cord", "", "", 20.0}};
  const Obstacles obstacles = find_obstacles(made.view(), rules, {0, 0, 0});
  EXPECT_NEAR(kind_named(obstacles, "vessel")->margin, 1.4, 0.05);
  EXPECT_EQ(kind_named(obstacles, "spinal_cord")->margin, 20.0);
}

TEST(Obstacles, a_tissue_that_the_case_does_not_know_is_refused_by_name) {
  PlanningRules rules;
  rules.avoid = {{"pancreas", "", "", 0.0}};
  try {
    find_obstacles(MadeUpPatient().view(), rules, Vec3::Zero());
    FAIL() << "expected a refusal";
  } catch (const std::exception& error) {
    EXPECT_THAT(error.what(), HasSubstr("'pancreas'"));
  }
}

TEST(Levels, a_spine_is_entered_at_its_allowed_levels_below_the_cord_only) {
  MadeUpPatient made;
  PlanningRules rules;
  rules.levels = {"L1_L2", "L2_L3", "L3_L4"};
  EXPECT_THAT(level_problem(made.view(), rules, {0, 0, 0}).value_or(""), HasSubstr("no known name"));
  made.landmarks() = {{"conus", {0, 0, 50}},  {"L1_L2", {0, 0, 33}},        {"L2_L3", {0, 0, 0}},
                      {"L3_L4", {0, 0, -33}}, {"L3_L4_skin", {0, 40, -33}}, {"L4_L5", {0, 0, -55}}};
  EXPECT_THAT(level_problem(made.view(), rules, {0, 0, 30}).value_or(""), HasSubstr("L1/L2 lies above L2/L3"));
  EXPECT_EQ(level_problem(made.view(), rules, {0, 0, 3}), std::nullopt);
  EXPECT_THAT(level_problem(made.view(), rules, {0, 0, -54}).value_or(""), HasSubstr("L4/L5 is not a level"));
  ASSERT_EQ(allowed_levels(made.view(), rules).size(), 2U);
  EXPECT_EQ(allowed_levels(made.view(), rules)[0].name, "L2_L3");
  made.landmarks()[0].position.z() = 12;  // a cord that ends lower, as in a child
  EXPECT_THAT(level_problem(made.view(), rules, {0, 0, 3}).value_or(""), HasSubstr("less than a vertebra"));
  rules.levels.clear();
  EXPECT_EQ(level_problem(made.view(), rules, {0, 0, 30}), std::nullopt);
}

}  // namespace
}  // namespace bodkin::patient
