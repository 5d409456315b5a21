#include "views/segment_slice.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "views/paint_kit.h"
#include "views/slice_sampling.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double closest_field = 20.0, widest_field = 600.0;  // mm
constexpr double cover = 0.38, active_cover = 0.5;            // share of the structure's colour

QColor colour_of_plane(SliceKind kind) {
  switch (kind) {
    case SliceKind::axial:
      return axial_colour;
    case SliceKind::coronal:
      return coronal_colour;
    case SliceKind::sagittal:
      return sagittal_colour;
    case SliceKind::along_needle:
      break;
  }
  return along_colour;
}

}  // namespace

SegmentSlice::SegmentSlice(SliceKind kind, QWidget* parent) : QWidget(parent), kind_(kind) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(160, 120);
}

void SegmentSlice::set_case(std::shared_ptr<const OpenCase> patient, const anatomy::LabelVolume* labels) {
  patient_ = std::move(patient);
  labels_ = labels;
  field_ = 160.0;
  middle_ = crosshair_;
  find_plane();
}

void SegmentSlice::show_labels(std::uint64_t version, std::uint16_t active,
                               const std::vector<std::uint32_t>& colours) {
  if (version == version_ && active == active_ && colours == colours_) return;
  version_ = version;
  active_ = active;
  colours_ = colours;
  picture_stale_ = true;
  update();
}

void SegmentSlice::set_crosshair(const Vec3& point) {
  crosshair_ = point;
  middle_ = width() > 0 && plane_.width > 0 ? middle_that_shows(plane_, middle_, point, 0.04) : point;
  find_plane();
}

void SegmentSlice::set_window(double window, double level) {
  window_ = std::clamp(window, 20.0, 4000.0);
  level_ = std::clamp(level, -1000.0, 3000.0);
  picture_stale_ = true;
  update();
}

void SegmentSlice::set_brush(const std::optional<double>& radius) {
  brush_ = radius;
  update();
}

void SegmentSlice::set_covered(bool on) {
  covered_ = on;
  picture_stale_ = true;
  update();
}

void SegmentSlice::find_plane() {
  plane_ = slice_plane(kind_, {middle_, field_, width(), height()}, Vec3::UnitY());
  samples_stale_ = picture_stale_ = true;
  update();
}

QPointF SegmentSlice::place(const Vec3& point) const {
  const Eigen::Vector2d at = plane_.place(point);
  return {at.x() + 0.5, at.y() + 0.5};
}

Vec3 SegmentSlice::point_at(const QPointF& at) const {
  return plane_.point(at.x() - 0.5, at.y() - 0.5);
}

const QImage& SegmentSlice::picture() {
  if (picture_stale_) make_picture();
  return picture_;
}

void SegmentSlice::make_picture() {
  picture_stale_ = false;
  picture_ = QImage(plane_.width, plane_.height, QImage::Format_RGB32);
  picture_.fill(Qt::black);
  if (patient_ == nullptr || plane_.width <= 0 || plane_.height <= 0) return;
  if (samples_stale_) {
    samples_stale_ = false;
    sample_hounsfield(plane_, patient_->patient.ct, {}, hounsfield_);
  }
  std::vector<std::uint16_t> above(static_cast<std::size_t>(plane_.width), 0);
  for (int row = 0; row < plane_.height; ++row) {
    auto* const line = reinterpret_cast<QRgb*>(picture_.scanLine(row));
    std::uint16_t left = 0;
    for (int column = 0; column < plane_.width; ++column) {
      const auto c = static_cast<std::size_t>(column);
      const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(plane_.width) + c;
      const int grey = grey_of(hounsfield_[pixel], window_, level_);
      line[column] = qRgb(grey, grey, grey);
      if (labels_ == nullptr || !covered_) continue;
      const std::uint16_t label = anatomy::nearest(*labels_, plane_.point(column, row), std::uint16_t{0});
      const bool is_edge = (row > 0 && (label == active_) != (above[c] == active_)) ||
                           (column > 0 && (label == active_) != (left == active_));
      above[c] = left = label;
      if (active_ != 0 && is_edge) {
        const std::uint32_t colour = active_ < colours_.size() ? colours_[active_] : 0xFFFFFFU;
        line[column] = colour | 0xFF000000U;
        continue;
      }
      if (label == 0 || label >= colours_.size()) continue;
      const double share = label == active_ ? active_cover : cover;
      const std::uint32_t colour = colours_[label];
      const auto mixed = [&](unsigned shift) {
        return static_cast<int>(std::lround((1.0 - share) * grey + share * ((colour >> shift) & 0xFFU)));
      };
      line[column] = qRgb(mixed(16), mixed(8), mixed(0));
    }
  }
}

