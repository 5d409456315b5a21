#include "imaging/ultrasound_screen/screen.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "imaging/ultrasound_screen/drawing.h"

namespace bodkin::imaging {

namespace {

using Place2 = Eigen::Vector2d;

constexpr double left_margin = 112.0, right_margin = 58.0, top_margin = 34.0, bottom_margin = 14.0;  // pixels
constexpr std::uint32_t scale_ink = 0x96A0AC, plain_ink = 0xE8EEF5, faint_ink = 0x8E9CAE, warning_ink = 0xF5B942,
                        caliper_ink = 0xFFD84D, marker_ink = 0x4CC2FF, mark_ink = 0x46C878, focus_ink = 0xF5B942;
constexpr double letter_size = 13.0, base_line = 13.0;     // pixels; from the upper edge of a line of words
constexpr double line_height = 19.0;                       // pixels
constexpr int least_width = 200, least_height = 150;       // pixels
constexpr int grey_bar_width = 10, grey_bar_height = 120;  // pixels
constexpr int room_for_words = 250, least_grey_bar = 40;   // pixels

void require_place(bool empty, const Place2& place) {
  if (empty) throw InputError("there is no picture to measure in");
  if (!place.allFinite()) throw InputError("the place to measure is not finite, expected mm in the probe's frame");
}

}  // namespace

UltrasoundScreen::UltrasoundScreen(int width, int height, OrientationMarkerSide mark)
    : width_(std::max(width, least_width)), height_(std::max(height, least_height)), mark_(mark) {}

void UltrasoundScreen::resize(int width, int height) {
  width_ = std::max(width, least_width);
  height_ = std::max(height, least_height);
}

void UltrasoundScreen::take(const ScanState& moment) {
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
  if (mark_ == OrientationMarkerSide::left) at.x() = frame.width - 1 - at.x();
  const Box where = box();
  return Place2(where.x, where.y) + where.scale * (at + Place2::Constant(0.5));
}

Place2 UltrasoundScreen::to_probe(const Place2& pixel) const {
  const UltrasoundFrame& frame = moment_.frame;
  const Box where = box();
  Place2 at = (pixel - Place2(where.x, where.y)) / where.scale - Place2::Constant(0.5);
  if (mark_ == OrientationMarkerSide::left) at.x() = frame.width - 1 - at.x();
  return frame.corner.head<2>() + frame.pixel * at;
}

bool UltrasoundScreen::holds(const Place2& pixel) const {
  if (empty()) return false;
  const Box where = box();
  const Place2 at = (pixel - Place2(where.x, where.y)) / where.scale;
  return at.x() >= 0.0 && at.y() >= 0.0 && at.x() < moment_.frame.width && at.y() < moment_.frame.height;
}

Canvas UltrasoundScreen::overlay() const {
  Canvas canvas(width_, height_);
  if (empty()) return canvas;
  draw_scale(canvas);
  draw_measurements(canvas);
  draw_words(canvas);
  return canvas;
}

ImageRgb UltrasoundScreen::compose() const {
  ImageRgb image(width_, height_);
  if (empty()) return image;
  const Box where = box();
  paste_grey(image, moment_.frame, mark_, where.x, where.y, where.scale);
  overlay().draw_over(image);
  return image;
}

void UltrasoundScreen::draw_scale(Canvas& canvas) const {
  const Box where = box();
  const UltrasoundFrame& frame = moment_.frame;
  const double x = where.x + where.scale * frame.width + 8.0;
  const int between = centimetres_between_numbers(moment_.settings.depth);
  const int last = static_cast<int>(std::floor(moment_.settings.depth / 10.0 + 1e-9));
  for (int centimetre = 0; centimetre <= last; ++centimetre) {
    const double y = to_screen({0.0, 10.0 * centimetre}).y();
    if (y > height_ - 4.0) break;
    const bool numbered = centimetre > 0 && centimetre % between == 0;
    canvas.stroke(Path::segment({x, y}, {x + (centimetre % between == 0 ? 9.0 : 5.0), y}), {scale_ink});
    if (numbered)
      canvas.text({x + 13.0, y + 5.0}, std::to_string(centimetre), {.size = letter_size, .ink = faint_ink});
  }
  canvas.text({x, where.y - 9.0}, "cm", {.size = letter_size, .ink = faint_ink});
  const double focus = to_screen({0.0, moment_.settings.focus}).y();
  if (focus > where.y && focus < height_ - 4.0)
    canvas.fill(Path::polygon({{x - 1.0, focus}, {x + 6.0, focus - 4.2}, {x + 6.0, focus + 4.2}}), focus_ink);
  // The probe's mark, above the picture on its marked side.
  const double mark_x =
      mark_ == OrientationMarkerSide::left ? where.x + 12.0 : where.x + where.scale * frame.width - 12.0;
  canvas.fill(Path::circle({mark_x, where.y - 14.0}, 6.0), mark_ink);
  // Below the machine's text, if the screen is high enough for both.
  const int bar_height = std::min(grey_bar_height, height_ - room_for_words);
  if (bar_height < least_grey_bar) return;
  canvas.image(grey_ramp(grey_bar_width, bar_height), 16.0, height_ - bar_height - 14.0, grey_bar_width, bar_height);
}

void UltrasoundScreen::draw_measurements(Canvas& canvas) const {
  const auto cross = [&canvas](const Place2& at, double half, std::uint32_t ink) {
    canvas.stroke(Path::cross(at, half), {ink, 1.5});
  };
  for (std::size_t i = 0; i < calipers_.size(); ++i) {
    const Place2 from = to_screen(calipers_[i].from), to = to_screen(calipers_[i].to);
    canvas.stroke(Path::segment(from, to), {caliper_ink, 1.0, {2.0, 3.0}});
    cross(from, 6.0, caliper_ink);
    cross(to, 6.0, caliper_ink);
    canvas.text({to.x() + 9.0, to.y() + 5.0}, std::to_string(i + 1),
                {.size = letter_size, .ink = caliper_ink, .halo = true});
  }
  if (measuring_) cross(to_screen(first_), 6.0, caliper_ink);
  for (const ImageMarker& marker : markers_) {
    const Place2 at = to_screen(marker.place);
    cross(at, 4.0, marker_ink);
    canvas.text({at.x() + 8.0, at.y() + 5.0}, marker.name, {.size = letter_size, .ink = marker_ink, .halo = true});
  }
}

void UltrasoundScreen::draw_words(Canvas& canvas) const {
  const Box where = box();
  const UltrasoundFrame& frame = moment_.frame;
  const double right = where.x + where.scale * frame.width, bottom = where.y + where.scale * frame.height;
  const double middle = 0.5 * (where.x + right), above = where.y - 10.0;
  const auto say = [&canvas](double x, double y, const std::string& words, std::uint32_t ink,
                             TextAnchor anchor = TextAnchor::start) {
    canvas.text({x, y}, words, {.size = letter_size, .ink = ink, .anchor = anchor});
  };
  double y = where.y + base_line;
  for (const std::string& line : machine_lines(moment_)) {
    say(12.0, y, translated(line), y > where.y + base_line ? faint_ink : plain_ink);
    y += line_height;
  }
  for (std::size_t i = 0; i < calipers_.size(); ++i)
    say(12.0, y + 8.0 + line_height * static_cast<double>(i),
        fmt::format("{}: {:.1f} mm", i + 1, calipers_[i].length()), caliper_ink);
  const Vec3 side = (mark_ == OrientationMarkerSide::left ? -1.0 : 1.0) * moment_.pose.linear().col(0);
  if (side.allFinite()) {
    say(where.x + 26.0, above, direction_letters(-side), plain_ink);
    say(right - 26.0, above, direction_letters(side), plain_ink, TextAnchor::end);
  }
  if (frozen_) say(middle, above, translated("FROZEN"), caliper_ink, TextAnchor::middle);
  if (frame.why != NoImage::none)
    say(middle, 0.5 * (where.y + bottom) + 5.0, translated(std::string(reason(frame.why))), warning_ink,
        TextAnchor::middle);
}

std::vector<std::string> machine_lines(const ScanState& moment, bool touch) {
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

}  // namespace bodkin::imaging
