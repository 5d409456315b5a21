#include "imaging/ultrasound_screen/scanner_image.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "imaging/ultrasound_screen/drawing.h"

namespace bodkin::imaging {

namespace {

constexpr double machine_left = 124.0, machine_right = 62.0, machine_top = 58.0, machine_bottom = 24.0;  // px
constexpr double least_machine_height = 600.0, most_machine_height = 1200.0;                             // px
constexpr double words_height = 40.0, least_caption = 320.0;  // px, for the text about a window; of a real image
constexpr double caption_size = 15.0;                         // px
constexpr std::uint32_t plain_colour = 0xE8EEF5;
constexpr std::uint32_t faint_colour = 0x96A0AC;
constexpr std::uint32_t warning_colour = 0xF5B942;
constexpr std::uint32_t caliper_colour = 0xFFD84D;
constexpr std::uint32_t marker_colour = 0x4CC2FF;
constexpr std::uint32_t track_colour = 0x43505A, mark_colour = 0x46C878;

using Spot = Eigen::Vector2d;

class ScannerArtist {
 public:
  explicit ScannerArtist(const ScannerImage& picture) : picture_(picture), frame_(picture.moment.frame) {
    scale_ =
        std::clamp(static_cast<double>(frame_.height), least_machine_height, most_machine_height) / frame_.height;
  }

  Canvas draw(const anatomy::TissueLibrary& library) {
    double width = right() + machine_right, height = bottom() + machine_bottom;
    const double real_x = width;
    if (picture_.window) height += words_height;
    if (picture_.reference) {
      height = std::max(height, real_bottom() + machine_bottom + words_height);
      width += real_wide() + machine_right;
    }
    const double ct_x = width;
    std::optional<SlicesDrawn> slices;
    if (picture_.ct) {
      slices = draw_slices({*picture_.ct}, library, "", high());
      width += slices->canvas.width();
      height = std::max(height, machine_top - slices->top + slices->canvas.height());
    }
    canvas_.set_size(std::round(width), std::round(height));
    canvas_.fill_all(0x000000);
    header();
    canvas_.image(grey_image(frame_, picture_.mark), machine_left, machine_top, wide(), high());
    left_column();
    depth_scale();
    marked_side();
    measurements();
    if (frame_.why != NoImage::none) why();
    if (picture_.window) {
      window(
          *picture_.window, [this](const Spot& place) { return spot_shown(place); }, machine_left, bottom());
    }
    if (picture_.reference) real(*picture_.reference, real_x);
    if (slices) canvas_.place(std::move(slices->canvas), ct_x, machine_top - slices->top);
    return std::move(canvas_);
  }

 private:
  double wide() const { return scale_ * frame_.width; }
  double high() const { return scale_ * frame_.height; }
  double right() const { return machine_left + wide(); }
  double bottom() const { return machine_top + high(); }

  // px of a place in the probe's frame.
  Spot spot(const Spot& place) const {
    Spot at = (place - frame_.corner.head<2>()) / frame_.pixel;
    if (picture_.mark == OrientationMarkerSide::left) at.x() = frame_.width - 1 - at.x();
    return Spot(machine_left, machine_top) + scale_ * (at + Spot::Constant(0.5));
  }

  // px of a place in the image: mm to the right of its middle and below the face.
  Spot spot_shown(const Spot& place) const {
    return {machine_left + 0.5 * wide() + per_millimetre() * place.x(),
            machine_top + scale_ * ((place.y() - frame_.corner.y()) / frame_.pixel + 0.5)};
  }
  double per_millimetre() const { return scale_ / frame_.pixel; }                             // px
  double real_pixel() const { return per_millimetre() * picture_.reference->picture.pixel; }  // px
  double real_wide() const {
    return std::max({least_caption, text_width(picture_.reference->caption, caption_size),
                     real_pixel() * picture_.reference->picture.width});
  }
  double real_bottom() const { return machine_top + real_pixel() * picture_.reference->picture.height; }

  void words(double x, double y, const std::string& text, std::uint32_t colour, double size,
             TextAnchor anchor = TextAnchor::start) {
    canvas_.text({x, y}, text, {.size = size, .ink = colour, .anchor = anchor});
  }

  void header() {
    words(16.0, 26.0, picture_.patient, plain_colour, caption_size);
    words(right() + machine_right - 14.0, 26.0, "Bodkin, simulated", faint_colour, 12, TextAnchor::end);
  }

