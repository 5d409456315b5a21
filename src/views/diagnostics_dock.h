#pragma once

#include <QRectF>
#include <memory>
#include <optional>
#include <vector>

#include "views/chart_columns.h"
#include "views/guard_log.h"
#include "views/view.h"

namespace bodkin::views {

// For researchers: the duration and lateness of ticks, the numbers of the force model with its wall next to the tip,
// the energy given by the hand, and the actions of the guard with their reasons.
class DiagnosticsDock : public View {
  Q_OBJECT
 public:
  explicit DiagnosticsDock(QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void show_frame(const Frame& frame, const Changes& changes) override;

  const GuardLog& log() const { return log_; }
  // mm by which the force model's wall is ahead of the tip; empty for a model without a wall.
  std::optional<double> wall_distance() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Number {
    QString title, unit;
    bool is_wall = false;  // a depth beside that of the tip
    double value = 0.0;
  };

  QString words_of_limits() const;
  QRectF heading(QPainter& painter, const QRectF& box, const QString& title) const;
  void draw_loop(QPainter& painter, const QRectF& box) const;
  void draw_model(QPainter& painter, const QRectF& box) const;
  void draw_wall(QPainter& painter, const QRectF& box) const;
  void draw_energy(QPainter& painter, const QRectF& box) const;
  void draw_log(QPainter& painter, const QRectF& box) const;

  GuardLog log_;
  std::optional<anatomy::DeviceLimits> limits_;
  std::vector<Number> numbers_;
  ChartCurve energy_{0.05};
  double depth_ = 0.0, time_ = 0.0, energy_now_ = 0.0;  // mm, s, N mm
  std::optional<haptics::ServoTimings> timings_;
  double rate_ = 1000.0;  // Hz
  double drawn_ = -1.0;   // s on the frame's clock
};

}  // namespace bodkin::views
