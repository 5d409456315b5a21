#include "views/slice_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double least_field = 10.0, most_field = 600.0, first_field = 135.0;  // mm
constexpr double moved_enough = 0.1;                                           // voxels
constexpr double edge_share = 0.12;  // of the view: nearer to its edge the tip is brought back into the middle

}  // namespace

SliceView::SliceView(SliceKind kind, QWidget* parent)
    : View(parent), kind_(kind), own_kind_(kind), measures_(std::make_shared<Measures>()) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(120, 120);
  setAttribute(Qt::WA_OpaquePaintEvent);
  name_itself();
}

void SliceView::name_itself() {
  setAccessibleName(title());
  setToolTip(tr("%1 slice. Left drag: crosshair. Right drag: window. Middle drag: move. Ctrl and wheel: zoom. "
                "Alt and wheel: scroll. M measures a distance, Q an angle.")
                 .arg(title()));
}

void SliceView::show_along_needle(bool on) {
  kind_ = on ? SliceKind::along_needle : own_kind_;
  name_itself();
  if (patient_ != nullptr) follow(shown_.follows && shown_.has_needle ? shown_.tip : shown_.crosshair);
  update();
}

void SliceView::set_case(std::shared_ptr<const OpenCase> patient) {
  patient_ = std::move(patient);
  image_.set_case(patient_);
  measures_->clear();
  measures_->cancel();
  cine_ = false;
  shown_ = {};
  hides_plan_ = false;
  show_whole_procedure();
}

void SliceView::show_whole_procedure() {
  placed_ = false;
  field_ = first_field;
  if (patient_ == nullptr) return update();
  const anatomy::Grid& lattice = patient_->patient.tissues.grid;
  middle_ = lattice.to_patient(0.5 * Vec3(lattice.size[0] - 1, lattice.size[1] - 1, lattice.size[2] - 1));
  if (const auto& path = patient_->description().procedure.path; path && !hides_plan_) {
    // The target slightly off the middle, so that the path from the skin is visible.
    constexpr double towards_the_entry = 0.3;
    middle_ = path->target + towards_the_entry * (path->entry - path->target);
    placed_ = true;
  }
  update();
}

void SliceView::set_measures(std::shared_ptr<Measures> measures) {
  measures_ = std::move(measures);
  update();
}

void SliceView::set_trails(std::shared_ptr<const std::vector<scene::Trail>> trails) {
  trails_ = std::move(trails);
  update();
}

void SliceView::set_look(const SliceLook& look) {
  look_ = look;
  look_.window = std::clamp(look.window, 1.0, 6000.0);
  look_.level = std::clamp(look.level, -2000.0, 5000.0);
  look_.slab.thickness = std::clamp(look.slab.thickness, 0.0, 50.0);
  update();
  emit look_changed();
}

imaging::SlicePlane SliceView::plane() const {
  const double ratio = devicePixelRatioF();
  return slice_plane(kind_,
                     {middle_, field_, std::max(1, static_cast<int>(std::lround(ratio * width()))),
                      std::max(1, static_cast<int>(std::lround(ratio * height())))},
                     shown_.axis);
}

// The centre of the picture's first pixel lies half a pixel inside the widget.
QPointF SliceView::to_widget(const Vec3& point) const {
  const Eigen::Vector2d place = (plane().place(point) + Eigen::Vector2d::Constant(0.5)) / devicePixelRatioF();
  return {place.x(), place.y()};
}

Vec3 SliceView::to_patient(const QPointF& place) const {
  const double ratio = devicePixelRatioF();
  return plane().point(ratio * place.x() - 0.5, ratio * place.y() - 0.5);
}

void SliceView::zoom(double factor) {
  field_ = std::clamp(field_ / factor, least_field, most_field);
  update();
}

// Moves the plane through a point. False if that is not worth another image.
bool SliceView::follow(const Vec3& point) {
  const imaging::SlicePlane now = plane();
  const Vec3 next = middle_that_shows(now, middle_, point, edge_share);
  if ((next - middle_).norm() < moved_enough * patient_->patient.tissues.grid.spacing.minCoeff()) return false;
  middle_ = next;
  return true;
}

