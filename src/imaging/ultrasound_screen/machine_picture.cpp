#include "imaging/ultrasound_screen/machine_picture.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "imaging/png_file.h"
#include "imaging/svg.h"

namespace bodkin {

namespace {

constexpr double machine_left = 124.0, machine_right = 62.0, machine_top = 58.0, machine_bottom = 24.0;  // px
constexpr double least_height = 600.0, most_height = 1200.0;                                             // px
constexpr double words_height = 40.0, least_caption = 320.0,
                 caption_letter = 9.0;  // px, of what is said of a window; of a real picture
constexpr const char* plain_colour = "#e8eef5";
constexpr const char* faint_colour = "#96a0ac";
constexpr const char* warning_colour = "#f5b942";
constexpr const char* caliper_colour = "#ffd84d";
constexpr const char* marker_colour = "#4cc2ff";

using Spot = Eigen::Vector2d;

class MachineArtist {
 public:
  explicit MachineArtist(const MachinePicture& picture) : picture_(picture), frame_(picture.moment.frame) {
    scale_ = std::clamp(static_cast<double>(frame_.height), least_height, most_height) / frame_.height;
  }

  MachineDrawn draw(const TissueLibrary& library) {
    header();
    emit(
        "<image x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" preserveAspectRatio=\"none\" "
        "xlink:href=\"{}\"/>\n",
        machine_left, machine_top, wide(), high(),
        data_uri("image/png", encode_png(grey_picture(frame_, picture_.mark))));
    left_column();
    depth_scale();
    marked_side();
    measurements();
    if (frame_.why != NoImage::none) why();
    double width = right() + machine_right, height = bottom() + machine_bottom;
    if (picture_.window) {
      window(
          *picture_.window, [this](const Spot& place) { return spot_shown(place); }, machine_left, bottom());
      height += words_height;
    }
    if (picture_.beside) {
      height = std::max(height, real_bottom() + machine_bottom + words_height);
      real(*picture_.beside, width);
      width += real_wide() + machine_right;
    }
    if (picture_.ct) {
      const SlicesDrawn slices = draw_slices({*picture_.ct}, library, "", high());
      emit("<g transform=\"translate({:.1f} {:.1f})\">{}</g>\n", width, machine_top - slices.top, slices.svg);
      width += slices.width;
      height = std::max(height, machine_top - slices.top + slices.height);
    }
    return {svg_document(width, height, svg_, "#000"), width, height, machine_left, machine_top, scale_};
  }

 private:
  template <typename... Arguments>
  void emit(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(svg_), text, std::forward<Arguments>(arguments)...);
  }

  double wide() const { return scale_ * frame_.width; }
  double high() const { return scale_ * frame_.height; }
  double right() const { return machine_left + wide(); }
  double bottom() const { return machine_top + high(); }

  // px of a place in the probe's frame.
  Spot spot(const Spot& place) const {
    Spot at = (place - frame_.corner.head<2>()) / frame_.pixel;
    if (picture_.mark == MarkSide::left) at.x() = frame_.width - 1 - at.x();
    return Spot(machine_left, machine_top) + scale_ * (at + Spot::Constant(0.5));
  }

  // px of a place as the picture shows it: mm to the right of its middle and below the face.
  Spot spot_shown(const Spot& place) const {
    return {machine_left + 0.5 * wide() + per_millimetre() * place.x(),
            machine_top + scale_ * ((place.y() - frame_.corner.y()) / frame_.pixel + 0.5)};
  }
  double per_millimetre() const { return scale_ / frame_.pixel; }                          // px
  double real_pixel() const { return per_millimetre() * picture_.beside->picture.pixel; }  // px
  double real_wide() const {
    const double caption = caption_letter * static_cast<double>(picture_.beside->caption.size());
    return std::max({least_caption, caption, real_pixel() * picture_.beside->picture.width});
  }
  double real_bottom() const { return machine_top + real_pixel() * picture_.beside->picture.height; }

  void words(double x, double y, const std::string& text, const char* colour, double size,
             const char* anchor = "start") {
    emit("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\" font-size=\"{:.0f}\" text-anchor=\"{}\">{}</text>\n", x, y,
         colour, size, anchor, escape_markup(text));
  }

  void header() {
    words(16.0, 26.0, picture_.patient, plain_colour, 15);
    words(right() + machine_right - 14.0, 26.0, "Bodkin, simulated", faint_colour, 12, "end");
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
    // The greys from white to black.
    emit(
        "<defs><linearGradient id=\"greys\" x1=\"0\" y1=\"0\" x2=\"0\" y2=\"1\"><stop offset=\"0\" "
        "stop-color=\"#fff\"/><stop offset=\"1\" stop-color=\"#000\"/></linearGradient></defs>"
        "<rect x=\"16\" y=\"{:.1f}\" width=\"12\" height=\"150\" fill=\"url(#greys)\" stroke=\"#43505a\"/>\n",
        bottom() - 151.0);
  }

  // The time-gain compensation, where somebody moved it.
  void sliders(double y) {
    const auto& set = picture_.moment.settings.sliders;
    if (std::all_of(set.begin(), set.end(), [](double value) { return value == 0.0; })) return;
    words(16.0, y, "TGC", faint_colour, 11);
    for (const double value : set) {
      y += 13.0;
      emit(
          "<path d=\"M20 {0:.1f}h60\" stroke=\"#43505a\"/><circle cx=\"{1:.1f}\" cy=\"{0:.1f}\" r=\"3.5\" "
          "fill=\"{2}\"/>\n",
          y, 50.0 + 1.5 * value, plain_colour);
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
      emit("<path d=\"M{0:.1f} {1:.1f}l9 -5v10z\" fill=\"{2}\"/>\n", x - 2.0, focus, warning_colour);
    }
  }

