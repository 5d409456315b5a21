#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "views/changes.h"
#include "views/frame.h"
#include "views/open_case.h"

namespace bodkin::views {

// A widget that draws the patient, the needle or the force, and emits the person's requests. It changes no model and
// never draws on its own: show_frame() determines whether anything that it shows has changed, and calls update()
// once.
class View : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;

  // Sets another patient, or none (null). Long work belongs on the view's own thread; until it is done the view says
  // what it prepares.
  virtual void set_case(std::shared_ptr<const OpenCase> patient) = 0;
  // The newest frame, at most 60 times a second, only for visible views.
  virtual void show_frame(const Frame& frame, const Changes& changes) = 0;

 signals:
  // The person's requests; MainWindow connects them with the hand and the models.
  void aimed(const bodkin::Vec3& point, const bodkin::Vec3& outwards);  // the pointer is over the skin: LPS mm, unit
  void aim_left();                                                      // it is not any more
  void put_down();                                  // a click on the skin: the tip is put down where the needle aims
  void pushed(double notches, bool fine);           // of the wheel, positive: inwards
  void dragged(double millimetres);                 // the hub was dragged along the needle, positive: inwards
  void tilted(double right, double cranial);        // rad, the hub was dragged about the tip
  void crosshair_moved(const bodkin::Vec3& point);  // LPS mm
  void follow_tip_toggled();
  void fill_requested();  // double click: move this view to the large slot
};

}  // namespace bodkin::views
