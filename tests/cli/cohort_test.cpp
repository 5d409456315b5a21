#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;
using CohortCommand = PatientCommand;

const char* const plan =
    "<plan version=\"1\" name=\"p\" title=\"P\"><stage title=\"a\" case=\"patient\" attempts=\"2\"/></plan>";

TEST_F(CohortCommand, of_experts_makes_a_table_that_score_compares_with) {
  write("plan.xml", plan);
  const Outcome made = bodkin("-q --json cohort plan.xml --trainees 3 --operator expert -o experts.csv");
  ASSERT_EQ(made.exit_code, 0) << made.text();
  const auto json = nlohmann::json::parse(made.output);
  EXPECT_EQ(json.at("attempts"), 6);
  EXPECT_EQ(lines_of(text_of("experts.csv")), 7);
  ASSERT_EQ(bodkin("-q run patient -o s.bodkin").exit_code, 0);
  const Outcome said = bodkin("-q --json score s.bodkin --experts experts.csv");
  ASSERT_EQ(said.exit_code, 0) << said.text();
  EXPECT_EQ(nlohmann::json::parse(said.output).at("experts"), 6);
}

TEST_F(CohortCommand, under_mpirun_makes_the_same_table_as_one_process) {
  write("plan.xml", plan);
  ASSERT_EQ(bodkin("-q cohort plan.xml --trainees 5 -o one.csv").exit_code, 0);
  const std::string line = "cd '" + folder_.string() +
                           "' && mpirun --allow-run-as-root --oversubscribe -n 3 '" BODKIN_BUILD
                           "/bin/bodkin' -q cohort plan.xml --trainees 5 -o three.csv > mpi.log 2>&1";
  ASSERT_EQ(std::system(line.c_str()), 0) << text_of("mpi.log");
  EXPECT_TRUE(text_of("three.csv") == text_of("one.csv")) << text_of("mpi.log");
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    EXPECT_EQ(entry.path().filename().string().find("three.csv.partial"), std::string::npos) << entry.path();
}

// As in a power cut: no code of the program runs after it.
TEST_F(CohortCommand, killed_in_between_goes_on_where_it_was_to_the_same_table) {
  write("plan.xml", plan);
  ASSERT_EQ(bodkin("-q cohort plan.xml --trainees 60 --seed 5 -o whole.csv").exit_code, 0);
  write("kill.sh", "cd '" + folder_.string() +
                       "'\n'" BODKIN_BUILD
                       "/bin/bodkin' -q cohort plan.xml --trainees 60 --seed 5 -o killed.csv > killed.log 2>&1 &\n"
                       "for i in $(seq 2000); do grep -q 'end of trainee' killed.csv.partial 2> /dev/null && break; "
                       "sleep 0.01; done\n"
                       "kill -9 $!\nwait $!\n");
  EXPECT_NE(std::system(("bash '" + (folder_ / "kill.sh").string() + "'").c_str()), 0);
  ASSERT_TRUE(std::filesystem::exists(folder_ / "killed.csv.partial")) << "it had ended before it was killed";
  const Outcome rest = bodkin("-q --json cohort plan.xml --trainees 60 --seed 5 -o killed.csv");
  ASSERT_EQ(rest.exit_code, 0) << rest.text();
  EXPECT_GT(nlohmann::json::parse(rest.output).at("continued"), 0);
  EXPECT_TRUE(text_of("killed.csv") == text_of("whole.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "killed.csv.partial"));
}

TEST_F(CohortCommand, refuses_a_part_that_is_none) {
  write("plan.xml", plan);
  for (const char* part : {"3/2", "0/2", "1", "a/b", "1/2/3"}) {
    const Outcome said = bodkin(std::string("-q cohort plan.xml --trainees 2 -o p.csv --part ") + part);
    EXPECT_EQ(said.exit_code, 2) << part;
    EXPECT_THAT(said.errors, HasSubstr("such as 2/4")) << part;
  }
}

TEST_F(CohortCommand, refuses_a_plan_of_a_case_that_there_is_not) {
  write("lost.xml", "<plan version=\"1\" name=\"p\" title=\"P\"><stage title=\"a\" case=\"nowhere\"/></plan>");
  const Outcome said = bodkin("-q cohort lost.xml");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.errors, HasSubstr("nowhere"));
  EXPECT_EQ(bodkin("-q cohort no_plan.xml").exit_code, 2);
}

}  // namespace
}  // namespace bodkin_test
