#include "views/diagnostics_dock.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <array>
#include <cmath>

#include "views/language.h"
#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double dock_interval = 0.1;  // s between two drawings: numbers that change faster cannot be read
constexpr double dock_gap = 12.0;      // pixels

// "wall_mm" -> "mm", "stored_N_mm" -> "N mm", "csf_flow_mm3_s" -> "mm³/s".
QString unit_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, const char*>, 6> units = {
      {{"mm3_s", "mm³/s"}, {"N_mm", "N mm"}, {"mm3", "mm³"}, {"mm", "mm"}, {"MPa", "MPa"}, {"N", "N"}}};
  for (const auto& [tail, unit] : units) {
    if (name.size() > tail.size() && name.ends_with(tail)) return QString::fromUtf8(unit);
  }
  return {};
}

// Three digits, and no minus before a nought.
QString three_digits(double value) {
  constexpr double least = 0.0005;
  return QString::number(std::abs(value) < least ? 0.0 : value, 'f', 3);
}

QString microseconds(double seconds) {
  return seconds < 1e-3 ? DiagnosticsDock::tr("%1 µs").arg(seconds * 1e6, 0, 'f', 0)
                        : DiagnosticsDock::tr("%1 ms").arg(seconds * 1e3, 0, 'f', 2);
}

}  // namespace

DiagnosticsDock::DiagnosticsDock(QWidget* parent) : View(parent) {
  setMinimumSize(260, 320);
  setAccessibleName(tr("Diagnostics"));
  setToolTip(tr("Times of the force loop, numbers of the force model, energy, and what the guard did"));
}

void DiagnosticsDock::set_case(std::shared_ptr<const OpenCase> /*patient*/) {
  log_.clear();
  numbers_.clear();
  energy_.lift();
  energy_.clear();
  timings_.reset();
  update();
}

void DiagnosticsDock::show_frame(const Frame& frame, const Changes& changes) {
  if (changes.attempt) {
    energy_.lift();
    energy_.clear();
    log_.clear();
  }
  for (const std::string& sentence : frame.notes) log_.note(frame.time, sentence);
  log_.note(frame.time, frame.guard, frame.fault, frame.limits);
  energy_.add(frame.time, frame.energy);
  depth_ = frame.depth;
  time_ = frame.time;
  energy_now_ = frame.energy;
  limits_ = frame.device_limits;
  rate_ = frame.rate;
  const std::size_t count = std::min(forces::count_of(frame.diagnostic_names), frame.diagnostics.size());
  if (numbers_.size() != count) {
    numbers_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const forces::DiagnosticName& name = frame.diagnostic_names[i];
      numbers_.push_back({in_words(std::string(name.title)), unit_of(name.name),
                          name.name == "wall_mm" || name.name == "reference_mm"});
    }
  }
  for (std::size_t i = 0; i < count; ++i) numbers_[i].value = frame.diagnostics[i];
  if (frame.clock - drawn_ < dock_interval && frame.clock >= drawn_ && !changes.theme) return;
  drawn_ = frame.clock;
  timings_.reset();
  if (frame.timings != nullptr) timings_ = *frame.timings;
  update();
}

std::optional<double> DiagnosticsDock::wall_distance() const {
  for (const Number& number : numbers_) {
    if (number.is_wall) return number.value - depth_;
  }
  return std::nullopt;
}

void DiagnosticsDock::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), Theme::now().panel);
  painter.setRenderHint(QPainter::Antialiasing);
  const double left = dock_gap, wide = width() - 2.0 * dock_gap;
  const double model =
      30.0 + 18.0 * static_cast<double>(std::max<std::size_t>(1, numbers_.size())) + (wall_distance() ? 44.0 : 0.0);
  const double rest = std::max(0.0, height() - model - 4.0 * dock_gap);
  double y = 8.0;
  const auto next = [&](double high) {
    const QRectF box(left, y, wide, high);
    y += high + dock_gap;
    return box;
  };
  draw_loop(painter, next(0.38 * rest));
  draw_model(painter, next(model));
  draw_energy(painter, next(0.27 * rest));
  draw_log(painter, next(0.35 * rest));
}

// The rest of the box below the heading.
QRectF DiagnosticsDock::heading(QPainter& painter, const QRectF& box, const QString& title) const {
  set_font(painter, text_size, true);
  draw_text(painter, {box.left(), box.top() + 14.0}, title, Theme::now().text);
  return box.adjusted(0.0, 24.0, 0.0, 0.0);
}

