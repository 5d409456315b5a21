#include "training/store/result_store.h"

#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "tests/training/store/stored_attempts.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "core/error.h"
#include "training/store/cohort_table.h"
#include "training/store/migrations.h"
#include "training/store/outbox.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using std::chrono_literals::operator""ms;

class StoreFile : public ::testing::Test {
 protected:
  std::string place() const { return (folder_.path() / "results.sqlite").string(); }
  fs::path outbox_folder() const { return folder_.path() / "outbox"; }
  std::string bytes() const {
    std::ifstream stream(place(), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  template <typename Work>
  static std::string refusal(Work&& work) {
    try {
      work();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "accepted";
  }

  ScratchFolder folder_;
};

TEST_F(StoreFile, gives_back_what_it_was_given) {
  AttemptRecord given = attempt_record("trainee-07", 1);
  given.plan = "first_week";
  given.stage = 2;
  given.file = "/sessions/one two.bodkin";
  EXPECT_TRUE(ResultStore(place()).add(given));
  const auto found = ResultStore(place()).attempt(given.digest);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->trainee, "trainee-07");
  EXPECT_EQ(found->procedure, given.procedure);
  EXPECT_EQ(found->started_at, given.started_at);
  EXPECT_EQ(found->duration, 61.25);
  EXPECT_EQ(found->verdict, Grade::pass);
  EXPECT_TRUE(found->reached);
  EXPECT_EQ(found->score, 87.5);
  EXPECT_EQ(found->headline, given.headline);
  EXPECT_EQ(found->metrics, given.metrics);
  ASSERT_EQ(found->findings.size(), 1U);
  EXPECT_EQ(found->findings[0].sentence, "You needed 3 passes.");
  EXPECT_EQ(found->plan, "first_week");
  EXPECT_EQ(found->stage, 2);
  EXPECT_EQ(found->file, given.file);
  EXPECT_FALSE(ResultStore(place()).attempt("another"));
}

TEST_F(StoreFile, keeps_no_session_twice_however_many_add_it) {
  { ResultStore made(place()); }
  std::vector<std::jthread> stations;
  for (int station = 0; station < 4; ++station) {
    stations.emplace_back([&] {
      ResultStore store(place(), 20000ms);
      for (int number = 0; number < 10; ++number) store.add(attempt_record("a", number));
    });
  }
  stations.clear();
  EXPECT_EQ(ResultStore(place()).summaries().size(), 10U);
  EXPECT_FALSE(ResultStore(place()).add(attempt_record("a", 3)));
}

TEST_F(StoreFile, sorts_by_trainee_procedure_and_time) {
  ResultStore store(place());
  store.add({attempt_record("b", 1), attempt_record("a", 2), attempt_record("a", 1, Grade::fail),
             attempt_record("a", 5, Grade::pass, "epidural")});
  const auto all = store.summaries();
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].procedure, "epidural");
  EXPECT_EQ(all[1].verdict, Grade::fail);
  EXPECT_EQ(all[3].trainee, "b");
  EXPECT_EQ(store.summaries("a", "lumbar_puncture").size(), 2U);
  EXPECT_EQ(store.summaries("", "epidural").size(), 1U);
  EXPECT_THAT(store.trainees(), ::testing::ElementsAre("a", "b"));
}

TEST_F(StoreFile, forgets_a_trainee_without_a_trace) {
  const fs::path owned = folder_.path() / "owned.bodkin", other = folder_.path() / "other.bodkin";
  std::ofstream(owned) << "x";
  std::ofstream(other) << "x";
  ResultStore store(place());
  std::vector<AttemptRecord> many;
  for (int number = 0; number < 200; ++number) many.push_back(attempt_record("Forgettable", number));
  store.add(many);
  AttemptRecord first = attempt_record("Forgettable", 500), second = attempt_record("Forgettable", 501),
                far = attempt_record("Forgettable", 502);
  first.file = owned.string();
  first.owns_file = true;
  second.file = other.string();
  far.file = "/there.bodkin";
  far.station = "room-3";
  far.owns_file = true;
  store.add({first, second, far, attempt_record("Kept", 1)});
  EXPECT_THAT(bytes(), HasSubstr("Forgettable"));
  const Deletion done = store.remove_trainee("Forgettable");
  EXPECT_EQ(done.attempts, 203);
  EXPECT_FALSE(fs::exists(owned));
  EXPECT_TRUE(fs::exists(other));
  EXPECT_THAT(done.other_files, ::testing::ElementsAre("/there.bodkin on room-3"));
  EXPECT_THAT(bytes(), Not(HasSubstr("Forgettable")));
  EXPECT_EQ(store.summaries().size(), 1U);
  EXPECT_THAT(refusal([&] { store.remove_trainee("Forgettable"); }), HasSubstr("has no trainee 'Forgettable'"));
}

