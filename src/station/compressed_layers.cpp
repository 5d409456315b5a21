#include "station/compressed_layers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bodkin::station {

namespace {

constexpr double least_layer_press = 0.1;  // mm; less moves no tissue
constexpr int pressed_lines = 65;

}  // namespace

CompressedLayers::CompressedLayers(std::shared_ptr<const imaging::AcousticVolume> patient,
                                   anatomy::UltrasoundProbe probe)
    : patient_(std::move(patient)), probe_(std::move(probe)) {
  settings_.depth = 0.0;
  detail_.lines = pressed_lines;
  gap_.resize(pressed_lines);
  by_line_.resize(pressed_lines);
}

void CompressedLayers::settle(const Pose& pose, double depth, bool gel) {
  if (depth != settings_.depth) {
    settings_.depth = depth;
    lines_ = imaging::scan_lines(probe_, settings_, detail_);
    origins_.clear();
    directions_.clear();
    for (int line = 0; line < lines_.lines; ++line) {
      origins_.push_back(lines_.origin(line));
      directions_.push_back(lines_.direction(line));
    }
  }
  pose_ = pose;
  const imaging::FaceContact contact =
      imaging::face_contact(*patient_, origins_, directions_, pose, gel, gap_, by_line_);
  press_ = contact.why == imaging::NoImage::none && contact.press >= least_layer_press ? contact.press : 0.0;
  if (press_ > 0.0) compression_.settle(*patient_, pose, press_);
}

Vec3 CompressedLayers::moved(const Vec3& place) const noexcept {
  if (press_ <= 0.0) return Vec3::Zero();
  const Eigen::Vector2d at = lines_.place(place);
  const double line = std::clamp(at.x(), 0.0, lines_.lines - 1.0);
  const double depth = std::max(at.y() * lines_.spacing, 0.0);
  const int left = std::min(static_cast<int>(line), lines_.lines - 2);
  const double part = line - left;
  const double press = (1.0 - part) * static_cast<double>(by_line_[static_cast<std::size_t>(left)]) +
                       part * static_cast<double>(by_line_[static_cast<std::size_t>(left) + 1]);
  return compression_.moved(depth) / press_ * press * (pose_.linear() * lines_.direction(line));
}

}  // namespace bodkin::station
