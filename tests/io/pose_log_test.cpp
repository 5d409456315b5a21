// Poses as 3D Slicer and PLUS record them: read, written, and transformed between frames.
#include "io/pose_log.h"

#include <cstdlib>

#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin::io {
namespace {

using ::testing::HasSubstr;

Pose turned(double angle, const Vec3& place) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(angle, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  pose.translation() = place;
  return pose;
}

PoseLog two_tools() {
  PoseLog log;
  log.tracks = {{"NeedleTipToReference", {}}, {"ProbeToReference", {}}};
  for (int i = 0; i < 20; ++i) {
    log.tracks[0].poses.push_back({100.0 + 0.05 * i, turned(0.1 * i, Vec3(i, -2.5 * i, 300.0))});
    if (i % 2 == 0) log.tracks[1].poses.push_back({100.0 + 0.05 * i, turned(-0.05 * i, Vec3(7.0, i, 1.0))});
  }
  log.messages = {{100.2, "contact (skin)"}, {100.7, "\"deep\" <5 mm & more>"}};
  return log;
}

void expect_same(const PoseLog& found, const PoseLog& expected, double shift) {
  ASSERT_EQ(found.tracks.size(), expected.tracks.size());
  for (const PoseTrack& track : expected.tracks) {
    const PoseTrack* const same = found.find(track.name);
    ASSERT_NE(same, nullptr) << track.name;
    ASSERT_EQ(same->poses.size(), track.poses.size());
    for (std::size_t i = 0; i < track.poses.size(); ++i) {
      EXPECT_NEAR(same->poses[i].time, track.poses[i].time - shift, 1e-6);
      EXPECT_LT((same->poses[i].pose.matrix() - track.poses[i].pose.matrix()).cwiseAbs().maxCoeff(), 1e-6);
    }
  }
}

TEST(PoseLog, a_recorder_log_reads_back_as_it_was_from_time_zero) {
  const std::string text = recorder_log(two_tools());
  EXPECT_THAT(text, HasSubstr("<TransformRecorderLog>"));
  EXPECT_THAT(text, HasSubstr("DeviceName=\"NeedleTipToReference\""));
  const PoseLog back = parse_recorder_log(text, "log.xml");
  expect_same(back, two_tools(), 100.0);
  ASSERT_EQ(back.messages.size(), 2U);
  EXPECT_NEAR(back.messages[0].time, 0.2, 1e-6);
  EXPECT_EQ(back.messages[1].text, two_tools().messages[1].text);
}

// As 3D Slicer writes it: two spaces before each entry, track after track, with a message at the end.
TEST(PoseLog, reads_a_log_that_3d_slicer_writes) {
  const PoseLog log = parse_recorder_log(
      "<TransformRecorderLog>\n"
      "  <log TimeStampSec=\"2\" TimeStampNSec=\"500000000\" type=\"transform\" DeviceName=\"StylusTipToRas\" "
      "transform=\"1 0 0 10 0 0 -1 20 0 1 0 30 0 0 0 1 \" />\n"
      "  <log TimeStampSec=\"1\" TimeStampNSec=\"0\" type=\"transform\" DeviceName=\"StylusTipToRas\" "
      "transform=\"1 0 0 1 0 1 0 2 0 0 1 3 0 0 0 1\" />\n"
      "  <log TimeStampSec=\"1\" TimeStampNSec=\"250000000\" type=\"message\" message=\"insertion\" />\n"
      "</TransformRecorderLog>\n",
      "log.xml");
  ASSERT_EQ(log.tracks.size(), 1U);
  ASSERT_EQ(log.tracks[0].poses.size(), 2U);
  EXPECT_EQ(log.tracks[0].poses[0].time, 1.0) << "in the order of time";
  EXPECT_EQ(log.tracks[0].poses[1].time, 2.5);
  EXPECT_EQ(log.tracks[0].poses[1].pose.translation(), Vec3(10.0, 20.0, 30.0));
  EXPECT_LT((log.tracks[0].poses[1].pose.linear().col(2) - Vec3(0.0, -1.0, 0.0)).norm(), 1e-12);
  EXPECT_EQ(log.messages.at(0).text, "insertion");
}

TEST(PoseLog, a_sequence_of_plus_reads_back_as_it_was) {
  const std::string bytes = sequence_of_poses(two_tools());
  EXPECT_THAT(bytes, HasSubstr("DimSize = 1 1 20\n"));
  EXPECT_THAT(bytes, HasSubstr("Seq_Frame0019_NeedleTipToReferenceTransformStatus = OK\n"));
  EXPECT_TRUE(bytes.ends_with(std::string("ElementDataFile = LOCAL\n") + std::string(20, '\0')));
  const PoseLog back = parse_sequence_poses(bytes, "a.igs.mha");
  const PoseTrack expected = two_tools().tracks[0];
  PoseLog needle;
  needle.tracks = {*back.find("NeedleTipToReference")};
  PoseLog other;
  other.tracks = {expected};
  expect_same(needle, other, 0.0);
  // The probe has every second pose; between them it is interpolated.
  const Pose between = back.find("ProbeToReference")->at(100.05);
  EXPECT_NEAR(between.translation().y(), 1.0, 1e-6);
}

TEST(PoseLog, leaves_out_what_a_tracker_did_not_see) {
  const std::string header =
      "ObjectType = Image\nSeq_Frame0000_NeedleToReferenceTransform = 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1\n"
      "Seq_Frame0000_NeedleToReferenceTransformStatus = INVALID\nSeq_Frame0000_Timestamp = 1\n"
      "Seq_Frame0001_NeedleToReferenceTransform = 1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1\r\n"
      "Seq_Frame0001_NeedleToReferenceTransformStatus = OK\r\nSeq_Frame0001_Timestamp = 2\r\n"
      "Seq_Frame0001_ImageToProbeTransform = 0.2 0 0 0 0 0.2 0 0 0 0 0.2 0 0 0 0 1\n"
      "Seq_Frame0002_NeedleToReferenceTransform = 1 0 0 3 0 1 0 0 0 0 1 0 0 0 0 1\n"
      "ElementDataFile = LOCAL\nSeq_Frame0003_Timestamp = no header any more";
  const PoseLog log = parse_sequence_poses(header, "x");
  ASSERT_EQ(log.tracks.size(), 1U);
  ASSERT_EQ(log.tracks[0].poses.size(), 1U) << "one that was seen and has a time";
  EXPECT_EQ(log.tracks[0].poses[0].pose.translation().x(), 2.0);
  std::string nrrd =
      "NRRD0005\ntype: unsigned char\nSeq_Frame0000_NeedleToReferenceTransform:=1 0 0 1 0 1 0 0 0 0 1 0 "
      "0 0 0 1\nSeq_Frame0000_Timestamp:=4.5\n\nSeq_Frame0001_Timestamp:=bytes of the picture";
  EXPECT_EQ(parse_sequence_poses(nrrd, "x").tracks.at(0).poses.at(0).time, 4.5);
}

TEST(PoseLog, leads_from_one_frame_to_another_forwards_and_backwards) {
  const Pose needle = turned(0.4, Vec3(10.0, 20.0, 30.0)), reference = turned(-0.9, Vec3(-5.0, 4.0, 3.0)),
             tip = turned(0.2, Vec3(0.0, 0.0, 120.0));
  PoseLog log;
  log.tracks = {{"NeedleToTracker", {{0.0, needle}, {1.0, needle}}},
                {"ReferenceToTracker", {{0.0, reference}}},
                {"NeedleTipToNeedle", {{0.0, tip}}}};
  const std::optional<PoseTrack> found = track_between(log, "NeedleToReference");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->poses.size(), 2U);
  EXPECT_LT((found->poses[1].pose.matrix() - (reference.inverse() * needle).matrix()).norm(), 1e-12);
  const Pose whole = track_between(log, "NeedleTipToReference").value().poses.at(0).pose;
  EXPECT_LT((whole.matrix() - (reference.inverse() * needle * tip).matrix()).norm(), 1e-12);
  EXPECT_FALSE(track_between(log, "NeedleToRas"));
  EXPECT_FALSE(track_between(log, "Needle"));
  EXPECT_FALSE(track_between({}, "NeedleToReference"));
}

