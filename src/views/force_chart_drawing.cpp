// How the force chart is drawn, and its menu.
#include <QMenu>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "views/force_chart.h"
#include "views/language.h"
#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

// Strong enough on the panel of either theme, and told apart by lightness too.
const QColor along_ink(0x35, 0xC9, 0x8B), across_ink(0xFF, 0xB0, 0x2E), number_ink(0xC7, 0x92, 0xEA);

QString without_tail(double value) {
  return QString::number(value, 'g', 4);
}

}  // namespace

void ForceChart::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), Theme::now().panel);
  draw_bands(painter);
  draw_ground(painter);
  const QRectF box = plot();
  painter.save();
  painter.setClipRect(box.adjusted(-1.0, -6.0, 1.0, 1.0));
  painter.setRenderHint(QPainter::Antialiasing);
  if (components_) {
    draw_trace(painter, along_, along_ink, 1.25);
    draw_trace(painter, across_, across_ink, 1.25);
  }
  if (diagnostic_) {
    const ChartCurve& curve = axis_ == Axis::depth ? number_.inwards : number_.in_time;
    draw_curve(painter, curve, number_ink, 1.25, number_.in_time.range());
  }
  draw_trace(painter, other_, second_session_colour, 1.5);
  draw_trace(painter, force_, Theme::now().accent, 1.75);
  if (cursor_) {
    draw_cursor(painter);
  } else if (in_body_ || axis_ == Axis::time) {
    const QPointF now = place(axis_ == Axis::depth ? depth_ : time_, now_);
    painter.setPen(QPen(Theme::now().panel, 1.5));
    painter.setBrush(Theme::now().accent);
    painter.drawEllipse(now, 4.5, 4.5);
  }
  painter.restore();
  draw_flags(painter);
  draw_legend(painter);
  draw_pointer(painter);
}

void ForceChart::draw_ground(QPainter& painter) const {
  const Theme& theme = Theme::now();
  const QRectF box = plot();
  set_font(painter, label_size);
  const double low = bottom(), high = top();
  constexpr double least_row = 18.0;  // pixels
  const double row = axis_step(high - low, std::max(2, static_cast<int>(box.height() / least_row)));
  for (double force = std::ceil(low / row - 1e-9) * row; force <= high + 1e-9; force += row) {
    const double y = std::round(place(from(), force).y()) + 0.5;
    painter.setPen(QPen(theme.line, std::abs(force) < 1e-9 ? 1.5 : 1.0));
    painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
    draw_text(painter, {box.left() - 8.0, y + 4.0}, without_tail(std::abs(force) < 1e-9 ? 0.0 : force), theme.second,
              Anchor::right);
  }
  draw_text(painter, {10.0, 16.0}, QStringLiteral("N"), theme.second);
  const int columns = std::max(2, static_cast<int>(box.width() / 75.0));
  const double step = axis_step(to() - from(), columns);
  const QString unit = axis_ == Axis::depth ? tr("mm") : tr("s");
  const double first = std::ceil(from() / step - 1e-9) * step;
  for (double at = first; at <= to() + 1e-9 * step; at += step) {
    const double x = place(at, 0.0).x();
    const bool last = at + step > to() + 1e-9 * step;
    const QString number = without_tail(std::abs(at) < 1e-9 ? 0.0 : at);
    const QString words = last ? number + QLatin1Char(' ') + unit : number;
    const double half = 0.5 * painter.fontMetrics().horizontalAdvance(words);
    draw_text(painter, {std::min(x, width() - 6.0 - half), box.bottom() + 16.0}, words, theme.second, Anchor::middle);
  }
}

// Only as deep as the needle has been: what lies ahead is for the ladder, which can be switched off.
void ForceChart::draw_bands(QPainter& painter) const {
  if (axis_ != Axis::depth || patient_ == nullptr || !tissues_shown_) return;
  const QRectF box = plot();
  set_font(painter, label_size);
  double written_to = box.left() - 100.0;
  for (const TissueBand& band : met_.bands()) {
    const double left = std::max(box.left(), place(band.from, 0.0).x());
    const double right = std::min(box.right(), place(band.to, 0.0).x());
    if (right <= left) continue;
    QColor colour = tissue_colour(band.tissue, patient_->patient.library);
    painter.fillRect(QRectF(left, box.bottom() - 3.0, right - left, 4.0), colour);
    colour.setAlphaF(Theme::now().is_dark ? 0.16 : 0.30);
    painter.fillRect(QRectF(left, box.top(), right - left, box.height() - 3.0), colour);
    const QString title = in_words(patient_->patient.library.title(band.tissue));
    const double wide = painter.fontMetrics().horizontalAdvance(title), begin = 0.5 * (left + right - wide);
    // Named if there is room; a name may extend slightly over its neighbours.
    if (wide > right - left + 24.0 || begin < written_to + 8.0 || begin + wide > width() - 4.0) continue;
    draw_text(painter, {begin, 16.0}, title, Theme::now().second);
    written_to = begin + wide;
  }
}

