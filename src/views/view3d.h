#pragma once

#include <QElapsedTimer>
#include <QPointF>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "scene/camera_moves.h"
#include "scene/export_surfaces.h"
#include "scene/look_file.h"
#include "scene/stereo.h"
#include "scene/surface_job.h"
#include "scene/view_software.h"
#include "views/view.h"

class QPushButton;

namespace bodkin::views {

class LookPanel;

// The patient in 3-D with the needle, the dented skin, the plan and the target. The image is drawn by the processor
// (SoftwareView); the widget paints it like any other.
//
// Mouse: over the skin it aims, a click puts the needle down; the wheel pushes, Ctrl and the wheel zoom; the hub is
// dragged along the needle or across it; a drag anywhere else turns the patient, with the right or middle button it
// moves him. A click on a face of the cube chooses that view. Keys: 0 to 6 views, P next preset, O the parts with
// their opacity and colour, arrows turn, + - zoom.
class View3d : public View {
  Q_OBJECT
 public:
  // `place`: prefix of the object names of the view and of its buttons: "practise" for "practise.view3d".
  explicit View3d(const QString& place, QWidget* parent = nullptr);
  ~View3d() override;

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void show_frame(const Frame& frame, const Changes& changes) override;

  void set_preset(scene::Preset preset);
  scene::Preset preset() const { return look_.preset; }
  // Visibility, opacity and colour of each part.
  void set_look(const scene::Look& look);
  const scene::Look& look() const { return look_; }
  // One of the looks saved with the case, with its direction of view if it has one.
  void show_saved_look(const std::string& name);
  // Whether the view begins with the case's initial look (the default).
  void set_opens_as_saved(bool opens) { opens_as_saved_ = opens; }
  // The placement of the body in the workspace of the needle's device.
  struct Workspace {
    Vec3 middle = Vec3::Zero();        // LPS mm, point in its middle
    Mat3 rotation = Mat3::Identity();  // operator's axes (right, away, up) to patient
  };
  // Moving mode: the workspace is drawn with its axes, and a drag turns the body in it, with the right or middle
  // button moves it, as long as no needle is down. The workspace is fixed on the screen. Empty: no moving.
  void set_workspace(const std::optional<Workspace>& workspace);
  const std::optional<Workspace>& workspace() const { return workspace_; }
  // Restricts the view to the outside of the patient, overriding other settings, or lifts the restriction.
  void set_outside_only(bool only);
  // The list of parts.
  void show_parts(bool shown);
  void choose_view(scene::StandardView view);
  // See scene::SoftwareView::set_skin_tint; once is_ready().
  void set_skin_tint(const std::vector<std::uint32_t>& tint);
  // Paths of the tip in finished sessions; null: none.
  void set_trails(std::shared_ptr<const std::vector<scene::Trail>> trails) { trails_ = std::move(trails); }
  const std::shared_ptr<const std::vector<scene::Trail>>& trails() const { return trails_; }
  void set_stereo(scene::Stereo stereo);
  scene::Stereo stereo() const { return stereo_; }

  // Writes the visible surfaces to a folder; a message is shown in the view for some seconds. False: they could not
  // be written.
  bool save_surfaces(const QString& folder, scene::SurfaceFormat format);
  // Writes the view as displayed. False: it could not be written.
  bool save_picture(const QString& file);

  // Whether the surfaces are available.
  bool is_ready() const { return scene_ != nullptr; }
  // LPS mm at rest, the points of Frame::displacements; empty until is_ready().
  std::vector<Vec3> deformable_points() const;
  // For tests and pictures; null until is_ready().
  scene::SoftwareView* scene() { return scene_.get(); }
  scene::Camera camera() const { return camera_; }
  void set_camera(const scene::Camera& camera);

 signals:
  void ready();           // is_ready() from now on
  void points_changed();  // deformable_points() have changed
  void preset_changed(bodkin::scene::Preset preset);
  void body_drag_started();                                                    // a drag begins
  void body_placed(const bodkin::Vec3& middle, const bodkin::Mat3& rotation);  // see Workspace

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
  enum class Drag { none, perhaps_turn, turn, pan, hub, hub_along, hub_across };

  void take_surfaces();
  std::unique_ptr<scene::SoftwareView> make_scene(std::shared_ptr<const scene::PatientSurfaces> surfaces) const;
  // One, or with stereo one for each eye.
  std::vector<scene::SoftwareView*> scenes() const;
  scene::PixelBox draw_scenes();
  void open_menu(const QPoint& at);
  void show_message(const QString& sentence);
  void update_scene(const Frame& frame);
  void update_skin(const Frame& frame);
  void aim();
  bool moves_body() const;
  void turn_body(double right, double down);
  void shift_body(double right, double down);
  void draw_workspace(QPainter& painter) const;
  void move_hub(const QPointF& from, const QPointF& to);
  bool is_over_hub(const QPointF& at) const;
  QRectF cube_place() const;
  QRect on_screen(const scene::PixelBox& pixels) const;
  QPointF on_screen(const scene::Place& place) const;
  QRect tip_mark() const;
  // In pixels of the image.
  QPointF in_picture(const QPointF& at) const;
  void fit_picture();
  void paint_preparation(QPainter& painter);
  void place_buttons();
  void make_look_panel(const QString& place);
  void place_look_panel();
  void open_looks_of_case();
  void save_look(const QString& name, bool with_view, bool opens_with);
  void remove_look(const QString& name);
  // False: they could not be written; the view says why.
  bool write_saved_looks(scene::CaseLooks looks);

  std::shared_ptr<const OpenCase> patient_;
  std::unique_ptr<scene::SurfaceJob> job_;
  std::unique_ptr<scene::SoftwareView> scene_, right_scene_;  // the second one for the right eye
  scene::Stereo stereo_ = scene::Stereo::off;
  scene::Picture stereo_picture_;
  QString message_;
  double message_until_ = 0.0;  // s
  int shown_percent_ = -1;

  scene::Camera camera_;
  scene::ViewSubject subject_;
  std::optional<scene::CameraFlight> flight_;
  double flight_began_ = 0.0, camera_moved_ = -1.0, breath_moved_ = -1.0, clock_ = 0.0;  // s
  scene::Look look_;
  scene::CaseLooks saved_looks_;
  bool opens_as_saved_ = true;
  LookPanel* panel_ = nullptr;
  std::optional<Workspace> workspace_;
  bool outside_only_ = false;
  std::shared_ptr<const std::vector<scene::Trail>> trails_;
  scene::NeedleLook needle_;
  bool has_needle_ = false;
  Frame shown_;  // painted over the image; without its spans
  QRect shown_tip_;
  double scale_ = 1.0;  // pixels of the picture for one of the widget

  Drag drag_ = Drag::none;
  QPointF pressed_, pointer_;
  bool pointer_moved_ = false, aimed_ = false;
  std::array<QPushButton*, 4> buttons_{};
  QPushButton* parts_button_ = nullptr;
};

}  // namespace bodkin::views