void DiagnosticsDock::draw_loop(QPainter& painter, const QRectF& box) const {
  const Theme& theme = Theme::now();
  const QRectF inner = heading(painter, box, tr("Force loop"));
  set_font(painter, label_size);
  if (!timings_ || timings_->ticks == 0) {
    return draw_text(painter, {inner.left(), inner.top() + 12.0}, tr("It is not running"), theme.second);
  }
  constexpr double from = 1e-6, to = 1e-2;  // s
  const QRectF plot = inner.adjusted(0.0, 0.0, 0.0, -68.0);
  const auto count = static_cast<std::size_t>(std::max(8.0, plot.width() / 4.0));
  const std::vector<double> compute = histogram_columns(timings_->compute, from, to, count);
  const std::vector<double> late = histogram_columns(timings_->lateness, from, to, count);
  double most = 0.0;
  for (std::size_t i = 0; i < count; ++i) most = std::max({most, compute[i], late[i]});
  // The root of the fraction, so that one slow tick in a thousand is visible.
  const auto bars = [&](const std::vector<double>& shares, QColor colour, double opacity) {
    colour.setAlphaF(opacity);
    for (std::size_t i = 0; i < count; ++i) {
      if (shares[i] <= 0.0) continue;
      const double high = std::max(1.5, plot.height() * std::sqrt(shares[i] / most));
      painter.fillRect(QRectF(plot.left() + plot.width() * static_cast<double>(i) / static_cast<double>(count),
                              plot.bottom() - high, plot.width() / static_cast<double>(count) - 1.0, high),
                       colour);
    }
  };
  bars(late, theme.caution, 0.7);
  bars(compute, theme.accent, 0.85);
  painter.setPen(QPen(theme.line, 1.0));
  painter.drawLine(plot.bottomLeft(), plot.bottomRight());
  const double period = std::log(1.0 / rate_ / from) / std::log(to / from);
  painter.setPen(QPen(theme.danger, 1.0, Qt::DashLine));
  painter.drawLine(QPointF(plot.left() + period * plot.width(), plot.top()),
                   QPointF(plot.left() + period * plot.width(), plot.bottom()));
  constexpr std::array<const char*, 5> marks = {"1 µs", "10", "100", "1 ms", "10"};
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const double x = plot.left() + plot.width() * static_cast<double>(i) / 4.0;
    draw_text(painter, {x, plot.bottom() + 14.0}, QString::fromUtf8(marks[i]), theme.second,
              i == 0   ? Anchor::left
              : i == 4 ? Anchor::right
                       : Anchor::middle);
  }
  const auto row = [&](double y, const QColor& colour, const QString& words) {
    painter.fillRect(QRectF(plot.left(), y - 8.0, 8.0, 8.0), colour);
    draw_text(painter, {plot.left() + 14.0, y}, words, theme.second);
  };
  const haptics::LatencyHistogram& work = timings_->compute;
  row(plot.bottom() + 32.0, theme.accent,
      tr("a tick takes %1, 99 %: %2, most %3")
          .arg(microseconds(work.percentile(0.5)), microseconds(work.percentile(0.99)),
               microseconds(work.maximum())));
  row(plot.bottom() + 48.0, theme.caution,
      tr("begins late by %1, 99 %: %2")
          .arg(microseconds(timings_->lateness.percentile(0.5)), microseconds(timings_->lateness.percentile(0.99))));
  draw_text(painter, {plot.left() + 14.0, plot.bottom() + 64.0},
            tr("%1 of %2 overran").arg(timings_->overruns).arg(timings_->ticks), theme.second);
}

void DiagnosticsDock::draw_model(QPainter& painter, const QRectF& box) const {
  const Theme& theme = Theme::now();
  const QRectF inner = heading(painter, box, tr("Force model"));
  set_font(painter, label_size);
  double y = inner.top() + 12.0;
  if (numbers_.empty()) draw_text(painter, {inner.left(), y}, tr("It has no values to show"), theme.second);
  for (const Number& number : numbers_) {
    const QString value = tr("%1 %2").arg(three_digits(number.value), number.unit);
    const int room = static_cast<int>(inner.width()) - painter.fontMetrics().horizontalAdvance(value) - 10;
    draw_text(painter, {inner.left(), y}, painter.fontMetrics().elidedText(number.title, Qt::ElideRight, room),
              theme.second);
    draw_text(painter, {inner.right(), y}, value, theme.text, Anchor::right);
    y += 18.0;
  }
  if (wall_distance()) draw_wall(painter, QRectF(inner.left(), y - 6.0, inner.width(), 40.0));
}