void SliceView::show_frame(const Frame& frame, const Changes& changes) {
  if (patient_ == nullptr) return;
  shown_.clock = frame.clock;
  if (cine_) step_cine(frame.clock);
  const bool follows_anew = frame.follows_tip != shown_.follows;  // the tip, or the crosshair at its last place
  const bool redraw = follows_anew || frame.drawn_in != shown_.drawn_in ||
                      frame.moved_tissue != shown_.moved_tissue || changes.needle || changes.tissue ||
                      changes.state || changes.plan || changes.crosshair || changes.warning || changes.theme ||
                      changes.attempt;
  if (!redraw) return;
  // An attempt with a hidden plan must not begin with the slices at it.
  if (const bool hides = !frame.plan; changes.attempt && hides != hides_plan_) {
    hides_plan_ = hides;
    show_whole_procedure();
  }
  shown_.state = frame.state;
  shown_.has_needle = frame.has_needle;
  shown_.tip = frame.needle.translation();
  if (frame.has_needle) {
    shown_.axis = needle_axis(frame.needle);
  } else if (frame.plan && frame.plan->length() > 0.0) {
    shown_.axis = frame.plan->direction();
  }
  shown_.left.clear();
  for (const LeftNeedle& left : frame.left_needles) shown_.left.push_back(left.pose);
  shown_.shape = tip_shape(frame);
  shown_.tissue = frame.tissue;
  shown_.plan = frame.plan;
  shown_.is_planning = frame.is_planning;
  shown_.broken = frame.plan_broken;
  shown_.tolerance = frame.target_tolerance;
  shown_.reached = frame.target_reached;
  shown_.drawn_in = frame.drawn_in;
  shown_.moved_tissue = frame.moved_tissue;
  shown_.crosshair = frame.crosshair;
  shown_.follows = frame.follows_tip;
  if (frame.follows_tip && frame.has_needle) {
    follow(shown_.tip);
  } else if (changes.crosshair || follows_anew || !placed_) {
    follow(shown_.crosshair);
  }
  placed_ = true;
  update();
}

double SliceView::scroll_step() const {
  if (patient_ == nullptr) return 1.0;
  const anatomy::Case& patient = patient_->patient;
  const anatomy::Grid& lattice = patient.ct.empty() ? patient.tissues.grid : patient.ct.grid;
  Eigen::Index axis = 0;
  (lattice.direction.transpose() * plane().normal()).cwiseAbs().maxCoeff(&axis);
  return std::max(0.25, lattice.spacing[axis]);
}

// Forwards is away from the eye.
void SliceView::scroll(double steps) {
  if (patient_ == nullptr) return;
  const imaging::SlicePlane now = plane();
  const Vec3 on_plane = middle_through(now, shown_.crosshair, middle_);
  emit crosshair_moved(on_plane + steps * scroll_step() * now.normal());
}

void SliceView::step_cine(double clock) {
  constexpr double interval = 0.1;  // s
  if (clock - cine_time_ < interval) return;
  cine_time_ = clock;
  const imaging::SlicePlane now = plane();
  const anatomy::Grid& lattice = patient_->patient.tissues.grid;
  const Vec3 next = middle_ + cine_direction_ * scroll_step() * now.normal();
  const Vec3 index = lattice.to_index(next);
  const Vec3 last(lattice.size[0] - 1, lattice.size[1] - 1, lattice.size[2] - 1);
  if ((index.array() < 0.0).any() || (index.array() > last.array()).any()) cine_direction_ = -cine_direction_;
  scroll(cine_direction_);
}

void SliceView::next_preset(int direction) {
  const auto count = static_cast<int>(window_presets.size());
  int index = direction > 0 ? -1 : count;
  for (int i = 0; i < count; ++i) {
    const WindowPreset& preset = window_presets[static_cast<std::size_t>(i)];
    if (preset.window == look_.window && preset.level == look_.level) index = i;
  }
  const WindowPreset& next = window_presets[static_cast<std::size_t>((index + direction + count) % count)];
  SliceLook look = look_;
  look.window = next.window;
  look.level = next.level;
  set_look(look);
}

void SliceView::next_slab() {
  constexpr std::array<Slab, 5> slabs = {Slab{}, Slab{3.0, SlabKind::mean}, Slab{10.0, SlabKind::mean},
                                         Slab{10.0, SlabKind::maximum}, Slab{30.0, SlabKind::maximum}};
  const auto* const now = std::find(slabs.begin(), slabs.end(), look_.slab);
  SliceLook look = look_;
  look.slab = now == slabs.end() || now + 1 == slabs.end() ? slabs.front() : *(now + 1);
  set_look(look);
}

void SliceView::remove_measure_under_pointer() {
  constexpr double reach = 6.0;  // pixels
  if (!pointer_) return;
  const double pixel = plane().pixel * devicePixelRatioF();
  if (const auto found = measures_->at(to_patient(*pointer_), reach * pixel)) {
    measures_->remove(*found);
    emit measures_changed();
    update();
  }
}

