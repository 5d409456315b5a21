#include "views/timeline.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "views/chart_columns.h"
#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double lane_side = 12.0, lane_height = 40.0, band_height = 12.0, foot = 18.0;  // pixels
constexpr double flag_height = 16.0, flag_reach = 5.0;

}  // namespace

Timeline::Timeline(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setAccessibleName(tr("Course of the session"));
  setToolTip(tr("Click or drag to go to a time, click a flag to go to its event"));
  setCursor(Qt::PointingHandCursor);
}

QSize Timeline::sizeHint() const {
  return {400, static_cast<int>(lane_height * static_cast<double>(std::max<std::size_t>(1, lanes_.size())) + foot)};
}

void Timeline::set_lanes(std::vector<Lane> lanes, double begin, double end) {
  lanes_ = std::move(lanes);
  begin_ = begin;
  end_ = std::max(end, begin + 1e-3);
  setFixedHeight(sizeHint().height());
  update();
}

void Timeline::set_time(double time) {
  if (time == time_) return;
  time_ = time;
  update();
}

double Timeline::x_of(double time) const {
  return lane_side + (width() - 2.0 * lane_side) * (time - begin_) / (end_ - begin_);
}

double Timeline::time_at(double x) const {
  return begin_ + (end_ - begin_) * std::clamp((x - lane_side) / std::max(1.0, width() - 2.0 * lane_side), 0.0, 1.0);
}

double Timeline::lane_top(std::size_t lane) const {
  return lane_height * static_cast<double>(lane);
}

QPoint Timeline::place_of_event(std::size_t lane, std::size_t event) const {
  const double x = x_of(lanes_[lane].events[event].time);
  return {static_cast<int>(std::lround(x)), static_cast<int>(lane_top(lane) + 0.5 * flag_height)};
}

const Timeline::Event* Timeline::event_at(const QPoint& at) const {
  const Event* nearest = nullptr;
  double least = flag_reach + 0.5;
  for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
    if (at.y() < lane_top(lane) || at.y() > lane_top(lane) + flag_height + 6.0) continue;
    for (const Event& event : lanes_[lane].events) {
      const double away = std::abs(x_of(event.time) - at.x());
      if (away >= least) continue;
      least = away;
      nearest = &event;
    }
  }
  return nearest;
}

void Timeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const Event* const flag = event_at(event->pos());
  emit seek_requested(flag != nullptr ? flag->time : time_at(event->pos().x()));
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->pos();
  if (event->buttons() & Qt::LeftButton) emit seek_requested(time_at(event->pos().x()));
  update();
}

void Timeline::leaveEvent(QEvent* /*event*/) {
  pointer_.reset();
  update();
}

void Timeline::draw_lane(QPainter& painter, std::size_t index) const {
  const Lane& lane = lanes_[index];
  const Theme& theme = Theme::now();
  const double top = lane_top(index), band_top = top + flag_height + 7.0;
  painter.fillRect(QRectF(lane_side, band_top, width() - 2.0 * lane_side, band_height), theme.raised);
  for (const Band& band : lane.bands) {
    const double left = x_of(band.from), wide = std::max(1.0, x_of(band.to) - left);
    painter.fillRect(QRectF(left, band_top, wide, band_height), band.colour);
  }
  painter.fillRect(QRectF(2.0, band_top, 4.0, band_height), lane.colour);
  set_font(painter, label_size);
  // Words are beside their flag if there is room before the next one's.
  double free_from = 0.0;
  for (const Event& event : lane.events) {
    const double x = std::round(x_of(event.time)) + 0.5;
    const QColor ink = event.is_bad ? theme.danger : theme.text;
    painter.setPen(QPen(ink, 1.0));
    painter.drawLine(QPointF(x, top + 3.0), QPointF(x, band_top + band_height));
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF corners[] = {{x, top + 3.0}, {x + 7.0, top + 7.0}, {x, top + 11.0}};
    painter.drawConvexPolygon(corners, 3);
    painter.setRenderHint(QPainter::Antialiasing, false);
    const double wide = painter.fontMetrics().horizontalAdvance(event.words);
    const bool at_the_edge = x + 11.0 + wide > width() - 2.0;
    const double left = at_the_edge ? x - 6.0 - wide : x + 11.0;
    const auto hides = [&](const Event& other) {
      const double flag = x_of(other.time);
      return &other != &event && flag > left - 9.0 && flag < left + wide + 2.0;
    };
    if (left < free_from || std::any_of(lane.events.begin(), lane.events.end(), hides)) {
      free_from = std::max(free_from, x + 12.0);
      continue;
    }
    draw_text(painter, {left, top + 12.0}, event.words, ink);
    free_from = std::max(x, left + wide) + 10.0;
  }
}

void Timeline::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const Theme& theme = Theme::now();
  for (std::size_t i = 0; i < lanes_.size(); ++i) draw_lane(painter, i);
  set_font(painter, label_size);
  constexpr double room_of_a_number = 70.0;  // pixels
  const double step = axis_step(end_ - begin_, std::max(2, static_cast<int>(width() / room_of_a_number)));
  for (double at = std::ceil(begin_ / step - 1e-9) * step; at <= end_ + 1e-9; at += step) {
    const double x = std::clamp(x_of(at), 18.0, width() - 18.0);
    draw_text(painter, {x, height() - 5.0}, tr("%1 s").arg(std::abs(at) < 1e-9 ? 0.0 : at), theme.second,
              Anchor::middle);
  }
  const double x = x_of(time_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme.ground, 4.0));
  painter.drawLine(QPointF(x, 0.0), QPointF(x, height() - foot));
  painter.setPen(QPen(theme.accent, 2.0));
  painter.drawLine(QPointF(x, 0.0), QPointF(x, height() - foot));
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.accent);
  painter.drawEllipse(QPointF(x, height() - foot), 5.0, 5.0);
  if (!pointer_) return;
  // The item under the pointer: an event in full, else the tissue.
  QString words;
  if (const Event* const flag = event_at(*pointer_)) {
    words = tr("%1, %2 s").arg(flag->words).arg(flag->time, 0, 'f', 1);
  } else {
    const double when = time_at(pointer_->x());
    for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
      if (pointer_->y() < lane_top(lane) || pointer_->y() > lane_top(lane) + lane_height) continue;
      for (const Band& band : lanes_[lane].bands) {
        if (when >= band.from && when <= band.to) words = tr("%1, %2 s").arg(band.title).arg(when, 0, 'f', 1);
      }
    }
  }
  if (words.isEmpty()) return;
  set_font(painter, label_size, true);
  const double wide = painter.fontMetrics().horizontalAdvance(words) + 12.0;
  const double left = std::clamp(pointer_->x() + 12.0, 0.0, std::max(0.0, width() - wide));
  const QRectF ground(left, height() - foot - 24.0, wide, 20.0);
  painter.setPen(QPen(theme.line, 1.0));
  painter.setBrush(theme.raised);
  painter.drawRoundedRect(ground, 4.0, 4.0);
  draw_text(painter, {left + 6.0, ground.bottom() - 6.0}, words, theme.text);
}

}  // namespace bodkin::views
