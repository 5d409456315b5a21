#include "training/cohort.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "session/operator_file.h"
#include "tests/training/lumbar_patient.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/error.h"
#include "training/procedure_file.h"
#include "training/trainee.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class CohortTable : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / fmt_name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  CohortSettings settings(int threads = 1) const {
    CohortSettings made;
    const anatomy::Case& patient = lumbar_patient();
    PlanStage stage;
    stage.title = "punctures";
    stage.attempts = 2;
    made.stages.push_back({stage, find_procedure("lumbar_puncture"), &patient, *patient.description.procedure.path});
    made.trainees = 4;
    made.seed = 7;
    made.novice = session::load_operator("novice");
    made.expert = session::load_operator("expert");
    made.fingerprint = "test";
    made.output = folder_ / "cohort.csv";
    made.threads = threads;
    return made;
  }
  std::string table() const {
    std::ifstream stream(folder_ / "cohort.csv", std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  fs::path partial() const { return folder_ / "cohort.csv.partial"; }
  static std::string fmt_name() { return "bodkin_cohort_" + std::to_string(getpid()); }

  fs::path folder_;
};

TEST_F(CohortTable, has_the_same_bytes_for_any_number_of_threads_and_after_an_interruption) {
  const CohortResult result = run_cohort(settings());
  const std::string whole = table();
  EXPECT_EQ(result.attempts, 8U);
  EXPECT_FALSE(fs::exists(partial()));
  EXPECT_EQ(std::count(whole.begin(), whole.end(), '\n'), 9);
  run_cohort(settings(3));
  EXPECT_EQ(table(), whole);

  // As if the call had been killed while writing its third trainee: two are complete, one row is cut off.
  std::istringstream lines(whole);
  std::string line, done = "# test\n";
  std::getline(lines, line);
  for (int trainee = 0; trainee < 2; ++trainee) {
    for (int row = 0; row < 2 && std::getline(lines, line); ++row) done += line + "\n";
    done += "# end of trainee " + std::to_string(trainee) + "\n";
  }
  std::getline(lines, line);
  std::ofstream(partial()) << done << line.substr(0, 20);
  const CohortResult continued = run_cohort(settings());
  EXPECT_EQ(continued.continued, 2U);
  EXPECT_EQ(table(), whole);
}

TEST_F(CohortTable, of_several_parts_has_the_same_bytes_in_any_order_and_after_an_interruption) {
  run_cohort(settings());
  const std::string whole = table();
  fs::remove(folder_ / "cohort.csv");
  CohortSettings part = settings();
  part.part = {2, 3};
  EXPECT_FALSE(run_cohort(part).is_whole);
  part.part = {0, 3};
  EXPECT_FALSE(run_cohort(part).is_whole);
  EXPECT_FALSE(fs::exists(folder_ / "cohort.csv"));
  // One process does the work of the third part, and all parts are merged.
  const CohortResult result = run_cohort(settings());
  EXPECT_TRUE(result.is_whole);
  EXPECT_EQ(result.continued, 3U);  // trainees 2, 0 and 3
  EXPECT_EQ(result.attempts, 8U);
  EXPECT_TRUE(table() == whole);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1) << "partial files are left";
}

TEST_F(CohortTable, of_another_plan_is_not_continued) {
  std::ofstream(partial()) << "# another\n";
  try {
    run_cohort(settings());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("was begun with another plan, seed, patient or version; remove it"));
  }
}

TEST_F(CohortTable, of_an_operator_ends_a_stage_after_enough_passes) {
  CohortSettings made = settings();
  made.performer = made.expert;
  made.trainees = 2;
  made.stages[0].plan.attempts = 5;
  made.stages[0].plan.passes = 2;
  const CohortResult result = run_cohort(made);
  EXPECT_EQ(result.attempts, 4U);
  EXPECT_EQ(result.verdicts.at("pass"), 4);
}

TEST(Trainee, learns_towards_the_expert_and_never_past_it) {
  for (std::uint64_t number = 0; number < 200; ++number) {
    const Trainee trainee = draw_trainee(3, number);
    double before = -1.0;
    for (int attempt = 0; attempt < 60; ++attempt) {
      EXPECT_GT(trainee.skill_after(attempt), before);
      EXPECT_LT(trainee.skill_after(attempt), 1.0);
      before = trainee.skill_after(attempt);
    }
  }
  EXPECT_NE(draw_trainee(3, 0).skill, draw_trainee(4, 0).skill);
}

TEST(Trainee, of_full_skill_is_the_expert_to_the_bit) {
  const simulation::OperatorScript novice = session::load_operator("novice"),
                                   expert = session::load_operator("expert");
  simulation::OperatorScript best = operator_of_skill(novice, expert, 1.0);
  best.name = expert.name;
  EXPECT_EQ(session::operator_json(best), session::operator_json(expert));
  const simulation::OperatorScript half = operator_of_skill(novice, expert, 0.5);
  EXPECT_NEAR(half.hand.tremor, 0.5 * (novice.hand.tremor + expert.hand.tremor), 1e-12);
  EXPECT_NEAR(half.reaction, 0.5 * (novice.reaction + expert.reaction), 1e-12);
  simulation::check(half, "half");
}

TEST(PlanFile, is_read_and_refused_with_the_line) {
  const Plan plan = parse_plan(
      "<plan version=\"1\" name=\"p\" title=\"P\"><stage title=\"a\" case=\"x\" attempts=\"3\" passes=\"2\"/></plan>",
      "plan.xml");
  EXPECT_EQ(plan.stages.at(0).patient, "x");
  EXPECT_EQ(plan.stages.at(0).attempts, 3);
  const auto refusal = [](const char* text) -> std::string {
    try {
      parse_plan(text, "plan.xml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(
      refusal("<plan version=\"1\" name=\"p\" title=\"P\">\n<stage title=\"a\" case=\"x\" attempts=\"0\"/></plan>"),
      HasSubstr("plan.xml, line 2: stage attempts is '0', expected"));
  EXPECT_THAT(refusal("<plan version=\"1\" name=\"p\" title=\"P\"/>"), HasSubstr("stage"));
}

}  // namespace
}  // namespace bodkin
