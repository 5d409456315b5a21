// A session file's data of a moving body.
#include "session/body_table.h"

#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "session/body_displacement.h"
#include "session/session_file.h"
#include "tests/session/session_samples.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::session;
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr std::uint64_t kept_body_steps = 20;

fem::BodyStep body_step(std::uint64_t number) {
  fem::BodyStep step;
  step.step = number;
  step.digest = 0xFEDCBA9876543210ULL * number;
  if (number > 3) {
    step.probe = Pose::Identity();
    step.probe->linear() = Eigen::Quaterniond(0.6, 0.0, -0.8, 0.0).toRotationMatrix();
    step.probe->translation() = Vec3(1.0 / 3.0, -2.5, 0.1 * static_cast<double>(number));
  }
  if (number == 9) step.probe->translation().x() = std::numeric_limits<double>::quiet_NaN();  // a sensor's fault
  return step;
}

void write_body_session(const fs::path& file, bool finish = true) {
  SessionHeader header = sample_header();
  header.moving_body = moving_body_text({}, 8);
  SessionWriter writer(file, header, true);
  for (std::uint64_t number = 1; number <= kept_body_steps; ++number) {
    writer.append(body_step(number));
    if (number % 2 == 0) writer.append(AppliedBodyStep{number / 2 - 1, 100 * number, number});
    writer.append(sample_record(number - 1));
    if (number == 7) writer.commit();
  }
  if (finish) writer.finish();
}

TEST(BodyTable, steps_and_what_the_needle_met_come_back_bit_for_bit) {
  for (const bool finish : {true, false}) {
    const ScratchSession scratch;
    write_body_session(scratch.path(), finish);
    const Session session = read_session(scratch.path());
    ASSERT_EQ(session.body_steps.size(), kept_body_steps);
    for (std::uint64_t number = 1; number <= kept_body_steps; ++number) {
      const fem::BodyStep &read = session.body_steps[number - 1], wanted = body_step(number);
      EXPECT_EQ(read.step, number);
      EXPECT_EQ(read.digest, wanted.digest);
      ASSERT_EQ(read.probe.has_value(), wanted.probe.has_value());
      for (int i = 0; wanted.probe && i < 12; ++i) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(read.probe->matrix()(i % 3, i / 3)),
                  std::bit_cast<std::uint64_t>(wanted.probe->matrix()(i % 3, i / 3)));
      }
    }
    ASSERT_EQ(session.applied_body_steps.size(), kept_body_steps / 2);
    EXPECT_EQ(session.applied_body_steps[4].tick, 1000U);
    EXPECT_EQ(session.applied_body_steps[4].step, 10U);
  }
}

TEST(BodyTable, a_session_whose_body_did_not_move_by_itself_has_no_such_tables) {
  const ScratchSession scratch;
  {
    SessionWriter writer(scratch.path(), sample_header(), true);
    writer.append(sample_record(0));
    writer.append(body_step(1));
    writer.append(AppliedBodyStep{0, 0, 1});
    writer.finish();
  }
  EXPECT_FALSE(SQLite::Database(scratch.path().string()).tableExists("body_steps"));
  const Session session = read_session(scratch.path());
  EXPECT_TRUE(session.body_steps.empty());
  EXPECT_TRUE(session.applied_body_steps.empty());
}

TEST(BodyTable, rows_that_no_writer_makes_are_refused) {
  const ScratchSession scratch;
  const auto tamper = [&](const std::string& sql) {
    write_body_session(scratch.path());
    SQLite::Database(scratch.path().string(), SQLite::OPEN_READWRITE).exec(sql);
    return refusal_of(scratch.path());
  };
  EXPECT_EQ(tamper("SELECT 1"), "it was accepted");
  for (const std::string change : {"probe=NULL", "probe=zeroblob(96)", "probe=zeroblob(95)", "probe='here'",
                                   "digest=digest+1", "checksum=0", "step=900"}) {
    EXPECT_THAT(tamper("UPDATE body_steps SET " + change + " WHERE step=7"),
                HasSubstr("of the moving body is damaged"))
        << change;
  }
  for (const std::string change : {"tick=tick+1", "step=step+1", "checksum=0", "number=number+100"}) {
    EXPECT_THAT(tamper("UPDATE body_taken SET " + change + " WHERE number=7"),
                HasSubstr("what the needle met of the moving body is damaged"))
        << change;
  }
  // A session with parts lost by a slow disk can still be reported, but not replayed.
  EXPECT_EQ(tamper("DELETE FROM body_steps WHERE step=7"), "it was accepted");
  EXPECT_THROW(check_moved_body(read_session(scratch.path())), InputError);
  EXPECT_EQ(tamper("DELETE FROM body_taken WHERE number=7"), "it was accepted");
  EXPECT_THROW(check_moved_body(read_session(scratch.path())), InputError);
  EXPECT_EQ(tamper("DROP TABLE body_steps"), "it was accepted");
  EXPECT_THROW(check_moved_body(read_session(scratch.path())), InputError);
  write_body_session(scratch.path());
  EXPECT_NO_THROW(check_moved_body(read_session(scratch.path())));
}

TEST(BodyTable, the_header_says_what_the_body_was_made_of) {
  fem::BodySolverSettings settings;
  settings.probe = {35.5, 20.0, 60.0, 12.0};
  settings.motion.dt = 0.02;
  const fem::BodySolverSettings read = moving_body_settings(moving_body_text(settings, 5));
  const std::vector<anatomy::NeedlePath> left = {{Vec3::Zero(), Vec3::UnitX()}};
  EXPECT_TRUE(moving_body_settings(moving_body_text(settings, 5), left).left_needles.empty())
      << "a session of before, whose moving body knew of no needle";
  fem::BodySolverSettings with = settings;
  with.left_needles = left;
  EXPECT_EQ(moving_body_settings(moving_body_text(with, 5), left).left_needles.size(), 1U);
  EXPECT_EQ(read.probe.width, 35.5);
  EXPECT_EQ(read.probe.thickness, 20.0);
  EXPECT_EQ(read.probe.radius, 60.0);
  EXPECT_EQ(read.probe.reach, 12.0);
  EXPECT_EQ(read.motion.dt, 0.02);
  for (const char* text : {"", "{}", "[1]", R"({"nodes":5,"width_mm":"wide"})"}) {
    EXPECT_THROW(moving_body_settings(text), InputError) << text;
  }
}

}  // namespace
}  // namespace bodkin