TEST(PoseLog, says_what_is_wrong_and_where) {
  const auto sentence = [](auto read) -> std::string {
    try {
      read();
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  const auto log_with = [](const std::string& attributes) {
    return "<TransformRecorderLog>\n<log TimeStampSec='1' TimeStampNSec='0' " + attributes +
           "/></TransformRecorderLog>";
  };
  EXPECT_THAT(
      sentence([&] { parse_recorder_log(log_with("type='transform' DeviceName='A' transform='1 2 3'"), "log.xml"); }),
      HasSubstr("log.xml, line 2: the transform is '1 2 3', expected 16 numbers"));
  EXPECT_THAT(sentence([&] {
                parse_recorder_log(
                    log_with("type='transform' DeviceName='A' transform='2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1'"),
                    "log.xml");
              }),
              HasSubstr("not a rotation"));
  EXPECT_THAT(sentence([&] { parse_recorder_log("<log/>", "log.xml"); }), HasSubstr("log.xml"));
  EXPECT_THAT(sentence([&] { parse_sequence_poses("PK\3\4", "a.mha"); }), HasSubstr("not a sequence of PLUS"));
  EXPECT_THAT(
      sentence([&] { parse_sequence_poses("ObjectType = Image\nSeq_Frame0000_Timestamp = soon\n", "a.mha"); }),
      HasSubstr("a.mha, line 2: the time is 'soon'"));
  EXPECT_THAT(sentence([&] { sequence_of_poses({}); }), HasSubstr("no pose"));
  EXPECT_THAT(sentence([&] { read_pose_log("no/such.xml"); }), HasSubstr("no/such.xml: cannot be read"));
}

TEST(PoseLog, a_file_is_known_by_what_it_begins_with) {
  const ScratchFolder folder;
  folder.write("a", recorder_log(two_tools()));
  folder.write("b", sequence_of_poses(two_tools()));
  EXPECT_EQ(read_pose_log(folder.path() / "a").messages.size(), 2U);
  EXPECT_EQ(read_pose_log(folder.path() / "b").find("NeedleTipToReference")->poses.size(), 20U);
}

TEST(PoseLog, reads_a_real_sequence_of_plus) {
  const char* const named = std::getenv("BODKIN_DATA");
  const std::filesystem::path data = named != nullptr ? named : BODKIN_REPOSITORY "/../shared/data";
  const std::filesystem::path file = data / "reference_ultrasound/spine_phantom_tracked.igs.mha";
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << file << " is not here; BODKIN_DATA names the folder of test data";
  const PoseLog log = read_pose_log(file);
  ASSERT_NE(log.find("ProbeToTracker"), nullptr);
  EXPECT_EQ(log.find("ProbeToTracker")->poses.size(), 21U);
  EXPECT_NEAR(log.find("ProbeToTracker")->poses[0].time, 215.102186, 1e-9);
  const PoseTrack probe = track_between(log, "ProbeToReference").value();
  ASSERT_EQ(probe.poses.size(), 21U);
  // By hand from the first frame: R' (p - t) of the reference's and the probe's first lines.
  EXPECT_LT((probe.poses[0].pose.translation() - Vec3(-55.433, 205.985, 17.508)).norm(), 0.05)
      << probe.poses[0].pose.translation();
}

}  // namespace
}  // namespace bodkin::io
