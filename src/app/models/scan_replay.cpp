#include "app/models/scan_replay.h"

#include <algorithm>

#include "imaging/ultrasound/acoustic_volume.h"
#include "imaging/ultrasound_screen/scan_field.h"

namespace bodkin::app {

std::optional<std::size_t> scan_at(const session::Session& session, double time) {
  if (session.scans.empty()) return std::nullopt;
  const auto after =
      std::upper_bound(session.scans.begin(), session.scans.end(), time,
                       [](double wanted, const session::ScanSample& sample) { return wanted < sample.time; });
  return after == session.scans.begin() ? 0 : static_cast<std::size_t>(after - session.scans.begin()) - 1;
}

std::vector<Vec3> scan_border(const session::Session& session, std::size_t sample) {
  std::vector<Vec3> border;
  if (!session.header.ultrasound || sample >= session.scans.size()) return border;
  const session::ScanSample& now = session.scans[sample];
  for (const Eigen::Vector2d& corner : imaging::field_of_view(*session.header.ultrasound, now.settings.depth))
    border.push_back(now.probe * Vec3(corner.x(), corner.y(), 0.0));
  border.push_back(border.front());
  return border;
}

ScanReplay::ScanReplay(const session::Session& session, const anatomy::Case& patient, const Progress& progress)
    : samples_(session.scans),
      needle_(patient.description.needle),
      machine_(imaging::acoustic_volume(patient, progress), *session.header.ultrasound,
               session.scans.front().settings) {
  for (const anatomy::NeedlePath& left : session.header.left_needles)
    left_.push_back({needle_pose(left.target, left.direction()), needle_});
}

station::UltrasoundChoice ScanReplay::choice(std::size_t sample) const {
  station::UltrasoundChoice choice;
  choice.probe = machine_.probe();
  choice.settings = samples_[sample].settings;
  choice.pose = samples_[sample].probe;
  return choice;
}

const station::LiveImage& ScanReplay::picture(std::size_t sample, const Pose& needle) {
  const bool same = shown_ == sample && picture_.needle && picture_.needle->matrix() == needle.matrix();
  if (same) return picture_;
  const session::ScanSample& now = samples_[sample];
  machine_.set(now.settings);
  picture_.frame = machine_.image(now.probe, imaging::NeedleInUltrasound{needle, needle_}, std::nullopt, left_);
  picture_.setup = {now.probe, now.settings};
  picture_.needle = needle;
  ++picture_.number;
  shown_ = sample;
  return picture_;
}

}  // namespace bodkin::app
