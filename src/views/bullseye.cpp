#include "views/bullseye.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "views/language.h"
#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double ring_margin = 10.0;  // pixels about the rings
constexpr double shown_most = 3.0;    // tolerances to the outer ring
constexpr double off_by_much = 2.0;   // tolerances: from here the words are amber

}  // namespace

Bullseye::Bullseye(QWidget* parent) : View(parent) {
  setMinimumSize(200, 84);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAccessibleName(tr("Needle seen along the planned path"));
}

void Bullseye::set_case(std::shared_ptr<const OpenCase> /*patient*/) {
  offset_.reset();
  has_plan_ = false;
  hint_.clear();
  update();
}

void Bullseye::set_path_hidden(bool hidden) {
  is_hidden_ = hidden;
  update();
}

void Bullseye::show_frame(const Frame& frame, const Changes& changes) {
  const QString hint = in_words(frame.hint);
  if (!changes.needle && !changes.plan && !changes.state && !changes.theme && !changes.attempt && hint == hint_)
    return;
  hint_ = hint;
  tolerance_ = std::max(0.1, frame.target_tolerance);
  has_plan_ = frame.plan.has_value();
  offset_.reset();
  if (frame.plan && frame.has_needle) {
    offset_ = path_offset(*frame.plan, frame.needle.translation(), needle_axis(frame.needle));
  }
  update();
}

double Bullseye::radius() const {
  return 0.5 * std::min<double>(height(), 92.0) - ring_margin;
}

QString Bullseye::name_of(Side side) {
  switch (side) {
    case Side::cranial:
      return tr("cranial");
    case Side::caudal:
      return tr("caudal");
    case Side::left:
      return tr("left");
    case Side::right:
      return tr("right");
    case Side::anterior:
      return tr("anterior");
    case Side::posterior:
      return tr("posterior");
    case Side::none:
      break;
  }
  return {};
}

QPointF Bullseye::middle() const {
  return {ring_margin + radius() + 2.0, 0.5 * height()};
}

QPointF Bullseye::place(const Eigen::Vector2d& offset) const {
  Eigen::Vector2d seen = radius() / (shown_most * tolerance_) * offset;
  if (seen.norm() > radius()) seen *= radius() / seen.norm();
  return middle() + QPointF(seen.x(), -seen.y());
}

void Bullseye::paintEvent(QPaintEvent* /*event*/) {
  const Theme& theme = Theme::dark();  // it is drawn over the patient's image
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = theme.ground;
  ground.setAlphaF(0.82);
  painter.setPen(QPen(theme.line, 1.0));
  painter.setBrush(ground);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), corner, corner);

  const QPointF centre = middle();
  const QColor ring_ink(0x4A, 0x56, 0x64), first_ring(0x7C, 0x89, 0x99);
  painter.setBrush(Qt::NoBrush);
  for (const double ring : {1.0, 2.0, 3.0}) {
    painter.setPen(QPen(ring == 1.0 ? first_ring : ring_ink, 1.0));
    painter.drawEllipse(centre, ring / shown_most * radius(), ring / shown_most * radius());
  }
  painter.setPen(QPen(theme.line, 1.0));
  painter.drawLine(centre - QPointF(radius(), 0.0), centre + QPointF(radius(), 0.0));
  painter.drawLine(centre - QPointF(0.0, radius()), centre + QPointF(0.0, radius()));
  if (has_plan_) {
    painter.setPen(QPen(theme.plan, 2.0));
    painter.drawEllipse(centre, 5.0, 5.0);
  }
  if (offset_) {
    const QPointF tip = place(offset_->tip), hub = place(offset_->hub);
    painter.setPen(QPen(theme.second, 1.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(hub, tip);
    painter.setPen(QPen(theme.ground, 1.5));
    painter.setBrush(offset_->distance > off_by_much * tolerance_ ? theme.caution : theme.text);
    painter.drawEllipse(tip, 4.5, 4.5);
  }

  const double left = centre.x() + radius() + 16.0, room = width() - left - 10.0;
  set_font(painter, text_size);
  const bool is_long = painter.fontMetrics().horizontalAdvance(hint_) > room;  // then it has two lines
  double y = centre.y() - (hint_.isEmpty() ? 4.0 : is_long ? 24.0 : 16.0);
  const auto write = [&](const QString& words, const QColor& ink, bool strong) {
    set_font(painter, text_size, strong);
    draw_text(painter, {left, y}, painter.fontMetrics().elidedText(words, Qt::ElideRight, static_cast<int>(room)),
              ink);
    y += 20.0;
  };
  if (offset_) {
    const QColor ink = offset_->distance > off_by_much * tolerance_ ? theme.caution : theme.text;
    QString distance = tr("%1 mm off path").arg(offset_->distance, 0, 'f', 1);
    if (offset_->side != Side::none) distance = tr("%1, %2").arg(distance, name_of(offset_->side));
    write(distance, ink, true);
    write(tr("%1° off plan").arg(offset_->angle, 0, 'f', 1), theme.second, false);
  } else {
    write(is_hidden_  ? tr("The planned path is not shown")
          : has_plan_ ? tr("No needle yet")
                      : tr("No planned path"),
          theme.text, true);
  }
  if (hint_.isEmpty()) return;
  if (!is_long) return write(hint_, theme.second, false);
  set_font(painter, text_size);
  painter.setPen(theme.second);
  const double line = painter.fontMetrics().lineSpacing();
  painter.drawText(QRectF(left, y - painter.fontMetrics().ascent(), room, 2.0 * line + 1.0),
                   static_cast<int>(Qt::AlignLeft | Qt::AlignTop) | Qt::TextWordWrap, hint_);
}

}  // namespace bodkin::views
