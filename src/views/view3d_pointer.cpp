// Mouse and keys in the 3-D view.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPushButton>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "views/orientation_cube.h"
#include "views/view3d.h"

namespace bodkin::views {

namespace {

constexpr double click_reach = 4.0;              // pixels that a click may move
constexpr double hub_reach = 10.0;               // pixels about the hub at which it is taken
constexpr double turn_per_pixel = 0.4 * degree;  // of a drag
constexpr double turn_per_key = 7.5 * degree;    // of an arrow key
constexpr double zoom_per_notch = 1.12, zoom_per_key = 1.25;
constexpr double end_on = 15.0 * degree;     // a needle closer to the line of sight has no direction on the screen
constexpr double eighths_of_degree = 120.0;  // a notch of the wheel, as Qt counts

double length_of(const QPointF& vector) {
  return std::hypot(vector.x(), vector.y());
}

}  // namespace

bool View3d::is_over_hub(const QPointF& at) const {
  if (!scene_ || !has_needle_) return false;
  const scene::Projection projection = scene_->projection();
  const auto front = projection.place(scene::hub_middle(needle_)), back = projection.place(scene::hub_end(needle_));
  if (!front || !back) return false;
  const QPointF a = on_screen(*front), b = on_screen(*back), along = b - a, from = at - a;
  const double square = QPointF::dotProduct(along, along);
  const double share = square > 0.0 ? std::clamp(QPointF::dotProduct(from, along) / square, -1.0, 1.0) : 0.0;
  return length_of(from - share * along) < hub_reach;
}

void View3d::aim() {
  pointer_moved_ = false;
  if (drag_ != Drag::none || needle_is_down(shown_.state)) return;
  const QPointF at = in_picture(pointer_);
  const auto skin = underMouse() && !workspace_ ? scene_->skin_at(at.x(), at.y()) : std::nullopt;
  if (skin) {
    emit aimed(skin->point, skin->normal);
  } else if (aimed_) {
    emit aim_left();
  }
  aimed_ = skin.has_value();
}

void View3d::mousePressEvent(QMouseEvent* event) {
  pressed_ = pointer_ = event->localPos();
  if (event->button() == Qt::LeftButton) {
    drag_ = is_over_hub(pressed_) && needle_is_down(shown_.state) ? Drag::hub : Drag::perhaps_turn;
  } else {
    drag_ = Drag::pan;
    if (moves_body()) emit body_drag_started();
  }
}

void View3d::mouseMoveEvent(QMouseEvent* event) {
  const QPointF before = pointer_;
  pointer_ = event->localPos();
  const QPointF moved = pointer_ - before;
  switch (drag_) {
    case Drag::none:
      pointer_moved_ = true;
      setCursor(needle_is_down(shown_.state) && is_over_hub(pointer_) ? Qt::OpenHandCursor : Qt::ArrowCursor);
      break;
    case Drag::perhaps_turn:
      if (length_of(pointer_ - pressed_) <= click_reach) break;
      drag_ = Drag::turn;
      if (moves_body()) emit body_drag_started();
      break;
    case Drag::turn:
      if (moves_body()) {
        turn_body(turn_per_pixel * moved.x(), turn_per_pixel * moved.y());
        break;
      }
      set_camera(scene::turned(camera_, turn_per_pixel * moved.x(), turn_per_pixel * moved.y()));
      break;
    case Drag::pan:
      if (moves_body()) {
        shift_body(moved.x(), moved.y());
        break;
      }
      set_camera(scene::panned(camera_, moved.x(), moved.y(), height()));
      break;
    case Drag::hub:
    case Drag::hub_along:
    case Drag::hub_across:
      move_hub(before, pointer_);
      break;
  }
}

void View3d::move_hub(const QPointF& from, const QPointF& to) {
  if (!scene_) return;
  const scene::Projection projection = scene_->projection();
  const Vec3 axis = needle_axis(needle_.pose), hub = scene::hub_middle(needle_);
  const double scale = projection.pixels_per_mm(hub) / scale_;  // pixels of the widget for 1 mm
  if (scale <= 0.0) return;
  const Vec3 seen = projection.axes().transpose() * axis;
  const QPointF along(seen.x(), seen.y());  // on the screen, as long as the sine of the angle to the line of sight
  const double sine = length_of(along);
  const QPointF moved = to - from;
  if (drag_ == Drag::hub) {
    const QPointF whole = to - pressed_;
    if (length_of(whole) <= click_reach) return;
    const double forwards = sine > 0.0 ? std::abs(QPointF::dotProduct(whole, along)) / sine : 0.0;
    const bool is_along = sine < std::sin(end_on) || forwards > 0.7 * length_of(whole);
    drag_ = is_along ? Drag::hub_along : Drag::hub_across;
    setCursor(Qt::ClosedHandCursor);
  }
  if (drag_ == Drag::hub_along) {
    // 1:1 in mm along the axis as displayed; if it points at the viewer, down is in.
    emit dragged(sine < std::sin(end_on) ? moved.y() / scale
                                         : QPointF::dotProduct(moved, along) / (sine * sine * scale));
    return;
  }
  const Vec3 across = (moved.x() * projection.axes().col(0) + moved.y() * projection.axes().col(1)) / scale;
  const double lever = (hub - needle_.pose.translation()).norm();
  emit tilted(-across.x() / lever, across.z() / lever);
}

void View3d::mouseReleaseEvent(QMouseEvent* event) {
  const Drag ended = drag_;
  drag_ = Drag::none;
  pointer_ = event->localPos();
  setCursor(Qt::ArrowCursor);
  if (event->button() == Qt::RightButton && length_of(pointer_ - pressed_) <= click_reach) {
    open_menu(event->globalPos());
    return;
  }
  if (ended != Drag::perhaps_turn || !scene_) return;
  if (const auto face = orientation_cube_face(cube_place(), camera_.axes(), pointer_)) {
    choose_view(*face);
    return;
  }
  if (workspace_) return;  // moving the body does not put the needle down
  const QPointF at = in_picture(pointer_);
  const auto skin = scene_->skin_at(at.x(), at.y());
  if (!skin) return;
  emit aimed(skin->point, skin->normal);
  emit put_down();
}

void View3d::leaveEvent(QEvent* event) {
  View::leaveEvent(event);
  if (aimed_) emit aim_left();
  aimed_ = pointer_moved_ = false;
}

void View3d::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / eighths_of_degree;
  if (notches == 0.0) return;
  if ((event->modifiers() & Qt::ControlModifier) == 0) {
    emit pushed(-notches, (event->modifiers() & Qt::ShiftModifier) != 0);
    return;
  }
  if (!scene_) return;
  const QPointF at = in_picture(event->position());
  const auto skin = scene_->skin_at(at.x(), at.y());
  set_camera(scene::zoomed(camera_, std::pow(zoom_per_notch, notches), skin ? skin->point : camera_.focus));
}

