#include "imaging/slice_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "imaging/png_file.h"
#include "imaging/svg.h"

namespace bodkin {

namespace {

constexpr double margin = 14.0;        // px around and between the slices
constexpr double title_height = 34.0;  // px
constexpr double panel_title = 22.0;   // px
constexpr double legend_row = 20.0;    // px
constexpr double legend_letter = 6.8;  // px, width of a letter of the legend
constexpr double near_plane = 2.0;     // mm: a line further away is dashed
constexpr const char* background = "#10151a";
constexpr const char* path_colour = "#ffd84d";
constexpr const char* travelled_colour = "#37e0c8";
constexpr const char* outline_colour = "#4cc2ff";

using Place = Eigen::Vector2d;

// Everything of one panel is drawn in px of the picture, inside an SVG element of the slice's size.
class PanelArtist {
 public:
  PanelArtist(const SlicePanel& panel, double scale) : panel_(panel), scale_(scale) {}

  std::string draw(const TissueLibrary& library, double x, double y) {
    const double w = width(), h = height();
    emit("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"#cfd8df\" font-size=\"13\">{}</text>\n", x, y - 7.0,
         escape_markup(panel_.title));
    emit("<svg x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\">\n", x, y, w, h);
    if (panel_.elements.empty()) {
      emit("<image width=\"{:.1f}\" height=\"{:.1f}\" preserveAspectRatio=\"none\" xlink:href=\"{}\"/>\n", w, h,
           data_uri("image/png", encode_png(paint(panel_.slice, library))));
    } else {
      elements(library);
    }
    outline();
    if (panel_.path) planned(*panel_.path);
    travelled();
    if (panel_.path) ends(*panel_.path);
    letters();
    bar();
    emit("<rect x=\"0.5\" y=\"0.5\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" stroke=\"#43505a\"/>\n</svg>\n",
         w - 1.0, h - 1.0);
    return std::move(svg_);
  }

  double width() const { return panel_.slice.plane.width * panel_.slice.plane.pixel * scale_; }
  double height() const { return panel_.slice.plane.height * panel_.slice.plane.pixel * scale_; }

 private:
  template <typename... Arguments>
  void emit(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(svg_), text, std::forward<Arguments>(arguments)...);
  }

  // px of a point of the patient; the half pixel is from the centre of the first pixel to the picture's edge.
  Place place(const Vec3& point) const {
    return (panel_.slice.plane.place(point) + Place::Constant(0.5)) * panel_.slice.plane.pixel * scale_;
  }

  bool is_near(const Vec3& point) const { return std::abs(panel_.slice.plane.distance(point)) <= near_plane; }

  // Cut elements, those of one tissue as one path.
  void elements(const TissueLibrary& library) {
    std::map<TissueId, std::string> paths;
    const double w = width(), h = height();
    for (const CutElement& cut : panel_.elements) {
      std::array<Place, 4> at;
      Place low = Place::Constant(1e9), high = Place::Constant(-1e9);
      for (std::size_t i = 0; i < static_cast<std::size_t>(cut.corners); ++i) {
        at[i] = place(cut.points[i]);
        low = low.cwiseMin(at[i]);
        high = high.cwiseMax(at[i]);
      }
      if (high.x() < 0.0 || high.y() < 0.0 || low.x() > w || low.y() > h) continue;
      std::string& path = paths[cut.tissue];
      for (std::size_t i = 0; i < static_cast<std::size_t>(cut.corners); ++i) {
        fmt::format_to(std::back_inserter(path), "{}{:.2f} {:.2f}", i == 0 ? "M" : "L", at[i].x(), at[i].y());
      }
      path += "Z";
    }
    for (const auto& [id, path] : paths) {
      const TissueProperties* properties = library.find(id);
      emit(
          "<path d=\"{}\" fill=\"{}\" stroke=\"#000\" stroke-opacity=\"0.6\" stroke-width=\"{:.2f}\" "
          "stroke-linejoin=\"round\"/>\n",
          path, css_colour(properties == nullptr ? 0x808080 : properties->colour),
          std::clamp(0.12 * scale_, 0.25, 0.7));
    }
  }

