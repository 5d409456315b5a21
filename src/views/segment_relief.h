#pragma once

#include <QImage>
#include <QWidget>
#include <cstdint>
#include <optional>
#include <vector>

#include "anatomy/volume.h"

namespace bodkin::views {

// The structure being corrected, in 3-D: its voxels, shaded by the depth at which rays meet them. Right drag turns
// it; the left button applies the tool at the place of the surface under the pointer.
class SegmentRelief : public QWidget {
  Q_OBJECT
 public:
  explicit SegmentRelief(QWidget* parent = nullptr);

  // `labels` must outlive the view or the next call; null: none. Reads the voxels of `label` again.
  void show_structure(const anatomy::LabelVolume* labels, std::uint16_t label, std::uint32_t colour);
  // rad: about the patient's long axis (0: from behind), and from above (positive).
  void set_turn(double about, double above);

  // The point at which the ray under a position of the widget meets the structure (LPS mm); empty if it does not.
  std::optional<Vec3> surface_at(const QPointF& at) const;
  // Position of a point in the widget.
  QPointF place(const Vec3& point) const;

 signals:
  void pressed(const bodkin::Vec3& point);
  void moved(const bodkin::Vec3& point);
  void released();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void find_box();
  void find_axes();
  void make_picture();
  double depth_along(const Vec3& from) const;

  const anatomy::LabelVolume* labels_ = nullptr;
  std::uint16_t label_ = 0;
  std::uint32_t colour_ = 0xFFFFFF;
  Vec3 middle_ = Vec3::Zero();  // LPS mm, of the structure
  double radius_ = 0.0;         // mm, of its bounding ball; 0: it has no voxel
  double about_ = 0.5, above_ = 0.3;
  Vec3 right_ = Vec3::UnitX(), down_ = -Vec3::UnitZ(), into_ = -Vec3::UnitY();
  double pixel_ = 1.0;  // mm
  QPointF pointer_;
  bool stale_ = true;
  QImage picture_;
};

}  // namespace bodkin::views