TEST_F(StoreFile, of_the_first_version_is_led_to_the_newest) {
  {
    const auto connection = connect_sqlite(place(), 100ms);
    migrate(*connection, 1);
    connection->change("INSERT INTO trainees VALUES('old', '2026-01-01T00:00:00Z')");
    connection->change(
        "INSERT INTO attempts VALUES('d', 'old', 'epidural', 'slim', 's', '2026-01-01T00:00:00Z', 5, 'fail', 0, "
        "12.5, "
        "'Failed', '{\"a\": 1}', '[]', '', 0)");
  }
  ResultStore store(place());
  const auto found = store.attempt("d");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->score, 12.5);
  EXPECT_EQ(found->plan, "");
  store.put_plan({"p", "P", "<plan/>"});
  store.put_plan({"p", "Q", "<plan/>"});
  ASSERT_EQ(store.plans().size(), 1U);
  EXPECT_EQ(store.plans()[0].title, "Q");
}

TEST_F(StoreFile, newer_than_the_program_is_left_as_it_is) {
  ResultStore(place()).add(attempt_record("a", 1));
  connect_sqlite(place(), 100ms)->change("UPDATE store_version SET version = 99");
  const std::string before = bytes();
  EXPECT_THAT(refusal([&] { ResultStore store(place()); }), HasSubstr("has version 99, made by a newer Bodkin"));
  EXPECT_EQ(bytes(), before);
}

TEST_F(StoreFile, that_is_something_else_is_refused) {
  std::ofstream(place()) << std::string(5000, 'x');
  EXPECT_THAT(refusal([&] { ResultStore store(place()); }), HasSubstr("is not a store of results"));
  const std::string other = (folder_.path() / "other.sqlite").string();
  connect_sqlite(other, 100ms)->change("CREATE TABLE songs(title TEXT)");
  EXPECT_THAT(refusal([&] { ResultStore store(other); }), HasSubstr("is a database, but not of results"));
  EXPECT_THAT(refusal([&] { ResultStore store("/nowhere/at/all.sqlite"); }), HasSubstr("cannot be opened"));
}

TEST_F(StoreFile, that_is_locked_says_so_and_the_attempt_waits) {
  ResultStore(place()).add(attempt_record("a", 1));
  {
    const auto other = connect_sqlite(place(), 100ms);
    other->begin();
    EXPECT_THAT(refusal([&] { ResultStore(place(), 50ms).add(attempt_record("a", 2)); }),
                HasSubstr("is locked by another program; nothing was changed"));
    Outbox outbox(place(), outbox_folder(), 50ms);
    const Delivery delivery = outbox.add(attempt_record("a", 2));
    EXPECT_EQ(delivery.state, Delivery::State::waiting);
    EXPECT_THAT(delivery.reason, HasSubstr("is locked by another program"));
    EXPECT_EQ(outbox.waiting(), 1);
    other->roll_back();
  }
  const Delivery later = Outbox(place(), outbox_folder()).add(attempt_record("a", 3));
  EXPECT_EQ(later.delivered, 1);
  EXPECT_EQ(ResultStore(place()).summaries().size(), 3U);
}

