#include "views/paint_kit.h"

#include <array>

#include "views/theme.h"

namespace bodkin::views {

namespace {

QPointF start_of(const QPainter& painter, const QPointF& at, const QString& text, Anchor anchor) {
  if (anchor == Anchor::left) return at;
  const double wide = painter.fontMetrics().horizontalAdvance(text);
  return at - QPointF(anchor == Anchor::right ? wide : 0.5 * wide, 0.0);
}

}  // namespace

void set_font(QPainter& painter, int pixels, bool strong) {
  painter.setFont(font(pixels, strong));
}

void draw_text_on_picture(QPainter& painter, const QPointF& at, const QString& text, const QColor& colour,
                          Anchor anchor) {
  const QPointF start = start_of(painter, at, text, anchor);
  painter.setPen(QColor(0, 0, 0, 110));
  constexpr std::array<QPointF, 8> around = {QPointF{-1, 0},  {1, 0},  {0, -1}, {0, 1},
                                             QPointF{-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
  for (const QPointF& offset : around) painter.drawText(start + offset, text);
  painter.setPen(colour);
  painter.drawText(start, text);
}

void draw_text(QPainter& painter, const QPointF& at, const QString& text, const QColor& colour, Anchor anchor) {
  painter.setPen(colour);
  painter.drawText(start_of(painter, at, text, anchor), text);
}

void draw_line_on_picture(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& colour,
                          double width, double border) {
  painter.setPen(QPen(QColor(0, 0, 0, 200), width + 2.0 * border, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(from, to);
  painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(from, to);
}

TipShape tip_shape(const Frame& frame) {
  if (frame.warning) return frame.warning->kind == Warning::Kind::bone ? TipShape::square : TipShape::triangle;
  if (frame.target_reached) return TipShape::ringed;
  if (frame.tissue == anatomy::tissue::cortical_bone || frame.tissue == anatomy::tissue::cancellous_bone) {
    return TipShape::square;
  }
  return frame.depth > 0.0 ? TipShape::filled : TipShape::hollow;
}

void draw_tip(QPainter& painter, const QPointF& at, TipShape shape, const QColor& tissue) {
  constexpr double half = 4.5;  // pixels
  const QColor rim(0x0E, 0x11, 0x16);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto body = [&] {
    if (shape == TipShape::square) {
      painter.drawRect(QRectF(at.x() - half, at.y() - half, 2.0 * half, 2.0 * half));
    } else if (shape == TipShape::triangle) {
      const std::array<QPointF, 3> corners = {at + QPointF(0.0, -1.3 * half), at + QPointF(1.25 * half, 0.9 * half),
                                              at + QPointF(-1.25 * half, 0.9 * half)};
      painter.drawConvexPolygon(corners.data(), static_cast<int>(corners.size()));
    } else {
      painter.drawEllipse(at, half, half);
    }
  };
  if (shape == TipShape::hollow) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(rim, 4.0));
    body();
    painter.setPen(QPen(Qt::white, 1.75));
    body();
    return;
  }
  painter.setPen(QPen(rim, 1.75));
  painter.setBrush(shape == TipShape::triangle ? Theme::dark().danger : tissue);
  body();
  if (shape != TipShape::ringed) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(rim, 4.5));
  painter.drawEllipse(at, 2.0 * half, 2.0 * half);
  painter.setPen(QPen(Theme::dark().plan, 2.0));
  painter.drawEllipse(at, 2.0 * half, 2.0 * half);
}

}  // namespace bodkin::views
