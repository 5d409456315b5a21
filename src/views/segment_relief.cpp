#include "views/segment_relief.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double missed = std::numeric_limits<double>::infinity();
constexpr int coarse = 2;              // pixels of the widget for each ray
constexpr double turn_a_pixel = 0.01;  // rad

}  // namespace

SegmentRelief::SegmentRelief(QWidget* parent) : QWidget(parent) {
  setMinimumSize(160, 120);
  find_axes();
}

void SegmentRelief::show_structure(const anatomy::LabelVolume* labels, std::uint16_t label, std::uint32_t colour) {
  labels_ = labels;
  label_ = label;
  colour_ = colour;
  find_box();
  find_axes();
}

void SegmentRelief::set_turn(double about, double above) {
  about_ = about;
  above_ = std::clamp(above, -1.5, 1.5);
  find_axes();
}

void SegmentRelief::find_box() {
  radius_ = 0.0;
  if (labels_ == nullptr || label_ == 0) return;
  const anatomy::Grid& lattice = labels_->grid;
  Vec3 low = Vec3::Constant(missed), high = Vec3::Constant(-missed);
  std::size_t offset = 0;
  for (int k = 0; k < lattice.size[2]; ++k) {
    for (int j = 0; j < lattice.size[1]; ++j) {
      for (int i = 0; i < lattice.size[0]; ++i, ++offset) {
        if (labels_->voxels[offset] != label_) continue;
        low = low.cwiseMin(Vec3(i, j, k));
        high = high.cwiseMax(Vec3(i, j, k));
      }
    }
  }
  if (low.x() > high.x()) return;
  middle_ = lattice.to_patient(0.5 * (low + high));
  radius_ = 0.5 * lattice.spacing.cwiseProduct(high - low + Vec3::Ones()).norm();
}

void SegmentRelief::find_axes() {
  // From behind the patient, turned about his long axis, then raised.
  const Vec3 level(std::sin(about_), std::cos(about_), 0.0);  // towards the eye: posterior is +y
  const Vec3 eye = std::cos(above_) * level + std::sin(above_) * Vec3::UnitZ();
  into_ = -eye;
  right_ = into_.cross(Vec3::UnitZ()).normalized();
  down_ = into_.cross(right_);
  const double least = std::max(1, std::min(width(), height()));
  pixel_ = radius_ > 0.0 ? 2.1 * radius_ / least : 1.0;
  stale_ = true;
  update();
}

// Distance from `from` along the view to the first voxel of the structure, mm.
double SegmentRelief::depth_along(const Vec3& from) const {
  const anatomy::Grid& lattice = labels_->grid;
  const double step = 0.5 * lattice.spacing.minCoeff();
  const Vec3 start = lattice.to_index(from), stride = lattice.to_index(from + step * into_) - start;
  const int count = static_cast<int>(2.0 * radius_ / step) + 1;
  Vec3 index = start;
  for (int i = 0; i < count; ++i, index += stride) {
    if (anatomy::nearest_at_index(*labels_, index, std::uint16_t{0}) == label_) return i * step;
  }
  return missed;
}

std::optional<Vec3> SegmentRelief::surface_at(const QPointF& at) const {
  if (radius_ == 0.0) return std::nullopt;
  const Vec3 from = middle_ - radius_ * into_ + pixel_ * (at.x() - 0.5 * width()) * right_ +
                    pixel_ * (at.y() - 0.5 * height()) * down_;
  const double depth = depth_along(from);
  if (depth == missed) return std::nullopt;
  return from + depth * into_;
}

QPointF SegmentRelief::place(const Vec3& point) const {
  const Vec3 away = (point - middle_) / pixel_;
  return {0.5 * width() + right_.dot(away), 0.5 * height() + down_.dot(away)};
}

void SegmentRelief::make_picture() {
  stale_ = false;
  const int columns = std::max(1, width() / coarse), rows = std::max(1, height() / coarse);
  picture_ = QImage(columns, rows, QImage::Format_RGB32);
  picture_.fill(Theme::dark().ground);
  if (radius_ == 0.0) return;
  std::vector<double> depths(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), missed);
  const double mm = coarse * pixel_;
  const Vec3 first = middle_ - radius_ * into_ - 0.5 * mm * (columns - 1) * right_ - 0.5 * mm * (rows - 1) * down_;
  const auto depth_of = [&](int column, int row) -> double& {
    return depths[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)];
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Vec3 from = first + mm * column * right_ + mm * row * down_;
      if ((from - middle_ + radius_ * into_).norm() > radius_) continue;
      depth_of(column, row) = depth_along(from);
    }
  }
  // The slope of the surface from depths two rays apart, because voxels form stairs.
  const auto slope = [&](int column, int row, int dx, int dy) {
    const int x1 = std::clamp(column + 2 * dx, 0, columns - 1), y1 = std::clamp(row + 2 * dy, 0, rows - 1);
    const int x0 = std::clamp(column - 2 * dx, 0, columns - 1), y0 = std::clamp(row - 2 * dy, 0, rows - 1);
    const double here = depth_of(column, row);
    const double next = depth_of(x1, y1), before = depth_of(x0, y0);
    const double upper = next == missed ? here : next, lower = before == missed ? here : before;
    return std::clamp((upper - lower) / (4.0 * mm), -4.0, 4.0);
  };
  for (int row = 0; row < rows; ++row) {
    auto* const line = reinterpret_cast<QRgb*>(picture_.scanLine(row));
    for (int column = 0; column < columns; ++column) {
      if (depth_of(column, row) == missed) continue;
      const Vec3 normal = Vec3(slope(column, row, 1, 0), slope(column, row, 0, 1), -1.0).normalized();
      const double light = 0.35 + 0.75 * std::max(0.0, normal.dot(Vec3(-0.35, -0.5, -0.8).normalized()));
      const auto lit = [&](unsigned shift) {
        return static_cast<int>(std::min(255.0, light * static_cast<double>((colour_ >> shift) & 0xFFU)));
      };
      line[column] = qRgb(lit(16), lit(8), lit(0));
    }
  }
}

void SegmentRelief::paintEvent(QPaintEvent* /*event*/) {
  if (stale_) make_picture();
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(rect(), picture_);
  set_font(painter, label_size);
  if (radius_ == 0.0)
    draw_text(painter, QPointF(0.5 * width(), 0.5 * height()), tr("no voxel yet"), Theme::dark().second,
              Anchor::middle);
  draw_text_on_picture(painter, {10.0, height() - 10.0}, tr("right drag turns"), Theme::dark().second);
}

void SegmentRelief::resizeEvent(QResizeEvent* /*event*/) {
  find_axes();
}

void SegmentRelief::mousePressEvent(QMouseEvent* event) {
  pointer_ = event->localPos();
  if (event->button() != Qt::LeftButton) return;
  if (const auto point = surface_at(pointer_)) emit pressed(*point);
}

void SegmentRelief::mouseMoveEvent(QMouseEvent* event) {
  const QPointF step = event->localPos() - pointer_;
  pointer_ = event->localPos();
  if ((event->buttons() & Qt::RightButton) != 0)
    return set_turn(about_ + turn_a_pixel * step.x(), above_ + turn_a_pixel * step.y());
  if ((event->buttons() & Qt::LeftButton) == 0) return;
  if (const auto point = surface_at(pointer_)) emit moved(*point);
}

void SegmentRelief::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit released();
}

}  // namespace bodkin::views
