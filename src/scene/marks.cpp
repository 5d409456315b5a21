#include "scene/marks.h"

#include <algorithm>
#include <array>

#include "scene/strokes.h"

namespace bodkin::scene {

namespace {

constexpr double ahead_of_skin = 40.0;     // mm of the path's line that are shown outside the body
constexpr double path_dash = 3.0;          // mm
constexpr double entry_ring_radius = 6.0;  // mm

void draw_path(const anatomy::NeedlePath& path, const Line& line, const Projection& projection,
               MovingPixels& pixels) {
  const std::array<Vec3, 2> ends = {path.entry - ahead_of_skin * path.direction(), path.target};
  draw_line(ends, line, projection, pixels);
}

// Between its broken stretches; those are thin, dotted and red.
void draw_pieces(const SceneMarks& marks, const Line& line, const Projection& projection, MovingPixels& pixels) {
  constexpr std::uint32_t red = 0xFF5A52;
  const anatomy::NeedlePath& path = *marks.path;
  const Vec3 along = path.direction();
  Line dots = line;
  dots.colour = red;
  dots.dash = 1.0;
  double from = -ahead_of_skin;
  const auto piece = [&](double begin, double end, const Line& look) {
    if (end <= begin) return;
    const std::array<Vec3, 2> ends = {path.entry + begin * along, path.entry + end * along};
    draw_line(ends, look, projection, pixels);
  };
  for (const auto& [begin, end] : marks.broken) {
    piece(from, begin, line);
    piece(begin, end, dots);
    from = end;
  }
  piece(from, path.length(), line);
}

}  // namespace

bool same_marks(const SceneMarks& a, const SceneMarks& b) {
  const auto same_path = [](const anatomy::NeedlePath& p, const anatomy::NeedlePath& q) {
    return p.entry == q.entry && p.target == q.target;
  };
  if (a.path.has_value() != b.path.has_value() || (a.path && !same_path(*a.path, *b.path))) return false;
  return std::equal(a.other_paths.begin(), a.other_paths.end(), b.other_paths.begin(), b.other_paths.end(),
                    same_path) &&
         a.target_tolerance == b.target_tolerance && a.path_shown == b.path_shown && a.insert_here == b.insert_here &&
         a.entry_normal == b.entry_normal && a.colour == b.colour && a.broken == b.broken && a.trails == b.trails;
}

void draw_marks(const SceneMarks& marks, const Projection& projection, MovingPixels& pixels) {
  if (marks.trails) {
    for (const Trail& trail : *marks.trails) {
      const Line way{.colour = trail.colour, .width = trail.width, .dash = 0.0, .opacity = 1.0F, .behind = 0.85F};
      draw_line(trail.points, way, projection, pixels);
    }
  }
  Line line{.colour = marks.colour, .width = 1.5, .dash = path_dash, .opacity = 1.0F, .behind = 0.6F};
  for (const anatomy::NeedlePath& path : marks.other_paths) {
    Line faint = line;
    faint.opacity = 0.45F;
    draw_path(path, faint, projection, pixels);
  }
  if (!marks.path) return;
  if (marks.path_shown) {
    draw_pieces(marks, line, projection, pixels);
    Line ring = line;
    ring.dash = 0.0;
    ring.width = 2.0;
    draw_circle(marks.path->target, projection.axes().col(2), marks.target_tolerance, ring, projection, pixels);
  }
  if (marks.insert_here) {
    const auto pulse = static_cast<float>(*marks.insert_here);
    Line ring{.colour = marks.colour, .width = 2.5, .dash = 0.0, .opacity = 0.55F + 0.45F * pulse, .behind = 0.2F};
    const Vec3 centre = marks.path->entry + 0.8 * marks.entry_normal;  // just above the skin, so as not to be in it
    draw_circle(centre, marks.entry_normal, entry_ring_radius * (0.85 + 0.3 * static_cast<double>(pulse)), ring,
                projection, pixels);
    draw_circle(centre, marks.entry_normal, 1.0, ring, projection, pixels);
  }
}

}  // namespace bodkin::scene
