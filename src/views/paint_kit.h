#pragma once

#include <QColor>
#include <QPainter>
#include <QPointF>
#include <QString>

#include "views/frame.h"

namespace bodkin::views {

// Sets the window's font for the next text; see font().
void set_font(QPainter& painter, int pixels, bool strong = false);

// Position of a text relative to its point, which is on its base line.
enum class Anchor { left, middle, right };

// Text on an image: with a dark border, so that it is legible on white bone too.
void draw_text_on_picture(QPainter& painter, const QPointF& at, const QString& text, const QColor& colour,
                          Anchor anchor = Anchor::left);
// Text on a plain background.
void draw_text(QPainter& painter, const QPointF& at, const QString& text, const QColor& colour,
               Anchor anchor = Anchor::left);
// A line with a black border of `border` pixels on each side.
void draw_line_on_picture(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& colour,
                          double width, double border = 1.5);

// The shape of the needle's tip shows its state independently of colour vision.
enum class TipShape {
  hollow,    // above the skin
  filled,    // in tissue
  square,    // on bone
  triangle,  // where it is forbidden
  ringed     // at the target
};
TipShape tip_shape(const Frame& frame);
// Nine pixels wide, with a dark rim.
void draw_tip(QPainter& painter, const QPointF& at, TipShape shape, const QColor& tissue);

}  // namespace bodkin::views
