#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/error.h"
#include "io/pose_log.h"
#include "io/pose_numbers.h"
#include "io/xml_document.h"
#include "io/xml_writer.h"

namespace bodkin::io {

namespace {

constexpr double nanosecond = 1e-9;

double time_of_entry(const XmlElement& entry, const std::string& where) {
  const double time = entry.number("TimeStampSec", 0.0) + nanosecond * entry.number("TimeStampNSec", 0.0);
  if (std::isfinite(time)) return time;
  throw InputError(fmt::format("{}: the time is not finite, expected seconds and nanoseconds", where));
}

// An entry of the log at its time.
struct LogEntry {
  double time = 0.0;
  const std::string* name = nullptr;  // null: a message
  const Pose* pose = nullptr;
  const std::string* text = nullptr;
};

}  // namespace

PoseLog parse_recorder_log(std::string_view document, const std::string& origin) {
  static const XmlSchema schema("recorder_log.xsd");
  const XmlElement root = schema.read(document, origin, {.root = "TransformRecorderLog"});
  PoseLog log;
  std::map<std::string, std::size_t> tracks;
  for (const XmlElement& entry : root.children) {
    const std::string where = fmt::format("{}, line {}", origin, entry.line);
    const std::string type = entry.string("type");
    if (type == "message" && !entry.string("message").empty())
      log.messages.push_back({time_of_entry(entry, where), entry.string("message")});
    if (type != "transform" || entry.string("DeviceName").empty() || entry.string("transform").empty()) continue;
    const std::string name = entry.string("DeviceName");
    const auto [found, is_new] = tracks.try_emplace(name, log.tracks.size());
    if (is_new) log.tracks.push_back({name, {}});
    log.tracks[found->second].poses.push_back(
        {time_of_entry(entry, where), pose_of_numbers(entry.string("transform"), where)});
  }
  sort_by_time(log);
  return log;
}

std::string recorder_log(const PoseLog& log) {
  std::vector<LogEntry> entries;
  for (const PoseTrack& track : log.tracks)
    for (const TimedPose& each : track.poses) entries.push_back({each.time, &track.name, &each.pose, nullptr});
  for (const TimedText& each : log.messages) entries.push_back({each.time, nullptr, nullptr, &each.text});
  std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  XmlWriter xml;
  xml.open("TransformRecorderLog");
  const double first = entries.empty() ? 0.0 : entries.front().time;
  for (const LogEntry& entry : entries) {
    const double time = entry.time - first, whole = std::floor(time);
    xml.open("log");
    xml.attribute("TimeStampSec", fmt::format("{:.0f}", whole));
    xml.attribute("TimeStampNSec", fmt::format("{:.0f}", std::min((time - whole) / nanosecond, 999999999.0)));
    xml.attribute("type", entry.pose == nullptr ? "message" : "transform");
    if (entry.pose == nullptr) {
      xml.attribute("message", *entry.text);
    } else {
      xml.attribute("DeviceName", *entry.name);
      xml.attribute("transform", numbers_of_pose(*entry.pose));
    }
    xml.close();
  }
  xml.close();
  return xml.finish();
}

}  // namespace bodkin::io