void ForceChart::draw_trace(QPainter& painter, const Trace& trace, const QColor& colour, double width) const {
  const ChartColumn newtons{static_cast<float>(bottom()), static_cast<float>(top())};
  if (axis_ == Axis::time) return draw_curve(painter, trace.in_time, colour, width, newtons);
  QColor faint = colour;
  faint.setAlphaF(0.45);
  draw_curve(painter, trace.outwards, faint, 1.0, newtons);
  draw_curve(painter, trace.inwards, colour, width, newtons);
}

// `scale`: the values at the lower and the upper edge.
void ForceChart::draw_curve(QPainter& painter, const ChartCurve& curve, const QColor& colour, double width,
                            const ChartColumn& scale) const {
  const QRectF box = plot();
  const auto count = static_cast<std::size_t>(box.width());
  const double span = scale.most - scale.least;
  if (!(span > 0.0)) return;
  const auto y_of = [&](float value) { return box.bottom() - box.height() * (value - scale.least) / span; };
  const std::vector<ChartColumn> columns = curve.columns(from(), to(), count);
  painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  QPolygonF line;
  const auto finish = [&] {
    if (line.size() > 1) painter.drawPolyline(line);
    line.clear();
  };
  // Empty columns are bridged where the curve's own pieces are wider than a pixel.
  const double pixel = (to() - from()) / static_cast<double>(count);
  const int longest_gap = 1 + static_cast<int>(std::ceil(curve.step() / pixel));
  int gap = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].empty()) {
      if (++gap > longest_gap) finish();
      continue;
    }
    gap = 0;
    const double x = box.left() + static_cast<double>(i) + 0.5;
    const double high = y_of(columns[i].most), low = y_of(columns[i].least);
    if (low - high < 1.0) {
      line << QPointF(x, 0.5 * (low + high));
    } else {
      const bool from_below = !line.isEmpty() && std::abs(line.last().y() - low) < std::abs(line.last().y() - high);
      line << QPointF(x, from_below ? low : high) << QPointF(x, from_below ? high : low);
    }
  }
  finish();
}

void ForceChart::draw_flags(QPainter& painter) const {
  const QRectF box = plot();
  constexpr double pole = 14.0, gap = 6.0;  // pixels
  set_font(painter, label_size);
  // The newest is always labelled, an older one if there is room.
  std::vector<QRectF> taken;
  for (auto flag = flags_.rbegin(); flag != flags_.rend(); ++flag) {
    const double x = place(axis_ == Axis::depth ? flag->depth : flag->time, 0.0).x();
    if (x < box.left() - 0.5 || x > box.right() + 0.5) continue;
    const QColor ink = flag->bad ? Theme::now().danger : Theme::now().text;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(ink, 1.0, Qt::DotLine));
    painter.drawLine(QPointF(x, box.top() + pole), QPointF(x, box.bottom() - 4.0));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    const QPointF corners[] = {{x, box.top() + 3.0}, {x + 7.0, box.top() + 7.0}, {x, box.top() + 11.0}};
    painter.drawConvexPolygon(corners, 3);
    const double wide = painter.fontMetrics().horizontalAdvance(flag->words);
    const bool turned_left = x + 10.0 + wide > width() - 4.0;
    const QRectF words(turned_left ? x - gap - wide : x + 10.0, box.top(), wide, 14.0);
    const auto hits = [&](const QRectF& other) { return other.adjusted(-gap, 0.0, gap, 0.0).intersects(words); };
    if (words.left() < box.left() || std::any_of(taken.begin(), taken.end(), hits)) {
      taken.emplace_back(x, box.top(), 8.0, 14.0);
      continue;
    }
    draw_text(painter, {words.left(), box.top() + 11.0}, flag->words, ink);
    taken.push_back(words.united(QRectF(x, box.top(), 8.0, 14.0)));
  }
}