bool SliceView::press(int key) {
  switch (key) {
    case Qt::Key_Up:
      scroll(-1.0);
      return true;
    case Qt::Key_Down:
      scroll(1.0);
      return true;
    case Qt::Key_BracketLeft:
      next_preset(-1);
      return true;
    case Qt::Key_BracketRight:
      next_preset(1);
      return true;
    case Qt::Key_M:
      measures_->begin(Measure::Kind::distance);
      break;
    case Qt::Key_Q:
      measures_->begin(Measure::Kind::angle);
      break;
    case Qt::Key_X:
      remove_measure_under_pointer();
      return true;
    case Qt::Key_C:
      cine_ = !cine_;
      cine_time_ = shown_.clock;
      break;
    case Qt::Key_F:
      emit follow_tip_toggled();
      return true;
    case Qt::Key_N:
      show_along_needle(kind_ != SliceKind::along_needle);
      return true;
    case Qt::Key_T:
      next_slab();
      return true;
    case Qt::Key_Home:
      show_whole_procedure();
      return true;
    default:
      return false;
  }
  emit measures_changed();
  update();
  return true;
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  const bool plain = (event->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == Qt::NoModifier;
  if (patient_ == nullptr || !plain || !press(event->key())) View::keyPressEvent(event);
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  pressed_at_ = dragged_to_ = event->pos();
  dragged_ = false;
  if (patient_ == nullptr) return;
  if (event->button() == Qt::LeftButton && measures_->waiting()) {
    measures_->add(to_patient(event->pos()));
    emit measures_changed();
    update();
    return;
  }
  if (event->button() == Qt::RightButton && measures_->waiting()) {
    measures_->cancel();
    emit measures_changed();
    return update();
  }
  drag_ = event->button() == Qt::LeftButton     ? Drag::crosshair
          : event->button() == Qt::RightButton  ? Drag::window
          : event->button() == Qt::MiddleButton ? Drag::pan
                                                : Drag::none;
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  constexpr int jitter = 3;  // pixels
  pointer_ = event->pos();
  if (patient_ == nullptr) return;
  if ((event->pos() - pressed_at_).manhattanLength() > jitter) dragged_ = true;
  const QPoint way = event->pos() - dragged_to_;
  if (drag_ != Drag::none && dragged_) dragged_to_ = event->pos();
  if (drag_ == Drag::crosshair && dragged_) {
    emit crosshair_moved(to_patient(event->pos()));
  } else if (drag_ == Drag::window && dragged_) {
    constexpr double share = 0.004;  // of the window, a pixel
    SliceLook look = look_;
    look.window *= std::exp(share * way.x());
    look.level -= share * look_.window * way.y();
    set_look(look);
  } else if (drag_ == Drag::pan && dragged_) {
    const imaging::SlicePlane now = plane();
    middle_ -= now.pixel * devicePixelRatioF() * (way.x() * now.right + way.y() * now.down);
  }
  update();
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  const Drag ended = std::exchange(drag_, Drag::none);
  if (patient_ == nullptr || dragged_) return;
  if (ended == Drag::crosshair) emit crosshair_moved(to_patient(event->pos()));
  if (ended == Drag::window) open_menu(event->pos());
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !measures_->waiting()) emit fill_requested();
}

void SliceView::wheelEvent(QWheelEvent* event) {
  constexpr double notch = 120.0, zoom_a_notch = 1.15;
  // Qt turns the wheel sideways while Alt is held.
  const double notches = (event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x()) / notch;
  event->accept();
  if (patient_ == nullptr || notches == 0.0) return;
  if ((event->modifiers() & Qt::ControlModifier) != 0) {
    // The point under the pointer stays there.
    const Vec3 before = to_patient(event->position());
    zoom(std::pow(zoom_a_notch, notches));
    middle_ += before - to_patient(event->position());
  } else if ((event->modifiers() & Qt::AltModifier) != 0 || !is_attempt(shown_.state)) {
    scroll(-notches);
  } else {
    emit pushed(-notches, (event->modifiers() & Qt::ShiftModifier) != 0);
  }
}

void SliceView::leaveEvent(QEvent* /*event*/) {
  pointer_.reset();
  update();
}

void SliceView::resizeEvent(QResizeEvent* /*event*/) {
  update();
}

void SliceView::focusInEvent(QFocusEvent* /*event*/) {
  update();
}

void SliceView::focusOutEvent(QFocusEvent* /*event*/) {
  update();
}

}  // namespace bodkin::views
