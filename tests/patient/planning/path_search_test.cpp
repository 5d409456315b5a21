#include "patient/planning/path_search.h"

#include <chrono>
#include <optional>

#include "patient/synthetic/lumbar.h"
#include "tests/patient/planning/made_up_patient.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/tissue_library_file.h"
#include "training/planning_rules.h"
#include "training/procedure_file.h"

namespace bodkin::patient {
namespace {

using ::testing::HasSubstr;

TEST(PathSearch, without_anything_in_the_way_the_shortest_way_is_the_first) {
  const MadeUpPatient made;
  const Vec3 target(0, 30, 0);  // 20 mm under the back, 50 mm and more under every other side
  const Obstacles obstacles = find_obstacles(made.view(), {}, target);
  const PathSearch search = search_paths(made.view(), obstacles, target, {});
  ASSERT_FALSE(search.proposals.empty());
  EXPECT_GT(search.proposals.front().path.direction().dot(-Vec3::UnitY()), std::cos(5.0 * degree));
  EXPECT_NEAR(search.proposals.front().path.length(), 20.5, 0.3);
  EXPECT_TRUE(search.why_not.empty());
  for (std::size_t i = 1; i < search.proposals.size(); ++i) {
    EXPECT_LT(search.proposals[i].path.direction().dot(search.proposals[0].path.direction()), std::cos(7.9 * degree));
  }
}

TEST(PathSearch, finds_the_gap_in_a_wall_of_bone_and_keeps_the_margin) {
  MadeUpPatient made;
  made.paint({0, 20, 0}, {60, 2, 60}, anatomy::tissue::cortical_bone);
  made.paint({14, 20, -6}, {5, 2, 5}, anatomy::tissue::soft);  // the gap
  made.paint({0, -20, 0}, {60, 2, 60}, anatomy::tissue::cortical_bone);
  for (const double side : {-30.0, 30.0}) {
    made.paint({side, 0, 0}, {2, 22, 60}, anatomy::tissue::cortical_bone);
    made.paint({0, 0, side}, {60, 22, 2}, anatomy::tissue::cortical_bone);
  }
  const Vec3 target(0, 0, 0);
  const Obstacles obstacles = find_obstacles(made.view(), {}, target);
  const PathSearch search = search_paths(made.view(), obstacles, target, {});
  ASSERT_FALSE(search.proposals.empty()) << search.why_not;
  for (const PathReport& each : search.proposals) {
    EXPECT_FALSE(each.room.blocked);
    EXPECT_GE(each.room.spare, 0.0);
    const double share = (20.0 - each.path.entry.y()) / (target.y() - each.path.entry.y());
    const Vec3 crossing = each.path.entry + share * (target - each.path.entry);
    EXPECT_NEAR(crossing.x(), 14.0, 5.0);
    EXPECT_NEAR(crossing.z(), -6.0, 5.0);
    // On the skin: body here, air 1 mm further out.
    EXPECT_EQ(anatomy::nearest(made.view().tissues, each.path.entry, anatomy::tissue::air), anatomy::tissue::soft);
    EXPECT_EQ(anatomy::nearest(made.view().tissues, Vec3(each.path.entry - each.path.direction()),
                               anatomy::TissueId{anatomy::tissue::soft}),
              anatomy::tissue::air);
  }
}

TEST(PathSearch, a_blocked_target_gives_none_and_says_why) {
  MadeUpPatient made;
  made.paint({0, 0, 0}, {12, 12, 12}, anatomy::tissue::cortical_bone);
  made.paint({0, 0, 0}, {8, 8, 8}, anatomy::tissue::soft);
  const Obstacles obstacles = find_obstacles(made.view(), {}, Vec3::Zero());
  const PathSearch search = search_paths(made.view(), obstacles, Vec3::Zero(), {});
  EXPECT_TRUE(search.proposals.empty());
  EXPECT_THAT(search.why_not, HasSubstr("go into bone"));
  EXPECT_GT(search.looked_at, 1000U);

  PathCriteria criteria;
  criteria.longest = 30.0;
  EXPECT_THAT(search_paths(made.view(), find_obstacles(made.view(), {}, {0, 20, 0}), {0, 0, 30}, criteria).why_not,
              ::testing::IsEmpty());  // 20 mm under the head's side
  criteria.longest = 10.0;
  EXPECT_THAT(search_paths(made.view(), find_obstacles(made.view(), {}, {0, 20, 0}), {0, 20, 0}, criteria).why_not,
              HasSubstr("longer than the 10 mm that the needle reaches"));
  EXPECT_THAT(search_paths(made.view(), obstacles, {0, 10, 0}, {}).why_not, HasSubstr("The target lies in bone"));
  EXPECT_THAT(search_paths(made.view(), obstacles, {0, 58, 0}, {}).why_not, HasSubstr("not lie in the body"));
}

TEST(PathSearch, can_be_stopped) {
  const MadeUpPatient made;
  std::stop_source source;
  source.request_stop();
  const Obstacles obstacles = find_obstacles(made.view(), {}, Vec3::Zero());
  EXPECT_TRUE(search_paths(made.view(), obstacles, Vec3::Zero(), {}, source.get_token()).proposals.empty());
}

TEST(StructureTarget, is_the_centre_or_the_deepest_point_of_a_crescent) {
  MadeUpPatient made;
  made.paint({10, 0, 0}, {6, 6, 6}, anatomy::tissue::mass, 4);
  made.name(4, "tumour", false);
  EXPECT_LT((target_in_structure(made.view(), "tumour") - Vec3(10, 0, 0)).norm(), 1.0);
  made.paint({10, -2, 0}, {4, 6, 60}, anatomy::tissue::soft, 0);  // what is left is a U around it
  const Vec3 inside = target_in_structure(made.view(), "tumour");
  EXPECT_EQ(anatomy::nearest(made.view().structures, inside, std::uint16_t{0}), 4);
  made.name(5, "stone", false);
  EXPECT_THROW(target_in_structure(made.view(), "stone"), InputError);
  try {
    target_in_structure(made.view(), "tumor");
    FAIL() << "expected a refusal";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("expected tumour, stone"));
  }
}

// The synthetic patient, whose vertebrae, vessels and organs are known.
class SyntheticPlan : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    library_ = io::default_tissue_library();
    LumbarParameters parameters;
    parameters.spacing = 1.5;
    patient_ = synthesize_lumbar(parameters, *library_, {});
  }
  static void TearDownTestSuite() {
    patient_.reset();
    library_.reset();
  }
  static PatientView view() {
    return {patient_->tissues, patient_->structures, patient_->structure_table, patient_->landmarks, *library_};
  }

  static inline std::optional<anatomy::TissueLibrary> library_;
  static inline std::optional<SyntheticPatient> patient_;
};

