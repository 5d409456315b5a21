#include "views/scan_viewer.h"

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

constexpr double cine_rate = 10.0;                   // slices a second
constexpr double side_share = 0.36;                  // of the width, for the sagittal picture
constexpr double viewer_gap = 8.0, mark_arm = 11.0;  // pixels
const QColor words_colour(0xA8, 0xE0, 0xB0), mark_colour(0xFF, 0xC2, 0x3D);

QFont console_font(int pixels) {
  QFont font(QStringLiteral("DejaVu Sans Mono"));
  font.setStyleHint(QFont::Monospace);
  font.setPixelSize(pixels);
  return font;
}

QImage greys(const std::int16_t* hounsfield, int width, int height, double window, double level) {
  QImage picture(width, height, QImage::Format_Grayscale8);
  for (int row = 0; row < height; ++row) {
    uchar* const line = picture.scanLine(row);
    for (int column = 0; column < width; ++column) {
      line[column] = grey_of(hounsfield[static_cast<std::ptrdiff_t>(row) * width + column], window, level);
    }
  }
  return picture;
}

QRectF fitted(const QRectF& place, double width, double height) {
  if (width <= 0.0 || height <= 0.0) return place;
  const double scale = std::min(place.width() / width, place.height() / height);
  const QSizeF size(scale * width, scale * height);
  return {place.center() - QPointF(0.5 * size.width(), 0.5 * size.height()), size};
}

}  // namespace

ScanViewer::ScanViewer(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(320, 240);
}

void ScanViewer::set_scan(std::shared_ptr<const imaging::CtScan> scan) {
  const bool another = scan != scan_;
  scan_ = std::move(scan);
  const std::size_t count = scan_ ? scan_->slices.size() : 0;
  if (another) mark_.reset();
  // While slices arrive, the newest is shown.
  if (count > slices_seen_ || another) slice_ = count > 0 ? static_cast<int>(count) - 1 : 0;
  slices_seen_ = count;
  pictures_stale_ = true;
  update();
  emit slice_changed();
}

bool ScanViewer::has_slice() const {
  return scan_ && slice_ >= 0 && slice_ < static_cast<int>(scan_->slices.size());
}

void ScanViewer::show_slice(int index) {
  if (!scan_ || scan_->slices.empty()) return;
  slice_ = std::clamp(index, 0, static_cast<int>(scan_->slices.size()) - 1);
  pictures_stale_ = true;
  update();
  emit slice_changed();
}

void ScanViewer::set_window(double window, double level) {
  window_ = std::clamp(window, 20.0, 4000.0);
  level_ = std::clamp(level, -1000.0, 3000.0);
  pictures_stale_ = true;
  update();
}

void ScanViewer::set_cine(bool on) {
  cine_ = on;
}

void ScanViewer::advance(double clock) {
  if (!cine_ || !scan_ || scan_->slices.empty()) {
    stepped_at_ = clock;
    return;
  }
  if (clock - stepped_at_ < 1.0 / cine_rate) return;
  stepped_at_ = clock;
  show_slice((slice_ + 1) % static_cast<int>(scan_->slices.size()));
}

void ScanViewer::set_mark(const std::optional<Vec3>& mark) {
  mark_ = mark;
  pictures_stale_ = true;  // the sagittal picture goes through it
  update();
  emit mark_changed();
}

QRectF ScanViewer::axial_place() const {
  const QRectF all(0.0, 0.0, (1.0 - side_share) * width() - viewer_gap, height());
  return scan_ ? fitted(all, scan_->plane.width, scan_->plane.height) : all;
}

QRectF ScanViewer::sagittal_place() const {
  const QRectF all((1.0 - side_share) * width(), 0.0, side_share * width(), height());
  return fitted(all, side_.width, side_.height);
}

QPointF ScanViewer::place(const Vec3& point) const {
  const QRectF all = axial_place();
  const Eigen::Vector2d at = scan_->plane.place(point);
  return {all.left() + all.width() * (at.x() + 0.5) / scan_->plane.width,
          all.top() + all.height() * (at.y() + 0.5) / scan_->plane.height};
}

std::optional<Vec3> ScanViewer::point_at(const QPointF& at) const {
  const QRectF all = axial_place();
  if (!has_slice() || !all.contains(at)) return std::nullopt;
  const double column = (at.x() - all.left()) / all.width() * scan_->plane.width - 0.5;
  const double row = (at.y() - all.top()) / all.height() * scan_->plane.height - 0.5;
  return scan_->point(scan_->slices[static_cast<std::size_t>(slice_)], column, row);
}

void ScanViewer::make_pictures() {
  pictures_stale_ = false;
  axial_ = sagittal_ = QImage();
  if (!has_slice()) return;
  const imaging::SlicePlane& plane = scan_->plane;
  const imaging::ScanSlice& slice = scan_->slices[static_cast<std::size_t>(slice_)];
  axial_ = greys(slice.hounsfield.data(), plane.width, plane.height, window_, level_);
  const int column = mark_ ? static_cast<int>(std::lround(plane.place(*mark_).x())) : plane.width / 2;
  side_ = imaging::reformatted(*scan_, imaging::Reformat::sagittal, column);
  sagittal_ = greys(side_.hounsfield.data(), side_.width, side_.height, window_, level_);
}

