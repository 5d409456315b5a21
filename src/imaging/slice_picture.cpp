#include "imaging/slice_picture.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace bodkin::imaging {

namespace {

constexpr double margin = 14.0;                                                   // px around and between the slices
constexpr double title_height = 34.0;                                             // px
constexpr double panel_title = 22.0;                                              // px
constexpr double legend_row = 20.0;                                               // px
constexpr double legend_text = 12.0, legend_text_left = 22.0, legend_gap = 14.0;  // px
constexpr double near_plane = 2.0;                                                // mm: a farther line is dashed
constexpr std::uint32_t background = 0x10151A, title_colour = 0xFFFFFF, panel_title_colour = 0xCFD8DF,
                        legend_colour = 0xDFE6EB, frame_colour = 0x43505A, black = 0x000000, white = 0xFFFFFF;
constexpr std::uint32_t path_colour = 0xFFD84D, target_colour = 0xFF5470, travelled_colour = 0x37E0C8,
                        outline_colour = 0x4CC2FF, level_colour = 0xB9E2FF, conus_colour = 0xFF9E3D;
constexpr double level_reach = 25.0;                        // mm from the slice: farther items are not marked
constexpr double near_path = 24.0;                          // px, of a level to the planned path's target
constexpr double half_interspace = 4.0, half_conus = 11.0;  // mm, half of the line across the canal
constexpr double level_text = 11.0;                         // px
constexpr double beside_level = 16.0;                       // mm from the middle of the canal to a level's name

using Place = Eigen::Vector2d;

// One slice and the drawing on it.
class PanelArtist {
 public:
  PanelArtist(const SlicePanel& panel, double scale)
      : panel_(panel),
        scale_(scale),
        canvas_(panel.slice.plane.width * panel.slice.plane.pixel * scale,
                panel.slice.plane.height * panel.slice.plane.pixel * scale) {}

  Canvas draw(const anatomy::TissueLibrary& library) {
    const double w = canvas_.width(), h = canvas_.height();
    if (panel_.elements.empty()) {
      canvas_.image(paint(panel_.slice, library), 0.0, 0.0, w, h);
    } else {
      elements(library);
    }
    std::vector<Place> outline;
    for (const Vec3& point : panel_.outline) outline.push_back(place(point));
    if (!outline.empty()) canvas_.stroke(Path::polygon(outline), {outline_colour, 1.2});
    levels();
    if (panel_.path) planned(*panel_.path);
    travelled();
    if (panel_.path) ends(*panel_.path);
    letters();
    bar();
    canvas_.stroke(Path::rectangle(0.5, 0.5, w - 1.0, h - 1.0), {frame_colour});
    return std::move(canvas_);
  }

 private:
  // px of a point of the patient; half a pixel lies between the centre of the first pixel and the image's edge.
  Place place(const Vec3& point) const {
    return (panel_.slice.plane.place(point) + Place::Constant(0.5)) * panel_.slice.plane.pixel * scale_;
  }

  bool is_near(const Vec3& point) const { return std::abs(panel_.slice.plane.distance(point)) <= near_plane; }

  // Cut elements, one path per tissue.
  void elements(const anatomy::TissueLibrary& library) {
    std::map<anatomy::TissueId, Path> paths;
    const double w = canvas_.width(), h = canvas_.height();
    for (const CutElement& cut : panel_.elements) {
      std::vector<Place> corners;
      Place low = Place::Constant(1e9), high = Place::Constant(-1e9);
      for (std::size_t i = 0; i < static_cast<std::size_t>(cut.corners); ++i) {
        corners.push_back(place(cut.points[i]));
        low = low.cwiseMin(corners.back());
        high = high.cwiseMax(corners.back());
      }
      if (high.x() < 0.0 || high.y() < 0.0 || low.x() > w || low.y() > h) continue;
      paths[cut.tissue].add(Path::polygon(corners));
    }
    for (const auto& [id, path] : paths) {
      const anatomy::TissueProperties* properties = library.find(id);
      canvas_.fill(path, properties == nullptr ? 0x808080 : properties->colour);
      canvas_.stroke(path, {{black, 0.6}, std::clamp(0.12 * scale_, 0.25, 0.7)});
    }
  }

  void line(const Vec3& from, const Vec3& to, std::uint32_t colour, double thickness) {
    const Path path = Path::segment(place(from), place(to));
    LineStyle style{colour, thickness};
    if (!is_near(0.5 * (from + to))) style.dash = {4.0, 3.0};
    canvas_.stroke(path, {{black, 0.55}, thickness + 1.6});
    canvas_.stroke(path, style);
  }

  void label(const Place& at, const std::string& text, std::uint32_t colour, double size, TextAnchor anchor) {
    canvas_.text(at, text, {.size = size, .ink = colour, .anchor = anchor, .halo = true});
  }

