#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry.h"

namespace bodkin::io {

// What a tracker said of one tool at one time.
struct TimedPose {
  double time = 0.0;             // s
  Pose pose = Pose::Identity();  // mm; as the file has it, which is RAS where the reference is a patient
};

// The poses of one tool, in the order of time, no two of one time.
struct PoseTrack {
  std::string name;  // "NeedleTipToReference": from one frame to another
  std::vector<TimedPose> poses;

  // At a time, between two poses on a straight line and by the shortest turn; the first or last one beyond them.
  // There must be a pose.
  Pose at(double time) const;
};

// What somebody wrote down meanwhile: "PerkTutor begins a task".
struct TimedText {
  double time = 0.0;  // s
  std::string text;
};

// Poses of tools as trackers record them.
struct PoseLog {
  std::vector<PoseTrack> tracks;
  std::vector<TimedText> messages;

  const PoseTrack* find(std::string_view name) const noexcept;
};

// The track of `name`, "AToB": that of the log, or the product of those that lead from A to B, each forwards or
// backwards (NeedleToTracker and ReferenceToTracker give NeedleToReference), at the times of the first of them.
// Nothing where none lead there.
std::optional<PoseTrack> track_between(const PoseLog& log, const std::string& name);

// The recorder's log of 3D Slicer's Perk Tutor, <TransformRecorderLog>. `origin` names it in messages. Throws
// InputError for another document, and for a time or a matrix that cannot be read.
PoseLog parse_recorder_log(std::string_view document, const std::string& origin);
// The same as a document; times begin at 0, for 3D Slicer keeps six digits of them.
std::string recorder_log(const PoseLog& log);

// The header of a sequence of PLUS, .igs.mha (lines "Key = Value") or .igs.nrrd (lines "Key:=Value"). Poses whose
// status is not OK are left out. Throws InputError for what is no such header, and for a time or a matrix that is
// none.
PoseLog parse_sequence_poses(std::string_view header, const std::string& origin);
// An .igs.mha of the log's tracks at the times of its first one, with a picture of one pixel each, as PLUS writes
// poses without pictures. Where another track has no pose within 0.1 s its status is INVALID. Throws InputError for a
// log without a pose.
std::string sequence_of_poses(const PoseLog& log);

// Either, by what the file begins with. At most 256 MiB are looked at. Throws InputError.
PoseLog read_pose_log(const std::filesystem::path& file);

}  // namespace bodkin::io
