#include "views/numbers.h"

#include <QPainter>
#include <cmath>

#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr double angle_to_mend = 5.0;  // degrees: from here the angle is amber

QString minutes(double seconds) {
  const int whole = static_cast<int>(std::floor(std::max(0.0, seconds)));
  return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace

Numbers::Numbers(QWidget* parent) : View(parent) {
  setMinimumSize(200, 96);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAccessibleName(tr("Force, distance to the target, angle and time"));
  set_case(nullptr);
}

void Numbers::set_case(std::shared_ptr<const OpenCase> /*patient*/) {
  const QString none = QStringLiteral("–");
  const QColor ink = Theme::now().text;
  cards_ = {Card{tr("Force along the needle"), none, tr("N"), ink}, Card{tr("To the target"), none, tr("mm"), ink},
            Card{tr("Angle to the plan"), none, QString(), ink}, Card{tr("Time in body"), none, QString(), ink}};
  update();
}

void Numbers::show_frame(const Frame& frame, const Changes& changes) {
  const Theme& theme = Theme::now();
  const QString none = QStringLiteral("–");
  std::array<Card, places> next = cards_;
  for (Card& card : next) card.ink = theme.text;
  next[force].text = frame.has_needle ? QString::number(frame.resistance, 'f', 2) : none;
  if (next[force].text == QLatin1String("-0.00")) next[force].text = QStringLiteral("0.00");
  if (frame.warning) next[force].ink = theme.danger;
  const bool aims = frame.plan.has_value() && frame.has_needle;
  next[target].text = aims ? QString::number(frame.target_distance, 'f', 1) : none;
  if (frame.target_reached) next[target].ink = theme.plan;
  next[angle].text = aims ? QStringLiteral("%1°").arg(frame.off_angle / degree, 0, 'f', 1) : none;
  if (aims && frame.off_angle > angle_to_mend * degree) next[angle].ink = theme.caution;
  next[time].text = minutes(frame.time_in_body);
  // Sixty times a second most of it stays the same.
  if (next == cards_ && !changes.theme) return;
  cards_ = next;
  update();
}

void Numbers::paintEvent(QPaintEvent* /*event*/) {
  const Theme& theme = Theme::now();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  constexpr double gap = grid;
  const double wide = 0.5 * (width() - gap), high = 0.5 * (height() - gap);
  for (std::size_t i = 0; i < cards_.size(); ++i) {
    const Card& card = cards_[i];
    const QRectF box(i % 2 == 0 ? 0.0 : wide + gap, i < 2 ? 0.0 : high + gap, wide, high);
    painter.setPen(QPen(theme.line, 1.0));
    painter.setBrush(theme.raised);
    painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), corner, corner);
    set_font(painter, label_size);
    const double left = box.left() + 12.0;
    draw_text(painter, {left, box.top() + 17.0},
              painter.fontMetrics().elidedText(card.title, Qt::ElideRight, static_cast<int>(wide - 20.0)),
              theme.second);
    set_font(painter, number_size, true);
    const double base = box.bottom() - std::max(8.0, 0.18 * high);
    draw_text(painter, {left, base}, card.text, card.ink);
    const double number = painter.fontMetrics().horizontalAdvance(card.text);
    set_font(painter, text_size);
    draw_text(painter, {left + number + 5.0, base}, card.unit, theme.second);
  }
}

}  // namespace bodkin::views
