#include "views/banner.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

#include "views/language.h"
#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr int banner_height = 60, banner_words = 60, banner_margin = 20;  // pixels

}  // namespace

Banner::Banner(QWidget* parent) : View(parent) {
  setVisible(false);
  setCursor(Qt::PointingHandCursor);
  setToolTip(tr("Click when you have read it"));
  setAccessibleName(tr("Warning"));
}

void Banner::set_case(std::shared_ptr<const OpenCase> /*patient*/) {
  warning_.reset();
  setVisible(false);
}

void Banner::show_frame(const Frame& frame, const Changes& changes) {
  if (!changes.warning && !changes.attempt && frame.warning.has_value() == warning_.has_value()) return;
  warning_ = frame.warning;
  setVisible(warning_.has_value());
  if (!warning_) return;
  setAccessibleDescription(in_words(warning_->title) + QStringLiteral(". ") + in_words(warning_->advice));
  updateGeometry();
  resize(sizeHint());
  raise();
  update();
}

QSize Banner::sizeHint() const {
  if (!warning_) return {0, 0};
  const int title = QFontMetrics(views::font(heading_size, true)).horizontalAdvance(in_words(warning_->title));
  const int advice = QFontMetrics(views::font(text_size)).horizontalAdvance(in_words(warning_->advice));
  return {banner_words + std::max({title, advice, 180}) + banner_margin, banner_height};
}

void Banner::mousePressEvent(QMouseEvent* /*event*/) {
  emit acknowledged();
}

void Banner::paintEvent(QPaintEvent* /*event*/) {
  if (!warning_) return;
  const Theme& theme = Theme::dark();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme.danger, 2.0));
  painter.setBrush(QColor(0x45, 0x12, 0x14, 240));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), corner, corner);
  // A triangle with an exclamation mark: a shape as well as a colour.
  const double middle = 0.5 * height();
  const QPointF triangle[] = {{32.0, middle - 14.0}, {48.0, middle + 13.0}, {16.0, middle + 13.0}};
  painter.setPen(QPen(theme.danger, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(theme.danger);
  painter.drawConvexPolygon(triangle, 3);
  painter.setPen(QPen(QColor(0x45, 0x12, 0x14), 3.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(32.0, middle - 5.0), QPointF(32.0, middle + 3.5));
  painter.drawPoint(QPointF(32.0, middle + 9.0));
  const int room = width() - banner_words - banner_margin + 8;
  set_font(painter, heading_size, true);
  draw_text(painter, {double{banner_words}, middle - 5.0},
            painter.fontMetrics().elidedText(in_words(warning_->title), Qt::ElideRight, room), Qt::white);
  set_font(painter, text_size);
  draw_text(painter, {double{banner_words}, middle + 16.0},
            painter.fontMetrics().elidedText(in_words(warning_->advice), Qt::ElideRight, room),
            QColor(0xF3, 0xD9, 0xD8));
}

}  // namespace bodkin::views
