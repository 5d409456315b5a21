#include "imaging/ultrasound_screen/screen.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "imaging/ultrasound_screen/drawing.h"

namespace bodkin {

namespace {

using Place2 = Eigen::Vector2d;

constexpr double left_margin = 112.0, right_margin = 58.0, top_margin = 34.0, bottom_margin = 14.0;  // pixels
constexpr Rgb scale_ink{150, 160, 172}, caliper_ink{255, 216, 77}, marker_ink{76, 194, 255}, mark_ink{70, 200, 120},
    focus_ink{245, 185, 66};
constexpr double grey_bar_width = 10.0, grey_bar_height = 120.0;  // pixels

void require_place(bool empty, const Place2& place) {
  if (empty) throw InputError("there is no picture to measure in");
  if (!place.allFinite()) throw InputError("the place to measure is not finite, expected mm in the probe's frame");
}

}  // namespace

UltrasoundScreen::UltrasoundScreen(int width, int height, MarkSide mark)
    : width_(std::max(width, 200)), height_(std::max(height, 150)), mark_(mark) {}

void UltrasoundScreen::take(const ScanMoment& moment) {
  if (!frozen_) moment_ = moment;
}

void UltrasoundScreen::freeze(bool frozen) {
  if (frozen_ && !frozen) clear_measurements();
  frozen_ = frozen;
}

void UltrasoundScreen::measure(const Place2& place) {
  require_place(empty(), place);
  if (measuring_) {
    calipers_.push_back({first_, place});
  } else {
    first_ = place;
  }
  measuring_ = !measuring_;
}

void UltrasoundScreen::mark(const Place2& place, const std::string& name) {
  require_place(empty(), place);
  markers_.push_back({place, name});
}

void UltrasoundScreen::clear_measurements() {
  calipers_.clear();
  markers_.clear();
  measuring_ = false;
}

UltrasoundScreen::Box UltrasoundScreen::box() const {
  const double wide = width_ - left_margin - right_margin, high = height_ - top_margin - bottom_margin;
  const UltrasoundFrame& frame = moment_.frame;
  if (frame.width < 1 || frame.height < 1) return {left_margin, top_margin, 1.0};
  const double scale = std::min(wide / frame.width, high / frame.height);
  return {left_margin + 0.5 * (wide - scale * frame.width), top_margin, scale};
}

// A pixel of the frame covers `scale` pixels of the screen, its centre half a pixel in.
Place2 UltrasoundScreen::to_screen(const Place2& place) const {
  const UltrasoundFrame& frame = moment_.frame;
  Place2 at = (place - frame.corner.head<2>()) / frame.pixel;
  if (mark_ == MarkSide::left) at.x() = frame.width - 1 - at.x();
  const Box where = box();
  return Place2(where.x, where.y) + where.scale * (at + Place2::Constant(0.5));
}

Place2 UltrasoundScreen::to_probe(const Place2& pixel) const {
  const UltrasoundFrame& frame = moment_.frame;
  const Box where = box();
  Place2 at = (pixel - Place2(where.x, where.y)) / where.scale - Place2::Constant(0.5);
  if (mark_ == MarkSide::left) at.x() = frame.width - 1 - at.x();
  return frame.corner.head<2>() + frame.pixel * at;
}

bool UltrasoundScreen::holds(const Place2& pixel) const {
  if (empty()) return false;
  const Box where = box();
  const Place2 at = (pixel - Place2(where.x, where.y)) / where.scale;
  return at.x() >= 0.0 && at.y() >= 0.0 && at.x() < moment_.frame.width && at.y() < moment_.frame.height;
}

ImageRgb UltrasoundScreen::compose() const {
  ImageRgb image(width_, height_);
  if (empty()) return image;
  draw_frame(image);
  draw_scale(image);
  draw_measurements(image);
  return image;
}

void UltrasoundScreen::draw_frame(ImageRgb& image) const {
  const Box where = box();
  const UltrasoundFrame& frame = moment_.frame;
  paste_grey(image, frame, mark_, where.x, where.y, where.scale);
}

void UltrasoundScreen::draw_scale(ImageRgb& image) const {
  const Box where = box();
  const UltrasoundFrame& frame = moment_.frame;
  const double x = where.x + where.scale * frame.width + 8.0;
  const int between = centimetres_between_numbers(moment_.settings.depth);
  const int last = static_cast<int>(std::floor(moment_.settings.depth / 10.0 + 1e-9));
  for (int centimetre = 0; centimetre <= last; ++centimetre) {
    const double y = to_screen({0.0, 10.0 * centimetre}).y();
    if (y > height_ - 4.0) break;
    draw_line(image, {x, y}, {x + (centimetre % between == 0 ? 9.0 : 5.0), y}, scale_ink);
  }
  const double focus = to_screen({0.0, moment_.settings.focus}).y();
  if (focus > where.y && focus < height_ - 4.0) draw_pointer(image, {x - 1.0, focus}, 7.0, focus_ink);
  // The probe's mark, above the picture on its marked side.
  const double mark_x = mark_ == MarkSide::left ? where.x + 12.0 : where.x + where.scale * frame.width - 12.0;
  draw_disc(image, {mark_x, where.y - 14.0}, 6.0, mark_ink);
  for (int row = 0; row < static_cast<int>(grey_bar_height); ++row) {
    const auto grey = static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - row / (grey_bar_height - 1.0))));
    for (int column = 0; column < static_cast<int>(grey_bar_width); ++column) {
      image.at(16 + column, height_ - static_cast<int>(grey_bar_height) - 14 + row) = {grey, grey, grey};
    }
  }
}

