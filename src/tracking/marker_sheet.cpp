#include "tracking/marker_sheet.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "core/shortest_turn.h"
#include "imaging/canvas.h"

namespace bodkin::tracking {

namespace {

using imaging::Canvas;
using imaging::Ink;
using imaging::Path;

// A page is drawn in typographic points, as in PDF.
constexpr double mm = 72.0 / 25.4;
constexpr double short_side = 210.0 * mm, long_side = 297.0 * mm;  // A4
constexpr double border = 8.0 * mm, ruler_room = 22.0 * mm;
constexpr double tab = 8.0 * mm;  // width of a glue tab
constexpr double darkest = 0.1;   // reflectance up to which a plain sheet is printed, black

// A face laid flat: its middle and its axes on the paper.
struct FlatFace {
  int id = -1;
  double side = 0.0, sheet = 0.0;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::UnitX(), down = Eigen::Vector2d::UnitY();

  Eigen::Vector2d at(double x, double y) const { return middle + x * right + y * down; }
};

// The marked faces of a body around its first one, unfolded along the shared edges.
std::vector<FlatFace> laid_flat(const MarkerBody& body) {
  std::vector<FlatFace> flat;
  const Pose* first = nullptr;
  for (const MarkerFace& face : body.faces) {
    if (face.id < 0 && face.reflectance > darkest) continue;
    if (first == nullptr) first = &face.place;
    const Pose relative = first->inverse() * face.place;
    FlatFace laid;
    laid.id = face.id;
    laid.side = face.side * mm;
    laid.sheet = face.sheet * mm;
    const Vec3 normal = relative.linear().col(2);
    Vec3 middle = relative.translation();
    Mat3 axes = relative.linear();
    if (normal.z() < 0.999) {
      const Vec3 towards = Vec3(middle.x(), middle.y(), 0.0).normalized();
      const Vec3 edge = 0.5 * body.faces.front().sheet * towards;
      const Mat3 fold = shortest_turn(normal, Vec3::UnitZ()).toRotationMatrix();
      middle = edge + fold * (middle - edge);
      axes = fold * axes;
    }
    laid.middle = mm * middle.head<2>();
    laid.right = axes.col(0).head<2>();
    laid.down = axes.col(1).head<2>();
    flat.push_back(laid);
  }
  return flat;
}

void draw_face(Canvas& canvas, const FlatFace& flat, bool folds) {
  const double cell = flat.side / marker_cells, half = 0.5 * flat.side, rim = 0.5 * flat.sheet;
  // Black first, then the white cells: no hairlines show between cells.
  canvas.fill(Path::polygon({flat.at(-half, -half), flat.at(half, -half), flat.at(half, half), flat.at(-half, half)}),
              Ink(0x000000));
  if (flat.id < 0) return;
  const auto pattern = marker_pattern(flat.id);
  for (int row = 0; row < marker_cells; ++row) {
    for (int column = 0; column < marker_cells; ++column) {
      if (!pattern[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]) continue;
      const double x = column * cell - half, y = row * cell - half;
      canvas.fill(
          Path::polygon({flat.at(x, y), flat.at(x + cell, y), flat.at(x + cell, y + cell), flat.at(x, y + cell)}),
          Ink(0xFFFFFF));
    }
  }
  if (!folds) return;
  // Fold lines are light: black ones would lie within the margin used by the camera.
  canvas.stroke(Path::polygon({flat.at(-rim, -rim), flat.at(rim, -rim), flat.at(rim, rim), flat.at(-rim, rim)}),
                {Ink(0xC8C8C8), 0.15 * mm, {2.0 * mm, 1.5 * mm}});
}

void draw_ruler(Canvas& canvas, const std::string& name) {
  const double x = border, y = canvas.height() - border - 4.0 * mm;
  canvas.stroke(Path::segment({x, y}, {x + 100.0 * mm, y}), {Ink(0x000000), 0.2 * mm});
  for (int n = 0; n <= 100; ++n) {
    const double length = (n % 10 == 0 ? 4.0 : n % 5 == 0 ? 3.0 : 2.0) * mm;
    canvas.stroke(Path::segment({x + n * mm, y}, {x + n * mm, y - length}), {Ink(0x000000), 0.1 * mm});
  }
  canvas.text({x, y + 4.0 * mm}, "100 mm: measure it; print at 100 %, without fitting to the page",
              {.size = 3.2 * mm, .ink = 0});
  canvas.text({x + 106.0 * mm, y}, name, {.size = 4.0 * mm, .ink = 0, .bold = true});
}

}  // namespace

std::string marker_sheets_pdf(const std::vector<MarkerBody>& bodies) {
  std::vector<Canvas> pages;
  for (const MarkerBody& body : bodies) {
    const std::vector<FlatFace> flat = laid_flat(body);
    if (flat.empty()) throw InputError(fmt::format("body \"{}\" has no marker to print", body.name));
    Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
    const bool folded = std::any_of(body.faces.begin(), body.faces.end(), [&](const MarkerFace& face) {
      return face.place.linear().col(2).dot(body.faces.front().place.linear().col(2)) < 0.99;
    });
    for (const FlatFace& face : flat) {
      const double reach = 0.5 * face.sheet + (folded ? tab : 0.0);
      low = low.cwiseMin(face.middle - Eigen::Vector2d::Constant(reach));
      high = high.cwiseMax(face.middle + Eigen::Vector2d::Constant(reach));
    }
    const Eigen::Vector2d size = high - low;
    const bool upright = size.x() <= short_side - mm && size.y() <= long_side - ruler_room;
    const bool across = size.x() <= long_side - mm && size.y() <= short_side - ruler_room;
    if (!upright && !across) {
      throw InputError(fmt::format("body \"{}\" takes {:.0f} x {:.0f} mm on paper; an A4 page holds 210 x 275 mm",
                                   body.name, size.x() / mm, size.y() / mm));
    }
    Canvas page(upright ? short_side : long_side, upright ? long_side : short_side);
    page.fill_all(Ink(0xFFFFFF));
    const Eigen::Vector2d shift = 0.5 * (Eigen::Vector2d(page.width(), page.height() - ruler_room) - size) - low;
    for (FlatFace face : flat) {
      face.middle += shift;
      draw_face(page, face, folded);
    }
    if (folded) {
      // Glue tabs on the right-hand sides of the outer faces, which meet when the net is folded.
      const Eigen::Vector2d root = flat.front().middle + shift;
      for (std::size_t i = 1; i < flat.size(); ++i) {
        const Eigen::Vector2d middle = flat[i].middle + shift, out = (middle - root).normalized();
        const Eigen::Vector2d side(-out.y(), out.x());
        const double half = 0.5 * flat[i].sheet;
        const Eigen::Vector2d from = middle + half * side - half * out, to = middle + half * side + half * out;
        page.stroke(
            Path::polyline({from, from + tab * side + 0.5 * tab * out, to + tab * side - 0.5 * tab * out, to}),
            {Ink(0xA0A0A0), 0.15 * mm});
      }
    }
    draw_ruler(page, body.name);
    pages.push_back(std::move(page));
  }
  return imaging::pdf(pages, "Marker bodies");
}

}  // namespace bodkin::tracking
