#include "report/probe_figures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "imaging/ultrasound_screen/scan_field.h"

namespace bodkin::report {

namespace {

constexpr double face_step = 0.5;            // mm between the points of the drawn way, to smooth trembling
constexpr double panel_pixels = 620.0;       // of a panel, along a side
constexpr double room_about = 8.0;           // mm around the probe's view
constexpr double largest_side = 260.0;       // mm
constexpr double unknown_half_width = 20.0;  // mm, of a slice without edges
constexpr double beyond_target = 15.0;       // mm, of the same

Vec3 marked_side(const training::ProbeState& probe) {
  return probe.into.cross(probe.normal);
}

}  // namespace

ProbeFigures::ProbeFigures(const session::Session& session)
    : session_(session), track_(training::probe_track(session)) {
  if (!session.ticks.empty()) start_ = static_cast<double>(session.ticks.front().tick) * session.header.dt;
}

const training::ProbeState& ProbeFigures::at(double time) const {
  const auto after =
      std::upper_bound(track_.begin(), track_.end(), time + start_,
                       [](double wanted, const training::ProbeState& probe) { return wanted < probe.time; });
  return after == track_.begin() ? track_.front() : *(after - 1);
}

std::vector<Vec3> ProbeFigures::face_path() const {
  std::vector<Vec3> path;
  for (const training::ProbeState& probe : track_)
    if (path.empty() || (probe.face - path.back()).norm() >= face_step) path.push_back(probe.face);
  return path;
}

std::string ProbeFigures::sentence(const training::Score& score) const {
  const training::ProbeState& first = track_.front();
  double moved = 0.0, turned = 0.0;
  const std::vector<Vec3> face = face_path();
  for (std::size_t i = 1; i < face.size(); ++i) moved += (face[i] - face[i - 1]).norm();
  for (const training::ProbeState& probe : track_) {
    Mat3 then, now;
    then << marked_side(first), first.into, first.normal;
    now << marked_side(probe), probe.into, probe.normal;
    const Mat3 turn = then.transpose() * now;
    turned = std::max(turned, std::acos(std::clamp(0.5 * (turn.trace() - 1.0), -1.0, 1.0)) / degree);
  }
  std::string text =
      fmt::format("The probe moved by {:.0f} mm and turned by up to {:.0f} deg from where it began.", moved, turned);
  const auto value = [&](const char* metric) {
    const training::MetricResult* found = score.find(metric);
    return found != nullptr ? std::optional(found->value) : std::nullopt;
  };
  if (const auto shown = value("target_shown_first_s")) {
    text += fmt::format(" It first showed the target after {:.1f} s.", *shown);
  } else {
    text += " It never showed the target.";
  }
  const auto seen = value("tip_in_slice_percent"), away = value("tip_to_slice_mean_mm"),
             angle = value("needle_to_slice_deg");
  if (seen && away && angle) {
    text += fmt::format(
        " With the needle in the body, the tip was in the slice for {:.0f} % of the time, {:.1f} mm from it in the "
        "mean, and the needle stood at {:.1f} deg to it.",
        *seen, *away, *angle);
  }
  return text;
}

std::vector<Vec3> ProbeFigures::outline(const training::ProbeState& probe) const {
  const Vec3 across = marked_side(probe);
  std::vector<Vec3> border;
  if (const auto& machine = session_.header.ultrasound) {
    for (const Eigen::Vector2d& corner : imaging::field_of_view(*machine, probe.reach))
      border.emplace_back(probe.face + corner.x() * across + corner.y() * probe.into);
    return border;
  }
  const double deep = std::max(0.0, (session_.header.path.target - probe.face).dot(probe.into)) + beyond_target;
  for (const auto& [x, y] : {std::pair(-1.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {-1.0, 1.0}})
    border.emplace_back(probe.face + x * unknown_half_width * across + y * deep * probe.into);
  return border;
}

std::vector<imaging::SlicePanel> ProbeFigures::panels(const anatomy::Case& patient,
                                                      const std::vector<Moment>& moments,
                                                      const std::vector<Vec3>& travelled) const {
  std::vector<imaging::SlicePanel> panels;
  for (const Moment& moment : moments) {
    const training::ProbeState& probe = at(moment.time);
    imaging::SlicePanel panel;
    panel.outline = outline(probe);
    panel.path = session_.header.path;
    panel.travelled = travelled;
    panel.title = "slice of the probe " + moment.words;
    // A square around its content, with the planned path.
    imaging::SlicePlane& plane = panel.slice.plane;
    plane.right = marked_side(probe);
    plane.down = probe.into;
    Eigen::Array2d low = Eigen::Array2d::Constant(1e9), high = -low;
    std::vector<Vec3> shown = panel.outline;
    shown.push_back(session_.header.path.entry);
    shown.push_back(session_.header.path.target);
    for (const Vec3& point : shown) {
      const Vec3 from_face = point - probe.face;
      const Eigen::Array2d place(from_face.dot(plane.right), from_face.dot(plane.down));
      low = low.min(place);
      high = high.max(place);
    }
    const double side = std::min(largest_side, (high - low).maxCoeff() + 2.0 * room_about);
    const Eigen::Array2d corner = 0.5 * (low + high) - 0.5 * side;
    plane.corner = probe.face + corner.x() * plane.right + corner.y() * plane.down;
    plane.pixel = side / panel_pixels;
    plane.width = plane.height = static_cast<int>(panel_pixels);
    panel.slice = imaging::cut(plane, patient.ct, patient.tissues);
    panels.push_back(std::move(panel));
  }
  return panels;
}

ProbePath ProbeFigures::path(double time) const {
  return {.face = face_path(), .slice = outline(at(time))};
}

}  // namespace bodkin::report
