#include "views/profile_chart.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <utility>

#include "views/language.h"
#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double chart_left = 44.0, chart_right = 18.0, chart_head = 26.0, chart_foot = 28.0;  // pixels
constexpr double chart_letter = 6.5;  // pixels, of small text

}  // namespace

ProfileChart::ProfileChart(QWidget* parent) : QWidget(parent) {
  setMinimumSize(260, 160);
  setAccessibleName(tr("Force against depth"));
  setToolTip(tr("The force of a slow, straight insertion along the planned path. Solid: now. Dashed: as it was."));
}

void ProfileChart::set_case(std::shared_ptr<const OpenCase> patient) {
  patient_ = std::move(patient);
  now_.reset();
  reference_.reset();
  update();
}

void ProfileChart::show_curves(std::shared_ptr<const ForceCurve> now, std::shared_ptr<const ForceCurve> reference) {
  if (now == now_ && reference == reference_) return;
  now_ = std::move(now);
  reference_ = std::move(reference);
  find_scale();
  update();
}

// Scales that do not jump with every change: rounded up to whole newtons, from both curves.
void ProfileChart::find_scale() {
  double force = 1.0, depth = 10.0, least = 0.0;
  for (const ForceCurve* const curve : {now_.get(), reference_.get()}) {
    if (curve == nullptr) continue;
    for (const ForceCurve::Point& point : curve->points) {
      force = std::max(force, point.force);
      least = std::min(least, point.force);
      depth = std::max(depth, point.depth);
    }
  }
  most_force_ = std::ceil(1.05 * force);
  least_force_ = std::floor(2.0 * least) / 2.0;
  most_depth_ = 10.0 * std::ceil(depth / 10.0);
}

QRectF ProfileChart::plot() const {
  return {chart_left, chart_head, width() - chart_left - chart_right, height() - chart_head - chart_foot};
}

QPointF ProfileChart::place(double depth, double force) const {
  const QRectF box = plot();
  return {box.left() + box.width() * depth / most_depth_,
          box.bottom() - box.height() * (force - least_force_) / (most_force_ - least_force_)};
}

void ProfileChart::draw_bands(QPainter& painter) const {
  if (now_ == nullptr || patient_ == nullptr) return;
  constexpr double line_height = 4.0;
  set_font(painter, label_size);
  for (const ForceCurve::Band& band : now_->bands) {
    const double from = place(band.from, 0.0).x(), to = place(band.to, 0.0).x();
    QColor colour = tissue_colour(band.tissue, patient_->patient.library);
    painter.fillRect(QRectF(from, plot().bottom() - line_height, to - from, line_height), colour);
    colour.setAlpha(Theme::now().is_dark ? 38 : 60);
    painter.fillRect(QRectF(from, plot().top(), to - from, plot().height()), colour);
    const QString name = in_words(patient_->patient.library.title(band.tissue));
    if (to - from > chart_letter * name.size())
      draw_text(painter, {0.5 * (from + to), plot().top() - 7.0}, name, Theme::now().second, Anchor::middle);
  }
}

void ProfileChart::draw_axes(QPainter& painter) const {
  const Theme& theme = Theme::now();
  set_font(painter, label_size);
  const double step = most_force_ > 12.0 ? 4.0 : most_force_ > 5.0 ? 2.0 : most_force_ > 2.0 ? 1.0 : 0.5;
  for (double force = std::ceil(least_force_ / step) * step; force <= most_force_ + 1e-9; force += step) {
    const double y = place(0.0, force).y();
    painter.setPen(QPen(theme.line, 1.0));
    painter.drawLine(QPointF(plot().left(), y), QPointF(plot().right(), y));
    draw_text(painter, {plot().left() - 8.0, y + 4.0}, QString::number(force, 'f', step < 1.0 ? 1 : 0), theme.second,
              Anchor::right);
  }
  draw_text(painter, {plot().left() - 8.0, plot().top() - 7.0}, tr("N"), theme.second, Anchor::right);
  for (double depth = 0.0; depth <= most_depth_ + 1e-9; depth += 10.0) {
    const bool is_last = depth + 10.0 > most_depth_ + 1e-9;
    const QString words = QString::number(depth, 'f', 0);
    draw_text(painter, {place(depth, 0.0).x(), height() - 10.0}, is_last ? tr("%1 mm").arg(words) : words,
              theme.second, is_last ? Anchor::right : Anchor::middle);
  }
}

void ProfileChart::draw_curve(QPainter& painter, const ForceCurve& curve, const QPen& pen) const {
  QPolygonF line;
  line.reserve(static_cast<int>(curve.points.size()));
  for (const ForceCurve::Point& point : curve.points) line << place(point.depth, point.force);
  painter.setPen(pen);
  painter.drawPolyline(line);
}

void ProfileChart::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const Theme& theme = Theme::now();
  painter.setRenderHint(QPainter::Antialiasing);
  draw_bands(painter);
  draw_axes(painter);
  if (reference_ != nullptr) draw_curve(painter, *reference_, QPen(theme.second, 1.5, Qt::DashLine));
  if (now_ != nullptr) draw_curve(painter, *now_, QPen(theme.accent, 2.0));
}

}  // namespace bodkin::views