  void planned(const anatomy::NeedlePath& path) {
    const double length = path.length();
    // Split where the path approaches or leaves the plane, so that each piece is entirely solid or dashed.
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
    if (spacing <= 4.0) return;
    for (int depth = 10; depth < length; depth += 10) {
      const Place at = place(along(depth / length));
      const double half = depth % 50 == 0 ? 6.0 : 4.0;
      canvas_.stroke(Path::segment(at - half * across, at + half * across), {path_colour, 1.3});
      const int step = spacing > 22.0 ? 10 : (spacing > 11.0 ? 20 : 50);
      if (depth % step != 0) continue;
      // To the side of a steep line, above a flat one.
      const bool steep = std::abs(across.x()) > std::abs(across.y());
      label(at + (steep ? Place(8.0, 3.5) : Place(0.0, -8.0)), std::to_string(depth), path_colour, 10.0,
            steep ? TextAnchor::start : TextAnchor::middle);
    }
  }

  void dot(const Place& at, double radius, std::uint32_t colour) {
    const Path circle = Path::circle(at, radius);
    canvas_.fill(circle, colour);
    canvas_.stroke(circle, {black});
  }

  void ends(const anatomy::NeedlePath& path) {
    dot(place(path.entry), 4.0, path_colour);
    const Path cross = Path::cross(place(path.target), 6.0);
    canvas_.stroke(cross, {black, 4.0});
    canvas_.stroke(cross, {target_colour, 2.0});
  }

  void levels() {
    for (const LevelMark& level : panel_.levels) {
      const Place at = place(level.place);
      const bool inside = at.x() > 0.0 && at.y() > 0.0 && at.x() < canvas_.width() && at.y() < canvas_.height();
      if (!inside || std::abs(panel_.slice.plane.distance(level.place)) > level_reach) continue;
      const std::uint32_t colour = level.end_of_cord ? conus_colour : level_colour;
      const Place half((level.end_of_cord ? half_conus : half_interspace) * scale_, 0.0);
      const Path line = Path::segment(at - half, at + half);
      canvas_.stroke(line, {{black, 0.6}, level.end_of_cord ? 4.0 : 3.0});
      canvas_.stroke(line, {colour, level.end_of_cord ? 2.2 : 1.4});
      // The conus is named on the right, because L1/L2 lies close below it; interspaces on the left if there is room.
      const double beside = beside_level * scale_;
      const bool right = level.end_of_cord || at.x() - beside < text_width(level.name, level_text) + 2.0;
      // Above the path's own numbers if the path comes from that side.
      const bool at_path = panel_.path && right == (place(panel_.path->entry).x() > at.x()) &&
                           (place(panel_.path->target) - at).norm() < near_path;
      label(at + Place(right ? beside : -beside, at_path ? -near_path : 4.0), level.name, colour, level_text,
            right ? TextAnchor::start : TextAnchor::end);
    }
  }

  void travelled() {
    if (panel_.travelled.size() < 2) return;
    std::vector<Place> points;
    for (const Vec3& point : panel_.travelled) points.push_back(place(point));
    const Path path = Path::polyline(points);
    canvas_.stroke(path, {{black, 0.5}, 3.0});
    canvas_.stroke(path, {travelled_colour, 1.5});
    dot(points.back(), 3.0, travelled_colour);
  }

  void letters() {
    const SlicePlane& plane = panel_.slice.plane;
    const double w = canvas_.width(), h = canvas_.height();
    const auto letter = [this](const Place& at, const Vec3& direction) {
      label(at, direction_letters(direction), white, 13.0, TextAnchor::middle);
    };
    letter({10.0, 0.5 * h + 5.0}, -plane.right);
    letter({w - 10.0, 0.5 * h + 5.0}, plane.right);
    letter({0.5 * w, 16.0}, -plane.down);
    letter({0.5 * w, h - 7.0}, plane.down);
  }

  void bar() {
    const double w = canvas_.width() / scale_;  // mm
    int millimetres = 5;
    for (const int choice : {10, 20, 50, 100}) {
      if (choice <= 0.3 * w) millimetres = choice;
    }
    const double left = 12.0, right = left + millimetres * scale_, y = canvas_.height() - 11.0;
    Path path = Path::segment({left, y}, {right, y});
    for (const double x : {left, right}) path.add(Path::segment({x, y - 4.0}, {x, y + 4.0}));
    canvas_.stroke(path, {{black, 0.7}, 4.0});
    canvas_.stroke(path, {white, 1.6});
    label({left, y - 8.0}, fmt::format("{} mm", millimetres), white, 11.0, TextAnchor::start);
  }

