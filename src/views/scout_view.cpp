#include "views/scout_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double handle_reach = 7.0;  // pixels about an edge at which it is taken
const QColor range_colour(0xFF, 0xC2, 0x3D);

}  // namespace

ScoutWidget::ScoutWidget(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setMinimumSize(160, 160);
}

void ScoutWidget::set_case(std::shared_ptr<const OpenCase> patient) {
  patient_ = std::move(patient);
  set_view(view_);
}

void ScoutWidget::set_view(imaging::ScoutView view) {
  view_ = view;
  scout_ = {};
  picture_ = QImage();
  if (patient_ && !patient_->patient.ct.empty()) {
    scout_ = imaging::make_scout(patient_->patient.ct, view_);
    picture_ =
        QImage(scout_.grey.data(), scout_.width, scout_.height, scout_.width, QImage::Format_Grayscale8).copy();
  }
  update();
}

void ScoutWidget::set_protocol(const imaging::ScanProtocol& protocol) {
  protocol_ = protocol;
  update();
}

void ScoutWidget::set_mark(std::optional<double> z) {
  if (z == mark_) return;
  mark_ = z;
  update();
}

void ScoutWidget::set_lines(const std::optional<anatomy::NeedlePath>& plan,
                            const std::optional<anatomy::NeedlePath>& needle) {
  plan_ = plan;
  needle_ = needle;
  update();
}

QRectF ScoutWidget::picture_place() const {
  if (picture_.isNull()) return rect();
  const double scale =
      std::min(static_cast<double>(width()) / scout_.width, static_cast<double>(height()) / scout_.height);
  const QSizeF size(scale * scout_.width, scale * scout_.height);
  return {QPointF(0.5 * (width() - size.width()), 0.5 * (height() - size.height())), size};
}

double ScoutWidget::y_of(double z) const {
  const QRectF all = picture_place();
  return all.top() + all.height() * (scout_.top - z) / (scout_.pixel * std::max(scout_.height, 1));
}

double ScoutWidget::z_of(double y) const {
  const QRectF all = picture_place();
  return scout_.top - scout_.pixel * scout_.height * (y - all.top()) / all.height();
}

QPointF ScoutWidget::place(const Vec3& point) const {
  // The left edge of the picture is the low end of the box that make_scout() sums.
  const anatomy::Grid& lattice = patient_->patient.ct.grid;
  double low = 1e9;
  const int across = view_ == imaging::ScoutView::frontal ? 0 : 1;
  for (int each = 0; each < 8; ++each) {
    Vec3 index;
    for (int axis = 0; axis < 3; ++axis) {
      index[axis] = (each >> axis & 1) != 0 ? lattice.size[static_cast<std::size_t>(axis)] - 0.5 : -0.5;
    }
    low = std::min(low, lattice.to_patient(index)[across]);
  }
  const QRectF all = picture_place();
  return {all.left() + all.width() * (point[across] - low) / (scout_.pixel * scout_.width), y_of(point.z())};
}

void ScoutWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  set_font(painter, label_size);
  if (picture_.isNull()) {
    painter.setPen(Theme::dark().second);
    painter.drawText(rect(), Qt::AlignCenter, patient_ ? tr("The patient has no CT") : tr("No patient"));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF all = picture_place();
  painter.drawImage(all, picture_);
  for (const double z : imaging::slice_positions(protocol_)) {
    const double top = y_of(z + 0.5 * protocol_.thickness), bottom = y_of(z - 0.5 * protocol_.thickness);
    painter.fillRect(QRectF(all.left(), top, all.width(), std::max(bottom - top - 0.6, 0.6)),
                     QColor(255, 194, 61, 46));
  }
  const double from = y_of(protocol_.from), to = y_of(protocol_.to);
  painter.setPen(QPen(range_colour, 1.5));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(all.left() + 1.0, std::min(from, to), all.width() - 2.0, std::abs(to - from)));
  for (const double y : {from, to}) {
    painter.fillRect(QRectF(all.center().x() - 16.0, y - 2.5, 32.0, 5.0), range_colour);
  }
  const auto words = [](double z) {
    return QStringLiteral("%1 %2").arg(z < 0.0 ? QLatin1Char('I') : QLatin1Char('S')).arg(std::abs(z), 0, 'f', 1);
  };
  draw_text_on_picture(painter, QPointF(all.left() + 6.0, std::min(from, to) - 5.0),
                       words(std::max(protocol_.from, protocol_.to)), range_colour);
  draw_text_on_picture(painter, QPointF(all.left() + 6.0, std::max(from, to) + 13.0),
                       words(std::min(protocol_.from, protocol_.to)), range_colour);
  if (mark_) {
    painter.setPen(QPen(axial_colour, 1.5));
    painter.drawLine(QPointF(all.left(), y_of(*mark_)), QPointF(all.right(), y_of(*mark_)));
  }
  if (plan_) {
    painter.setPen(QPen(Theme::dark().plan, 1.5, Qt::DashLine));
    painter.drawLine(place(plan_->entry), place(plan_->target));
    painter.setPen(QPen(Theme::dark().plan, 1.5));
    painter.drawEllipse(place(plan_->target), 4.0, 4.0);
  }
  if (needle_) draw_line_on_picture(painter, place(needle_->entry), place(needle_->target), steel, 2.0);
  const bool frontal = view_ == imaging::ScoutView::frontal;
  draw_text_on_picture(painter, QPointF(all.left() + 6.0, all.center().y()), frontal ? tr("R") : tr("A"),
                       Theme::dark().second);
  draw_text_on_picture(painter, QPointF(all.right() - 6.0, all.center().y()), frontal ? tr("L") : tr("P"),
                       Theme::dark().second, Anchor::right);
}

ScoutWidget::Drag ScoutWidget::drag_at(double y) const {
  const double from = y_of(protocol_.from), to = y_of(protocol_.to);
  if (std::abs(y - from) < handle_reach && std::abs(y - from) <= std::abs(y - to)) return Drag::from;
  if (std::abs(y - to) < handle_reach) return Drag::to;
  return y > std::min(from, to) && y < std::max(from, to) ? Drag::all : Drag::none;
}

void ScoutWidget::mousePressEvent(QMouseEvent* event) {
  if (picture_.isNull() || event->button() != Qt::LeftButton) return;
  drag_ = drag_at(event->localPos().y());
  pressed_z_ = z_of(event->localPos().y());
}

void ScoutWidget::mouseMoveEvent(QMouseEvent* event) {
  const double y = event->localPos().y();
  if (drag_ == Drag::none) {
    const Drag over = picture_.isNull() ? Drag::none : drag_at(y);
    setCursor(over == Drag::none ? Qt::ArrowCursor : over == Drag::all ? Qt::OpenHandCursor : Qt::SizeVerCursor);
    return;
  }
  const double z = std::clamp(z_of(y), scout_.bottom(), scout_.top);
  double from = protocol_.from, to = protocol_.to;
  if (drag_ == Drag::from) from = z;
  if (drag_ == Drag::to) to = z;
  if (drag_ == Drag::all) {
    const double low = std::min(from, to), high = std::max(from, to);
    const double moved = std::clamp(z - pressed_z_, scout_.bottom() - low, scout_.top - high);
    from += moved;
    to += moved;
    pressed_z_ = z;
  }
  emit range_changed(from, to);
}

void ScoutWidget::mouseReleaseEvent(QMouseEvent*) {
  drag_ = Drag::none;
}

}  // namespace bodkin::views
