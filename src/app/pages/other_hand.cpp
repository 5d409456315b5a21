#include "app/pages/other_hand.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <string_view>
#include <utility>

namespace bodkin::app {

namespace {

constexpr int between = 4;                 // pixels
constexpr double kilopascal = 1000.0;      // of a MPa
constexpr double cubic_mm_of_mL = 1000.0;  // mm^3

double diagnostic(const views::Frame& frame, std::string_view name) {
  for (std::size_t i = 0; i < frame.diagnostic_names.size() && i < frame.diagnostics.size(); ++i)
    if (frame.diagnostic_names[i].name == name) return frame.diagnostics[i];
  return 0.0;
}

void label_button(QPushButton* button, const QString& words, const char* key, bool on) {
  const QString text = QStringLiteral("%1   %2").arg(words, QLatin1String(key));
  if (button->text() != text) button->setText(text);
  button->setChecked(on);
}

}  // namespace

OtherHandBar::OtherHandBar(QWidget* parent) : QWidget(parent) {
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(between);
  finger_ = add("practise.finger", tr("Feel the skin with a finger, or take the needle again (H)"));
  stylet_ = add("practise.stylet", tr("Take the stylet out of the needle, or put it back (S)"));
  manometer_ = add("practise.manometer", tr("Connect the manometer, or take it off (R)"));
  plunger_ = add("practise.plunger", tr("Press the plunger of the syringe as long as the button or B is held"));
  air_ = add("practise.air", tr("Fill the syringe with air, or with saline again; another attempt begins"));
  breath_ = add("practise.breath", tr("Ask the patient to hold the breath, or to breathe again (Z)"));
  air_->setText(tr("Air"));
  air_->setAccessibleName(air_->text());
  for (const auto& [button, words] :
       {std::pair{finger_, tr("Finger")}, std::pair{stylet_, tr("Stylet")}, std::pair{manometer_, tr("Manometer")},
        std::pair{plunger_, tr("Plunger")}, std::pair{breath_, tr("Breath")}})
    button->setAccessibleName(words);
  connect(finger_, &QPushButton::clicked, this, &OtherHandBar::finger_turned);
  connect(stylet_, &QPushButton::clicked, this, &OtherHandBar::stylet_turned);
  connect(manometer_, &QPushButton::clicked, this, &OtherHandBar::manometer_turned);
  connect(breath_, &QPushButton::clicked, this, &OtherHandBar::breath_turned);
  connect(plunger_, &QPushButton::pressed, this, [this] { emit plunger_pressed(true); });
  connect(plunger_, &QPushButton::released, this, [this] { emit plunger_pressed(false); });
  connect(air_, &QPushButton::clicked, this, &OtherHandBar::filling_chosen);
  hide();
}

QPushButton* OtherHandBar::add(const char* name, const QString& tip) {
  auto* const button = new QPushButton;
  button->setObjectName(QLatin1String(name));
  button->setToolTip(tip);
  button->setCheckable(true);
  button->setFocusPolicy(Qt::NoFocus);  // keys belong to the views
  layout()->addWidget(button);
  return button;
}

void OtherHandBar::show_frame(const views::Frame& frame) {
  const views::OtherHandState& now = frame.other_hand;
  finger_->setVisible(now.has_finger);
  for (QPushButton* const each : {stylet_, manometer_}) each->setVisible(now.has_fluid);
  for (QPushButton* const each : {plunger_, air_}) each->setVisible(now.has_syringe);
  label_button(finger_, tr("Finger"), "H", now.finger);
  const double collected = diagnostic(frame, "csf_collected_mm3") / cubic_mm_of_mL;
  label_button(stylet_,
               now.stylet_in       ? tr("Stylet")
               : collected > 0.005 ? tr("Stylet out, %1 mL").arg(collected, 0, 'f', 1)
                                   : tr("Stylet out"),
               "S", !now.stylet_in);
  const double height = diagnostic(frame, "csf_height_mm");
  label_button(manometer_, now.manometer_on ? tr("Manometer %1 mm").arg(height, 0, 'f', 0) : tr("Manometer"), "R",
               now.manometer_on);
  const double pressure = diagnostic(frame, "syringe_pressure_MPa") * kilopascal;
  label_button(plunger_, now.plunger ? tr("Plunger %1 kPa").arg(pressure, 0, 'f', 0) : tr("Plunger"), "B",
               now.plunger);
  air_->setChecked(now.air);
  breath_->setVisible(now.breathes);
  label_button(breath_,
               !now.holds_breath      ? tr("Breathes")
               : frame.drawn_in > 0.0 ? tr("Breathes out")
                                      : tr("Breath held"),
               "Z", now.holds_breath);
  setVisible(now.has_finger || now.has_fluid || now.has_syringe || now.breathes);
  if (size() != sizeHint()) resize(sizeHint());
}

}  // namespace bodkin::app
