#pragma once

#include <QWidget>
#include <array>
#include <cstdint>
#include <optional>

#include "imaging/volume_rendering/transfer_function.h"

namespace bodkin::views {

// The opacity of each HU as a curve over the patient's histogram. Points are dragged; a double click on the
// background adds one, a right click or Delete removes one.
class OpacityCurve : public QWidget {
  Q_OBJECT
 public:
  explicit OpacityCurve(QWidget* parent = nullptr);

  // Voxels in each 16 HU from -1024 on.
  void set_histogram(const std::array<std::uint32_t, 256>& histogram);
  void set_function(const imaging::TransferFunction& function);
  const imaging::TransferFunction& function() const { return function_; }

  // Position of a HU and an opacity in the widget, and the inverse. The scale of opacity is stretched at the bottom,
  // where curves of soft tissue are.
  QPointF place(double hounsfield, double opacity) const;
  double hounsfield_at(double x) const;
  double opacity_at(double y) const;

 signals:
  void function_changed(const bodkin::imaging::TransferFunction& function);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  QRectF ground() const;
  std::optional<std::size_t> point_at(const QPointF& at) const;
  void change(const imaging::TransferFunction& function);

  imaging::TransferFunction function_;
  std::array<float, 256> heights_{};  // 0 to 1, of the histogram
  std::optional<std::size_t> held_, over_;
};

}  // namespace bodkin::views
