// Simulated hands in a deformable body move to where they lead the needle, in `bodkin cohort` as in `bodkin run`.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "session/operator_file.h"
#include "session/session_run.h"
#include "tests/station/block_of_tissue.h"
#include <gtest/gtest.h>
#include <unistd.h>

#include "training/cohort.h"
#include "training/procedure_file.h"
#include "training/simulated_attempt.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

namespace fs = std::filesystem;

class DeformableAttempt : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("bodkin_deformable_attempt_" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static const NeedlePath& path() { return *block().patient.description.procedure.path; }
  static const BlockOfTissue& block() {
    static const BlockOfTissue made = block_of_tissue();
    return made;
  }

  fs::path folder_;
};

int count_of(const session::Session& session, forces::EventKind kind) {
  return static_cast<int>(std::ranges::count_if(
      session.events, [kind](const session::SessionEvent& event) { return event.event.kind == kind; }));
}

TEST_F(DeformableAttempt, has_the_ticks_that_bodkin_run_records) {
  session::RunSettings settings;
  settings.script = session::load_operator("novice");
  settings.seed = 3;
  settings.path = path();
  settings.longest = 20.0;
  settings.output = folder_ / "run.bodkin";
  settings.whole_body = block().whole;
  session::SessionHeader header;
  header.path = path();
  header.haptics = block().patient.description.haptics;
  header.dt = 0.001;
  session::run_session(block().patient, header, settings, {});
  const session::Session recorded = session::read_session(settings.output);
  const session::Session attempt = simulate_attempt(block().patient, settings.script, path(), settings.seed,
                                                    {.longest = settings.longest, .whole_body = block().whole});
  ASSERT_EQ(attempt.ticks.size(), recorded.ticks.size());
  ASSERT_GT(attempt.ticks.size(), 1000U);
  for (std::size_t i = 0; i < attempt.ticks.size(); ++i) {
    ASSERT_EQ(attempt.ticks[i].output.requested.force, recorded.ticks[i].output.requested.force) << i;
    ASSERT_EQ(attempt.ticks[i].input.needle.matrix(), recorded.ticks[i].input.needle.matrix()) << i;
  }
  EXPECT_EQ(attempt.events.size(), recorded.events.size());
  EXPECT_GT(count_of(attempt, forces::EventKind::points_taken), 0);
}

// Novices aim off the planned line and tilt the needle during the insertion. The points of the planned line end
// before the needle stops.
TEST_F(DeformableAttempt, of_novices_stays_in_tissue_that_is_felt) {
  int left_plan = 0, left_own = 0;
  const simulation::OperatorScript script = session::load_operator("novice");
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    left_plan += count_of(simulate_attempt(block().patient, script, path(), seed, {.longest = 20.0}),
                          forces::EventKind::points_passed);
    left_own += count_of(
        simulate_attempt(block().patient, script, path(), seed, {.longest = 20.0, .whole_body = block().whole}),
        forces::EventKind::points_passed);
  }
  EXPECT_GT(left_plan, 0);
  EXPECT_EQ(left_own, 0);
}

TEST_F(DeformableAttempt, makes_a_table_of_the_same_bytes_for_any_number_of_threads_and_after_an_interruption) {
  PlanStage stage;
  stage.title = "punctures";
  stage.attempts = 1;
  CohortSettings settings;
  settings.stages.push_back({stage, find_procedure("needle_insertion"), &block().patient, path(), block().whole});
  settings.trainees = 4;
  settings.seed = 7;
  settings.novice = session::load_operator("novice");
  settings.expert = session::load_operator("expert");
  settings.fingerprint = "test";
  settings.output = folder_ / "cohort.csv";
  const auto table = [&] {
    std::ifstream stream(settings.output, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  settings.threads = 1;
  run_cohort(settings);
  const std::string whole = table();
  EXPECT_EQ(std::count(whole.begin(), whole.end(), '\n'), 5);
  settings.threads = 3;
  run_cohort(settings);
  EXPECT_EQ(table(), whole);
  // As if the call had been killed after its first trainee.
  std::istringstream lines(whole);
  std::string head, first;
  std::getline(lines, head);
  std::getline(lines, first);
  std::ofstream(folder_ / "cohort.csv.partial") << "# test\n" << first << "\n# end of trainee 0\n";
  EXPECT_EQ(run_cohort(settings).continued, 1U);
  EXPECT_EQ(table(), whole);
  // With the planned line alone the table differs.
  settings.stages[0].whole_body.reset();
  run_cohort(settings);
  EXPECT_NE(table(), whole);
}

}  // namespace
}  // namespace bodkin
