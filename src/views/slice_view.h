#pragma once

#include <QPoint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "scene/marks.h"
#include "views/measures.h"
#include "views/paint_kit.h"
#include "views/slice_geometry.h"
#include "views/slice_image.h"
#include "views/view.h"

namespace bodkin::views {

// A slice of the patient with needle, path, target, crosshair and measures.
//
// Mouse: left drag moves the crosshair, right drag sets the window (sideways its width, up its level), middle drag
// moves the image, Ctrl and wheel zoom, Alt and wheel scroll; the plain wheel scrolls, or pushes the needle during an
// attempt. Double click requests the large slot. Keys: see press().
class SliceView : public View {
  Q_OBJECT
 public:
  explicit SliceView(SliceKind kind, QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void show_frame(const Frame& frame, const Changes& changes) override;

  // All slices of a page share one list; never null.
  void set_measures(std::shared_ptr<Measures> measures);
  // Paths of the tip in finished sessions, drawn faintly where they are not near the plane; null: none.
  void set_trails(std::shared_ptr<const std::vector<scene::Trail>> trails);

  // Whether the next clicks belong to a distance or an angle.
  bool is_measuring() const { return measures_->waiting(); }

  SliceKind kind() const { return kind_; }
  // Shows the plane that contains the needle instead of the view's own.
  void show_along_needle(bool on);
  const SliceLook& look() const { return look_; }
  void set_look(const SliceLook& look);
  // The displayed plane, in pixels of the image: device pixels, not those of the widget.
  imaging::SlicePlane plane() const;
  // Between places of the widget and the patient, LPS mm.
  QPointF to_widget(const Vec3& point) const;
  Vec3 to_patient(const QPointF& place) const;
  // mm along the longer side of the view, 10 to 600.
  double field() const { return field_; }
  void zoom(double factor);
  void show_whole_procedure();  // the zoom and place that a case opens with

 signals:
  void measures_changed();  // other slices draw them too
  void look_changed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  // The parts of the newest frame that are drawn.
  struct Shown {
    State state = State::no_case;
    bool has_needle = false;
    Vec3 tip = Vec3::Zero(), axis = Vec3::UnitY();
    TipShape shape = TipShape::hollow;
    anatomy::TissueId tissue = anatomy::tissue::air;
    std::vector<Pose> left;  // needles that were left in the body
    std::optional<anatomy::NeedlePath> plan;
    bool is_planning = false;
    std::vector<std::pair<double, double>> broken;  // mm of the plan from its entry
    double tolerance = 3.0;                         // mm
    bool reached = false;
    double drawn_in = 0.0;  // breath, 0 to 1
    std::shared_ptr<const imaging::TissueDisplacement> moved_tissue;
    Vec3 crosshair = Vec3::Zero();
    bool follows = true;
    double clock = 0.0;
  };

  bool press(int key);
  void scroll(double steps);
  void step_cine(double clock);
  void next_preset(int direction);
  void next_slab();
  void remove_measure_under_pointer();
  void open_menu(const QPoint& at);
  double scroll_step() const;  // mm
  bool follow(const Vec3& point);

  void draw_crosshair(QPainter& painter) const;
  void draw_plan(QPainter& painter) const;
  void draw_trails(QPainter& painter) const;
  void draw_left_needles(QPainter& painter) const;
  void draw_needle(QPainter& painter) const;
  void draw_measures(QPainter& painter) const;
  void draw_words(QPainter& painter) const;
  QString words_under_pointer() const;
  QColor colour() const;
  QString title() const;
  void name_itself();

  SliceKind kind_, own_kind_;
  std::shared_ptr<const OpenCase> patient_;
  std::shared_ptr<Measures> measures_;
  std::shared_ptr<const std::vector<scene::Trail>> trails_;
  SliceImage image_;
  SliceLook look_;
  Vec3 middle_ = Vec3::Zero();  // LPS mm, in the middle of the view
  double field_ = 135.0;
  Shown shown_;
  bool placed_ = false;      // middle_ has been set for the patient
  bool hides_plan_ = false;  // the attempt does not show the plan

  enum class Drag { none, crosshair, window, pan };
  Drag drag_ = Drag::none;
  QPoint pressed_at_, dragged_to_;
  bool dragged_ = false;
  std::optional<QPoint> pointer_;
  bool cine_ = false;
  double cine_time_ = 0.0;  // s on the frame's clock of the last step
  int cine_direction_ = 1;
};

}  // namespace bodkin::views