// The millimetres about the tip, which is in the middle; deeper is to the right.
void DiagnosticsDock::draw_wall(QPainter& painter, const QRectF& box) const {
  constexpr double half = 5.0;  // mm to each side
  const Theme& theme = Theme::now();
  const QColor wall(0xC7, 0x92, 0xEA);
  const double ahead = *wall_distance(), line = box.top() + 18.0;
  const auto x_of = [&](double millimetres) {
    return box.center().x() + 0.5 * box.width() * std::clamp(millimetres / half, -1.0, 1.0);
  };
  painter.setPen(QPen(theme.line, 1.0));
  painter.drawLine(QPointF(box.left(), line), QPointF(box.right(), line));
  for (int mark = -5; mark <= 5; ++mark) {
    painter.drawLine(QPointF(x_of(mark), line - 2.0), QPointF(x_of(mark), line + 2.0));
  }
  painter.setPen(QPen(wall, 3.0));
  painter.drawLine(QPointF(x_of(ahead), line - 9.0), QPointF(x_of(ahead), line + 9.0));
  painter.setPen(QPen(theme.panel, 1.0));
  painter.setBrush(theme.text);
  const QPointF tip[] = {{x_of(0.0), line}, {x_of(0.0) - 10.0, line - 5.0}, {x_of(0.0) - 10.0, line + 5.0}};
  painter.drawConvexPolygon(tip, 3);
  const QString words = ahead >= 0.0 ? tr("wall %1 mm ahead of the tip").arg(ahead, 0, 'f', 2)
                                     : tr("tip %1 mm beyond the wall").arg(-ahead, 0, 'f', 2);
  draw_text(painter, {box.center().x(), line + 20.0}, words, theme.second, Anchor::middle);
}

void DiagnosticsDock::draw_energy(QPainter& painter, const QRectF& box) const {
  const Theme& theme = Theme::now();
  const QRectF inner = heading(painter, box, tr("Energy given to the tissue"));
  set_font(painter, label_size);
  draw_text(painter, {box.right(), box.top() + 14.0}, tr("%1 N mm").arg(energy_now_, 0, 'f', 1), theme.text,
            Anchor::right);
  painter.setPen(QPen(theme.line, 1.0));
  painter.drawLine(inner.bottomLeft(), inner.bottomRight());
  const ChartColumn& range = energy_.range();
  if (range.empty() || inner.height() < 8.0) return;
  const double low = std::min(0.0F, range.least), high = std::max(1.0F, range.most);
  const auto count = static_cast<std::size_t>(inner.width());
  const std::vector<ChartColumn> columns = energy_.columns(0.0, std::max(10.0, energy_.reach()), count);
  QPolygonF line;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].empty()) continue;
    line << QPointF(inner.left() + static_cast<double>(i),
                    inner.bottom() - inner.height() * (columns[i].most - low) / (high - low));
  }
  painter.setPen(QPen(theme.good, 1.5));
  painter.drawPolyline(line);
}

QString DiagnosticsDock::words_of_limits() const {
  if (!limits_) return {};
  if (limits_->peak_force <= 0.0) return tr("the device renders no force");
  return tr("the device: at most %1 N, %2 N for long, %3 N/mm")
      .arg(limits_->peak_force, 0, 'g', 3)
      .arg(limits_->continuous_force, 0, 'g', 3)
      .arg(limits_->stiffness, 0, 'g', 2);
}

void DiagnosticsDock::draw_log(QPainter& painter, const QRectF& box) const {
  const Theme& theme = Theme::now();
  const QRectF inner = heading(painter, box, tr("Messages of the guard and the station"));
  set_font(painter, label_size);
  double y = inner.top() + 12.0;
  if (const QString words = words_of_limits(); !words.isEmpty()) {
    draw_text(painter, {inner.left(), y}, words, theme.second);
    y += 17.0;
  }
  if (log_.lines().empty()) draw_text(painter, {inner.left(), y}, tr("Nothing"), theme.second);
  for (const GuardLog::Line& line : log_.lines()) {
    if (y > box.bottom()) break;
    draw_text(painter, {inner.left() + 40.0, y}, tr("%1 s").arg(line.time, 0, 'f', 1), theme.second, Anchor::right);
    QString words = in_words(line.words);
    if (line.times > 1) words += tr(" (%1 times)").arg(line.times);
    const QRectF room(inner.left() + 50.0, y - painter.fontMetrics().ascent(), inner.width() - 52.0, inner.height());
    const int how = static_cast<int>(Qt::AlignLeft | Qt::AlignTop) | Qt::TextWordWrap;
    painter.setPen(line.bad ? theme.danger : theme.text);
    painter.drawText(room, how, words);
    y += painter.boundingRect(room, how, words).height() + 3.0;
  }
}

}  // namespace bodkin::views
