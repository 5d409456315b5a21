#include "io/pose_log.h"

#include <algorithm>
#include <deque>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "io/xml_document.h"

namespace bodkin::io {

namespace {

// The frames of "NeedleTipToReference". The last "To" before a capital is the separator: frames' names contain none.
std::optional<std::pair<std::string, std::string>> frames_of(const std::string& name) {
  for (std::size_t at = name.rfind("To"); at != std::string::npos && at > 0; at = name.rfind("To", at - 1)) {
    if (at + 2 < name.size() && name[at + 2] >= 'A' && name[at + 2] <= 'Z')
      return std::pair(name.substr(0, at), name.substr(at + 2));
  }
  return std::nullopt;
}

// One step from a frame to another: a track, or the inverse of one.
struct TrackStep {
  const PoseTrack* track = nullptr;
  bool backwards = false;
};

Pose pose_at(const TrackStep& step, double time) {
  const Pose pose = step.track->at(time);
  return step.backwards ? pose.inverse() : pose;
}

// The shortest chain of tracks from one frame to the other.
std::vector<TrackStep> steps_between(const PoseLog& log, const std::string& from, const std::string& to) {
  struct Visited {
    std::string before;
    TrackStep step;
  };
  std::map<std::string, Visited> visited = {{from, {}}};
  std::deque<std::string> next = {from};
  while (!next.empty() && !visited.contains(to)) {
    const std::string here = next.front();
    next.pop_front();
    for (const PoseTrack& track : log.tracks) {
      const auto frames = frames_of(track.name);
      if (!frames || track.poses.empty()) continue;
      for (const bool backwards : {false, true}) {
        const std::string& begin = backwards ? frames->second : frames->first;
        const std::string& end = backwards ? frames->first : frames->second;
        if (begin == here && visited.try_emplace(end, Visited{here, {&track, backwards}}).second) next.push_back(end);
      }
    }
  }
  std::vector<TrackStep> steps;
  if (!visited.contains(to)) return steps;
  for (std::string frame = to; frame != from; frame = visited.at(frame).before)
    steps.push_back(visited.at(frame).step);
  std::reverse(steps.begin(), steps.end());
  return steps;
}

}  // namespace

Pose PoseTrack::at(double time) const {
  const auto after = std::lower_bound(poses.begin(), poses.end(), time,
                                      [](const TimedPose& pose, double value) { return pose.time < value; });
  if (after == poses.begin()) return poses.front().pose;
  if (after == poses.end()) return poses.back().pose;
  const TimedPose& before = *std::prev(after);
  const double share = (time - before.time) / (after->time - before.time);
  Pose pose = Pose::Identity();
  pose.translation() = before.pose.translation() + share * (after->pose.translation() - before.pose.translation());
  pose.linear() = Eigen::Quaterniond(before.pose.linear())
                      .slerp(share, Eigen::Quaterniond(after->pose.linear()))
                      .normalized()
                      .toRotationMatrix();
  return pose;
}

const PoseTrack* PoseLog::find(std::string_view name) const noexcept {
  for (const PoseTrack& track : tracks) {
    if (track.name == name) return &track;
  }
  return nullptr;
}

std::optional<PoseTrack> track_between(const PoseLog& log, const std::string& name) {
  if (const PoseTrack* own = log.find(name)) return *own;
  const auto frames = frames_of(name);
  if (!frames) return std::nullopt;
  const std::vector<TrackStep> steps = steps_between(log, frames->first, frames->second);
  if (steps.empty()) return std::nullopt;
  PoseTrack track;
  track.name = name;
  track.poses.reserve(steps.front().track->poses.size());
  for (const TimedPose& each : steps.front().track->poses) {
    Pose pose = Pose::Identity();
    for (const TrackStep& step : steps) pose = pose_at(step, each.time) * pose;
    track.poses.push_back({each.time, pose});
  }
  return track;
}

PoseLog read_pose_log(const std::filesystem::path& file) {
  constexpr std::size_t piece = std::size_t{1} << 20U, most = std::size_t{256} << 20U;  // bytes
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(piece, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(piece));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (bytes.empty()) {
    throw InputError(
        fmt::format("{}: cannot be read, expected a recorder log (.xml) or a sequence (.igs.mha)", file.string()));
  }
  const bool is_xml = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF") != std::string::npos &&
                      bytes[bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF")] == '<';
  const bool is_nrrd = bytes.starts_with("NRRD");
  const auto is_whole = [&](std::size_t from) {
    if (is_xml) return false;
    return bytes.find(is_nrrd ? "\n\n" : "\nElementDataFile", from) != std::string::npos;
  };
  for (std::size_t looked = 0; stream && bytes.size() < most && !is_whole(looked);) {
    const std::size_t size = bytes.size();
    looked = size < 16 ? 0 : size - 16;
    bytes.resize(size + piece);
    stream.read(bytes.data() + size, static_cast<std::streamsize>(piece));
    bytes.resize(size + static_cast<std::size_t>(stream.gcount()));
  }
  return is_xml ? parse_recorder_log(bytes, file.string()) : parse_sequence_poses(bytes, file.string());
}

}  // namespace bodkin::io