  void left_column() {
    double y = machine_top + 14.0;
    for (const std::string& line : machine_lines(picture_.moment, picture_.touch)) {
      const bool first = y < machine_top + 15.0;
      words(16.0, y, line, first ? plain_colour : faint_colour, first ? 17 : 13);
      y += first ? 24.0 : 19.0;
    }
    for (std::size_t i = 0; i < picture_.calipers.size(); ++i) {
      y += i == 0 ? 10.0 : 0.0;
      words(16.0, y, fmt::format("{}: {:.1f} mm", i + 1, picture_.calipers[i].length()), caliper_colour, 13);
      y += 19.0;
    }
    sliders(bottom() - 290.0);
    // The grey scale from white to black.
    const double top = bottom() - 151.0;
    canvas_.image(grey_ramp(12, 150), 16.0, top, 12.0, 150.0);
    canvas_.stroke(Path::rectangle(16.0, top, 12.0, 150.0), {track_colour});
  }

  // The time-gain compensation, if it was changed.
  void sliders(double y) {
    const auto& set = picture_.moment.settings.sliders;
    if (std::all_of(set.begin(), set.end(), [](double value) { return value == 0.0; })) return;
    words(16.0, y, "TGC", faint_colour, 11);
    for (const double value : set) {
      y += 13.0;
      canvas_.stroke(Path::segment({20.0, y}, {80.0, y}), {track_colour});
      canvas_.fill(Path::circle({50.0 + 1.5 * value, y}, 3.5), plain_colour);
    }
  }

  void depth_scale() {
    const UltrasoundSettings& set = picture_.moment.settings;
    const double x = right() + 8.0;
    centimetres(
        x, set.depth,
        [this](double depth) {
          return spot({0.0, depth}).y();
        },
        bottom());
    const double focus = spot({0.0, set.focus}).y();
    if (focus > machine_top && focus < bottom()) {
      canvas_.fill(Path::polygon({{x - 2.0, focus}, {x + 7.0, focus - 5.0}, {x + 7.0, focus + 5.0}}), warning_colour);
    }
  }

  // Marks every half centimetre down to `depth` mm, at most to `last` px.
  template <typename Height>
  void centimetres(double x, double depth, Height&& height, double last) {
    const int between = centimetres_between_numbers(depth);
    words(x, machine_top - 8.0, "cm", faint_colour, 11);
    for (int half = 0; 5.0 * half <= depth + 1e-9; ++half) {
      const double y = height(5.0 * half);
      if (y > last + 1.0) break;
      const bool numbered = half % (2 * between) == 0;
      if (half % 2 != 0 && depth > 120.0) continue;
      const double length = numbered ? 10.0 : (half % 2 == 0 ? 7.0 : 4.0);
      canvas_.stroke(Path::segment({x, y}, {x + length, y}), {faint_colour});
      if (numbered && half > 0) words(x + 15.0, y + 4.5, std::to_string(half / 2), faint_colour, 12);
    }
  }

  void marked_dot(double x) {
    canvas_.fill(Path::circle({x, machine_top - 14.0}, 8.0), mark_colour);
    canvas_.text({x, machine_top - 10.0}, "B", {.size = 11.0, .anchor = TextAnchor::middle, .bold = true});
  }

  // The window in an image, placed by `to_px`, and the text about it below the image.
  template <typename ToPx>
  void window(const WindowMessage& message, ToPx&& to_px, double left, double below) {
    const Spot middle(message.window.across, message.window.depth),
        half(0.5 * message.window.width, 0.5 * message.window.height);
    const Spot from = to_px(middle - half), to = to_px(middle + half);
    canvas_.stroke(Path::rectangle(from.x(), from.y(), to.x() - from.x(), to.y() - from.y()),
                   {caliper_colour, 1.0, {4.0, 3.0}});
    for (const std::string& line : message.words) words(left, below += 18.0, line, caliper_colour, 13);
  }

