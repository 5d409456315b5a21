#pragma once

#include <QWidget>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/pages/other_hand.h"
#include "views/banner.h"
#include "views/bullseye.h"
#include "views/depth_ladder.h"
#include "views/diagnostics_dock.h"
#include "views/force_chart.h"
#include "views/numbers.h"
#include "views/slice_view.h"
#include "views/tip_label.h"
#include "views/ultrasound_view.h"
#include "views/view3d.h"
#include "views/volume_view.h"

#include "training/plan.h"

class QLabel;
class QPushButton;
class QSplitter;

namespace bodkin::app {

using namespace views;

// The page of an insertion: the patient in 3-D with the essential facts in its corners, three slices, the force, four
// numbers and the buttons. Arranges and connects widgets; draws nothing.
class PractisePage : public QWidget {
  Q_OBJECT
 public:
  explicit PractisePage(QWidget* parent = nullptr);

  void set_case(const std::shared_ptr<const OpenCase>& patient);
  void show_frame(const Frame& frame, const Changes& changes);

  const std::vector<View*>& views() const { return views_; }
  View3d& view3d() { return *view3d_; }
  // Moves the focus to the next or previous visible view.
  void focus_next(bool backwards);
  void toggle_ladder();
  void toggle_numbers();
  // The numbers for researchers instead of the slices.
  void toggle_dock();
  // Enlarges the view with the focus to the whole page, and back.
  void toggle_fill();
  // Ultrasound in the big slot, the slices below; empty: without. Throws InputError, without a change, if the probe
  // cannot be held as the choice says.
  void show_ultrasound(const std::optional<station::UltrasoundChoice>& choice);
  UltrasoundView& ultrasound() { return *ultrasound_; }
  OtherHandBar& other_hand() { return *other_hand_; }
  // Shows or hides the volume view of the patient, beside slices and ultrasound in a separate big slot; no effect if
  // a training stage hides the inside.
  void toggle_volume();
  VolumeView& volume() { return *volume_; }
  bool has_volume() const { return has_volume_; }
  bool may_show_volume() const { return aids_.inside && aids_.slices && aids_.ladder; }
  // The aids that a stage of a training plan permits.
  void set_aids(const training::PlanAids& aids);
  // The strip at the top: the plan with its progress, and the next step of the procedure; both empty: no strip.
  void show_plan(const QString& standing, const QString& step);
  // Stores the splitter positions for the next use on a screen of this size.
  void save_layout() const;
  // Moves this view into the big slot of the slices.
  void make_big(View* view);

  // The moving mode of the body, with its buttons.
  void show_moving(const std::optional<View3d::Workspace>& workspace);

 signals:
  void moving_toggled();
  void moving_undone();
  void moving_reset();
  void hold_requested();
  void again_requested();
  void end_requested();
  void warning_acknowledged();
  void message_requested(const QString& sentence);  // why something could not be kept

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* make_instruments();
  QWidget* make_slices();
  QWidget* make_strip();
  void make_moving();
  void arrange_overlays();
  void show_probe(const Frame& frame);
  void take_measures(const std::filesystem::path& folder);
  void save_measures();
  void arrange_slices();
  void arrange_columns();
  void restore_layout();
  void reset_layout();

  View3d* view3d_;
  TipLabel* tip_;
  Bullseye* bullseye_;
  DepthLadder* ladder_;
  Banner* banner_;
  ForceChart* chart_;
  Numbers* numbers_;
  DiagnosticsDock* dock_;
  UltrasoundView* ultrasound_;
  VolumeView* volume_;
  OtherHandBar* other_hand_;
  training::PlanAids aids_{.ultrasound = true};  // without a plan everything may be seen
  bool has_ultrasound_ = false, has_volume_ = false;
  std::optional<anatomy::UltrasoundProbe> probe_;    // of the live ultrasound
  std::optional<std::pair<Pose, double>> outlined_;  // where it is drawn, and the depth of its picture, mm
  std::shared_ptr<Measures> measures_ = std::make_shared<Measures>();  // of all slices
  std::filesystem::path measured_in_;                                  // the patient's folder
  std::vector<SliceView*> slices_;                                     // the first one is big
  std::vector<View*> views_;                                           // all of them
  QSplitter* columns_ = nullptr;
  QSplitter* left_ = nullptr;
  QWidget* right_ = nullptr;
  QWidget* strip_ = nullptr;
  QLabel* standing_ = nullptr;
  QLabel* step_ = nullptr;
  QWidget* instruments_ = nullptr;
  QPushButton* hold_ = nullptr;
  QPushButton *move_ = nullptr, *undo_ = nullptr, *reset_ = nullptr;  // the body
  QPushButton* inside_ = nullptr;                                     // the volume
  View* filled_ = nullptr;
};

}  // namespace bodkin::app
