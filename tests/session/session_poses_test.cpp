// Export of sessions to other programs, and import of their recordings.
#include "session/session_poses.h"

#include "session/session_run.h"
#include "tests/io/scratch_folder.h"
#include "tests/session/session_samples.h"
#include "tests/session/slab_case.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin::session {
namespace {

using ::testing::HasSubstr;
namespace tissue = anatomy::tissue;

// A needle that goes straight in at 20 mm/s as a tracker of 60 Hz sees it, in RAS: from 20 mm above the skin to 18 mm
// below it, and waits.
io::PoseLog insertion(const std::string& name) {
  io::PoseLog log;
  log.tracks = {{name, {}}};
  for (int i = 0; i <= 150; ++i) {
    const double time = 1000.0 + i / 60.0;
    const double y = std::max(20.0 - 20.0 * i / 60.0, -18.0);
    Pose lps = needle_pose(Vec3(0.0, y, 0.0), -Vec3::UnitY());
    lps.linear().topRows<2>() *= -1.0;
    lps.translation().head<2>() *= -1.0;
    log.tracks[0].poses.push_back({time, lps});
  }
  return log;
}

class PoseImportTest : public testing::Test {
 protected:
  PoseImportTest() : patient_(slab_case({{tissue::skin, 2.0}, {tissue::fat, 12.0}, {tissue::muscle, 36.0}})) {
    folder_.write("case.xml", "<case/>");
    how_.output = folder_.path() / "imported.bodkin";
  }
  SessionHeader header() const {
    return session_header(patient_, folder_.path(), *patient_.description.procedure.path);
  }
  std::string refusal(const io::PoseLog& log) const {
    try {
      import_poses(patient_, header(), log, how_, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  ScratchFolder folder_;
  anatomy::Case patient_;
  PoseImport how_;
};

TEST_F(PoseImportTest, every_recording_has_an_id_of_its_own) {
  EXPECT_EQ(header().recording_id.size(), 32U);
  EXPECT_NE(header().recording_id, header().recording_id);
}

TEST_F(PoseImportTest, a_recorded_needle_meets_the_layers_where_the_case_has_them) {
  const PoseImportResult done = import_poses(patient_, header(), insertion("NeedleTipToReference"), how_, {});
  const Session session = read_session(how_.output);
  EXPECT_TRUE(session.finished);
  EXPECT_EQ(session.header.operator_name, "tracked");
  EXPECT_EQ(session.ticks.size(), 2501U) << "2.5 s at 1 kHz";
  EXPECT_EQ(done.ticks, session.ticks.size());
  EXPECT_EQ(done.poses, 151U);
  EXPECT_NEAR(done.longest_gap, 1.0 / 60.0, 1e-9);
  EXPECT_NEAR(session.ticks.back().output.depth, 18.0, 1e-6);
  EXPECT_EQ(session.ticks.back().output.tissue, tissue::muscle);
  ASSERT_FALSE(session.events.empty());
  EXPECT_EQ(session.events.front().event.kind, forces::EventKind::contact);
  EXPECT_NEAR(static_cast<double>(session.events.front().tick) * 1e-3, 1.0, 0.003) << "20 mm at 20 mm/s";
  double force = 0.0;
  for (const simulation::TickRecord& record : session.ticks) force = std::max(force, record.output.resistance);
  EXPECT_GT(force, 0.1);
}

TEST_F(PoseImportTest, what_was_exported_is_imported_with_the_same_ticks) {
  import_poses(patient_, header(), insertion("NeedleTipToReference"), how_, {});
  const Session first = read_session(how_.output);
  for (const bool as_sequence : {false, true}) {
    const io::PoseLog poses = poses_of(first, 1000.0);
    EXPECT_EQ(poses.tracks.at(0).poses.size(), first.ticks.size());
    EXPECT_FALSE(poses.messages.empty());
    EXPECT_THAT(poses.messages[0].text, HasSubstr("contact (skin)"));
    const io::PoseLog back = as_sequence ? io::parse_sequence_poses(io::sequence_of_poses(poses), "x")
                                         : io::parse_recorder_log(io::recorder_log(poses), "x");
    how_.output = folder_.path() / (as_sequence ? "sequence.bodkin" : "log.bodkin");
    import_poses(patient_, header(), back, how_, {});
    const Session again = read_session(how_.output);
    ASSERT_EQ(again.ticks.size(), first.ticks.size());
    for (std::size_t i = 0; i < first.ticks.size(); ++i) {
      EXPECT_LT((again.ticks[i].input.needle.matrix() - first.ticks[i].input.needle.matrix()).norm(), 1e-5) << i;
      EXPECT_EQ(again.ticks[i].output.tissue, first.ticks[i].output.tissue) << i;
    }
    EXPECT_EQ(again.events.size(), first.events.size());
  }
}

TEST_F(PoseImportTest, a_probe_beside_the_needle_is_kept_and_exported_in_its_own_axes) {
  io::PoseLog log = insertion("NeedleTipToReference");
  Pose probe = Pose::Identity();
  probe.linear() << 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0;
  probe.translation() = Vec3(5.0, -1.0, 12.0);
  log.tracks.push_back({"ProbeToReference", {{1000.0, probe}, {1002.5, probe}}});
  EXPECT_EQ(import_poses(patient_, header(), log, how_, {}).samples, 251U);
  const Session session = read_session(how_.output);
  ASSERT_TRUE(session.header.second);
  EXPECT_EQ(session.header.second->role, SecondRole::probe);
  const io::PoseLog back = poses_of(session, 60.0);
  ASSERT_NE(back.find("ProbeToReference"), nullptr);
  EXPECT_LT((back.find("ProbeToReference")->poses.at(7).pose.matrix() - probe.matrix()).norm(), 1e-9);
  EXPECT_NEAR(static_cast<double>(back.tracks.at(0).poses.size()), 151.0, 1.0) << "60 a second of 2.5 s";
}

// Mouse and keys hold it, so that there is no second hand: each pose holds until the next one.
TEST_F(PoseImportTest, the_probe_of_an_ultrasound_machine_is_exported_with_every_pose_of_the_needle) {
  import_poses(patient_, header(), insertion("NeedleTipToReference"), how_, {});
  Session session = read_session(how_.output);
  ScanSample sample;
  sample.time = 0.5;
  sample.probe.translation() = Vec3(1.0, 2.0, 3.0);
  session.scans.push_back(sample);
  sample.time = 1.0;
  sample.probe.translation().z() = 8.0;
  session.scans.push_back(sample);
  const io::PoseLog log = poses_of(session, 100.0);
  const io::PoseTrack* const probe = log.find("ProbeToReference");
  ASSERT_NE(probe, nullptr);
  ASSERT_EQ(probe->poses.size(), 201U) << "from 0.5 s to 2.5 s";
  EXPECT_NEAR(probe->poses[0].time, 0.5, 1e-9);
  EXPECT_EQ(probe->poses[49].pose.translation(), Vec3(-1.0, -2.0, 3.0)) << "RAS";
  EXPECT_EQ(probe->poses[50].pose.translation(), Vec3(-1.0, -2.0, 8.0));
}

TEST_F(PoseImportTest, a_recording_that_cannot_be_one_of_this_patient_is_refused) {
  EXPECT_THAT(refusal(insertion("StylusToTracker")),
              HasSubstr("has no NeedleTipToReference; it has StylusToTracker"));
  EXPECT_THAT(refusal({}), HasSubstr("no pose at all"));
  io::PoseLog far = insertion("NeedleTipToReference");
  far.tracks[0].poses[3].pose.translation().z() = 5000.0;
  EXPECT_THAT(refusal(far), HasSubstr("from the entry of the case's path"));
  io::PoseLog long_one = insertion("NeedleTipToReference");
  long_one.tracks[0].poses.back().time += 4000.0;
  EXPECT_THAT(refusal(long_one), HasSubstr("expected at most 3600"));
  io::PoseLog short_one = insertion("NeedleTipToReference");
  short_one.tracks[0].poses.resize(1);
  EXPECT_THAT(refusal(short_one), HasSubstr("one pose"));
  EXPECT_FALSE(std::filesystem::exists(how_.output));
}

}  // namespace
}  // namespace bodkin::session
