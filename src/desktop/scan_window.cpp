#include "desktop/scan_window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "desktop/machine_view.h"
#include <fmt/format.h>

#include "imaging/ultrasound_screen/scan_field.h"

namespace bodkin::desktop {

namespace {

using Size = SdlScreen::Size;
using Align = SdlScreen::Align;

constexpr int scan_width = 1280, scan_height = 660;  // pixels
constexpr double machine_x = 12.0, machine_y = 52.0, ct_x = 824.0, ct_y = 88.0;
constexpr int machine_wide = 800, machine_high = 556;
constexpr double ct_wide = 444.0, ct_high = 333.0;
constexpr double key_row = 17.0;
constexpr double keys_y = ct_y + ct_high + 22.0;  // or the sliders in their place
constexpr double sliders_left = ct_x + 130.0, sliders_wide = 220.0;
constexpr int way_pieces = 24;         // of a needle's way
constexpr double near_ct_plane = 2.0;  // mm
constexpr double ct_pixel_most = 1.0;  // mm; twice the ultrasound's is fine enough

constexpr Colour scan_black{0, 0, 0}, scan_panel{16, 20, 27}, scan_ink{232, 238, 245}, scan_faint{142, 156, 174},
    scan_warn{245, 185, 66}, scan_yellow{255, 216, 77}, scan_blue{76, 194, 255}, scan_teal{55, 224, 200};

constexpr std::array<std::pair<std::string_view, std::string_view>, 22> scan_help = {{
    {"drag", "slide the probe over the skin"},
    {"I J K L", "slide it too"},
    {"wheel", "press it in, lift it off"},
    {"shift-wheel", "depth"},
    {"D  shift-D", "depth"},
    {"left, right", "rotate the probe on the spot"},
    {"up, down", "tilt: the slice fans"},
    {"shift-left, shift-right", "rock within the slice"},
    {"G  shift-G", "gain"},
    {"R  shift-R", "dynamic range"},
    {"O  shift-O", "focus"},
    {"Q  shift-Q", "frequency"},
    {"T", "sliders of the time-gain compensation"},
    {"1 to 8, with shift", "a slider up, down; so do mouse and wheel"},
    {"0", "all sliders to the middle"},
    {"N", "needle in or out of the patient"},
    {"page down, page up", "needle deeper, shallower"},
    {"F, space", "freeze"},
    {"C", "calipers: two clicks each"},
    {"M", "mark the place under the pointer"},
    {"X", "clear calipers and marks"},
    {"S", "save the picture"},
}};

// The same in few words, always in sight.
constexpr std::array<std::pair<std::string_view, std::string_view>, 16> scan_keys = {{
    {"drag, I J K L", "slide"},
    {"wheel", "press"},
    {"left right", "rotate"},
    {"up down", "tilt"},
    {"shift-left right", "rock"},
    {"N, page keys", "needle"},
    {"F", "freeze"},
    {"?", "all keys"},
    {"D", "depth"},
    {"G", "gain"},
    {"R", "dynamic range"},
    {"O", "focus"},
    {"Q", "frequency"},
    {"T, 1 to 8", "TGC sliders"},
    {"C M X", "measure"},
    {"S", "save"},
}};

bool same_plane(const imaging::SlicePlane& a, const imaging::SlicePlane& b) {
  return a.corner == b.corner && a.right == b.right && a.down == b.down && a.pixel == b.pixel && a.width == b.width &&
         a.height == b.height;
}

}  // namespace

ScanWindow::ScanWindow(const anatomy::Case& patient, imaging::MarkSide mark)
    : patient_(patient),
      mark_(mark),
      screen_("Bodkin: ultrasound of " + patient.description.name, scan_width, scan_height) {}

station::LiveScan::Place ScanWindow::machine_place() {
  return {machine_x, machine_y, machine_wide, machine_high, sliders_left, keys_y + 22.0, sliders_wide};
}

void ScanWindow::draw(const station::LiveScan& scan, const ScanPace& pace) {
  screen_.clear(scan_panel);
  screen_.text(24.0, 14.0, patient_.description.name, Size::large, scan_ink);
  draw_machine(screen_, machine_place(), scan.screen());
  draw_ct(scan);
  if (scan.sliders_shown()) {
    draw_gain(scan);
  } else {
    draw_keys();
  }
  draw_foot(scan, pace);
  if (scan.help()) draw_help();
  screen_.present();
}

void ScanWindow::draw_gain(const station::LiveScan& scan) {
  screen_.text(ct_x + 16.0, keys_y, "Time-gain compensation: 1 to 8, mouse, wheel; T closes", Size::small,
               scan_faint);
  draw_sliders(screen_, machine_place(), scan.settings().sliders, scan.settings().depth);
}

void ScanWindow::draw_ct(const station::LiveScan& scan) {
  screen_.fill(ct_x, machine_y, ct_wide, machine_high, scan_black);
  screen_.text(ct_x + 0.5 * ct_wide, machine_y + 10.0, "CT, the same plane", Size::small, scan_faint, Align::middle);
  if (scan.screen().empty()) return;
  const imaging::ScanMoment& moment = scan.screen().moment();
  if (!moment.pose.matrix().allFinite()) return;
  imaging::SlicePlane plane = imaging::plane_of(moment.frame, moment.pose, mark_);
  const int coarse = std::max(1, static_cast<int>(std::floor(ct_pixel_most / plane.pixel)));
  plane.corner += 0.5 * (coarse - 1) * plane.pixel * (plane.right + plane.down);
  plane.width = std::max(1, plane.width / coarse);
  plane.height = std::max(1, plane.height / coarse);
  plane.pixel *= coarse;
  if (!same_plane(plane, ct_plane_)) {
    ct_ = imaging::paint(imaging::cut(plane, patient_.ct, patient_.tissues), patient_.library);
    ct_plane_ = plane;
  }
  draw_ct_lines(scan);
}

void ScanWindow::draw_ct_lines(const station::LiveScan& scan) {
  const double scale = std::min(ct_wide / ct_.width, ct_high / ct_.height);
  const double wide = scale * ct_.width, high = scale * ct_.height;
  const double left = ct_x + 0.5 * (ct_wide - wide);
  screen_.picture(left, ct_y, wide, high, ct_);
  const auto spot = [&](const Vec3& point) -> Eigen::Vector2f {
    const Eigen::Vector2d at =
        Eigen::Vector2d(left, ct_y) + scale * (ct_plane_.place(point) + Eigen::Vector2d::Constant(0.5));
    return at.cwiseMax(Eigen::Vector2d(left, ct_y)).cwiseMin(Eigen::Vector2d(left + wide, ct_y + high)).cast<float>();
  };
  const imaging::ScanMoment& moment = scan.screen().moment();
  std::vector<Eigen::Vector2f> points;
  for (const Eigen::Vector2d& corner : imaging::field_of_view(moment.probe, moment.settings.depth)) {
    points.push_back(spot(moment.pose * Vec3(corner.x(), corner.y(), 0.0)));
  }
  points.push_back(points.front());
  screen_.line(points, scan_blue);
  // Solid where it is near the plane, dashed elsewhere.
  const auto way = [&](const Vec3& from, const Vec3& to, Colour colour) {
    std::vector<Eigen::Vector2f> pieces;
    for (int i = 0; i < way_pieces; ++i) {
      const Vec3 begin = from + (to - from) * i / way_pieces, end = from + (to - from) * (i + 1) / way_pieces;
      if (i % 2 != 0 && std::abs(ct_plane_.distance(begin)) > near_ct_plane) continue;
      const Eigen::Vector2d place = ct_plane_.place(begin);
      if (place.minCoeff() < 0.0 || place.x() > ct_plane_.width || place.y() > ct_plane_.height) continue;
      pieces.push_back(spot(begin));
      pieces.push_back(spot(end));
    }
    screen_.segments(pieces, colour);
  };
  if (const std::optional<anatomy::NeedlePath>& path = patient_.description.procedure.path) {
    way(path->entry, path->target, scan_yellow);
    if (const auto needle = scan.needle()) way(path->entry, needle->pose.translation(), scan_teal);
  }
  // On a dark ground, for bone is white.
  const auto letters = [&](double x, double y, const Vec3& direction) {
    screen_.fill(x - 14.0, y, 28.0, 20.0, scan_panel);
    screen_.text(x, y, imaging::direction_letters(direction), Size::normal, scan_ink, Align::middle);
  };
  letters(left + 16.0, ct_y + 0.5 * high - 10.0, -ct_plane_.right);
  letters(left + wide - 16.0, ct_y + 0.5 * high - 10.0, ct_plane_.right);
  letters(left + wide - 16.0, ct_y + 2.0, -ct_plane_.down);
  letters(left + wide - 16.0, ct_y + high - 22.0, ct_plane_.down);
}

void ScanWindow::draw_keys() {
  constexpr double top = keys_y;
  constexpr std::size_t rows = scan_keys.size() / 2;
  for (std::size_t i = 0; i < scan_keys.size(); ++i) {
    const double x = ct_x + (i < rows ? 16.0 : 236.0), y = top + key_row * static_cast<double>(i % rows);
    screen_.text(x, y, std::string(scan_keys[i].first), Size::small, scan_ink);
    screen_.text(x + (i < rows ? 128.0 : 68.0), y, std::string(scan_keys[i].second), Size::small, scan_faint);
  }
}

void ScanWindow::draw_foot(const station::LiveScan& scan, const ScanPace& pace) {
  constexpr double y = scan_height - 36.0;
  const std::string words = !scan.message().empty() ? scan.message()
                            : scan.measuring()      ? "Calipers: click two places; C again to move the probe"
                                               : "? explains the keys, Escape ends; with shift a knob turns back";
  screen_.text(24.0, y, words, Size::normal, scan.message().empty() ? scan_faint : scan_warn);
  screen_.text(scan_width - 24.0, y, fmt::format("{:.1f} ms a picture, {:.0f} frames/s", pace.picture, pace.frames),
               Size::normal, scan_faint, Align::right);
}

void ScanWindow::draw_help() {
  constexpr double x = 330.0, y = 22.0, wide = 620.0, row = 25.0;
  screen_.fill(x, y, wide, 70.0 + row * static_cast<double>(scan_help.size()), {30, 38, 50});
  screen_.text(x + 24.0, y + 16.0, "Keys", Size::large, scan_ink);
  double at = y + 58.0;
  for (const auto& [keys, what] : scan_help) {
    screen_.text(x + 24.0, at, std::string(keys), Size::normal, scan_yellow);
    screen_.text(x + 250.0, at, std::string(what), Size::normal, scan_ink);
    at += row;
  }
}

}  // namespace bodkin::desktop
