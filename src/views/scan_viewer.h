#pragma once

#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>

#include "imaging/ct_scan.h"

namespace bodkin::views {

// The slices of a scan: axial, and next to it the sagittal reformat, in which gaps stay black. The wheel and the
// arrow keys scroll through them, a click marks a lesion, a right drag sets the window.
class ScanViewer : public QWidget {
  Q_OBJECT
 public:
  explicit ScanViewer(QWidget* parent = nullptr);

  // Null: none. More slices may have been added since the last call.
  void set_scan(std::shared_ptr<const imaging::CtScan> scan);
  void show_slice(int index);
  int slice() const { return slice_; }
  void set_window(double window, double level);  // HU
  void set_cine(bool on);
  bool cine() const { return cine_; }
  void advance(double clock);  // s, of the cine
  void set_mark(const std::optional<Vec3>& mark);
  const std::optional<Vec3>& mark() const { return mark_; }
  // Position of a place of the shown slice in the widget, and back (LPS mm).
  QPointF place(const Vec3& point) const;
  std::optional<Vec3> point_at(const QPointF& at) const;

 signals:
  void slice_changed();
  void mark_changed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRectF axial_place() const;
  QRectF sagittal_place() const;
  bool has_slice() const;
  void make_pictures();
  void draw_words(QPainter& painter) const;

  std::shared_ptr<const imaging::CtScan> scan_;
  imaging::ReformattedSlice side_;
  QImage axial_, sagittal_;
  int slice_ = 0;
  std::size_t slices_seen_ = 0;
  double window_ = 400.0, level_ = 40.0;
  bool cine_ = false;
  double stepped_at_ = 0.0;
  std::optional<Vec3> mark_;
  QPointF pointer_;
  bool pictures_stale_ = true;
};

}  // namespace bodkin::views
