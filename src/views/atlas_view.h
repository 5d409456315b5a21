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
// under the pointer is highlighted and named, a click selects it.
class AtlasView : public QWidget {
  Q_OBJECT
 public:
  explicit AtlasView(QWidget* parent = nullptr);

  void set_body(std::shared_ptr<const patient::Atlas> atlas, std::shared_ptr<const scene::PatientSurfaces> surfaces);
  // Selects a point, or none: highlights it, its meridian, and for a luo-connecting point its collateral.
  void choose(const patient::AtlasPoint* point);
  // Shows the needle of a device, in the operator's frame with its middle at zero (mm); `reach`: mm, height of its
  // workspace, which fills the view. It is aligned with the screen: right is right, up is up, away is into the
  // screen. The point that it touches, within 8 mm, is highlighted and reported once. Empty: no needle.
  void show_needle(const std::optional<Pose>& hand, double reach);
  // LPS mm, of the needle that is shown.
  std::optional<Vec3> tip() const { return tip_; }
  // Hides points and names, for practice; shows the indicated and the true point afterwards.
  void hide_points(bool hidden);
  void show_answer(const std::optional<Vec3>& shown);
  // Turns and zooms to a place of the left half.
  void look_at(const Vec3& place, const Vec3& normal);
  void look_at_all();

  bool is_ready() const { return scene_ != nullptr; }
  // The position of a place in the widget, for tests; empty when it is hidden.
  std::optional<QPointF> place_of(const Vec3& p) const;
  QString message() const { return message_; }
  void show_message(const QString& sentence);

 signals:
  // A place on the skin was clicked, and the point within 8 mm of it (null: none).
  void clicked(const bodkin::Vec3& place, const bodkin::patient::AtlasPoint* point);
  // The needle has reached another point.
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
  QString message_;
};

}  // namespace bodkin::views
