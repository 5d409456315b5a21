#include "views/clearance_legend.h"

#include "views/clearance_colour.h"
#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

ClearanceLegend::ClearanceLegend(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFixedSize(214, 58);
  setAccessibleName(tr("Colours of the skin: clearance of a path that begins there"));
}

void ClearanceLegend::show_message(const QString& sentence) {
  if (sentence == message_) return;
  message_ = sentence;
  update();
}

void ClearanceLegend::paintEvent(QPaintEvent* /*event*/) {
  constexpr double margin = 12.0, bar = 10.0;  // pixels
  const Theme& theme = Theme::dark();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = theme.panel;
  ground.setAlphaF(0.88);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawRoundedRect(rect(), corner, corner);
  painter.setRenderHint(QPainter::Antialiasing, false);
  const int first = static_cast<int>(margin), last = width() - static_cast<int>(margin);
  for (int x = first; x < last; ++x) {
    const float share = static_cast<float>(x - first) / static_cast<float>(last - first);
    painter.fillRect(QRectF(x, margin, 1.0, bar), QColor(static_cast<QRgb>(clearance_colour(share * map_top))));
  }
  set_font(painter, label_size);
  const double below = margin + bar + 14.0;
  draw_text(painter, {margin, below}, tr("blocked"), theme.second);
  draw_text(painter, {0.5 * width(), below}, message_.isEmpty() ? tr("clearance") : message_, theme.text,
            Anchor::middle);
  draw_text(painter, {width() - margin, below}, tr("%1 mm").arg(static_cast<int>(map_top)), theme.second,
            Anchor::right);
}

}  // namespace bodkin::views
