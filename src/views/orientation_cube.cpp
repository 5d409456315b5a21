#include "views/orientation_cube.h"

#include <QPolygonF>
#include <QTransform>
#include <algorithm>
#include <array>
#include <vector>

#include "views/theme.h"

namespace bodkin::views {

namespace {

struct CubeFace {
  char letter;
  scene::StandardView view;
  Vec3 outwards, right, up;  // LPS, as the letter is read
};

const std::array<CubeFace, 6>& cube_faces() {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  static const std::array<CubeFace, 6> faces = {{{'A', scene::StandardView::anterior, -y, x, z},
                                                 {'P', scene::StandardView::posterior, y, -x, z},
                                                 {'L', scene::StandardView::left, x, y, z},
                                                 {'R', scene::StandardView::right, -x, -y, z},
                                                 {'S', scene::StandardView::superior, z, x, y * -1.0},
                                                 {'I', scene::StandardView::inferior, -z, x, y}}};
  return faces;
}

QPointF seen(const QRectF& place, const Mat3& axes, const Vec3& point) {
  const double half = 0.29 * std::min(place.width(), place.height());
  const Vec3 turned = axes.transpose() * point;
  return place.center() + QPointF(half * turned.x(), half * turned.y());
}

QPolygonF outline(const QRectF& place, const Mat3& axes, const CubeFace& face) {
  QPolygonF corners;
  for (const auto& [u, v] : {std::pair{-1, 1}, {1, 1}, {1, -1}, {-1, -1}}) {
    corners << seen(place, axes, face.outwards + u * face.right + v * face.up);
  }
  return corners;
}

double towards_viewer(const Mat3& axes, const CubeFace& face) {
  return -axes.col(2).dot(face.outwards);
}

}  // namespace

void draw_orientation_cube(QPainter& painter, const QRectF& place, const Mat3& axes) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const CubeFace& face : cube_faces()) {
    const double light = towards_viewer(axes, face);
    if (light <= 0.0) continue;
    const QPolygonF corners = outline(place, axes, face);
    painter.setPen(QPen(QColor(0x0E, 0x11, 0x16), 1.0));
    painter.setBrush(QColor::fromRgb(static_cast<int>(70 + 70 * light), static_cast<int>(80 + 72 * light),
                                     static_cast<int>(92 + 74 * light), 235));
    painter.drawPolygon(corners);
    if (light < 0.25) continue;
    // The letter lies on the face: a unit square is mapped onto it.
    QTransform onto;
    const QPolygonF unit(QVector<QPointF>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    if (!QTransform::quadToQuad(unit, corners, onto)) continue;
    painter.save();
    painter.setTransform(onto, true);
    QFont letter = font(label_size, true);
    letter.setPixelSize(100);
    painter.scale(0.012, 0.012);
    painter.setFont(letter);
    painter.setPen(Theme::dark().text);
    painter.drawText(QRectF(-100, -100, 200, 200), Qt::AlignCenter, QString(QLatin1Char(face.letter)));
    painter.restore();
  }
  painter.restore();
}

std::optional<scene::StandardView> orientation_cube_face(const QRectF& place, const Mat3& axes, const QPointF& at) {
  for (const CubeFace& face : cube_faces()) {
    if (towards_viewer(axes, face) > 0.05 && outline(place, axes, face).containsPoint(at, Qt::OddEvenFill)) {
      return face.view;
    }
  }
  return std::nullopt;
}

}  // namespace bodkin::views
