#include "training/probe_track.h"

#include <cmath>

namespace bodkin::training {

namespace {

constexpr double moment_interval = 0.01;  // s, as for a second hand
constexpr double time_rounding = 1e-9;    // s

// A second hand's tool: third axis out of its tip, slice in its first and third.
ProbeState moment_of(const session::SecondSample& sample, double reach) {
  return {sample.time, sample.position, sample.rotation * Vec3::UnitZ(), sample.rotation * Vec3::UnitY(), reach};
}

}  // namespace

// The probe's own frame: second axis into the patient, slice in its first and second.
ProbeState probe_moment(const session::ScanSample& sample, double time) {
  const Mat3 axes = sample.probe.linear();
  return {time, sample.probe.translation(), axes.col(1), axes.col(2), sample.settings.depth};
}

bool is_in_picture(const ProbeState& probe, const anatomy::UltrasoundProbe* machine, const Vec3& point,
                   double thickness) {
  const Vec3 from_face = point - probe.face;
  if (std::abs(from_face.dot(probe.normal)) > thickness) return false;
  const double down = from_face.dot(probe.into);
  if (!(down > 0.0)) return false;
  if (machine == nullptr) return down <= probe.reach;
  const double across = std::abs(from_face.dot(probe.into.cross(probe.normal)));
  switch (machine->kind) {
    case anatomy::ProbeKind::linear:
      return across <= 0.5 * machine->aperture() && down <= probe.reach;
    case anatomy::ProbeKind::curvilinear: {
      // The face is part of a circle around a point behind its middle.
      const double behind = down + machine->radius, away = std::hypot(across, behind) - machine->radius;
      return std::atan2(across, behind) <= 0.5 * machine->aperture() / machine->radius && away > 0.0 &&
             away <= probe.reach;
    }
    case anatomy::ProbeKind::phased:
      break;
  }
  return std::atan2(across, down) <= 0.5 * machine->sector * degree && std::hypot(across, down) <= probe.reach;
}

std::vector<ProbeState> probe_track(const session::Session& session) {
  std::vector<ProbeState> track;
  if (session.header.second && session.header.second->role == session::SecondRole::probe) {
    track.reserve(session.second.size());
    auto now = session.scans.begin();
    for (const session::SecondSample& sample : session.second) {
      while (now != session.scans.end() && now + 1 != session.scans.end() && (now + 1)->time <= sample.time) ++now;
      const bool is_set = now != session.scans.end();
      const double shown = session.header.ultrasound ? session.header.ultrasound->depth : unbounded;
      track.push_back(moment_of(sample, is_set ? now->settings.depth : shown));
    }
    return track;
  }
  if (session.scans.empty() || session.ticks.empty()) return track;
  const double end = static_cast<double>(session.ticks.back().tick) * session.header.dt;
  const double begin = session.scans.front().time;
  auto now = session.scans.begin();
  for (double moment = 0.0; begin + moment * moment_interval <= end + time_rounding; ++moment) {
    const double time = begin + moment * moment_interval;
    while (now + 1 != session.scans.end() && (now + 1)->time <= time + time_rounding) ++now;
    track.push_back(probe_moment(*now, time));
  }
  return track;
}

}  // namespace bodkin::training
