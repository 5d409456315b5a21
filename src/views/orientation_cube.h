#pragma once

#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <optional>

#include "scene/camera_moves.h"

namespace bodkin::views {

// A cube with the patient's orientation and a letter on each face: A anterior, P posterior, L left, R right, S
// superior, I inferior. `axes`: of the camera.
void draw_orientation_cube(QPainter& painter, const QRectF& place, const Mat3& axes);
// The view of the face under a pixel.
std::optional<scene::StandardView> orientation_cube_face(const QRectF& place, const Mat3& axes, const QPointF& at);

}  // namespace bodkin::views