  void line(const Vec3& from, const Vec3& to, const char* colour, double thickness) {
    const Place a = place(from), b = place(to);
    const char* dashes = is_near(0.5 * (from + to)) ? "" : " stroke-dasharray=\"4 3\"";
    emit(
        "<path d=\"M{0:.2f} {1:.2f}L{2:.2f} {3:.2f}\" stroke=\"#000\" stroke-opacity=\"0.55\" "
        "stroke-width=\"{4:.1f}\"/>"
        "<path d=\"M{0:.2f} {1:.2f}L{2:.2f} {3:.2f}\" stroke=\"{5}\" stroke-width=\"{6:.1f}\"{7}/>\n",
        a.x(), a.y(), b.x(), b.y(), thickness + 1.6, colour, thickness, dashes);
  }

  void label(const Place& at, const std::string& text, const char* colour, double size, const char* anchor) {
    emit(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\" font-size=\"{:.0f}\" text-anchor=\"{}\" stroke=\"#000\" "
        "stroke-width=\"3\" stroke-opacity=\"0.7\" paint-order=\"stroke\" stroke-linejoin=\"round\">{}</text>\n",
        at.x(), at.y(), colour, size, anchor, escape_markup(text));
  }

  void planned(const NeedlePath& path) {
    const double length = path.length();
    // Split where the path comes near the plane or leaves it, so that each piece is solid or dashed as a whole.
    std::vector<double> cuts = {0.0, 1.0};
    const double first = panel_.slice.plane.distance(path.entry), last = panel_.slice.plane.distance(path.target);
    for (const double limit : {-near_plane, near_plane}) {
      const double share = (limit - first) / (last - first);
      if (share > 0.0 && share < 1.0) cuts.push_back(share);
    }
    std::sort(cuts.begin(), cuts.end());
    const auto along = [&](double share) -> Vec3 { return path.entry + share * (path.target - path.entry); };
    for (std::size_t i = 1; i < cuts.size(); ++i) line(along(cuts[i - 1]), along(cuts[i]), path_colour, 2.0);

    const Place start = place(path.entry), end = place(path.target);
    const Place across =
        (end - start).norm() > 1.0 ? Place(-(end - start).y(), (end - start).x()).normalized() : Place::UnitX();
    const double spacing = (end - start).norm() / length * 10.0;  // px between ticks
    if (spacing > 4.0) {
      for (int depth = 10; depth < length; depth += 10) {
        const Place at = place(along(depth / length));
        const double half = depth % 50 == 0 ? 6.0 : 4.0;
        emit("<path d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\" stroke=\"{}\" stroke-width=\"1.3\"/>\n",
             (at - half * across).x(), (at - half * across).y(), (at + half * across).x(), (at + half * across).y(),
             path_colour);
        const int step = spacing > 22.0 ? 10 : (spacing > 11.0 ? 20 : 50);
        if (depth % step == 0) {
          // To the side of a steep line, above a flat one.
          const bool steep = std::abs(across.x()) > std::abs(across.y());
          label(steep ? Place(at + Place(8.0, 3.5)) : Place(at + Place(0.0, -8.0)), std::to_string(depth),
                path_colour, 10, steep ? "start" : "middle");
        }
      }
    }
  }

  void ends(const NeedlePath& path) {
    const Place start = place(path.entry), end = place(path.target);
    emit("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4\" fill=\"{}\" stroke=\"#000\"/>\n", start.x(), start.y(),
         path_colour);
    emit(
        "<path d=\"M{0:.2f} {2:.2f}H{1:.2f}M{3:.2f} {4:.2f}V{5:.2f}\" stroke=\"#000\" stroke-width=\"4\"/>"
        "<path d=\"M{0:.2f} {2:.2f}H{1:.2f}M{3:.2f} {4:.2f}V{5:.2f}\" stroke=\"#ff5470\" stroke-width=\"2\"/>\n",
        end.x() - 6, end.x() + 6, end.y(), end.x(), end.y() - 6, end.y() + 6);
  }

  void travelled() {
    if (panel_.travelled.size() < 2) return;
    std::string points;
    for (const Vec3& point : panel_.travelled) {
      const Place at = place(point);
      fmt::format_to(std::back_inserter(points), "{:.2f},{:.2f} ", at.x(), at.y());
    }
    emit(
        "<polyline points=\"{0}\" fill=\"none\" stroke=\"#000\" stroke-opacity=\"0.5\" stroke-width=\"3\"/>"
        "<polyline points=\"{0}\" fill=\"none\" stroke=\"{1}\" stroke-width=\"1.5\"/>\n",
        points, travelled_colour);
    const Place tip = place(panel_.travelled.back());
    emit("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3\" fill=\"{}\" stroke=\"#000\"/>\n", tip.x(), tip.y(),
         travelled_colour);
  }

