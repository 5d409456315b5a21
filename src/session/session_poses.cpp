#include "session/session_poses.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "session/tick_codec.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/settings_check.h"
#include "simulation/haptic_tick.h"

namespace bodkin::session {

namespace {

constexpr double probe_interval = 0.01;     // s, as a second hand is recorded
constexpr double farthest_needle = 2000.0;  // mm

// L M with L = diag(-1, -1, 1): the patient's axes turned from LPS to RAS or back.
Pose with_other_axes(Pose pose) {
  pose.linear().topRows<2>() *= -1.0;
  pose.translation().head<2>() *= -1.0;
  return pose;
}

// From a tool whose third axis points out of its tip to the frame of a probe, and back.
Pose probe_of_tool(const Pose& tool) {
  Pose probe = tool;
  probe.linear().col(1) = tool.linear().col(2);
  probe.linear().col(2) = -tool.linear().col(1);
  return probe;
}
Pose tool_of_probe(const Pose& probe) {
  Pose tool = probe;
  tool.linear().col(2) = probe.linear().col(1);
  tool.linear().col(1) = -probe.linear().col(2);
  return tool;
}

std::string title_of(const SessionHeader& header, anatomy::TissueId id) {
  for (const TissueName& tissue : header.tissues) {
    if (tissue.id == id) return tissue.title;
  }
  return std::to_string(id);
}

io::PoseTrack needle_track(const io::PoseLog& log, const PoseImport& how) {
  std::optional<io::PoseTrack> found = io::track_between(log, how.needle);
  if (!found || found->poses.empty()) {
    std::vector<std::string> names;
    for (const io::PoseTrack& track : log.tracks) names.push_back(track.name);
    throw InputError(fmt::format("the recording has no {}; it has {}; name the needle with --needle", how.needle,
                                 names.empty() ? "no pose at all" : fmt::format("{}", fmt::join(names, ", "))));
  }
  if (found->poses.size() < 2)
    throw InputError(fmt::format("the recording has one pose of {}, expected two at least", how.needle));
  return std::move(*found);
}

void check_needle(const io::PoseTrack& track, const Vec3& entry) {
  constexpr double longest = 3600.0;  // s
  if (const double time = track.poses.back().time - track.poses.front().time; time > longest) {
    throw InputError(
        fmt::format("the recording of {} takes {:.0f} s, expected at most {:g}", track.name, time, longest));
  }
  for (const io::TimedPose& each : track.poses) {
    const double distance = (with_other_axes(each.pose).translation() - entry).norm();
    if (distance <= farthest_needle) continue;
    throw InputError(
        fmt::format("at {:.2f} s {} is {:.0f} mm from the entry of the case's path, expected at most {:g}; "
                    "the reference must be the patient's CT in RAS mm",
                    each.time, track.name, distance, farthest_needle));
  }
}

SecondSample sample_at(const io::PoseTrack& probe, double time, double begin) {
  const Pose tool = tool_of_probe(with_other_axes(probe.at(begin + time)));
  SecondSample sample;
  sample.time = time;
  sample.position = tool.translation();
  sample.rotation = Eigen::Quaterniond(tool.linear()).normalized();
  return sample;
}

}  // namespace

io::PoseLog poses_of(const Session& session, double rate) {
  constexpr double highest = 4000.0;
  check_range("poses", "rate", rate, {1.0, highest}, "Hz");
  if (session.ticks.empty()) throw InputError("the session has no tick, expected one in which a needle moved");
  const double dt = session.header.dt;
  io::PoseLog log;
  io::PoseTrack needle{"NeedleTipToReference", {}};
  io::PoseTrack scanned{"ProbeToReference", {}};  // of an ultrasound machine
  auto scan = session.scans.begin();
  double next = 0.0;
  for (const simulation::TickRecord& record : session.ticks) {
    const double time = static_cast<double>(record.tick) * dt;
    const bool is_last = &record == &session.ticks.back();
    if (time < next - 0.5 * dt && !is_last) continue;
    needle.poses.push_back({time, with_other_axes(record.input.needle)});
    while (scan != session.scans.end() && scan + 1 != session.scans.end() && (scan + 1)->time <= time) ++scan;
    if (scan != session.scans.end() && scan->time <= time)
      scanned.poses.push_back({time, with_other_axes(scan->probe)});
    next = (std::floor((time + 0.5 * dt) * rate) + 1.0) / rate;
  }
  log.tracks.push_back(std::move(needle));
  if (session.header.second && session.header.second->role == SecondRole::probe && !session.second.empty()) {
    io::PoseTrack probe{"ProbeToReference", {}};
    for (const SecondSample& sample : session.second) {
      Pose tool = Pose::Identity();
      tool.translation() = sample.position;
      tool.linear() = sample.rotation.toRotationMatrix();
      probe.poses.push_back({sample.time, with_other_axes(probe_of_tool(tool))});
    }
    log.tracks.push_back(std::move(probe));
  } else if (!scanned.poses.empty()) {
    log.tracks.push_back(std::move(scanned));
  }
  for (const SessionEvent& event : session.events) {
    log.messages.push_back(
        {static_cast<double>(event.tick) * dt,
         fmt::format("{} ({})", event_kind_name(event.event.kind), title_of(session.header, event.event.tissue))});
  }
  return log;
}

PoseImportResult import_poses(const anatomy::Case& patient, SessionHeader header, const io::PoseLog& log,
                              const PoseImport& how, const Progress& progress) {
  const io::PoseTrack needle = needle_track(log, how);
  check_needle(needle, header.path.entry);
  const std::optional<io::PoseTrack> found = how.probe.empty() ? std::nullopt : io::track_between(log, how.probe);
  const io::PoseTrack* const probe = found && !found->poses.empty() ? &*found : nullptr;
  header.operator_name = "tracked";
  header.operator_settings = nlohmann::ordered_json{{"needle", how.needle}, {"poses", needle.poses.size()}}.dump();
  if (probe != nullptr) {
    header.second =
        SecondHeader{SecondRole::probe,
                     nlohmann::ordered_json{{"device", "tracked " + how.probe}, {"driver", "recording"}}.dump()};
  }
  PoseImportResult result;
  result.poses = needle.poses.size();
  for (std::size_t i = 1; i < needle.poses.size(); ++i)
    result.longest_gap = std::max(result.longest_gap, needle.poses[i].time - needle.poses[i - 1].time);
  const double begin = needle.poses.front().time, duration = needle.poses.back().time - begin;
  simulation::HapticTick tick(patient);
  SessionWriter writer(how.output, header, how.overwrite);
  const auto ticks = static_cast<std::uint64_t>(std::floor(duration / header.dt + 1e-6)) + 1;
  double next_sample = 0.0;
  for (std::uint64_t number = 0; number < ticks; ++number) {
    const double time = static_cast<double>(number) * header.dt;
    simulation::TickRecord record;
    record.tick = number;
    record.input.needle = with_other_axes(needle.at(begin + time));
    record.input.needle.linear() = record.input.needle.linear() * how.tool;
    record.output = tick.step(record.input);
    writer.append(record);
    if (probe != nullptr && time >= next_sample - 1e-9) {
      next_sample = time + probe_interval;
      writer.append(sample_at(*probe, time, begin));
      ++result.samples;
    }
    constexpr std::uint64_t show_every = 4096;  // ticks
    if (progress && number % show_every == 0)
      progress("following the recorded needle", static_cast<double>(number) / static_cast<double>(ticks));
  }
  writer.finish();
  result.ticks = ticks;
  return result;
}

}  // namespace bodkin::session