void SegmentSlice::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.drawImage(0, 0, picture());
  if (patient_ == nullptr) return;
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF at = place(crosshair_);
  QColor line = Theme::dark().plan;
  line.setAlphaF(0.5);
  painter.setPen(QPen(line, 1.0));
  constexpr double open = 14.0;  // pixels about the crosshair
  painter.drawLine(QPointF(0.0, at.y()), at - QPointF(open, 0.0));
  painter.drawLine(at + QPointF(open, 0.0), QPointF(width(), at.y()));
  painter.drawLine(QPointF(at.x(), 0.0), at - QPointF(0.0, open));
  painter.drawLine(at + QPointF(0.0, open), QPointF(at.x(), height()));
  if (brush_ && has_pointer_) {
    const double radius = *brush_ / plane_.pixel;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, 3.0));
    painter.drawEllipse(pointer_, radius, radius);
    painter.setPen(QPen(Qt::white, 1.0));
    painter.drawEllipse(pointer_, radius, radius);
  }
  set_font(painter, label_size);
  draw_text_on_picture(painter, {10.0, 18.0}, QString::fromStdString(position_text(plane_, crosshair_)),
                       colour_of_plane(kind_));
  const std::int16_t hounsfield = anatomy::nearest(patient_->patient.ct, crosshair_, anatomy::lowest_hounsfield);
  draw_text_on_picture(painter, {10.0, height() - 10.0}, tr("%1 HU").arg(hounsfield), Theme::dark().text);
}

void SegmentSlice::resizeEvent(QResizeEvent* /*event*/) {
  find_plane();
}

void SegmentSlice::mousePressEvent(QMouseEvent* event) {
  pointer_ = event->localPos();
  if (event->button() == Qt::LeftButton && patient_ != nullptr) emit pressed(point_at(pointer_));
}

void SegmentSlice::mouseMoveEvent(QMouseEvent* event) {
  const QPointF step = event->localPos() - pointer_;
  pointer_ = event->localPos();
  has_pointer_ = true;
  if ((event->buttons() & Qt::LeftButton) != 0 && patient_ != nullptr) {
    emit moved(point_at(pointer_));
  } else if ((event->buttons() & Qt::RightButton) != 0) {
    emit window_changed(window_ + 3.0 * step.x(), level_ - 3.0 * step.y());
  } else if ((event->buttons() & Qt::MiddleButton) != 0) {
    middle_ -= plane_.pixel * (step.x() * plane_.right + step.y() * plane_.down);
    find_plane();
  } else if (brush_) {
    update();
  }
}

void SegmentSlice::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && patient_ != nullptr) emit released();
}

void SegmentSlice::leaveEvent(QEvent* event) {
  has_pointer_ = false;
  update();
  QWidget::leaveEvent(event);
}

// One voxel farther along the lattice's axis most perpendicular to the plane.
void SegmentSlice::scroll(int slices) {
  if (patient_ == nullptr) return;
  const anatomy::Grid& lattice = patient_->patient.ct.grid;
  const Vec3 normal = plane_.right.cross(plane_.down);
  int axis = 0;
  (lattice.direction.transpose() * normal).cwiseAbs().maxCoeff(&axis);
  const double sign = lattice.direction.col(axis).dot(normal) < 0.0 ? -1.0 : 1.0;
  emit crosshair_moved(crosshair_ + sign * slices * lattice.spacing[axis] * lattice.direction.col(axis));
}

void SegmentSlice::wheelEvent(QWheelEvent* event) {
  const int notches = event->angleDelta().y() / 120;
  if (notches == 0) return;
  if ((event->modifiers() & Qt::ControlModifier) == 0) return scroll(notches);
  const Vec3 under = point_at(event->position());
  const double before = field_;
  field_ = std::clamp(field_ * std::pow(0.8, notches), closest_field, widest_field);
  middle_ = under + field_ / before * (middle_ - under);
  find_plane();
}

void SegmentSlice::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
      return scroll(1);
    case Qt::Key_Down:
      return scroll(-1);
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace bodkin::views
