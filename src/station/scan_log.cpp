#include "station/scan_log.h"

#include <utility>

#include "station/hand_session.h"

namespace bodkin::station {

namespace {
constexpr double shortest_interval = 0.01;  // s between samples, as of a second hand
}  // namespace

ScanLog::ScanLog(std::shared_ptr<const anatomy::Case> patient, const anatomy::UltrasoundProbe& probe)
    : patient_(std::move(patient)), search_(*patient_, probe) {}

void ScanLog::follow(const LiveImage& picture, std::uint64_t ticks, HandSession& session) {
  const bool is_new = ticks > 0 && picture.number > 0 && picture.number != picture_;
  if (!is_new || !picture.setup.probe.matrix().allFinite()) return;
  const double time = static_cast<double>(ticks - 1) / patient_->description.haptics.rate;
  const ScanSetup& now = picture.setup;
  const bool same = last_ && last_->probe.matrix() == now.probe.matrix() && last_->settings == now.settings;
  if (last_ && !same && time - time_ < shortest_interval) return;
  picture_ = picture.number;
  if (same) return;
  last_ = now;
  time_ = time;
  session.note(session::ScanSample{time, now.probe, now.settings});
  record_parts(now, time, session);
}

void ScanLog::record_parts(const ScanSetup& now, double time, HandSession& session) {
  imaging::ScannedParts found;
  search_.add(now.probe, now.settings, found);
  for (const session::ScannedPart& part : session::newly_scanned(found, seen_, *patient_, time)) session.note(part);
}

}  // namespace bodkin::station