TEST_F(StoreFile, on_a_full_disk_says_so_and_keeps_what_it_had) {
  ResultStore store(place());
  store.add(attempt_record("a", 1));
  std::vector<AttemptRecord> many;
  for (int number = 2; number < 500; ++number) many.push_back(attempt_record("a", number));
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = fs::file_size(place()) + 8192;
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string said = refusal([&] { store.add(many); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(said, HasSubstr("cannot be written; nothing was changed: free space on its disk"));
  EXPECT_EQ(store.summaries().size(), 1U);
  EXPECT_EQ(store.add(many), 498);
}

// Leaves attempts waiting for a store that another program has locked.
void keep_waiting(const std::string& place, const fs::path& folder, std::initializer_list<int> numbers) {
  const auto other = connect_sqlite(place, 100ms);
  other->begin();
  for (const int number : numbers)
    EXPECT_EQ(Outbox(place, folder, 50ms).add(attempt_record("a", number)).state, Delivery::State::waiting);
  other->roll_back();
}

TEST_F(StoreFile, is_delivered_to_once_where_a_call_was_killed_before_it_forgot) {
  { ResultStore made(place()); }
  keep_waiting(place(), outbox_folder(), {1, 2});
  ResultStore(place()).add(attempt_record("a", 1));  // the killed call had already stored this
  Outbox outbox(place(), outbox_folder());
  EXPECT_EQ(outbox.deliver(), 2);
  EXPECT_EQ(outbox.deliver(), 0);
  EXPECT_EQ(ResultStore(place()).summaries().size(), 2U);
  EXPECT_EQ(outbox.waiting(), 0);
}

// A station used with two stores, one of which is unavailable for a time.
TEST_F(StoreFile, gets_what_waits_for_it_and_another_store_gets_none_of_that) {
  const std::string second = place() + ".second";
  for (const std::string& each : {place(), second}) ResultStore made(each);
  keep_waiting(place(), outbox_folder(), {1, 2});
  keep_waiting(second, outbox_folder(), {3});
  Outbox to_first(place(), outbox_folder()), to_second(second, outbox_folder());
  EXPECT_EQ(to_first.waiting(), 2);
  EXPECT_EQ(to_second.waiting(), 1);
  // Adding to the second store delivers only attempts waiting for that store.
  EXPECT_EQ(to_second.add(attempt_record("a", 4)).delivered, 1);
  EXPECT_EQ(ResultStore(second).summaries().size(), 2U);
  EXPECT_TRUE(ResultStore(place()).summaries().empty());
  ASSERT_EQ(to_second.waiting_elsewhere().size(), 1U);
  EXPECT_EQ(to_second.waiting_elsewhere()[0].store, place());
  EXPECT_EQ(to_second.waiting_elsewhere()[0].attempts, 2);
  EXPECT_EQ(to_second.deliver(), 0);
  // The same store under another spelling of its path.
  const std::string roundabout = (folder_.path() / "outbox" / ".." / fs::path(place()).filename()).string();
  EXPECT_EQ(Outbox(roundabout, outbox_folder()).deliver(), 2);
  EXPECT_EQ(ResultStore(place()).summaries().size(), 2U);
  EXPECT_TRUE(to_second.waiting_elsewhere().empty());
}

// Only the store knows the next stage, and it did not answer.
TEST_F(StoreFile, gives_an_attempt_that_waited_the_stage_that_it_has_when_it_is_delivered) {
  const PlanInUse plan = read_plan_in_use("lumbar_puncture_first_steps");
  const int first_stage_attempts = plan.plan.stages.front().attempts;
  ResultStore(place()).put_plan({plan.plan.name, plan.plan.title, plan.document});
  std::vector<AttemptRecord> late = {attempt_record("a", 40)};
  {
    const auto other = connect_sqlite(place(), 100ms);
    other->begin();
    Outbox outbox(place(), outbox_folder(), 50ms);
    outbox.put_in_plan(plan, late);
    EXPECT_EQ(late.front().plan, plan.plan.name);
    EXPECT_EQ(outbox.add(late.front()).state, Delivery::State::waiting);
    other->roll_back();
  }
  // Meanwhile another station fills the first stage.
  std::vector<AttemptRecord> earlier;
  for (int number = 1; number <= first_stage_attempts; ++number) {
    earlier.push_back(attempt_record("a", number));
    earlier.back().verdict = Grade::fail;
  }
  {
    ResultStore store(place());
    put_in_stages(plan, store, earlier);
    store.add(earlier);
  }
  EXPECT_EQ(Outbox(place(), outbox_folder()).deliver(), 1);
  const auto kept = ResultStore(place()).attempt(late.front().digest);
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(kept->plan, plan.plan.name);
  EXPECT_EQ(kept->stage, 2);
}

TEST_F(StoreFile, that_has_moved_is_followed_when_asked) {
  const std::string moved = place() + ".moved";
  { ResultStore made(place()); }
  keep_waiting(place(), outbox_folder(), {1, 2});
  Outbox outbox(moved, outbox_folder());
  EXPECT_THAT(refusal([&] { outbox.take_over(moved); }),
              HasSubstr("nothing on this station waits for the store " + moved));
  EXPECT_EQ(outbox.take_over(place()), 2);
  EXPECT_EQ(ResultStore(moved).summaries().size(), 2U);
  EXPECT_THAT(refusal([&] { outbox.take_over(place()); }), HasSubstr("waits for the store " + place()));
}

TEST_F(StoreFile, forgets_what_waits_of_a_trainee_for_it_alone) {
  const std::string second = place() + ".second";
  for (const std::string& each : {place(), second}) ResultStore made(each);
  keep_waiting(place(), outbox_folder(), {1, 2});
  keep_waiting(second, outbox_folder(), {3});
  EXPECT_EQ(Outbox(place(), outbox_folder()).remove_trainee("a").attempts, 2);
  EXPECT_EQ(Outbox(place(), outbox_folder()).waiting(), 0);
  EXPECT_EQ(Outbox(second, outbox_folder()).waiting(), 1) << "a label of another store may be another person";
}

TEST_F(StoreFile, refuses_a_label_that_could_be_an_address) {
  ResultStore store(place());
  for (const char* label : {"", " a", "a ", "anna@example.org", "a/b", "a\nb"}) {
    AttemptRecord record = attempt_record("a", 1);
    record.trainee = label;
    EXPECT_THAT(refusal([&] { store.add(record); }), HasSubstr("expected a label of 1 to 64 letters")) << label;
  }
  EXPECT_NO_THROW(check_label("Zoë 3", "the trainee"));
  EXPECT_NO_THROW(check_label(std::string(64, 'x'), "the trainee"));
  EXPECT_THROW(check_label(std::string(65, 'x'), "the trainee"), InputError);
}

TEST(CohortTable, counts_by_trainee_and_procedure) {
  std::vector<AttemptSummary> attempts;
  const auto add = [&](const char* trainee, Grade verdict, double score) {
    attempts.push_back({trainee, "epidural", "2026", std::to_string(attempts.size()), verdict, score, 0});
  };
  add("a", Grade::dangerous, 0.0);
  add("a", Grade::pass, 80.0);
  add("a", Grade::borderline, 50.0);
  add("a", Grade::pass, 90.0);
  add("a", Grade::pass, 70.0);
  add("a", Grade::pass, 100.0);
  add("b", Grade::fail, 10.0);
  const std::vector<CohortRow> rows = cohort_table(attempts);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].attempts, 6);
  EXPECT_EQ(rows[0].passed, 4);
  EXPECT_EQ(rows[0].dangerous, 1);
  EXPECT_EQ(rows[0].borderline, 1);
  EXPECT_EQ(rows[0].last_in_a_row, 3);
  EXPECT_DOUBLE_EQ(rows[0].score, 78.0);  // of the last five
  EXPECT_FALSE(rows[0].mastery);
  EXPECT_EQ(rows[1].failed, 1);
  EXPECT_DOUBLE_EQ(rows[1].score, 10.0);
}

// With 10 % and 30 % and error probabilities of 10 % each, s is 0.186 and h0 1.627 by the formulas of cusum.h: the
// ninth success without a failure (0.186 n > 1.627 from n = 9 on) shows mastery, the eighth does not.
TEST(CohortTable, sees_mastery_where_the_theory_says) {
  std::vector<AttemptSummary> attempts;
  for (int number = 0; number < 8; ++number)
    attempts.push_back({"a", "epidural", "2026", std::to_string(number), Grade::pass, 100.0, 0});
  EXPECT_FALSE(cohort_table(attempts)[0].mastery);
  attempts.push_back(attempts.back());
  EXPECT_TRUE(cohort_table(attempts)[0].mastery);
  for (int number = 0; number < 4; ++number)
    attempts.push_back({"a", "epidural", "2026", std::to_string(number), Grade::fail, 0.0, 0});
  EXPECT_FALSE(cohort_table(attempts)[0].mastery);
}

}  // namespace
}  // namespace bodkin
