#pragma once

#include <QImage>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "views/open_case.h"
#include "views/slice_geometry.h"

namespace bodkin::views {

// One slice of a segmentation under correction: the CT, the structures over it, the brush at the pointer. Mouse: left
// applies the tool, right drag sets the window, middle drag moves the image, the wheel scrolls through the slices,
// with Ctrl it zooms.
class SegmentSlice : public QWidget {
  Q_OBJECT
 public:
  explicit SegmentSlice(SliceKind kind, QWidget* parent = nullptr);

  SliceKind kind() const { return kind_; }
  // `labels` lie on the CT's lattice and must outlive the view or the next call; null: none.
  void set_case(std::shared_ptr<const OpenCase> patient, const anatomy::LabelVolume* labels);
  // `version` shows whether the labels have changed. `colours`: 0xRRGGBB of each label; `active` has an outline.
  void show_labels(std::uint64_t version, std::uint16_t active, const std::vector<std::uint32_t>& colours);
  void set_crosshair(const Vec3& point);
  void set_window(double window, double level);  // HU
  // The outline of the brush at the pointer, mm; empty: a tool without one.
  void set_brush(const std::optional<double>& radius);
  // Shows structures over the CT or only the CT.
  void set_covered(bool on);

  const imaging::SlicePlane& plane() const { return plane_; }
  const QImage& picture();  // of the present state
  // Pixels of the widget, and LPS mm.
  QPointF place(const Vec3& point) const;
  Vec3 point_at(const QPointF& at) const;

 signals:
  void pressed(const bodkin::Vec3& point);
  void moved(const bodkin::Vec3& point);  // with the left button down
  void released();
  void crosshair_moved(const bodkin::Vec3& point);
  void window_changed(double window, double level);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void find_plane();
  void make_picture();
  void scroll(int slices);

  SliceKind kind_;
  std::shared_ptr<const OpenCase> patient_;
  const anatomy::LabelVolume* labels_ = nullptr;
  std::uint64_t version_ = 0;
  std::uint16_t active_ = 0;
  std::vector<std::uint32_t> colours_;
  imaging::SlicePlane plane_;
  Vec3 crosshair_ = Vec3::Zero(), middle_ = Vec3::Zero();
  double field_ = 160.0;  // mm
  double window_ = 400.0, level_ = 40.0;
  std::optional<double> brush_;
  bool covered_ = true;
  QPointF pointer_;
  bool has_pointer_ = false;
  std::vector<float> hounsfield_;
  bool samples_stale_ = true, picture_stale_ = true;
  QImage picture_;
};

}  // namespace bodkin::views