void ForceChart::draw_legend(QPainter& painter) const {
  if (!components_ && !diagnostic_) return;
  set_font(painter, label_size);
  const QRectF box = plot();
  double y = box.top() + 30.0;
  const auto row = [&](const QString& words, const QColor& colour) {
    const double wide = painter.fontMetrics().horizontalAdvance(words);
    painter.fillRect(QRectF(box.right() - wide - 30.0, y - 12.0, wide + 28.0, 16.0), Theme::now().panel);
    painter.fillRect(QRectF(box.right() - wide - 24.0, y - 5.0, 14.0, 2.0), colour);
    draw_text(painter, {box.right() - 6.0, y}, words, Theme::now().text, Anchor::right);
    y += 16.0;
  };
  row(tr("force"), Theme::now().accent);
  if (components_) {
    row(tr("along the needle"), along_ink);
    row(tr("across it"), across_ink);
  }
  if (!diagnostic_ || *diagnostic_ >= diagnostic_titles_.size()) return;
  const ChartColumn& range = number_.in_time.range();
  const QString title = diagnostic_titles_[*diagnostic_];
  row(range.empty() ? title : tr("%1, %2 to %3").arg(title, without_tail(range.least), without_tail(range.most)),
      number_ink);
}

void ForceChart::draw_pointer(QPainter& painter) const {
  const QRectF box = plot();
  if (!pointer_ || !box.contains(*pointer_)) return;
  if (pressed_ && std::abs(pressed_->x() - pointer_->x()) > 6) {
    QColor shade = Theme::now().accent;
    shade.setAlphaF(0.2);
    painter.fillRect(QRectF(QPointF(pressed_->x(), box.top()), QPointF(pointer_->x(), box.bottom())).normalized(),
                     shade);
  }
  const double along = along_at(pointer_->x()), pixel = (to() - from()) / box.width();
  const ChartCurve& curve = axis_ == Axis::depth ? force_.inwards : force_.in_time;
  const double half = 0.5 * std::max(pixel, curve.step());
  const ChartColumn value = curve.columns(std::max(0.0, along - half), along + half, 1).front();
  painter.setPen(QPen(Theme::now().second, 1.0));
  const double x = std::floor(pointer_->x()) + 0.5;
  painter.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
  const QString at = axis_ == Axis::depth ? tr("%1 mm").arg(along, 0, 'f', 1) : tr("%1 s").arg(along, 0, 'f', 1);
  const QString words = value.empty() ? at : tr("%1: %2 N").arg(at).arg(value.most, 0, 'f', 2);
  set_font(painter, label_size, true);
  const double wide = painter.fontMetrics().horizontalAdvance(words) + 12.0;
  const double left = x + 6.0 + wide > box.right() ? x - 6.0 - wide : x + 6.0;
  const QRectF ground(left, box.top() + 20.0, wide, 20.0);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Theme::now().line, 1.0));
  painter.setBrush(Theme::now().raised);
  painter.drawRoundedRect(ground, 4.0, 4.0);
  draw_text(painter, {left + 6.0, ground.bottom() - 6.0}, words, Theme::now().text);
}

void ForceChart::draw_cursor(QPainter& painter) const {
  const QRectF box = plot();
  const double along = axis_ == Axis::depth ? cursor_->depth : cursor_->time;
  const QPointF at = place(along, cursor_->force);
  painter.setPen(QPen(Theme::now().text, 1.5));
  painter.drawLine(QPointF(at.x(), box.top()), QPointF(at.x(), box.bottom()));
  painter.setPen(QPen(Theme::now().panel, 1.5));
  painter.setBrush(Theme::now().accent);
  painter.drawEllipse(at, 4.5, 4.5);
}

void ForceChart::open_menu(const QPoint& at) {
  QMenu menu(this);
  const auto add = [&](const QString& text, bool checked, auto&& act) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setChecked(checked);
    connect(action, &QAction::triggered, this, act);
  };
  add(tr("Against depth"), axis_ == Axis::depth, [this] { set_axis(Axis::depth); });
  add(tr("Against time"), axis_ == Axis::time, [this] { set_axis(Axis::time); });
  menu.addSeparator();
  add(tr("Parts along and across the needle"), components_, [this] { show_components(!components_); });
  for (std::size_t i = 0; i < diagnostic_titles_.size(); ++i) {
    add(diagnostic_titles_[i], diagnostic_ == i,
        [this, i] { show_diagnostic(diagnostic_ == i ? std::nullopt : std::optional<std::size_t>(i)); });
  }
  menu.exec(mapToGlobal(at));
}

}  // namespace bodkin::views
