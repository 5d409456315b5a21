#include "views/opacity_curve.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double point_radius = 5.0, point_reach = 9.0;                   // pixels
constexpr double side = 10.0, above = 10.0, below = 22.0;                 // pixels about the ground
constexpr double least = imaging::least_shown_hounsfield, most = 2000.0;  // HU that are drawn
constexpr int ticks[] = {-1000, -500, 0, 500, 1000, 1500};

}  // namespace

OpacityCurve::OpacityCurve(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(180, 130);
}

void OpacityCurve::set_histogram(const std::array<std::uint32_t, 256>& histogram) {
  // Air outside the body would make everything else small.
  double highest = 1.0;
  for (std::size_t i = 8; i < histogram.size(); ++i) highest = std::max(highest, static_cast<double>(histogram[i]));
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    heights_[i] = static_cast<float>(std::min(std::log1p(histogram[i]) / std::log1p(highest), 1.0));
  }
  update();
}

void OpacityCurve::set_function(const imaging::TransferFunction& function) {
  function_ = function;
  update();
}

QRectF OpacityCurve::ground() const {
  return QRectF(rect()).adjusted(side, above, -side, -below);
}

QPointF OpacityCurve::place(double hounsfield, double opacity) const {
  const QRectF all = ground();
  return {all.left() + all.width() * std::clamp((hounsfield - least) / (most - least), 0.0, 1.0),
          all.bottom() - all.height() * std::sqrt(std::clamp(opacity, 0.0, 1.0))};
}

double OpacityCurve::hounsfield_at(double x) const {
  const QRectF all = ground();
  return least + (most - least) * (x - all.left()) / all.width();
}

double OpacityCurve::opacity_at(double y) const {
  const QRectF all = ground();
  const double share = std::clamp((all.bottom() - y) / all.height(), 0.0, 1.0);
  return share * share;
}

std::optional<std::size_t> OpacityCurve::point_at(const QPointF& at) const {
  std::optional<std::size_t> nearest;
  double distance = point_reach;
  for (std::size_t i = 0; i < function_.opacity.size(); ++i) {
    const QPointF from = place(function_.opacity[i].hounsfield, function_.opacity[i].opacity) - at;
    if (std::hypot(from.x(), from.y()) > distance) continue;
    distance = std::hypot(from.x(), from.y());
    nearest = i;
  }
  return nearest;
}

void OpacityCurve::change(const imaging::TransferFunction& function) {
  function_ = function;
  update();
  emit function_changed(function_);
}

void OpacityCurve::paintEvent(QPaintEvent*) {
  const Theme& theme = Theme::dark();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), QColor(0x0A, 0x0D, 0x11));
  const QRectF all = ground();
  QPainterPath hills;
  hills.moveTo(all.bottomLeft());
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    const double hounsfield = least + 16.0 * (static_cast<double>(i) + 0.5);
    if (hounsfield > most) break;
    hills.lineTo(place(hounsfield, 0.0).x(), all.bottom() - static_cast<double>(heights_[i]) * all.height());
  }
  hills.lineTo(all.bottomRight());
  hills.closeSubpath();
  painter.fillPath(hills, QColor(0x2C, 0x35, 0x41));
  set_font(painter, label_size);
  for (const int tick : ticks) {
    const double x = place(tick, 0.0).x();
    painter.setPen(QPen(QColor(255, 255, 255, 26), 1.0));
    painter.drawLine(QPointF(x, all.top()), QPointF(x, all.bottom()));
    draw_text(painter, QPointF(x, all.bottom() + 15.0), QString::number(tick), theme.second, Anchor::middle);
  }
  // Under the curve the colours that the HU have.
  QLinearGradient colours(all.left(), 0.0, all.right(), 0.0);
  for (int i = 0; i <= 48; ++i) {
    const std::array<double, 3> colour = function_.colour_at(least + (most - least) * i / 48.0);
    colours.setColorAt(i / 48.0, QColor::fromRgbF(colour[0], colour[1], colour[2], 0.75));
  }
  QPainterPath curve;
  for (int x = 0; x <= static_cast<int>(all.width()); ++x) {
    const QPointF at = place(hounsfield_at(all.left() + x), function_.opacity_at(hounsfield_at(all.left() + x)));
    x == 0 ? curve.moveTo(at) : curve.lineTo(at);
  }
  QPainterPath under = curve;
  under.lineTo(all.bottomRight());
  under.lineTo(all.bottomLeft());
  under.closeSubpath();
  painter.fillPath(under, colours);
  painter.strokePath(curve, QPen(theme.text, 1.6));
  for (std::size_t i = 0; i < function_.opacity.size(); ++i) {
    const bool lit = held_ == i || (!held_ && over_ == i);
    painter.setPen(QPen(QColor(0x0A, 0x0D, 0x11), 1.5));
    painter.setBrush(lit ? theme.accent : theme.text);
    painter.drawEllipse(place(function_.opacity[i].hounsfield, function_.opacity[i].opacity), point_radius,
                        point_radius);
  }
  const std::optional<std::size_t> named = held_ ? held_ : over_;
  if (named) {
    const imaging::OpacityPoint& point = function_.opacity[*named];
    draw_text_on_picture(painter, QPointF(all.right(), all.top() + 10.0),
                         tr("%1 HU, %2 % of the light a mm")
                             .arg(point.hounsfield, 0, 'f', 0)
                             .arg(100.0 * point.opacity, 0, 'f', point.opacity < 0.1 ? 1 : 0),
                         theme.text, Anchor::right);
  }
}

void OpacityCurve::mousePressEvent(QMouseEvent* event) {
  const std::optional<std::size_t> point = point_at(event->localPos());
  if (event->button() == Qt::LeftButton) held_ = point;
  if (event->button() == Qt::RightButton && point) {
    imaging::TransferFunction next = function_;
    next.remove_point(*point);
    over_.reset();
    change(next);
  }
  update();
}

void OpacityCurve::mouseMoveEvent(QMouseEvent* event) {
  if (!held_) {
    const std::optional<std::size_t> over = point_at(event->localPos());
    if (over != over_) update();
    over_ = over;
    return;
  }
  imaging::TransferFunction next = function_;
  next.move_point(*held_, std::min(hounsfield_at(event->localPos().x()), most), opacity_at(event->localPos().y()));
  change(next);
}

void OpacityCurve::mouseReleaseEvent(QMouseEvent*) {
  over_ = held_;
  held_.reset();
  update();
}

void OpacityCurve::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || point_at(event->localPos())) return;
  imaging::TransferFunction next = function_;
  held_ = next.add_point(hounsfield_at(event->localPos().x()), opacity_at(event->localPos().y()));
  change(next);
}

void OpacityCurve::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Delete || !over_) return QWidget::keyPressEvent(event);
  imaging::TransferFunction next = function_;
  next.remove_point(*over_);
  over_.reset();
  change(next);
}

void OpacityCurve::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  over_.reset();
  update();
}

}  // namespace bodkin::views
