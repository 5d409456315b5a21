#pragma once

#include <QPoint>
#include <QWidget>

#include "app/models/tour_steps.h"

class QLabel;
class QPushButton;

namespace bodkin::app {

// The balloon of the two-minute tour, over the page on which the needle goes in: says one thing to do, and goes on
// when it is done.
class Tour : public QWidget {
  Q_OBJECT
 public:
  // `page`: over which it lies; `patient`: the view that is turned.
  Tour(QWidget* page, QWidget* patient);

  void begin();
  bool is_running() const { return running_; }
  const TourSteps& steps() const { return steps_; }
  void show_frame(const Frame& frame);
  void end();

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show_step();
  QPoint tail() const;

  TourSteps steps_;
  QWidget* patient_;
  QLabel *number_, *title_, *words_;
  QPushButton* leave_;
  QPoint pressed_;
  bool running_ = false;
  TourSteps::Step shown_ = TourSteps::Step::done;
};

}  // namespace bodkin::app
