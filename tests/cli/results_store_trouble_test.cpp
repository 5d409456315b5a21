#include <csignal>
#include <cstdlib>

#include "tests/cli/results_rig.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "training/store/result_store.h"

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using std::chrono_literals::operator""ms;

// Every command that opens the store, when the store cannot be used: one sentence, the matching exit code, and no
// change in the store. The session to be stored waits.
class StoreTrouble : public ResultsRig {
 protected:
  void SetUp() override {
    ResultsRig::SetUp();
    fs::remove(store());
  }

  static fs::path store() { return folder_ / "store.sqlite"; }
  static std::string at_store() { return " --store " + store().string(); }

  static bodkin::training::AttemptRecord attempt(int number) {
    bodkin::training::AttemptRecord record;
    record.digest = "attempt/" + std::to_string(number);
    record.trainee = "trainee-01";
    record.procedure = "lumbar_puncture";
    record.started_at = "2026-11-23T10:00:00Z";
    record.headline = std::string(200, 'x');
    return record;
  }

  static void expect_one_sentence(const std::string& arguments, int exit_code, const std::string& words) {
    const Outcome said = bodkin(arguments);
    EXPECT_EQ(said.exit_code, exit_code) << arguments;
    EXPECT_THAT(said.errors, StartsWith("bodkin: ")) << arguments;
    EXPECT_THAT(said.errors, HasSubstr(words)) << arguments;
    EXPECT_EQ(lines_of(said.errors), 1) << arguments << ": " << said.errors;
  }

  // `results add` keeps the attempt here, with the reason.
  static void expect_that_it_waits(const std::string& place, const std::string& words) {
    const Outcome waits = bodkin("results add session.bodkin --trainee trainee-07" + place);
    EXPECT_EQ(waits.exit_code, 0) << waits.text();
    EXPECT_THAT(waits.output, HasSubstr("waits for the store"));
    EXPECT_THAT(waits.errors, HasSubstr(words));
  }
};

const std::vector<std::string> readers = {"-q results list", "-q results show trainee-01",
                                          "-q results csv -o table.csv", "-q results delete trainee-01",
                                          "-q plan show lumbar_puncture_first_steps --trainee trainee-01"};

TEST_F(StoreTrouble, a_newer_store_is_left_as_it_is) {
  bodkin::training::ResultStore(store().string()).add(attempt(1));
  bodkin::training::connect_sqlite(store().string(), 1000ms)
      ->change("UPDATE store_version SET version = version + 1");
  const std::string before = text_of("store.sqlite");
  for (const std::string& command : readers) expect_one_sentence(command + at_store(), 2, "newer");
  expect_that_it_waits(at_store(), "newer");
  expect_one_sentence("-q results deliver" + at_store(), 2, "newer");
  EXPECT_EQ(text_of("store.sqlite"), before);
  EXPECT_FALSE(fs::exists(folder_ / "table.csv"));
  bodkin::training::connect_sqlite(store().string(), 1000ms)
      ->change("UPDATE store_version SET version = version - 1");
  EXPECT_THAT(bodkin("-q results deliver" + at_store()).output, HasSubstr("attempts delivered: 1"));
  EXPECT_EQ(bodkin::training::ResultStore(store().string()).summaries().size(), 2U);
}

TEST_F(StoreTrouble, a_server_that_cannot_be_reached_loses_nothing) {
  const std::string nowhere = " --store postgresql://station:secret@127.0.0.1:1/none";
  for (const std::string& command : readers) expect_one_sentence(command + nowhere, 1, "cannot be reached");
  expect_that_it_waits(nowhere, "cannot be reached");
  expect_one_sentence("-q results deliver" + nowhere, 1, "cannot be reached");
  EXPECT_THAT(bodkin("results list").errors, HasSubstr("attempts of this station that wait for another store"));
  EXPECT_THAT(bodkin("results deliver" + nowhere).errors, ::testing::Not(HasSubstr("secret")));
}

// Also with a plan whose stage is only in the store.
TEST_F(StoreTrouble, an_attempt_at_a_plan_waits_and_gets_its_stage_when_it_is_delivered) {
  const std::string nowhere = "postgresql://station@127.0.0.1:1/none";
  expect_that_it_waits(" --plan lumbar_puncture_first_steps --store " + nowhere, "cannot be reached");
  EXPECT_THAT(bodkin("-q results deliver --from " + nowhere + at_store()).output, HasSubstr("attempts delivered: 1"));
  EXPECT_THAT(bodkin("-q plan show lumbar_puncture_first_steps --trainee trainee-07" + at_store()).output,
              HasSubstr("trainee-07: stage 1 of 3, 1 of 2 passed in a row, attempt 2 of 10"));
}

// As with a hung program: each command waits for five seconds.
TEST_F(StoreTrouble, a_locked_store_says_so_and_the_attempt_waits) {
  bodkin::training::ResultStore(store().string()).add(attempt(1));
  const auto other = bodkin::training::connect_sqlite(store().string(), 1000ms);
  other->change("BEGIN EXCLUSIVE");
  expect_one_sentence("-q results list" + at_store(), 1, "is locked by another program; nothing was changed");
  expect_that_it_waits(at_store(), "is locked by another program");
  other->roll_back();
  EXPECT_THAT(bodkin("-q results deliver" + at_store()).output, HasSubstr("attempts delivered: 1"));
  EXPECT_EQ(bodkin::training::ResultStore(store().string()).summaries().size(), 2U);
}

// The limit on the size of files simulates a full disk: the store exceeds it, and the queue is far below.
TEST_F(StoreTrouble, on_a_full_disk_the_store_keeps_what_it_had_and_the_attempt_waits) {
  std::vector<bodkin::training::AttemptRecord> many;
  for (int number = 0; number < 1000; ++number) many.push_back(attempt(number));
  bodkin::training::ResultStore(store().string()).add(many);
  const rlim_t size = fs::file_size(store());
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = size / 2;
  setrlimit(RLIMIT_FSIZE, &small);
  expect_that_it_waits(at_store(), "cannot be written; nothing was changed: free space on its disk");
  expect_one_sentence("-q results deliver" + at_store(), 1, "cannot be written; nothing was changed");
  expect_one_sentence("-q results delete trainee-01" + at_store(), 1, "cannot be written; nothing was changed");
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(bodkin::training::ResultStore(store().string()).summaries("trainee-01").size(), many.size());
  EXPECT_THAT(bodkin("-q results deliver" + at_store()).output, HasSubstr("attempts delivered: 1"));
}

}  // namespace
}  // namespace bodkin_test
