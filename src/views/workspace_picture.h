#pragma once

#include <QWidget>
#include <optional>

#include "core/geometry.h"
#include "haptics/device.h"

namespace bodkin::views {

// The position of a device's tool in its workspace, from above and from the operator's right, with the applied force
// as a bar.
class WorkspacePicture : public QWidget {
 public:
  explicit WorkspacePicture(QWidget* parent = nullptr);

  // `hand`: mm, operator's frame; nothing: the device is not open. `force`: N, of `strongest` N.
  void show_hand(const haptics::DeviceAbilities& abilities, const std::optional<Pose>& hand, double force);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Side;
  Side side(bool from_above) const;
  void draw_side(QPainter& painter, const Side& side, const QString& title) const;

  Vec3 low_ = Vec3::Constant(-100.0), high_ = Vec3::Constant(100.0);  // mm
  bool box_is_known_ = false;
  std::optional<Pose> hand_;
  double force_ = 0.0, strongest_ = 0.0;
};

}  // namespace bodkin::views