TEST_F(SyntheticPlan, a_lumbar_puncture_is_proposed_from_behind_between_the_vertebrae) {
  const PlanningRules rules = training::planning_rules(training::find_shipped_procedure("lumbar_puncture"));
  const std::vector<anatomy::Landmark> levels = allowed_levels(view(), rules);
  ASSERT_FALSE(levels.empty());
  for (const anatomy::Landmark& level : levels) EXPECT_NE(level.name, "L1_L2");
  const Vec3 target = patient_->path.target;
  ASSERT_EQ(level_problem(view(), rules, target), std::nullopt);
  const auto begin = std::chrono::steady_clock::now();
  const Obstacles obstacles = find_obstacles(view(), rules, target);
  const PathSearch search = search_paths(view(), obstacles, target, criteria_for({}, rules));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_LT(seconds, 20.0);
  ASSERT_FALSE(search.proposals.empty()) << search.why_not;
  for (const PathReport& each : search.proposals) {
    EXPECT_LT(each.path.direction().y(), -std::cos(40.1 * degree));
    for (const Crossed& crossed : each.crosses) {
      EXPECT_NE(crossed.tissue, anatomy::tissue::cortical_bone);
      EXPECT_NE(crossed.tissue, anatomy::tissue::spinal_cord);
    }
    EXPECT_EQ(each.crosses.front().tissue, anatomy::tissue::skin);
  }
}

TEST_F(SyntheticPlan, a_vertebra_as_target_is_refused_in_words) {
  const PlanningRules rules = training::planning_rules(training::find_shipped_procedure("ct_guided_biopsy"));
  const Vec3 target = target_in_structure(view(), "vertebrae_L3");
  const PathSearch search = search_paths(view(), find_obstacles(view(), rules, target), target, {});
  EXPECT_TRUE(search.proposals.empty());
  EXPECT_THAT(search.why_not, HasSubstr("bone"));
}

}  // namespace
}  // namespace bodkin::patient
