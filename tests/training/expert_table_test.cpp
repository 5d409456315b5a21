#include "training/expert_table.h"

#include <cstdlib>
#include <fstream>

#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/resources.h"
#include "training/metric.h"
#include "training/procedure_file.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

using ::testing::HasSubstr;

ExpertAttempt attempt_of(const std::string& digest, double path_length) {
  ExpertAttempt attempt;
  attempt.digest = digest;
  attempt.score.metrics.push_back(
      {.metric = find_metric("path_length_mm"), .value = path_length, .grade = {}, .experts = {}});
  return attempt;
}

class ExpertTable : public ::testing::Test {
 protected:
  void SetUp() override { setenv("XDG_DATA_HOME", folder_.path().c_str(), 1); }
  void TearDown() override { unsetenv("XDG_DATA_HOME"); }
  ScratchFolder folder_;
};

TEST_F(ExpertTable, own_experts_take_the_place_of_the_simulated_ones) {
  const std::string simulated = experts_of(find_shipped_procedure("epidural"))->origin();
  std::vector<ExpertAttempt> attempts;
  for (int i = 0; i < 6; ++i) attempts.push_back(attempt_of("digest-" + std::to_string(i), 10.0 * i));
  const std::filesystem::path file = own_expert_file("epidural");
  const ExpertsAdded added = add_experts(file, attempts);
  EXPECT_EQ(added.added, 6U);
  EXPECT_EQ(added.attempts, 6U);
  const auto own = experts_of(find_shipped_procedure("epidural"));
  EXPECT_NE(own->origin(), simulated);
  EXPECT_EQ(own->size(), 6U);
  EXPECT_NEAR(own->place("path_length_mm", 25.0)->percentile, 50.0, 1e-9);
  EXPECT_EQ(experts_of(find_shipped_procedure("lumbar_puncture"))->size(), 60U);
}

TEST_F(ExpertTable, an_attempt_that_is_added_again_replaces_its_row) {
  const std::filesystem::path file = own_expert_file("epidural");
  add_experts(file, std::vector{attempt_of("one", 1.0), attempt_of("two", 2.0)});
  const ExpertsAdded again = add_experts(file, std::vector{attempt_of("two", 7.0), attempt_of("three", 3.0)});
  EXPECT_EQ(again.added, 1U);
  EXPECT_EQ(again.known, 1U);
  EXPECT_EQ(again.attempts, 3U);
  EXPECT_EQ(ExpertSet::read(file).size(), 3U);
}

TEST_F(ExpertTable, attempts_measured_with_other_thresholds_are_neither_mixed_nor_compared_with) {
  const std::filesystem::path file = own_expert_file("epidural");
  std::vector<ExpertAttempt> attempts;
  for (int i = 0; i < 6; ++i) attempts.push_back(attempt_of("digest-" + std::to_string(i), 10.0 * i));
  for (ExpertAttempt& each : attempts) each.score.thresholds.stop_speed = 3.0;
  add_experts(file, attempts);
  EXPECT_THAT(io::read_text_file(file, 100'000), HasSubstr("# Measured with thresholds: stop_mm_per_s 3\n"));
  training::Procedure procedure = find_shipped_procedure("epidural");
  EXPECT_FALSE(experts_of(procedure).has_value());
  procedure.thresholds.stop_speed = 3.0;
  EXPECT_EQ(experts_of(procedure)->size(), 6U);
  try {
    add_experts(file, std::vector{attempt_of("usual", 2.0)});
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("measured with the thresholds stop_mm_per_s 3, the new ones with the usual"));
  }
  EXPECT_EQ(ExpertSet::read(file).size(), 6U);
}

TEST_F(ExpertTable, a_table_of_another_version_is_refused_and_left_as_it_is) {
  const std::filesystem::path file = own_expert_file("epidural");
  std::filesystem::create_directories(file.parent_path());
  const std::string other = "digest,verdict,path_length_mm\none,pass,3\n";
  std::ofstream(file) << other;
  try {
    add_experts(file, std::vector{attempt_of("two", 2.0)});
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("its columns are not those of this version"));
    EXPECT_THAT(error.what(), HasSubstr("bodkin experts delete epidural"));
  }
  EXPECT_EQ(io::read_text_file(file, 1000), other);
}

}  // namespace
}  // namespace bodkin
