#pragma once

#include <QWidget>

#include "views/frame.h"

class QPushButton;

namespace bodkin::app {

// The tasks of the hand without the needle on this patient: palpate the skin, remove the stylet, connect the
// manometer, press the plunger, ask the patient to hold the breath. A row of buttons that show the state; those
// without a use for this patient are hidden.
class OtherHandBar : public QWidget {
  Q_OBJECT
 public:
  explicit OtherHandBar(QWidget* parent);

  void show_frame(const views::Frame& frame);

 signals:
  void finger_turned();
  void stylet_turned();
  void manometer_turned();
  void breath_turned();
  void plunger_pressed(bool on);
  void filling_chosen(bool air);

 private:
  QPushButton* add(const char* name, const QString& tip);

  QPushButton *finger_, *stylet_, *manometer_, *plunger_, *air_, *breath_;
};

}  // namespace bodkin::app