  const SlicePanel& panel_;
  double scale_;  // px per mm
  Canvas canvas_;
};

struct LegendEntry {
  std::string text;
  std::uint32_t colour;
  bool is_line;  // else an area
};

std::vector<LegendEntry> legend_of(const std::vector<SlicePanel>& panels, const anatomy::TissueLibrary& library) {
  std::vector<LegendEntry> entries;
  const auto any = [&panels](auto&& shows) { return std::any_of(panels.begin(), panels.end(), shows); };
  if (any([](const SlicePanel& panel) { return panel.path.has_value(); }))
    entries.push_back({"planned path", path_colour, true});
  if (any([](const SlicePanel& panel) { return panel.travelled.size() > 1; }))
    entries.push_back({"path of the tip", travelled_colour, true});
  if (any([](const SlicePanel& panel) { return !panel.outline.empty(); }))
    entries.push_back({"what the probe sees", outline_colour, true});
  const auto is_conus = [](const LevelMark& level) { return level.end_of_cord; };
  if (any([&](const SlicePanel& panel) { return std::any_of(panel.levels.begin(), panel.levels.end(), is_conus); }))
    entries.push_back({"conus, where the spinal cord ends", conus_colour, true});
  std::set<anatomy::TissueId> seen;
  for (const SlicePanel& panel : panels) {
    for (const anatomy::TissueId id : tissues_present(panel.slice)) seen.insert(id);
    seen.insert(panel.named.begin(), panel.named.end());
    for (const CutElement& cut : panel.elements) seen.insert(cut.tissue);
  }
  for (const anatomy::TissueId id : seen) {
    if (const anatomy::TissueProperties* properties = library.find(id))
      entries.push_back({properties->title, properties->colour, false});
  }
  return entries;
}

// The landmarks of a case that are levels of its spine: "L3_L4", "interspace_1", "conus", but not "L3_L4_skin".
std::vector<LevelMark> levels_of(const anatomy::CaseDescription& about) {
  std::vector<LevelMark> levels;
  for (const anatomy::Landmark& landmark : about.landmarks) {
    std::string name = landmark.name;
    if (name == "conus") {
      levels.push_back({landmark.position, name, true});
      continue;
    }
    const bool unknown = name.starts_with("interspace_");
    const auto separator = name.find('_');
    const bool between = separator != std::string::npos && separator >= 2 &&
                         name.find('_', separator + 1) == std::string::npos &&
                         std::string_view("CTLS").find(name[0]) != std::string_view::npos &&
                         std::isdigit(static_cast<unsigned char>(name[1])) != 0;
    if (name.ends_with("_skin") || (!unknown && !between)) continue;
    name[separator] = unknown ? ' ' : '/';
    levels.push_back({landmark.position, name, false});
  }
  return levels;
}

}  // namespace

SlicesDrawn draw_slices(const std::vector<SlicePanel>& panels, const anatomy::TissueLibrary& library,
                        const std::string& title, double height) {
  struct DrawnPanel {
    Canvas canvas;
    double x;
  };
  std::vector<DrawnPanel> drawn;
  double x = margin;
  const double top = (title.empty() ? 0.0 : title_height) + panel_title + 6.0;
  for (const SlicePanel& panel : panels) {
    const SlicePlane& plane = panel.slice.plane;
    drawn.push_back({PanelArtist(panel, height / (plane.height * plane.pixel)).draw(library), x});
    x += drawn.back().canvas.width() + margin;
  }
  struct PlacedEntry {
    LegendEntry entry;
    Place at;
  };
  std::vector<PlacedEntry> legend;
  Place next(margin, top + height + 24.0);
  for (const LegendEntry& entry : legend_of(panels, library)) {
    const double wide = legend_text_left + text_width(entry.text, legend_text) + legend_gap;
    if (next.x() + wide > x && next.x() > margin) next = {margin, next.y() + legend_row};
    legend.push_back({entry, next});
    next.x() += wide;
  }
  Canvas canvas(std::ceil(x), std::ceil(next.y() + 16.0));
  canvas.fill_all(background);
  canvas.text({margin, 25.0}, title, {.size = 17.0, .ink = title_colour, .bold = true});
  for (std::size_t i = 0; i < panels.size(); ++i) {
    canvas.text({drawn[i].x, top - 7.0}, panels[i].title, {.size = 13.0, .ink = panel_title_colour});
    canvas.place(std::move(drawn[i].canvas), drawn[i].x, top);
  }
  for (const auto& [entry, at] : legend) {
    if (entry.is_line)
      canvas.stroke(Path::segment(at, at + Place(16.0, 0.0)), {entry.colour, 2.5});
    else
      canvas.fill(Path::rectangle(at.x(), at.y() - 6.0, 14.0, 12.0), entry.colour);
    canvas.text(at + Place(legend_text_left - 1.0, 4.5), entry.text, {.size = legend_text, .ink = legend_colour});
  }
  return {std::move(canvas), top};
}

Canvas slice_picture(const std::vector<SlicePanel>& panels, const anatomy::TissueLibrary& library,
                     const std::string& title, double height) {
  return draw_slices(panels, library, title, height).canvas;
}

Canvas case_picture(const anatomy::Case& patient) {
  constexpr double panel_height = 430.0;            // px
  constexpr double closest = 90.0, widest = 440.0;  // mm
  constexpr double pixels_across = 640.0;
  const PatientBox body = body_box(patient.tissues);
  const std::optional<anatomy::NeedlePath>& path = patient.description.procedure.path;
  const Vec3 room = (body.high - body.low + Vec3::Constant(8.0)).cwiseMin(widest);
  const Vec3 target = path ? path->target : Vec3(0.5 * (body.low + body.high));
  // The middle of the body, or of the part around the target if the body is larger than the image.
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
  panels.front().levels = panels.back().levels = levels_of(patient.description);
  return slice_picture(panels, patient.library, patient.description.name, panel_height);
}

}  // namespace bodkin::imaging
