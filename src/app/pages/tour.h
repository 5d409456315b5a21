#pragma once

#include <QPoint>
#include <QWidget>
#include <optional>

#include "app/models/tour_steps.h"
#include "views/view3d.h"

class QLabel;
class QPushButton;

namespace bodkin::app {

// The balloon of the two-minute tour, over the page on which the needle goes in: says one thing to do, and goes on
// when it is done.
class Tour : public QWidget {
  Q_OBJECT
 public:
  // `page`: over which it lies; `patient`: the view that is turned, and that has the ring.
  Tour(QWidget* page, View3d* patient);
  // Where the ring on the skin is on the page; nothing where it is not seen.
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