  void outline() {
    if (panel_.outline.empty()) return;
    std::string points;
    for (const Vec3& point : panel_.outline) {
      const Place at = place(point);
      fmt::format_to(std::back_inserter(points), "{:.2f},{:.2f} ", at.x(), at.y());
    }
    emit("<polygon points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\"/>\n", points, outline_colour);
  }

  void letters() {
    const SlicePlane& plane = panel_.slice.plane;
    const double w = width(), h = height();
    label({10.0, 0.5 * h + 5.0}, direction_letters(-plane.right), "#fff", 13, "middle");
    label({w - 10.0, 0.5 * h + 5.0}, direction_letters(plane.right), "#fff", 13, "middle");
    label({0.5 * w, 16.0}, direction_letters(-plane.down), "#fff", 13, "middle");
    label({0.5 * w, h - 7.0}, direction_letters(plane.down), "#fff", 13, "middle");
  }

  void bar() {
    const double w = width() / scale_;  // mm
    int millimetres = 5;
    for (const int choice : {10, 20, 50, 100}) {
      if (choice <= 0.3 * w) millimetres = choice;
    }
    const double length = millimetres * scale_, y = height() - 11.0;
    emit(
        "<path d=\"M12 {0:.1f}h{1:.2f}M12 {2:.1f}v8M{3:.2f} {2:.1f}v8\" stroke=\"#000\" stroke-opacity=\"0.7\" "
        "stroke-width=\"4\"/><path d=\"M12 {0:.1f}h{1:.2f}M12 {2:.1f}v8M{3:.2f} {2:.1f}v8\" stroke=\"#fff\" "
        "stroke-width=\"1.6\"/>\n",
        y, length, y - 4.0, 12.0 + length);
    label({12.0, y - 8.0}, fmt::format("{} mm", millimetres), "#fff", 11, "start");
  }

  const SlicePanel& panel_;
  double scale_;  // px per mm
  std::string svg_;
};

struct LegendEntry {
  std::string text;
  std::string sign;  // SVG around (0, 0), 16 px wide
};

std::vector<LegendEntry> legend_of(const std::vector<SlicePanel>& panels, const TissueLibrary& library) {
  std::vector<LegendEntry> entries;
  const auto stroke = [](const char* colour) {
    return fmt::format("<path d=\"M0 0h16\" stroke=\"{}\" stroke-width=\"2.5\"/>", colour);
  };
  const bool any_path = std::any_of(panels.begin(), panels.end(), [](const auto& p) { return p.path.has_value(); });
  const bool any_travelled =
      std::any_of(panels.begin(), panels.end(), [](const auto& p) { return p.travelled.size() > 1; });
  if (any_path) entries.push_back({"planned path", stroke(path_colour)});
  if (any_travelled) entries.push_back({"path of the tip", stroke(travelled_colour)});
  if (std::any_of(panels.begin(), panels.end(), [](const auto& p) { return !p.outline.empty(); })) {
    entries.push_back({"what the probe sees", stroke(outline_colour)});
  }
  std::vector<TissueId> seen;
  for (const SlicePanel& panel : panels) {
    for (const TissueId id : tissues_present(panel.slice)) {
      if (std::find(seen.begin(), seen.end(), id) == seen.end()) seen.push_back(id);
    }
    for (const TissueId id : panel.named) {
      if (std::find(seen.begin(), seen.end(), id) == seen.end()) seen.push_back(id);
    }
    for (const CutElement& cut : panel.elements) {
      if (std::find(seen.begin(), seen.end(), cut.tissue) == seen.end()) seen.push_back(cut.tissue);
    }
  }
  std::sort(seen.begin(), seen.end());
  for (const TissueId id : seen) {
    const TissueProperties* properties = library.find(id);
    if (properties == nullptr) continue;
    entries.push_back(
        {properties->title, fmt::format("<rect y=\"-6\" width=\"14\" height=\"12\" rx=\"2\" fill=\"{}\"/>",
                                        css_colour(properties->colour))});
  }
  return entries;
}

}  // namespace

