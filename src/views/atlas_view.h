#pragma once

#include <QPointF>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "patient/acupuncture/atlas.h"
#include "scene/view_software.h"

class QPainter;

namespace bodkin::views {

// The body with points and meridians. A drag turns it, with the right button it moves, the wheel zooms; the point
// under the pointer is lit and named, a click chooses it.
class AtlasView : public QWidget {
  Q_OBJECT
 public:
  explicit AtlasView(QWidget* parent = nullptr);

  void set_body(std::shared_ptr<const patient::Atlas> atlas, std::shared_ptr<const scene::PatientSurfaces> surfaces);
  // The chosen point, or none: it is lit, its meridian, and of a luo-connecting point its collateral.
  void choose(const patient::AtlasPoint* point);
  // The needle of a device, in the operator's frame with its middle at zero (mm); `reach`: mm that its workspace is
  // high, which fills the picture. It lies along the screen: right is right, up is up, away is into the picture. The
  // point that it touches, within 8 mm, is lit and told once. Nothing: no needle.
  void show_needle(const std::optional<Pose>& hand, double reach);
  // LPS mm, of the needle that is shown.
  std::optional<Vec3> tip() const { return tip_; }
  // Without points and names, for practice; then the place that was shown and the true point.
  void hide_points(bool hidden);
  void show_answer(const std::optional<Vec3>& shown);
  // Turns and comes near to a place of the left half.
  void look_at(const Vec3& place, const Vec3& normal);
  void look_at_all();

  bool is_ready() const { return scene_ != nullptr; }
  // Where a place is in the widget, for tests; nothing when it is hidden.
  std::optional<QPointF> place_of(const Vec3& p) const;
  QString said() const { return said_; }
  void say(const QString& sentence);

 signals:
  // A place on the skin, and the point within 8 mm of it (null: none).
  void clicked(const bodkin::Vec3& place, const bodkin::patient::AtlasPoint* point);
  // The needle has come to another point.
  void touched(const bodkin::patient::AtlasPoint* point);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  struct Mark {
    const patient::AtlasPoint* point;
    Vec3 place;
    QPointF at;
  };
  void find_visible();
  bool sees(const Vec3& p) const;
  void paint_meridians(QPainter& painter) const;
  void paint_collateral(QPainter& painter) const;
  void paint_points(QPainter& painter) const;
  const Mark* mark_at(const QPointF& at) const;
  void move_camera(const scene::Camera& camera);

  std::shared_ptr<const patient::Atlas> atlas_;
  std::unique_ptr<scene::SoftwareView> scene_;
  scene::Camera camera_;
  std::vector<Mark> marks_;  // that are seen
  const patient::AtlasPoint* chosen_ = nullptr;
  const patient::AtlasPoint* lit_ = nullptr;
  std::optional<Vec3> shown_, tip_;
  const patient::AtlasPoint* touched_ = nullptr;  // by the needle
  bool hidden_ = false, moved_ = false;
  QPointF pressed_, last_;
  QString said_;
};

}  // namespace bodkin::views