void View3d::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key >= Qt::Key_0 && key < Qt::Key_0 + scene::standard_view_count) {
    choose_view(static_cast<scene::StandardView>(key - Qt::Key_0));
    return;
  }
  switch (key) {
    case Qt::Key_P:
      set_preset(scene::presets[(static_cast<std::size_t>(look_.preset) + 1) % std::size(scene::presets)]);
      break;
    case Qt::Key_O:
      show_parts(!parts_button_->isChecked());
      break;
    case Qt::Key_Left:
      set_camera(scene::turned(camera_, -turn_per_key, 0.0));
      break;
    case Qt::Key_Right:
      set_camera(scene::turned(camera_, turn_per_key, 0.0));
      break;
    case Qt::Key_Up:
      set_camera(scene::turned(camera_, 0.0, -turn_per_key));
      break;
    case Qt::Key_Down:
      set_camera(scene::turned(camera_, 0.0, turn_per_key));
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      set_camera(scene::zoomed(camera_, zoom_per_key, camera_.focus));
      break;
    case Qt::Key_Minus:
      set_camera(scene::zoomed(camera_, 1.0 / zoom_per_key, camera_.focus));
      break;
    case Qt::Key_Y:
      set_stereo(static_cast<scene::Stereo>((static_cast<int>(stereo_) + 1) % 3));
      break;
    default:
      View::keyPressEvent(event);
  }
}

}  // namespace bodkin::views