  // The real image with its left margin at `x`, its scale, its marked side and its origin.
  void real(const ReferenceImage& real, double x) {
    const GreyImage& grey = real.picture;
    const double across = real_pixel() * grey.width, down = real_pixel() * grey.height;
    ImageRgb image(grey.width, grey.height);
    std::transform(grey.pixels.begin(), grey.pixels.end(), image.pixels.begin(), [](std::uint8_t value) {
      return Rgb{value, value, value};
    });
    canvas_.image(std::move(image), x, machine_top, across, down);
    words(x, 26.0, real.caption, plain_colour, caption_size);
    words(real.mark ? x + 26.0 : x, machine_top - 9.0, "real", faint_colour, 12);
    const auto to_px = [&](const Spot& place) {
      return Spot(x + 0.5 * across + per_millimetre() * place.x(),
                  machine_top + real_pixel() * (grey.row(place.y()) + 0.5));
    };
    centimetres(
        x + across + 8.0, grey.top + grey.pixel * grey.height,
        [&to_px](double depth) {
          return to_px({0.0, depth}).y();
        },
        machine_top + down);
    if (real.mark) marked_dot(*real.mark == OrientationMarkerSide::left ? x + 10.0 : x + across - 10.0);
    if (real.window) window(*real.window, to_px, x, machine_top + down);
  }

  void marked_side() {
    const bool left = picture_.mark == OrientationMarkerSide::left;
    marked_dot(left ? machine_left + 10.0 : right() - 10.0);
    const Vec3 to_right = (left ? -1.0 : 1.0) * picture_.moment.pose.linear().col(0);
    if (!to_right.allFinite()) return;
    words(machine_left + (left ? 26.0 : 4.0), machine_top - 9.0, direction_letters(-to_right), plain_colour, 14);
    words(right() - (left ? 4.0 : 26.0), machine_top - 9.0, direction_letters(to_right), plain_colour, 14,
          TextAnchor::end);
  }

  void measurements() {
    for (std::size_t i = 0; i < picture_.calipers.size(); ++i) {
      const Spot from = spot(picture_.calipers[i].from), to = spot(picture_.calipers[i].to);
      canvas_.stroke(Path::segment(from, to), {caliper_colour, 1.0, {2.0, 3.0}});
      for (const Spot& end : {from, to}) canvas_.stroke(Path::cross(end, 6.0), {caliper_colour, 1.5});
      words(to.x() + 9.0, to.y() + 4.0, std::to_string(i + 1), caliper_colour, 12);
    }
    for (const ImageMarker& marker : picture_.markers) {
      const Spot at = spot(marker.place);
      canvas_.stroke(Path::cross(at, 4.0), {marker_colour, 1.5});
      words(at.x() + 8.0, at.y() + 4.0, marker.name, marker_colour, 13);
    }
  }

  // The sentence with the reason for a missing image, broken into lines that fit.
  void why() {
    const std::string sentence(reason(frame_.why));
    const auto fitting = static_cast<std::size_t>(std::max(16.0, wide() / 8.5));
    double y = machine_top + 0.42 * high();
    for (std::size_t begin = 0; begin < sentence.size();) {
      std::size_t end = std::min(sentence.size(), begin + fitting);
      if (end < sentence.size()) {
        const std::size_t blank = sentence.rfind(' ', end);
        if (blank != std::string::npos && blank > begin) end = blank;
      }
      words(0.5 * (machine_left + right()), y, sentence.substr(begin, end - begin), warning_colour, 15,
            TextAnchor::middle);
      y += 22.0;
      begin = sentence[std::min(end, sentence.size() - 1)] == ' ' ? end + 1 : end;
    }
  }

  const ScannerImage& picture_;
  const UltrasoundFrame& frame_;
  double scale_ = 1.0;  // px per pixel of the frame
  Canvas canvas_{0.0, 0.0};
};

}  // namespace

Canvas draw_scanner_image(const ScannerImage& picture, const anatomy::TissueLibrary& library) {
  return ScannerArtist(picture).draw(library);
}

SlicePanel ct_panel(const anatomy::Case& patient, const ScanState& moment, OrientationMarkerSide mark,
                    const std::vector<Vec3>& needle) {
  SlicePanel panel;
  panel.slice = cut(plane_of(moment.frame, moment.pose, mark), patient.ct, patient.tissues);
  panel.title = "CT, the same plane";
  panel.path = patient.description.procedure.path;
  panel.travelled = needle;
  for (const Eigen::Vector2d& corner : field_of_view(moment.probe, moment.settings.depth)) {
    panel.outline.push_back(moment.pose * Vec3(corner.x(), corner.y(), 0.0));
  }
  return panel;
}

}  // namespace bodkin::imaging