  // Marks at every half centimetre down to `depth` mm, as far as `last` px.
  template <typename Height>
  void centimetres(double x, double depth, Height&& height, double last) {
    const int between = centimetres_between_numbers(depth);
    words(x, machine_top - 8.0, "cm", faint_colour, 11);
    for (int half = 0; 5.0 * half <= depth + 1e-9; ++half) {
      const double y = height(5.0 * half);
      if (y > last + 1.0) break;
      const bool numbered = half % (2 * between) == 0;
      if (half % 2 != 0 && depth > 120.0) continue;
      emit("<path d=\"M{:.1f} {:.1f}h{}\" stroke=\"{}\"/>\n", x, y, numbered ? 10 : (half % 2 == 0 ? 7 : 4),
           faint_colour);
      if (numbered && half > 0) words(x + 15.0, y + 4.5, std::to_string(half / 2), faint_colour, 12);
    }
  }

  void marked_dot(double x) {
    emit(
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"8\" fill=\"#46c878\"/><text x=\"{0:.1f}\" y=\"{2:.1f}\" "
        "fill=\"#000\" font-size=\"11\" font-weight=\"bold\" text-anchor=\"middle\">B</text>\n",
        x, machine_top - 14.0, machine_top - 10.0);
  }

  // The window in a picture whose places `to_px` gives, and what is said of it below the picture.
  template <typename ToPx>
  void window(const WindowSaid& said, ToPx&& to_px, double left, double below) {
    const Spot middle(said.window.across, said.window.depth), half(0.5 * said.window.width, 0.5 * said.window.height);
    const Spot from = to_px(middle - half), to = to_px(middle + half);
    emit(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" stroke=\"{}\" "
        "stroke-dasharray=\"4 3\"/>\n",
        from.x(), from.y(), to.x() - from.x(), to.y() - from.y(), caliper_colour);
    for (const std::string& line : said.words) words(left, below += 18.0, line, caliper_colour, 13);
  }

  // The real picture with its left margin at `x`, its scale, its marked side and where it comes from.
  void real(const RealPicture& real, double x) {
    const GreyPicture& grey = real.picture;
    const double across = real_pixel() * grey.width, down = real_pixel() * grey.height;
    ImageRgb image(grey.width, grey.height);
    std::transform(grey.pixels.begin(), grey.pixels.end(), image.pixels.begin(), [](std::uint8_t value) {
      return Rgb{value, value, value};
    });
    emit(
        "<image x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" preserveAspectRatio=\"none\" "
        "xlink:href=\"{}\"/>\n",
        x, machine_top, across, down, data_uri("image/png", encode_png(image)));
    words(x, 26.0, real.caption, plain_colour, 15);
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
    if (real.mark) marked_dot(*real.mark == MarkSide::left ? x + 10.0 : x + across - 10.0);
    if (real.window) window(*real.window, to_px, x, machine_top + down);
  }

  void marked_side() {
    const bool left = picture_.mark == MarkSide::left;
    marked_dot(left ? machine_left + 10.0 : right() - 10.0);
    const Vec3 to_right = (left ? -1.0 : 1.0) * picture_.moment.pose.linear().col(0);
    if (!to_right.allFinite()) return;
    words(machine_left + (left ? 26.0 : 4.0), machine_top - 9.0, direction_letters(-to_right), plain_colour, 14);
    words(right() - (left ? 4.0 : 26.0), machine_top - 9.0, direction_letters(to_right), plain_colour, 14, "end");
  }

  void cross(const Spot& at, double half, const char* colour) {
    emit("<path d=\"M{:.1f} {:.1f}h{:.1f}M{:.1f} {:.1f}v{:.1f}\" stroke=\"{}\" stroke-width=\"1.5\"/>\n",
         at.x() - half, at.y(), 2.0 * half, at.x(), at.y() - half, 2.0 * half, colour);
  }

  void measurements() {
    for (std::size_t i = 0; i < picture_.calipers.size(); ++i) {
      const Spot from = spot(picture_.calipers[i].from), to = spot(picture_.calipers[i].to);
      emit("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\" stroke-dasharray=\"2 3\"/>\n", from.x(), from.y(),
           to.x(), to.y(), caliper_colour);
      cross(from, 6.0, caliper_colour);
      cross(to, 6.0, caliper_colour);
      words(to.x() + 9.0, to.y() + 4.0, std::to_string(i + 1), caliper_colour, 12);
    }
    for (const ImageMarker& marker : picture_.markers) {
      const Spot at = spot(marker.place);
      cross(at, 4.0, marker_colour);
      words(at.x() + 8.0, at.y() + 4.0, marker.name, marker_colour, 13);
    }
  }

  // The sentence that says why there is no picture, broken to lines that fit.
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
      words(0.5 * (machine_left + right()), y, sentence.substr(begin, end - begin), warning_colour, 15, "middle");
      y += 22.0;
      begin = sentence[std::min(end, sentence.size() - 1)] == ' ' ? end + 1 : end;
    }
  }

  const MachinePicture& picture_;
  const UltrasoundFrame& frame_;
  double scale_ = 1.0;  // px per pixel of the frame
  std::string svg_;
};

}  // namespace

MachineDrawn machine_picture(const MachinePicture& picture, const TissueLibrary& library) {
  return MachineArtist(picture).draw(library);
}

SlicePanel ct_panel(const Case& patient, const ScanMoment& moment, MarkSide mark, const std::vector<Vec3>& needle) {
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

}  // namespace bodkin
