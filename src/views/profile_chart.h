#pragma once

#include <QWidget>
#include <memory>

#include "views/force_curve.h"
#include "views/open_case.h"

namespace bodkin::views {

// Force against depth of one insertion, current (solid) and previous (dashed), over bands of the tissues.
class ProfileChart : public QWidget {
  Q_OBJECT
 public:
  explicit ProfileChart(QWidget* parent = nullptr);

  // Names and colours of the tissues; null: none.
  void set_case(std::shared_ptr<const OpenCase> patient);
  // Either may be null.
  void show_curves(std::shared_ptr<const ForceCurve> now, std::shared_ptr<const ForceCurve> reference);

  // Position of a depth (mm) and a force (N), pixels of the widget.
  QPointF place(double depth, double force) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRectF plot() const;
  void find_scale();
  void draw_axes(QPainter& painter) const;
  void draw_bands(QPainter& painter) const;
  void draw_curve(QPainter& painter, const ForceCurve& curve, const QPen& pen) const;

  std::shared_ptr<const OpenCase> patient_;
  std::shared_ptr<const ForceCurve> now_, reference_;
  double most_force_ = 4.0, most_depth_ = 60.0, least_force_ = 0.0;
};

}  // namespace bodkin::views
