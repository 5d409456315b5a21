// The mouse on the planning page.
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "app/pages/plan.h"
#include "patient/planning/path_search.h"
#include "views/orientation_cube.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr double reach = 11.0;          // pixels about a point at which it is taken
constexpr double jitter = 4.0;          // pixels that a click may move
constexpr double longest_body = 400.0;  // mm from a target to the skin
constexpr double eighths_a_notch = 120.0, zoom_of_notch = 1.12;

double distance(const QPointF& a, const QPointF& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

}  // namespace

bool PlanPage::eventFilter(QObject* watched, QEvent* event) {
  if (model_ == nullptr || !is_shown_) return Page::eventFilter(watched, event);
  auto* const slice = qobject_cast<SliceView*>(watched);
  switch (event->type()) {
    case QEvent::Resize:
      if (watched == view3d_) place_overlays();
      break;
    case QEvent::MouseButtonPress: {
      auto* const mouse = static_cast<QMouseEvent*>(event);
      drag_ = Drag::none;
      if (mouse->button() != Qt::LeftButton) break;
      pressed_ = mouse->localPos();
      return slice != nullptr ? press_in_slice(slice, mouse) : press_in_view3d(mouse);
    }
    case QEvent::MouseMove:
      if (drag_ == Drag::entry || drag_ == Drag::target)
        return drag_to(watched, static_cast<QMouseEvent*>(event)->localPos());
      break;
    case QEvent::MouseButtonRelease: {
      const Drag ended = drag_;
      drop(watched, static_cast<QMouseEvent*>(event));
      // The view that received the press must receive the release.
      return ended == Drag::entry || ended == Drag::target;
    }
    case QEvent::MouseButtonDblClick:
      return slice != nullptr;  // a second click, not a request for a larger view
    case QEvent::Wheel:
      if (watched == view3d_) {
        auto* const wheel = static_cast<QWheelEvent*>(event);
        if ((wheel->modifiers() & Qt::ControlModifier) != 0 || !view3d_->is_ready()) break;
        view3d_->set_camera(scene::zoomed(view3d_->camera(),
                                          std::pow(zoom_of_notch, wheel->angleDelta().y() / eighths_a_notch),
                                          skin_under(wheel->position()).value_or(view3d_->camera().focus)));
        return true;
      }
      break;
    default:
      break;
  }
  return Page::eventFilter(watched, event);
}

bool PlanPage::press_in_view3d(QMouseEvent* event) {
  drag_ = Drag::perhaps_click;
  const auto& entry = model_->points().entry;
  if (!view3d_->is_ready() || !entry) return false;
  const scene::SoftwareView& scene = *view3d_->scene();
  const auto place = scene.projection().place(*entry);
  if (!place) return false;
  const double scale = static_cast<double>(view3d_->width()) / scene.width();
  if (distance(QPointF(place->x * scale, place->y * scale), event->localPos()) > reach) return false;
  drag_ = Drag::entry;
  return true;
}

bool PlanPage::press_in_slice(SliceView* slice, QMouseEvent* event) {
  const PlanModel::Points& points = model_->points();
  if (slice->is_measuring()) return false;
  drag_ = Drag::perhaps_click;
  if (points.target && distance(slice->to_widget(*points.target), event->localPos()) <= reach) drag_ = Drag::target;
  if (points.entry && distance(slice->to_widget(*points.entry), event->localPos()) <= reach) drag_ = Drag::entry;
  return drag_ == Drag::entry || drag_ == Drag::target;
}

std::optional<Vec3> PlanPage::skin_under(const QPointF& at) {
  if (!view3d_->is_ready()) return std::nullopt;
  const double scale = static_cast<double>(view3d_->scene()->width()) / view3d_->width();
  const auto skin = view3d_->scene()->skin_at(at.x() * scale, at.y() * scale);
  if (!skin) return std::nullopt;
  return skin->point;
}

// The visible surface is smoothed, and a place in a slice lies inside: the entry is where the line from the target
// through that point leaves the body.
void PlanPage::enter_through(const Vec3& point, bool is_step) {
  Vec3 entry = point;
  if (const auto& target = model_->points().target; target && (point - *target).norm() > 1.0) {
    const auto skin =
        patient::find_skin_exit(shown_->patient.tissues, *target, (point - *target).normalized(), longest_body);
    if (!skin) return;
    entry = *skin;
  }
  chosen_ = -1;
  is_step ? model_->set_entry(entry) : model_->move_entry(entry);
  show_plan();
}

bool PlanPage::drag_to(QObject* watched, const QPointF& at) {
  if (distance(at, pressed_) < jitter) return true;
  auto* const slice = qobject_cast<SliceView*>(watched);
  const std::optional<Vec3> point = slice != nullptr ? slice->to_patient(at) : skin_under(at);
  if (!point) return true;
  if (drag_ == Drag::entry) {
    enter_through(*point, false);
  } else {
    model_->move_target(*point);
    show_plan();
  }
  return true;
}

void PlanPage::drop(QObject* watched, QMouseEvent* event) {
  const Drag ended = std::exchange(drag_, Drag::none);
  if (event->button() != Qt::LeftButton || ended == Drag::none) return;
  if (ended != Drag::perhaps_click) {
    model_->commit();
    show_plan();
    return show_proposals();
  }
  if (distance(event->localPos(), pressed_) > jitter) return;
  auto* const slice = qobject_cast<SliceView*>(watched);
  if (slice == nullptr) {
    constexpr double cube = 76.0, beside = 12.0;  // pixels: where the view has its cube, which takes clicks
    const QRectF place(beside, view3d_->height() - cube - beside, cube, cube);
    if (orientation_cube_face(place, view3d_->camera().axes(), event->localPos())) return;
    if (const auto skin = skin_under(event->localPos())) enter_through(*skin, true);
    return;
  }
  const Vec3 point = slice->to_patient(event->localPos());
  if ((event->modifiers() & Qt::ShiftModifier) != 0) return enter_through(point, true);
  chosen_ = -1;
  model_->set_target(point);
  show_plan();
  show_proposals();
}

}  // namespace bodkin::app
