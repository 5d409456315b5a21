// The moving mode of the 3-D view: the body is taken and turned in the workspace of the device, whose axes are drawn.
#include <QPainter>
#include <array>

#include "views/paint_kit.h"
#include "views/theme.h"
#include "views/view3d.h"

namespace bodkin::views {

namespace {

constexpr double half_box = 50.0;  // mm from the middle of the workspace to a face of the box that is drawn

// A motion of camera and workspace against the body: x becomes to + turn (x - from).
scene::Camera carried(const scene::Camera& camera, const Vec3& from, const Vec3& to, const Mat3& turn) {
  scene::Camera moved = camera;
  moved.eye = to + turn * (camera.eye - from);
  moved.focus = to + turn * (camera.focus - from);
  moved.up = turn * camera.up;
  return moved;
}

Mat3 mended(const Mat3& worn) {
  return Eigen::Quaterniond(worn).normalized().toRotationMatrix();
}

}  // namespace

bool View3d::moves_body() const {
  return workspace_ && scene_ && !needle_is_down(shown_.state);
}

void View3d::set_workspace(const std::optional<Workspace>& workspace) {
  if (workspace && workspace_) {  // it stays where it is on the screen
    const Mat3 turn = mended(workspace->rotation * workspace_->rotation.transpose());
    set_camera(carried(camera_, workspace_->middle, workspace->middle, turn));
  }
  workspace_ = workspace;
  setCursor(workspace ? Qt::SizeAllCursor : Qt::ArrowCursor);
  update();
}

void View3d::turn_body(double right, double down) {
  const Mat3 turn = scene::turned(camera_, right, down).axes() * camera_.axes().transpose();
  const Workspace next{workspace_->middle, mended(turn * workspace_->rotation)};
  set_workspace(next);
  emit body_placed(next.middle, next.rotation);
}

void View3d::shift_body(double right, double down) {
  const Vec3 way = scene::panned(camera_, right, down, height()).focus - camera_.focus;
  const Workspace next{workspace_->middle + way, workspace_->rotation};
  set_workspace(next);
  emit body_placed(next.middle, next.rotation);
}

void View3d::draw_workspace(QPainter& painter) const {
  const scene::Projection projection = scene_->projection();
  const auto seen = [&](const Vec3& at) {  // `at`: mm in the workspace
    return projection.place(workspace_->middle + workspace_->rotation * at);
  };
  const auto line = [&](const Vec3& from, const Vec3& to) {
    const auto a = seen(from), b = seen(to);
    if (a && b) painter.drawLine(on_screen(*a), on_screen(*b));
  };
  painter.setRenderHint(QPainter::Antialiasing);
  QColor faint = Theme::dark().second;
  faint.setAlphaF(0.55);
  painter.setPen(QPen(faint, 1.0));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double one : {-half_box, half_box}) {
      for (const double other : {-half_box, half_box}) {
        Vec3 from = Vec3::Zero();
        from[(axis + 1) % 3] = one;
        from[(axis + 2) % 3] = other;
        from[axis] = -half_box;
        Vec3 to = from;
        to[axis] = half_box;
        line(from, to);
      }
    }
  }
  const std::array<QString, 3> names = {tr("right"), tr("away"), tr("up")};
  const std::array<QColor, 3> colours = {QColor(0xFF, 0x6B, 0x6B), QColor(0x63, 0xD4, 0x71),
                                         QColor(0x5A, 0xA9, 0xFF)};
  set_font(painter, text_size, true);
  for (std::size_t axis = 0; axis < names.size(); ++axis) {
    const Vec3 end = half_box * Vec3::Unit(static_cast<int>(axis));
    painter.setPen(QPen(colours[axis], 3.0, Qt::SolidLine, Qt::RoundCap));
    line(Vec3::Zero(), end);
    if (const auto at = seen(1.12 * end))
      draw_text_on_picture(painter, on_screen(*at), names[axis], colours[axis], Anchor::middle);
  }
}

}  // namespace bodkin::views
