#pragma once

#include <QPointF>
#include <memory>
#include <vector>

#include "app/models/plan_model.h"
#include "app/page.h"
#include "views/clearance_legend.h"
#include "views/frame.h"
#include "views/measures.h"
#include "views/slice_view.h"
#include "views/view3d.h"

class QComboBox;
class QLabel;
class QMouseEvent;
class QPushButton;
class QTableWidget;

namespace bodkin::app {

using namespace views;

// Editor of entry and target: by clicks in 3-D and in the slices, or from the proposals. Colours the skin by the
// suitability of each entry. Arranges and connects widgets; the logic is in PlanModel.
//
// Mouse: a click on the skin sets the entry; a click in a slice sets the target, with Shift the entry, where the line
// from the target through that point leaves the body. Both points can be dragged.
class PlanPage : public Page {
  Q_OBJECT
 public:
  explicit PlanPage(QWidget* parent = nullptr);
  ~PlanPage() override;

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void enter() override;
  void leave() override;
  void advance(double clock) override;
  bool press(const QKeySequence& keys) override;

  PlanModel* model() { return model_.get(); }  // null: no patient
  View3d& view3d() { return *view3d_; }

 signals:
  // The plan has changed since the page was entered.
  void plan_changed(const bodkin::anatomy::NeedlePath& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum class Drag { none, entry, target, perhaps_click };

  QWidget* make_panel();
  QWidget* make_slices();
  void place_overlays();
  void show_plan();
  void show_proposals();
  void show_map();
  void next_proposal();
  bool press_in_view3d(QMouseEvent* event);
  bool press_in_slice(SliceView* slice, QMouseEvent* event);
  bool drag_to(QObject* watched, const QPointF& at);
  void drop(QObject* watched, QMouseEvent* event);
  std::optional<Vec3> skin_under(const QPointF& at);
  void enter_through(const Vec3& point, bool is_step);

  std::shared_ptr<const OpenCase> patient_, shown_;
  std::unique_ptr<PlanModel> model_;
  View3d* view3d_;
  ClearanceLegend* legend_;
  QLabel* summary_;
  std::vector<SliceView*> slices_;
  QTableWidget* paths_ = nullptr;
  QComboBox* structures_ = nullptr;
  QLabel* message_ = nullptr;
  QPushButton* undo_ = nullptr;
  QPushButton* redo_ = nullptr;
  QPushButton* practise_ = nullptr;
  Frame frame_;
  bool plan_moved_ = true, crosshair_moved_ = true, is_shown_ = false;
  std::optional<anatomy::NeedlePath> entered_with_;
  Drag drag_ = Drag::none;
  QPointF pressed_;
  double clock_ = 0.0;
  int chosen_ = -1;  // of the proposals
};

}  // namespace bodkin::app
