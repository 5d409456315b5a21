#include "training/store/attempt_record.h"

#include "tests/training/written_session.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "training/procedure_file.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

TEST(AttemptRecord, says_of_a_session_what_its_score_says) {
  WrittenSession written = good_puncture();
  const Score judged = score(written.session(), written_description(), find_procedure("lumbar_puncture"));
  const AttemptRecord record = record_of(written.session(), "slim", judged);
  EXPECT_EQ(record.procedure, "lumbar_puncture");
  EXPECT_EQ(record.patient, "slim");
  EXPECT_EQ(record.verdict, judged.verdict);
  EXPECT_EQ(record.reached, judged.reached);
  EXPECT_EQ(record.started_at, "2026-11-21T02:00:00Z");
  EXPECT_NEAR(record.duration, 1e-3 * static_cast<double>(written.session().ticks.size() - 1), 1e-9);
  EXPECT_EQ(record.metrics.size(), judged.metrics.size());
  EXPECT_FALSE(record.station.empty());
  AttemptRecord read;
  read_metrics(read, metrics_json(record), "test");
  read_findings(read, findings_json(record), "test");
  EXPECT_EQ(read.metrics, record.metrics);
  ASSERT_EQ(read.findings.size(), record.findings.size());
  EXPECT_EQ(read.findings.front().sentence, record.findings.front().sentence);
  EXPECT_EQ(read.findings.front().grade, record.findings.front().grade);
}

TEST(AttemptRecord, has_a_digest_of_what_was_recorded) {
  WrittenSession one = good_puncture(), same = good_puncture(), other = good_puncture(), later = good_puncture();
  other.session().ticks[5000].input.needle.translation().y() += 1e-9;
  later.session().header.started_at = "2026-11-21T02:00:01Z";
  EXPECT_EQ(session_digest(one.session()).size(), 32U);
  EXPECT_EQ(session_digest(one.session()), session_digest(same.session()));
  EXPECT_NE(session_digest(one.session()), session_digest(other.session()));
  EXPECT_NE(session_digest(one.session()), session_digest(later.session()));
  // Two stations started in the same second, with equal hand motions.
  one.session().header.recording_id = "0123456789abcdef0123456789abcdef";
  same.session().header.recording_id = "0123456789abcdef0123456789abcdf0";
  EXPECT_NE(session_digest(one.session()), session_digest(same.session()));
  same.session().header.recording_id = one.session().header.recording_id;
  EXPECT_EQ(session_digest(one.session()), session_digest(same.session()));
}

TEST(ScorePoints, are_the_share_of_the_rules_that_were_kept) {
  Score score;
  score.reached = true;
  score.verdict = Grade::fail;
  const auto add = [&](std::optional<Grade> grade) { score.metrics.push_back({nullptr, 0.0, grade, {}}); };
  add(Grade::pass);
  add(Grade::borderline);
  add(Grade::fail);
  add(std::nullopt);
  EXPECT_DOUBLE_EQ(score_points(score), 50.0);
  score.verdict = Grade::dangerous;
  EXPECT_DOUBLE_EQ(score_points(score), 0.0);
  score.verdict = Grade::pass;
  score.reached = false;
  EXPECT_DOUBLE_EQ(score_points(score), 0.0);
  score.reached = true;
  score.metrics.clear();
  EXPECT_DOUBLE_EQ(score_points(score), 100.0);
}

}  // namespace
}  // namespace bodkin
