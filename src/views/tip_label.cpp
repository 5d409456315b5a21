#include "views/tip_label.h"

#include <QPainter>
#include <utility>

#include "views/language.h"
#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::views {

TipLabel::TipLabel(QWidget* parent) : View(parent) {
  setMinimumSize(150, 56);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAccessibleName(tr("Tissue at the tip"));
}

void TipLabel::set_case(std::shared_ptr<const OpenCase> patient) {
  patient_ = std::move(patient);
  heading_.clear();
  place_.clear();
  update();
}

void TipLabel::show_frame(const Frame& frame, const Changes& changes) {
  if (patient_ == nullptr) return;
  if (!changes.tissue && !changes.state && !changes.warning && !changes.attempt && !changes.theme &&
      !heading_.isEmpty())
    return;
  const bool on_bone =
      frame.tissue == anatomy::tissue::cortical_bone || (frame.warning && frame.warning->kind == Warning::Kind::bone);
  danger_ = frame.warning.has_value();
  colour_ = danger_ ? Theme::dark().danger : tissue_colour(frame.tissue, patient_->patient.library);
  place_ = in_words(frame.place);
  if (frame.depth > 0.0 && frame.has_needle) {
    heading_ = on_bone ? tr("TIP ON BONE") : tr("TIP IN");
  } else if (frame.state == State::touching) {
    heading_ = tr("PRESSING ON");
    place_ = tr("skin");
    colour_ = tissue_colour(anatomy::tissue::skin, patient_->patient.library);
  } else if (frame.has_needle) {
    heading_ = tr("TIP ABOVE");
    place_ = tr("skin");
    colour_ = Theme::dark().second;
  } else {
    heading_ = tr("NEEDLE");
    place_ = tr("not on the patient");
    colour_ = Theme::dark().second;
  }
  update();
}

void TipLabel::paintEvent(QPaintEvent* /*event*/) {
  if (heading_.isEmpty()) return;
  const Theme& theme = Theme::dark();  // it lies on the picture of the patient
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = theme.ground;
  ground.setAlphaF(0.82);
  painter.setPen(QPen(danger_ ? theme.danger : theme.line, danger_ ? 2.0 : 1.0));
  painter.setBrush(ground);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), corner, corner);
  painter.fillRect(QRectF(2.0, 9.0, 5.0, height() - 18.0), colour_);
  set_font(painter, label_size);
  draw_text(painter, {18.0, 23.0}, heading_, theme.second);
  set_font(painter, 19, true);
  draw_text(painter, {18.0, 47.0}, painter.fontMetrics().elidedText(place_, Qt::ElideRight, width() - 28),
            theme.text);
}

}  // namespace bodkin::views