SlicesDrawn draw_slices(const std::vector<SlicePanel>& panels, const TissueLibrary& library, const std::string& title,
                        double height) {
  std::string content;
  double x = margin;
  const double top = (title.empty() ? 0.0 : title_height) + panel_title + 6.0;
  for (const SlicePanel& panel : panels) {
    const SlicePlane& plane = panel.slice.plane;
    PanelArtist artist(panel, height / (plane.height * plane.pixel));
    content += artist.draw(library, x, top);
    x += artist.width() + margin;
  }
  if (!title.empty()) {
    content +=
        fmt::format("<text x=\"{:.1f}\" y=\"25\" fill=\"#fff\" font-size=\"17\" font-weight=\"bold\">{}</text>\n",
                    margin, escape_markup(title));
  }
  double column = margin, row = top + height + 24.0;
  for (const LegendEntry& entry : legend_of(panels, library)) {
    const double wide = 22.0 + legend_letter * static_cast<double>(entry.text.size()) + 14.0;
    if (column + wide > x && column > margin) {
      column = margin;
      row += legend_row;
    }
    content += fmt::format(
        "<g transform=\"translate({:.1f} {:.1f})\">{}<text x=\"21\" y=\"4.5\" fill=\"#dfe6eb\" "
        "font-size=\"12\">{}</text></g>\n",
        column, row, entry.sign, escape_markup(entry.text));
    column += wide;
  }
  return {content, x, row + 16.0, top};
}

std::string slice_picture(const std::vector<SlicePanel>& panels, const TissueLibrary& library,
                          const std::string& title, double height) {
  const SlicesDrawn drawn = draw_slices(panels, library, title, height);
  return svg_document(drawn.width, drawn.height, drawn.svg, background);
}

std::string case_picture(const Case& patient) {
  constexpr double panel_height = 430.0;            // px
  constexpr double closest = 90.0, widest = 440.0;  // mm
  constexpr double pixels_across = 640.0;
  const PatientBox body = body_box(patient.tissues);
  const std::optional<NeedlePath>& path = patient.description.procedure.path;
  const Vec3 room = (body.high - body.low + Vec3::Constant(8.0)).cwiseMin(widest);
  const Vec3 target = path ? path->target : Vec3(0.5 * (body.low + body.high));
  // The middle of the body, or of the part around the target when the body is larger than the picture.
  const Vec3 slack = 0.5 * (body.high - body.low + Vec3::Constant(8.0) - room);
  const Vec3 middle_of_body = 0.5 * (body.low + body.high);
  const Vec3 centre = target.cwiseMin(middle_of_body + slack).cwiseMax(middle_of_body - slack);

  std::vector<SlicePanel> panels;
  const auto add = [&](const SlicePlane& plane, const std::string& title) {
    panels.push_back({cut(plane, patient.ct, patient.tissues), title, path, {}});
  };

  if (path) {
    const double side = std::clamp(1.45 * path->length(), closest, 260.0);
    const Vec3 middle = 0.5 * (path->entry + path->target);
    const SlicePlane plane = sagittal_plane_along(*path, middle, side, side, side / pixels_across);
    const double tilt = std::acos(std::min(1.0, std::abs(plane.normal().x()))) * 180.0 / EIGEN_PI;
    add(plane, tilt < 0.5 ? std::string("sagittal, along the path")
                          : fmt::format("sagittal, turned {:.0f}° to hold the path", tilt));
  } else {
    const double side = std::max(room.y(), room.z());
    add(view_plane(View::sagittal, centre, room.y(), room.z(), side / pixels_across), "sagittal");
  }
  const double pixel = std::max(room.x(), std::max(room.y(), room.z())) / pixels_across;
  add(view_plane(View::axial, {centre.x(), centre.y(), target.z()}, room.x(), room.y(), pixel),
      fmt::format("axial at z = {:.0f} mm", target.z()));
  add(view_plane(View::coronal, {centre.x(), target.y(), centre.z()}, room.x(), room.z(), pixel),
      fmt::format("coronal at y = {:.0f} mm", target.y()));
  return slice_picture(panels, patient.library, patient.description.name, panel_height);
}

}  // namespace bodkin
