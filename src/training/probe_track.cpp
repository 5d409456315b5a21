#include "training/probe_track.h"

namespace bodkin::training {

namespace {

constexpr double moment_interval = 0.01;  // s, that of a second hand
constexpr double time_rounding = 1e-9;    // s

// A second hand's tool: third axis out of its tip, the slice in its first and third.
ProbeMoment moment_of(const session::SecondSample& sample) {
  return {sample.time, sample.position, sample.rotation * Vec3::UnitZ(), sample.rotation * Vec3::UnitY()};
}

// The probe's own frame: second axis into the patient, the slice in its first and second.
ProbeMoment moment_of(const session::ScanSample& sample, double time) {
  const Mat3 axes = sample.probe.linear();
  return {time, sample.probe.translation(), axes.col(1), axes.col(2)};
}

}  // namespace

std::vector<ProbeMoment> probe_track(const session::Session& session) {
  std::vector<ProbeMoment> track;
  if (session.header.second && session.header.second->role == session::SecondRole::probe) {
    track.reserve(session.second.size());
    for (const session::SecondSample& sample : session.second) track.push_back(moment_of(sample));
    return track;
  }
  if (session.scans.empty() || session.ticks.empty()) return track;
  const double end = static_cast<double>(session.ticks.back().tick) * session.header.dt;
  const double begin = session.scans.front().time;
  auto now = session.scans.begin();
  for (double moment = 0.0; begin + moment * moment_interval <= end + time_rounding; ++moment) {
    const double time = begin + moment * moment_interval;
    while (now + 1 != session.scans.end() && (now + 1)->time <= time + time_rounding) ++now;
    track.push_back(moment_of(*now, time));
  }
  return track;
}

}  // namespace bodkin::training
