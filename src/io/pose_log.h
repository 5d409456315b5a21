#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry.h"

namespace bodkin::io {

// A tracker's report about one tool at one time.
struct TimedPose {
  double time = 0.0;             // s
  Pose pose = Pose::Identity();  // mm; as in the file, that is in RAS if the reference is a patient
};

// The poses of one tool, in chronological order, no two at one time.
struct PoseTrack {
  std::string name;  // "NeedleTipToReference": from one frame to another
  std::vector<TimedPose> poses;

  // The pose at a time: interpolated linearly and by the smallest rotation; the first or last one outside the range.
  // There must be a pose.
  Pose at(double time) const;
};

// An annotation: "PerkTutor begins a task".
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

// The track of `name`, "AToB": that of the log, or the product of tracks that lead from A to B, each forwards or
// backwards (NeedleToTracker and ReferenceToTracker give NeedleToReference), at the times of the first of them. Empty
// if none lead there.
std::optional<PoseTrack> track_between(const PoseLog& log, const std::string& name);

// The recorder's log of 3D Slicer's Perk Tutor, <TransformRecorderLog>. `origin` names it in messages. Throws
// InputError for another document, and for a time or a matrix that cannot be read.
PoseLog parse_recorder_log(std::string_view document, const std::string& origin);
// The same as a document; times begin at 0, for 3D Slicer keeps six digits of them.
std::string recorder_log(const PoseLog& log);

// The header of a sequence of PLUS, .igs.mha (lines "Key = Value") or .igs.nrrd (lines "Key:=Value"). Poses whose
// status is not OK are left out. Throws InputError for an invalid header, time or matrix.
PoseLog parse_sequence_poses(std::string_view header, const std::string& origin);
// An .igs.mha of the log's tracks at the times of its first one, with an image of one pixel each, as PLUS writes
// poses without images. Where another track has no pose within 0.1 s its status is INVALID. Throws InputError for a
// log without a pose.
std::string sequence_of_poses(const PoseLog& log);

// Reads either format, detected by its beginning. At most 256 MiB are read. Throws InputError.
PoseLog read_pose_log(const std::filesystem::path& file);

}  // namespace bodkin::io
