#pragma once

#include <QPoint>
#include <QWidget>
#include <optional>

#include "app/models/tour_steps.h"
#include "views/view3d.h"

class QLabel;
class QPushButton;

namespace bodkin::app {

// The balloon of the two-minute tour, over the practice page: shows one instruction, and the next one when the user
// has followed it.
class Tour : public QWidget {
  Q_OBJECT
 public:
  // `page`: below it; `patient`: the view to turn, which has the ring.
  Tour(QWidget* page, View3d* patient);
  // The position on the page of the ring on the skin; empty if it is not visible.
  std::optional<QPoint> ring(const Frame& frame) const;

  void begin();
  bool is_running() const { return running_; }
  const TourSteps& steps() const { return steps_; }
  void show_frame(const Frame& frame);
  void end();

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show_step(const Frame& frame);
  void place(const Frame& frame);
  QPoint tail() const;

  TourSteps steps_;
  View3d* patient_;
  QLabel *number_, *title_, *words_;
  QPushButton* leave_;
  QPoint pressed_;
  bool running_ = false, tail_right_ = false;
  TourSteps::Step shown_ = TourSteps::Step::done;
};

}  // namespace bodkin::app