void UltrasoundScreen::draw_measurements(ImageRgb& image) const {
  for (const Caliper& caliper : calipers_) {
    const Place2 from = to_screen(caliper.from), to = to_screen(caliper.to);
    draw_dotted_line(image, from, to, caliper_ink);
    draw_cross(image, from, 6.0, caliper_ink);
    draw_cross(image, to, 6.0, caliper_ink);
  }
  if (measuring_) draw_cross(image, to_screen(first_), 6.0, caliper_ink);
  for (const ImageMarker& marker : markers_) draw_cross(image, to_screen(marker.place), 4.0, marker_ink);
}

std::vector<ScreenWords> UltrasoundScreen::words() const {
  using Role = ScreenWords::Role;
  using Align = ScreenWords::Align;
  std::vector<ScreenWords> all;
  if (empty()) return all;
  const Box where = box();
  const UltrasoundFrame& frame = moment_.frame;
  const double right = where.x + where.scale * frame.width, bottom = where.y + where.scale * frame.height;
  double y = where.y;
  for (const std::string& line : machine_lines(moment_)) {
    all.push_back({12.0, y, line, y > where.y ? Role::faint : Role::plain, Align::left});
    y += 19.0;
  }
  const int between = centimetres_between_numbers(moment_.settings.depth);
  for (int centimetre = between; 10.0 * centimetre <= moment_.settings.depth + 1e-9; centimetre += between) {
    const double at = to_screen({0.0, 10.0 * centimetre}).y();
    if (at < bottom + 4.0)
      all.push_back({right + 21.0, at - 8.0, std::to_string(centimetre), Role::faint, Align::left});
  }
  all.push_back({right + 8.0, where.y - 22.0, "cm", Role::faint, Align::left});
  const Vec3 side = (mark_ == MarkSide::left ? -1.0 : 1.0) * moment_.pose.linear().col(0);
  if (side.allFinite()) {
    all.push_back({where.x + 26.0, where.y - 23.0, direction_letters(-side), Role::plain, Align::left});
    all.push_back({right - 26.0, where.y - 23.0, direction_letters(side), Role::plain, Align::right});
  }
  if (frozen_) all.push_back({0.5 * (where.x + right), where.y - 23.0, "FROZEN", Role::caliper, Align::middle});
  if (frame.why != NoImage::none) {
    all.push_back({0.5 * (where.x + right), 0.5 * (where.y + bottom) - 8.0, std::string(reason(frame.why)),
                   Role::warning, Align::middle});
  }
  for (std::size_t i = 0; i < calipers_.size(); ++i) {
    const Place2 end = to_screen(calipers_[i].to);
    all.push_back({end.x() + 9.0, end.y() - 8.0, fmt::format("{}", i + 1), Role::caliper, Align::left});
    all.push_back({12.0, y + 8.0 + 19.0 * static_cast<double>(i),
                   fmt::format("{}: {:.1f} mm", i + 1, calipers_[i].length()), Role::caliper, Align::left});
  }
  for (const ImageMarker& marker : markers_) {
    const Place2 at = to_screen(marker.place);
    all.push_back({at.x() + 8.0, at.y() - 8.0, marker.name, Role::marker, Align::left});
  }
  return all;
}

std::vector<std::string> machine_lines(const ScanMoment& moment, bool touch) {
  const UltrasoundSettings& set = moment.settings;
  const double frequency = set.frequency > 0.0 ? set.frequency : moment.probe.frequency;
  std::vector<std::string> lines = {moment.probe.name,
                                    fmt::format("{:.1f} MHz", frequency),
                                    fmt::format("D {:.1f} cm", set.depth / 10.0),
                                    fmt::format("G {:+.0f} dB", set.gain),
                                    fmt::format("DR {:.0f} dB", set.dynamic_range),
                                    fmt::format("F {:.1f} cm", set.focus / 10.0)};
  if (touch && moment.frame.why == NoImage::none) {
    lines.push_back(fmt::format("contact {:.0f} %", 100.0 * moment.frame.contact));
    lines.push_back(fmt::format("press {:.1f} mm", moment.frame.press));
  }
  if (!moment.needle.empty()) lines.push_back(moment.needle);
  return lines;
}

int centimetres_between_numbers(double depth) {
  return depth <= 80.0 ? 1 : depth <= 160.0 ? 2 : 5;
}

}  // namespace bodkin
