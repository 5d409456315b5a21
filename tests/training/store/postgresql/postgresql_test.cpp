#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "tests/training/store/postgresql/postgresql_server.h"
#include "tests/training/store/stored_attempts.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

// The store on a real server, started for these tests.
class StoreServer : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { server_ = std::make_unique<PostgresqlServer>(); }
  static void TearDownTestSuite() { server_.reset(); }
  void SetUp() override {
    try {
      connect_postgresql(server_->url(), 2000ms)->change("DROP SCHEMA IF EXISTS bodkin CASCADE");
    } catch (const StoreUnreachable&) {
      if (server_->missing().empty()) throw;
    }
    if (!server_->missing().empty()) GTEST_SKIP() << server_->missing();
  }

  static inline std::unique_ptr<PostgresqlServer> server_;
};

TEST_F(StoreServer, keeps_and_gives_back_the_same_as_a_file) {
  AttemptRecord given = attempt_record("trainee-07", 1);
  given.plan = "first_week";
  given.stage = 2;
  given.owns_file = true;
  {
    ResultStore store(server_->url());
    EXPECT_TRUE(store.add(given));
    EXPECT_FALSE(store.add(given));
    store.put_plan({"p", "P", "<plan/>"});
    store.put_plan({"p", "Q", "<plan/>"});
  }
  ResultStore store(server_->url());
  const auto found = store.attempt(given.digest);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->duration, 61.25);
  EXPECT_EQ(found->verdict, Grade::pass);
  EXPECT_TRUE(found->reached);
  EXPECT_EQ(found->score, 87.5);
  EXPECT_EQ(found->metrics, given.metrics);
  EXPECT_EQ(found->headline, given.headline);
  EXPECT_EQ(found->stage, 2);
  EXPECT_TRUE(found->owns_file);
  EXPECT_EQ(store.plans().at(0).title, "Q");
  EXPECT_EQ(store.summaries_of_plan("first_week").at(0).stage, 2);
  EXPECT_EQ(cohort_table(store.summaries()).at(0).passed, 1);
  EXPECT_EQ(store.place().find("secret"), std::string::npos);
  EXPECT_EQ(ResultStore(server_->url() + "?password=secret").place().find("secret"), std::string::npos);
}

TEST_F(StoreServer, keeps_no_session_twice_however_many_stations_make_and_fill_it) {
  std::vector<std::jthread> stations;
  for (int station = 0; station < 4; ++station) {
    stations.emplace_back([&] {
      ResultStore store(server_->url(), 20000ms);
      for (int number = 0; number < 10; ++number) store.add(attempt_record("a", number));
    });
  }
  stations.clear();
  EXPECT_EQ(ResultStore(server_->url()).summaries().size(), 10U);
}

TEST_F(StoreServer, that_goes_away_is_delivered_to_when_it_is_back) {
  const ScratchFolder folder;
  Outbox outbox(server_->url(), folder.path() / "outbox", 1000ms);
  EXPECT_EQ(outbox.add(attempt_record("a", 1)).state, Delivery::State::stored);
  ResultStore open(server_->url(), 1000ms);
  server_->stop();
  EXPECT_THROW(open.add(attempt_record("a", 9)), StoreUnreachable);
  const Delivery delivery = outbox.add(attempt_record("a", 2));
  EXPECT_EQ(delivery.state, Delivery::State::waiting);
  EXPECT_THAT(delivery.reason, HasSubstr("cannot be reached"));
  EXPECT_THAT(delivery.reason, Not(HasSubstr("secret")));
  EXPECT_THROW(outbox.deliver(), StoreUnreachable);
  EXPECT_EQ(outbox.add(attempt_record("a", 3)).state, Delivery::State::waiting);
  EXPECT_EQ(outbox.waiting(), 2);
  for (const auto& each : fs::recursive_directory_iterator(folder.path())) {
    if (!each.is_regular_file()) continue;
    std::ifstream in(each.path(), std::ios::binary);
    const std::string kept((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    EXPECT_EQ(kept.find("secret"), std::string::npos) << each.path() << ": no password is stored";
  }
  server_->start();
  EXPECT_EQ(outbox.deliver(), 2);
  EXPECT_EQ(outbox.add(attempt_record("a", 3)).state, Delivery::State::known);
  EXPECT_EQ(outbox.waiting(), 0);
  EXPECT_EQ(ResultStore(server_->url()).summaries().size(), 3U);
}

TEST_F(StoreServer, forgets_a_trainee) {
  ResultStore store(server_->url());
  store.add({attempt_record("a", 1), attempt_record("a", 2), attempt_record("b", 1)});
  EXPECT_EQ(store.remove_trainee("a").attempts, 2);
  EXPECT_THAT(store.trainees(), ::testing::ElementsAre("b"));
  EXPECT_THROW(store.remove_trainee("a"), InputError);
}

TEST_F(StoreServer, of_another_version_is_led_on_or_left_alone) {
  {
    const auto connection = connect_postgresql(server_->url(), 1000ms);
    migrate(*connection, 1);
    EXPECT_EQ(store_version(*connection), 1);
  }
  ResultStore(server_->url()).add(attempt_record("a", 1));
  const auto connection = connect_postgresql(server_->url(), 1000ms);
  EXPECT_EQ(store_version(*connection), newest_store_version());
  connection->change("UPDATE store_version SET version = 99");
  try {
    ResultStore store(server_->url());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("made by a newer Bodkin"));
  }
}

TEST_F(StoreServer, that_another_station_holds_says_so) {
  ResultStore store(server_->url(), 1000ms);
  const auto other = connect_postgresql(server_->url(), 1000ms);
  other->begin();
  try {
    store.add(attempt_record("a", 1));
    FAIL();
  } catch (const SystemError& error) {
    EXPECT_THAT(error.what(), HasSubstr("is locked by another station; nothing was changed"));
  }
  other->roll_back();
  EXPECT_TRUE(store.add(attempt_record("a", 1)));
}

}  // namespace
}  // namespace bodkin
