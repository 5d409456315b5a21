#pragma once

#include <QPointF>
#include <memory>
#include <optional>
#include <string>

#include "scene/camera_moves.h"
#include "scene/volume_picture.h"
#include "views/moving_detail.h"
#include "views/view.h"

namespace bodkin::views {

// The inside of the patient without surfaces: colour, grey, the largest HU or the sum on each ray, with needle, path
// and target at their depth. It is drawn on its own threads: by the processor coarsely while the camera or the look
// changes and in full shortly afterwards, by a graphics card in full at once.
//
// Mouse: a drag turns the patient, with the middle button it moves him, with the right one it sets the window
// (brightness in a sum); the wheel zooms; a double click asks for the whole page. Keys: 0 to 6 views, M next mode, P
// next preset, arrows turn, + - zoom.
class VolumeView : public View {
  Q_OBJECT
 public:
  explicit VolumeView(const QString& place, QWidget* parent = nullptr);
  ~VolumeView() override;

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void show_frame(const Frame& frame, const Changes& changes) override;
  // Nothing is prepared before the view is first shown, and nothing drawn while it is hidden.

  const imaging::VolumeLook& look() const { return look_; }
  void set_look(const imaging::VolumeLook& look);
  void set_mode(imaging::VolumeMode mode);
  void choose_preset(imaging::TransferPreset preset);
  const scene::Camera& camera() const { return camera_; }
  void set_camera(const scene::Camera& camera);
  void choose_view(scene::StandardView view);
  bool press(int key);  // false: not a key of this view
  scene::VolumeDrawer drawer() const { return drawer_; }
  void set_drawer(scene::VolumeDrawer drawer);
  // The graphics card in use, and why a requested one is not; either may be empty.
  const std::string& card() const { return card_; }
  const std::string& refusal() const { return refusal_; }

  // The patient's volume; null until it is prepared.
  std::shared_ptr<const imaging::PreparedVolume> volume() const;
  // The displayed image; its base is null before the first one.
  const scene::VolumePicture& picture() const { return picture_; }
  // Whether the image has full quality and shows the newest settings.
  bool is_settled() const;

 signals:
  void ready();  // volume() is there
  void look_changed();
  void drawer_changed();                                       // card() or refusal()
  void preset_chosen(bodkin::imaging::TransferPreset preset);  // by choose_preset() or by its key; look() has it

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  scene::VolumeRequest request_for(int level) const;
  void order_what_is_missing();
  void take_volume();
  void take_drawer();
  void show_needle(const Frame& frame);

  std::shared_ptr<const OpenCase> patient_;
  std::unique_ptr<scene::VolumeJob> job_;
  scene::VolumePicture picture_;
  MovingDetail moving_detail_;
  scene::VolumeDrawer drawer_ = scene::VolumeDrawer::automatic;
  bool by_card_ = false;
  std::string card_, refusal_;
  imaging::VolumeLook look_;
  imaging::TransferPreset preset_ = imaging::TransferPreset::bone;
  scene::Camera camera_;
  scene::ViewSubject subject_;
  std::optional<scene::CameraFlight> flight_;
  double flight_began_ = 0.0, clock_ = 0.0, changed_at_ = 0.0;  // s
  std::optional<scene::VolumeRequest> requested_;
  bool has_volume_ = false, moved_ = true;
  int shown_percent_ = -1;
  double scale_ = 1.0;  // pixels of the picture for one of the widget
  std::vector<scene::NeedleLook> needles_;
  scene::SceneMarks marks_;
  Qt::MouseButton dragged_ = Qt::NoButton;
  QPointF pointer_;
};

}  // namespace bodkin::views
