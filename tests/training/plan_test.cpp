#include "training/plan.h"

#include <vector>

#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "training/plan_progress.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

using ::testing::HasSubstr;

std::string plan_document(const std::string& attributes) {
  return "<plan version=\"1\" name=\"p\" title=\"P\">\n<stage title=\"a\" " + attributes + "/></plan>";
}

std::string plan_refusal(const std::string& attributes) {
  try {
    check_names(parse_plan(plan_document(attributes), "plan.xml"), "plan.xml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::vector<StageAttempt> attempts_of(const std::string& letters, int stage = 1, double score = 100.0) {
  std::vector<StageAttempt> attempts;
  for (const char letter : letters) {
    attempts.push_back({stage,
                        letter == 'p'   ? Grade::pass
                        : letter == 'b' ? Grade::borderline
                        : letter == 'f' ? Grade::fail
                                        : Grade::dangerous,
                        score});
  }
  return attempts;
}

TEST(PlanDocument, has_aids_and_criteria) {
  const Plan plan = parse_plan(
      plan_document(
          "case=\"built-in\" overlay=\"false\" ultrasound=\"true\" passes=\"3\" score_from=\"70\" mastery=\"true\" "
          "must_pass=\"true\""),
      "plan.xml");
  const PlanStage& stage = plan.stages.at(0);
  EXPECT_FALSE(stage.aids.overlay);
  EXPECT_TRUE(stage.aids.slices);
  EXPECT_TRUE(stage.aids.ultrasound);
  EXPECT_EQ(stage.passes, 3);
  EXPECT_EQ(stage.score_from, 70.0);
  EXPECT_TRUE(stage.mastery);
  EXPECT_TRUE(stage.must_pass);
}

TEST(PlanDocument, that_names_what_does_not_exist_is_refused) {
  EXPECT_EQ(plan_refusal("case=\"built-in\" procedure=\"epidural\""), "accepted");
  EXPECT_THAT(plan_refusal("case=\"built-in\" procedure=\"appendectomy\""),
              HasSubstr("plan.xml: stage 'a': there is no procedure 'appendectomy', expected one of acupuncture"));
  EXPECT_THAT(plan_refusal("case=\"nowhere\""), HasSubstr("the case 'nowhere' is not a folder with a case.xml"));
  EXPECT_THAT(plan_refusal("case=\"built-in\" score_from=\"101\""), HasSubstr("plan.xml, line 2: stage score_from"));
  EXPECT_THAT(plan_refusal("case=\"built-in\" overlay=\"perhaps\""), HasSubstr("overlay"));
  EXPECT_THAT(plan_refusal("case=\"built-in\" must_pass=\"true\""),
              HasSubstr("must be passed but does not say by what"));
}

TEST(PlanDocument, of_every_plan_that_comes_with_bodkin_is_whole) {
  EXPECT_FALSE(shipped_plans().empty());
  for (const std::string& name : shipped_plans()) {
    const Plan plan = read_plan(find_plan(name));
    EXPECT_EQ(plan.name, name);
    EXPECT_NO_THROW(check_names(plan, name));
  }
  EXPECT_THROW(find_plan("no_such_plan"), InputError);
}

TEST(PlanProgress, counts_passes_in_a_row) {
  const PlanStage stage{.title = "a", .attempts = 6, .passes = 3};
  EXPECT_EQ(progress_in(stage, attempts_of("ppfp")).in_a_row, 1);
  EXPECT_FALSE(progress_in(stage, attempts_of("ppfp")).is_done);
  EXPECT_TRUE(progress_in(stage, attempts_of("pppf")).is_passed);  // it remains passed, whatever comes later
  EXPECT_FALSE(progress_in(stage, attempts_of("ppbpp")).is_passed);
  const StageProgress worn_out = progress_in(stage, attempts_of("fffffd"));
  EXPECT_FALSE(worn_out.is_passed);
  EXPECT_TRUE(worn_out.is_done);
  EXPECT_EQ(progress_words(stage, progress_in(stage, attempts_of("fpp"))), "2 of 3 passed in a row, attempt 4 of 6");
}

TEST(PlanProgress, asks_for_the_score_and_for_mastery) {
  const PlanStage good{.title = "a", .attempts = 9, .passes = 2, .score_from = 80.0};
  EXPECT_FALSE(progress_in(good, attempts_of("pp", 1, 79.0)).is_passed);
  EXPECT_TRUE(progress_in(good, attempts_of("pp", 1, 80.0)).is_passed);
  const PlanStage master{.title = "a", .attempts = 5, .mastery = true, .must_pass = true};
  EXPECT_FALSE(progress_in(master, attempts_of("pppppppp")).is_done);
  EXPECT_TRUE(progress_in(master, attempts_of("ppppppppp")).is_done);  // cusum_test.cpp: the ninth success
}

TEST(PlanProgress, that_must_pass_goes_on) {
  const PlanStage stage{.title = "a", .attempts = 2, .passes = 2, .must_pass = true};
  EXPECT_FALSE(progress_in(stage, attempts_of("fpfpf")).is_done);
  EXPECT_TRUE(progress_in(stage, attempts_of("fpfpfpp")).is_done);
}

TEST(PlanProgress, leads_from_stage_to_stage) {
  Plan plan;
  plan.stages = {{.title = "a", .attempts = 2}, {.title = "b", .attempts = 5, .passes = 1}};
  EXPECT_EQ(progress_in(plan, {}).stage, 1);
  std::vector<StageAttempt> done = attempts_of("f");
  EXPECT_EQ(progress_in(plan, done).stage, 1);
  done.push_back({1, Grade::fail, 0.0});
  EXPECT_EQ(progress_in(plan, done).stage, 2);
  EXPECT_EQ(progress_in(plan, done).here.attempts, 0);
  done.push_back({2, Grade::pass, 90.0});
  EXPECT_EQ(progress_in(plan, done).stage, 3);
}

}  // namespace
}  // namespace bodkin