void ScanViewer::paintEvent(QPaintEvent*) {
  if (pictures_stale_) make_pictures();
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  painter.setFont(console_font(text_size));
  if (!has_slice()) {
    painter.setPen(words_colour);
    painter.drawText(rect(), Qt::AlignCenter, tr("No slices yet.\nSet the range on the scout, then press Scan."));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.drawImage(axial_place(), axial_);
  const QRectF side = sagittal_place();
  painter.drawImage(side, sagittal_);
  const imaging::ScanSlice& slice = scan_->slices[static_cast<std::size_t>(slice_)];
  const double y = side.top() + side.height() * (side_.top - slice.z) / (side_.pixel * side_.height);
  painter.setPen(QPen(axial_colour, 1.0));
  painter.drawLine(QPointF(side.left(), y), QPointF(side.right(), y));
  if (mark_) {
    const double distance = std::abs(mark_->z() - slice.z);
    const bool here = distance <= 0.5 * scan_->protocol.thickness + 1e-6;
    const QPointF at = place(*mark_);
    painter.setPen(QPen(here ? mark_colour : QColor(255, 194, 61, 90), 2.0));
    for (const QPointF& arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
      painter.drawLine(at + 4.0 * arm, at + mark_arm * arm);
    }
  }
  draw_words(painter);
}

void ScanViewer::draw_words(QPainter& painter) const {
  painter.setFont(console_font(text_size));
  const imaging::ScanProtocol& protocol = scan_->protocol;
  const imaging::ScanSlice& slice = scan_->slices[static_cast<std::size_t>(slice_)];
  const auto write = [&](double x, double line, const QString& words, Anchor anchor = Anchor::left) {
    draw_text_on_picture(painter, QPointF(x, line), words, words_colour, anchor);
  };
  const double right = (1.0 - side_share) * width() - viewer_gap - 10.0, below = height() - 12.0;
  write(10.0, 20.0, tr("IM %1/%2").arg(slice_ + 1).arg(imaging::slice_positions(protocol).size()));
  write(10.0, 38.0,
        QStringLiteral("%1 %2")
            .arg(slice.z < 0.0 ? QLatin1Char('I') : QLatin1Char('S'))
            .arg(std::abs(slice.z), 0, 'f', 1));
  write(right, 20.0, tr("SL %1 mm").arg(protocol.thickness, 0, 'f', 1), Anchor::right);
  write(right, 38.0, tr("SP %1 mm").arg(protocol.spacing, 0, 'f', 1), Anchor::right);
  write(10.0, below, QStringLiteral("W %1  L %2").arg(window_, 0, 'f', 0).arg(level_, 0, 'f', 0));
  const QRectF axial = axial_place();
  write(axial.left() + 8.0, axial.center().y(), tr("R"));
  write(axial.right() - 8.0, axial.center().y(), tr("L"), Anchor::right);
  write(axial.center().x(), axial.bottom() - 8.0, tr("P"), Anchor::middle);
  if (scan_->needle) write(right, below, tr("NEEDLE IN PLACE"), Anchor::right);
}

void ScanViewer::mousePressEvent(QMouseEvent* event) {
  pointer_ = event->localPos();
  if (event->button() != Qt::LeftButton) return;
  if (const auto point = point_at(pointer_)) return set_mark(point);
  const QRectF side = sagittal_place();
  if (!has_slice() || !side.contains(pointer_)) return;
  // A click in the sagittal picture shows the slice at that height.
  const double z = side_.top - (pointer_.y() - side.top()) / side.height() * side_.pixel * side_.height;
  const imaging::ScanSlice* const found = scan_->slice_at(z);
  if (found != nullptr) show_slice(static_cast<int>(found - scan_->slices.data()));
}

void ScanViewer::mouseMoveEvent(QMouseEvent* event) {
  const QPointF moved = event->localPos() - pointer_;
  pointer_ = event->localPos();
  if ((event->buttons() & Qt::RightButton) != 0) set_window(window_ + 3.0 * moved.x(), level_ - 3.0 * moved.y());
}

void ScanViewer::wheelEvent(QWheelEvent* event) {
  const int notches = event->angleDelta().y() / 120;
  if (notches != 0) show_slice(slice_ + notches);
}

void ScanViewer::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
      return show_slice(slice_ + 1);
    case Qt::Key_Down:
      return show_slice(slice_ - 1);
    case Qt::Key_Home:
      return show_slice(0);
    case Qt::Key_End:
      return scan_ ? show_slice(static_cast<int>(scan_->slices.size()) - 1) : void();
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace bodkin::views
