#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parameter_value.h"
#include "io/pose_log.h"
#include "io/pose_numbers.h"
#include "io/xml_document.h"

namespace bodkin::io {

namespace {

constexpr std::string_view frame_prefix = "Seq_Frame", transform_ending = "Transform";
constexpr double nearest = 0.1;  // s, to a pose of another tool

// The header's data of one frame.
struct SequenceFrame {
  std::optional<double> time;
  std::map<std::string, Pose, std::less<>> poses;
  std::map<std::string, bool, std::less<>> is_ok;  // where the header says so
};

// "0012_NeedleTipToReferenceTransform" as a number and the rest.
std::optional<std::pair<std::uint32_t, std::string_view>> numbered_field(std::string_view key) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
  const auto digits = static_cast<std::size_t>(end - key.data());
  if (error != std::errc() || digits + 1 >= key.size() || key[digits] != '_') return std::nullopt;
  return std::pair(number, key.substr(digits + 1));
}

void take_field(SequenceFrame& frame, std::string_view field, std::string_view value, const std::string& where) {
  constexpr std::string_view status = "TransformStatus";
  if (field == "Timestamp") {
    double time = 0.0;
    if (!parse_number(value, time) || !std::isfinite(time))
      throw InputError(fmt::format("{}: the time is {}, expected a number of seconds", where, in_quotes(value)));
    frame.time = time;
  } else if (field.ends_with(status)) {
    frame.is_ok[std::string(field.substr(0, field.size() - status.size()))] = value == "OK";
  } else if (field.ends_with(transform_ending) && !field.starts_with("Image")) {  // which scales
    frame.poses[std::string(field.substr(0, field.size() - transform_ending.size()))] = pose_of_numbers(value, where);
  }
}

}  // namespace

PoseLog parse_sequence_poses(std::string_view header, const std::string& origin) {
  const bool is_nrrd = header.starts_with("NRRD");
  if (!is_nrrd && !header.starts_with("ObjectType")) {
    throw InputError(fmt::format(
        "{}: this is not a sequence of PLUS; expected .igs.mha, .igs.nrrd or a recorder log in XML", origin));
  }
  const std::string_view sign = is_nrrd ? ":=" : "=";
  std::map<std::uint32_t, SequenceFrame> frames;
  for (int number = 1; !header.empty(); ++number) {
    const std::size_t end = std::min(header.find('\n'), header.size());
    std::string_view line = header.substr(0, end);
    header.remove_prefix(std::min(end + 1, header.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (is_nrrd && line.empty()) break;
    const std::size_t equals = line.find(sign);
    if (equals == std::string_view::npos) continue;
    std::string_view key = without_blanks(line.substr(0, equals));
    if (key == "ElementDataFile") break;
    if (!key.starts_with(frame_prefix)) continue;
    key.remove_prefix(frame_prefix.size());
    const auto field = numbered_field(key);
    if (!field) continue;
    take_field(frames[field->first], field->second, without_blanks(line.substr(equals + sign.size())),
               fmt::format("{}, line {}", origin, number));
  }
  PoseLog log;
  std::map<std::string, std::size_t, std::less<>> tracks;
  for (const auto& [number, frame] : frames) {
    if (!frame.time) continue;
    for (const auto& [name, pose] : frame.poses) {
      const auto status = frame.is_ok.find(name);
      if (status != frame.is_ok.end() && !status->second) continue;
      const auto [found, is_new] = tracks.try_emplace(name, log.tracks.size());
      if (is_new) log.tracks.push_back({name, {}});
      log.tracks[found->second].poses.push_back({*frame.time, pose});
    }
  }
  sort_by_time(log);
  return log;
}

std::string sequence_of_poses(const PoseLog& log) {
  if (log.tracks.empty() || log.tracks.front().poses.empty())
    throw InputError("there is no pose for a sequence, expected at least one");
  const std::vector<TimedPose>& times = log.tracks.front().poses;
  std::string text;
  const auto line = [&](const std::string& name, const std::string& value) { text += name + " = " + value + "\n"; };
  line("ObjectType", "Image");
  line("NDims", "3");
  line("AnatomicalOrientation", "RAI");
  line("BinaryData", "True");
  line("BinaryDataByteOrderMSB", "False");
  line("CenterOfRotation", "0 0 0");
  line("CompressedData", "False");
  line("DimSize", fmt::format("1 1 {}", times.size()));
  line("Kinds", "domain domain list");
  line("ElementSpacing", "1 1 1");
  line("ElementType", "MET_UCHAR");
  line("Offset", "0 0 0");
  line("TransformMatrix", "1 0 0 0 1 0 0 0 1");
  line("UltrasoundImageOrientation", "MF");
  line("UltrasoundImageType", "BRIGHTNESS");
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double time = times[i].time;
    const std::string name = fmt::format("Seq_Frame{:04}_", i);
    for (const PoseTrack& track : log.tracks) {
      const bool is_ok = !track.poses.empty() && time >= track.poses.front().time - nearest &&
                         time <= track.poses.back().time + nearest;
      line(name + track.name + "Transform", numbers_of_pose(is_ok ? track.at(time) : Pose::Identity()));
      line(name + track.name + "TransformStatus", is_ok ? "OK" : "INVALID");
    }
    line(name + "Timestamp", fmt::format("{:.6f}", time));
    line(name + "UnfilteredTimestamp", fmt::format("{:.6f}", time));
    line(name + "FrameNumber", std::to_string(i));
    line(name + "ImageStatus", "OK");
  }
  line("ElementDataFile", "LOCAL");
  return text + std::string(times.size(), '\0');
}

}  // namespace bodkin::io
