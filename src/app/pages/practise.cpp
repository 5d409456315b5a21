#include "app/pages/practise.h"

#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeySequence>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "app/kept_drawer.h"

namespace bodkin::app {

namespace {

constexpr int margin = 12;                               // pixels, of what lies on the picture
constexpr int slice_column = 452, instrument_row = 164;  // pixels at 1280 x 720
constexpr int gap = 4;
constexpr int ladder_top = 60;  // below the buttons
constexpr int cube = 84;        // the orientation cube of the 3-D view, in its lower left corner

// One for each screen size: a layout for a projector does not fit a laptop.
QString layout_key(const QSplitter& splitter) {
  const QScreen* const screen = QGuiApplication::primaryScreen();
  const QSize size = screen == nullptr ? QSize() : screen->size();
  return QStringLiteral("splitters/%1x%2/%3").arg(size.width()).arg(size.height()).arg(splitter.objectName());
}

}  // namespace

PractisePage::PractisePage(QWidget* parent)
    : QWidget(parent),
      view3d_(new View3d(QStringLiteral("practise"), this)),
      tip_(new TipLabel(view3d_)),
      bullseye_(new Bullseye(view3d_)),
      ladder_(new DepthLadder(view3d_)),
      banner_(new Banner(view3d_)),
      chart_(new ForceChart(this)),
      numbers_(new Numbers(this)),
      dock_(new DiagnosticsDock(this)),
      ultrasound_(new UltrasoundView(this)),
      volume_(new VolumeView(QStringLiteral("practise.volume"), this)),
      other_hand_(new OtherHandBar(view3d_)) {
  setObjectName(QStringLiteral("practise"));
  view3d_->installEventFilter(this);
  const std::shared_ptr<Measures>& measures = measures_;
  for (const auto& [kind, name] : {std::pair{SliceKind::sagittal, "practise.slice.sagittal"},
                                   std::pair{SliceKind::axial, "practise.slice.axial"},
                                   std::pair{SliceKind::coronal, "practise.slice.coronal"}}) {
    auto* slice = new SliceView(kind, this);
    slice->setObjectName(QLatin1String(name));
    slice->set_measures(measures);
    slices_.push_back(slice);
  }
  for (SliceView* slice : slices_) {
    for (SliceView* other : slices_) {
      if (other != slice) connect(slice, &SliceView::measures_changed, other, qOverload<>(&QWidget::update));
    }
    connect(slice, &View::fill_requested, this, [this, slice] { make_big(slice); });
    connect(slice, &SliceView::measures_changed, this, &PractisePage::save_measures);
  }
  views_ = {view3d_, tip_, bullseye_, ladder_, banner_, chart_, numbers_, dock_};
  views_.insert(views_.end(), slices_.begin(), slices_.end());
  views_.push_back(ultrasound_);
  views_.push_back(volume_);
  connect(volume_, &View::fill_requested, this, [this] {
    volume_->setFocus(Qt::MouseFocusReason);
    toggle_fill();
  });
  ultrasound_->setObjectName(QStringLiteral("practise.ultrasound"));
  connect(banner_, &Banner::acknowledged, this, &PractisePage::warning_acknowledged);

  left_ = new QSplitter(Qt::Vertical);
  left_->setObjectName(QStringLiteral("practise.rows"));
  left_->addWidget(view3d_);
  left_->addWidget(make_instruments());
  left_->setStretchFactor(0, 1);
  columns_ = new QSplitter(Qt::Horizontal);
  columns_->setObjectName(QStringLiteral("practise.columns"));
  columns_->addWidget(left_);
  columns_->addWidget(make_slices());
  dock_->setObjectName(QStringLiteral("practise.dock"));
  dock_->hide();
  columns_->addWidget(dock_);
  columns_->setStretchFactor(0, 3);
  columns_->setStretchFactor(1, 2);
  for (QSplitter* splitter : {left_, columns_}) {
    splitter->setHandleWidth(gap);
    splitter->setChildrenCollapsible(false);
  }
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(0);
  whole->addWidget(make_strip());
  whole->addWidget(columns_, 1);
  for (QSplitter* splitter : {left_, columns_}) splitter->handle(1)->installEventFilter(this);
  make_moving();
  reset_layout();
  restore_layout();
}

void PractisePage::make_moving() {
  const auto button = [&](const QString& text, const char* name, const QString& tip) {
    auto* made = new QPushButton(text, view3d_);
    made->setObjectName(QLatin1String(name));
    made->setAccessibleName(text);
    made->setToolTip(tip);
    made->setFocusPolicy(Qt::NoFocus);
    return made;
  };
  move_ = button(tr("Move the body"), "practise.move",
                 tr("Turn and move the body in the workspace of the device, needle outside (G)"));
  move_->setCheckable(true);
  undo_ = button(tr("Undo"), "practise.move.undo", tr("Undo the last move of the body (Ctrl+Z)"));
  reset_ =
      button(tr("As at first"), "practise.move.reset", tr("Put the body back where it was at first (Ctrl+Home)"));
  inside_ =
      button(tr("Volume"), "practise.volume",
             tr("The inside of the patient from the CT, next to the slices (I); M for the mode, P for the preset"));
  inside_->setCheckable(true);
  connect(inside_, &QPushButton::clicked, this, &PractisePage::toggle_volume);
  connect(move_, &QPushButton::clicked, this, &PractisePage::moving_toggled);
  connect(undo_, &QPushButton::clicked, this, &PractisePage::moving_undone);
  connect(reset_, &QPushButton::clicked, this, &PractisePage::moving_reset);
  show_moving({});
}

void PractisePage::show_moving(const std::optional<View3d::Workspace>& workspace) {
  const bool was_moving = view3d_->workspace().has_value();
  view3d_->set_workspace(workspace);
  // The ladder would cover the workspace.
  if (aids_.ladder && was_moving != workspace.has_value()) ladder_->setVisible(was_moving);
  move_->setChecked(workspace.has_value());
  undo_->setVisible(workspace.has_value());
  reset_->setVisible(workspace.has_value());
  arrange_overlays();  // a hidden widget has no place
}

void PractisePage::reset_layout() {
  left_->setSizes({508, instrument_row});
  columns_->setSizes({828, slice_column});
}

void PractisePage::save_layout() const {
  QSettings settings;
  for (const QSplitter* splitter : {left_, columns_}) settings.setValue(layout_key(*splitter), splitter->saveState());
}

void PractisePage::restore_layout() {
  const QSettings settings;
  for (QSplitter* splitter : {left_, columns_})
    splitter->restoreState(settings.value(layout_key(*splitter)).toByteArray());
}

QWidget* PractisePage::make_strip() {
  strip_ = new QWidget;
  strip_->setObjectName(QStringLiteral("panel"));
  strip_->setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(strip_);
  row->setContentsMargins(margin, 6, margin, 6);
  row->setSpacing(2 * margin);
  standing_ = new QLabel;
  standing_->setObjectName(QStringLiteral("practise.plan"));
  row->addWidget(standing_);
  step_ = new QLabel;
  step_->setObjectName(QStringLiteral("practise.step"));
  step_->setProperty("role", QStringLiteral("second"));
  step_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  step_->setWordWrap(true);
  row->addWidget(step_, 1);
  strip_->hide();
  return strip_;
}

void PractisePage::show_plan(const QString& standing, const QString& step) {
  strip_->setVisible(!standing.isEmpty() || !step.isEmpty());
  if (standing_->text() != standing) standing_->setText(standing);
  if (step_->text() != step) step_->setText(step);
}

void PractisePage::set_aids(const training::PlanAids& aids) {
  if (filled_ != nullptr) toggle_fill();
  aids_ = aids;
  ladder_->setVisible(aids_.ladder);
  tip_->setVisible(aids_.ladder);
  chart_->show_tissues(aids_.ladder);
  bullseye_->set_path_hidden(!aids_.overlay);
  view3d_->set_outside_only(!aids_.inside);
  ultrasound_->allow_ct(aids_.slices);
  has_volume_ = has_volume_ && may_show_volume();
  inside_->setChecked(has_volume_);
  inside_->setVisible(may_show_volume());
  dock_->hide();
  arrange_slices();
  arrange_columns();
}

// Slices or ultrasound beside the patient, the researchers' dock, or neither.
void PractisePage::arrange_columns() {
  if (filled_ != nullptr) return;
  right_->setVisible(dock_->isHidden() && (aids_.slices || has_ultrasound_ || has_volume_));
}

QWidget* PractisePage::make_instruments() {
  instruments_ = new QWidget;
  instruments_->setObjectName(QStringLiteral("panel"));
  instruments_->setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(instruments_);
  row->setContentsMargins(gap, gap, margin, margin - gap);
  row->setSpacing(margin);
  chart_->setObjectName(QStringLiteral("practise.chart"));
  row->addWidget(chart_, 5);
  auto* side = new QVBoxLayout;
  side->setSpacing(8);
  numbers_->setObjectName(QStringLiteral("practise.numbers"));
  side->addWidget(numbers_, 1);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  const auto button = [&](const QString& text, const char* key, const char* name, const QString& tip) {
    const QString key_name = QKeySequence(QLatin1String(key)).toString(QKeySequence::NativeText);
    auto* made = new QPushButton(QStringLiteral("%1   %2").arg(text, key_name));
    made->setObjectName(QLatin1String(name));
    made->setAccessibleName(text);
    made->setToolTip(tip);
    made->setFocusPolicy(Qt::NoFocus);  // keys belong to the views
    buttons->addWidget(made);
    return made;
  };
  hold_ = button(tr("Hold"), "Space", "practise.hold", tr("The needle stays where it is while you look around"));
  hold_->setCheckable(true);
  connect(hold_, &QPushButton::clicked, this, &PractisePage::hold_requested);
  connect(button(tr("Again"), "A", "practise.again", tr("Save this attempt and begin another one")),
          &QPushButton::clicked, this, &PractisePage::again_requested);
  connect(button(tr("End"), "E", "practise.end", tr("Save this attempt and see the result")), &QPushButton::clicked,
          this, &PractisePage::end_requested);
  side->addLayout(buttons);
  row->addLayout(side, 3);
  return instruments_;
}

QWidget* PractisePage::make_slices() {
  right_ = new QWidget;
  auto* rows = new QVBoxLayout(right_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(gap);
  arrange_slices();
  return right_;
}

void PractisePage::arrange_slices() {
  auto* rows = static_cast<QVBoxLayout*>(right_->layout());
  while (QLayoutItem* item = rows->takeAt(0)) delete item;  // a layout or what holds a widget, not the widget
  auto* small = new QHBoxLayout;
  small->setSpacing(gap);
  const bool is_taken = has_ultrasound_ || has_volume_;  // the big slot
  const std::size_t most_below = has_ultrasound_ && has_volume_ ? 0 : is_taken ? 2 : slices_.size();
  ultrasound_->setVisible(has_ultrasound_);
  volume_->setVisible(has_volume_);
  if (has_ultrasound_) rows->addWidget(ultrasound_, 4);
  if (has_volume_) rows->addWidget(volume_, 4);
  for (std::size_t i = 0; i < slices_.size(); ++i) {
    const bool big = i == 0 && !is_taken, shown = aids_.slices && i < most_below;
    slices_[i]->setVisible(shown);
    if (big && shown) {
      rows->addWidget(slices_[i], 4);
    } else if (shown) {
      small->addWidget(slices_[i], 1);
    }
  }
  if (small->count() == 0) {
    delete small;
  } else {
    rows->addLayout(small, 3);
  }
}

void PractisePage::make_big(View* view) {
  const auto found = std::find(slices_.begin(), slices_.end(), view);
  if (found == slices_.end() || found == slices_.begin()) return;
  std::iter_swap(slices_.begin(), found);
  arrange_slices();
}

void PractisePage::show_ultrasound(const std::optional<station::UltrasoundChoice>& choice) {
  ultrasound_->set_scan(choice);
  has_ultrasound_ = choice.has_value();
  probe_.reset();
  if (choice) probe_ = choice->probe;
  arrange_slices();
  arrange_columns();
  if (has_ultrasound_) ultrasound_->setFocus(Qt::OtherFocusReason);
}

void PractisePage::toggle_volume() {
  if (!may_show_volume()) return;
  if (filled_ != nullptr) toggle_fill();
  has_volume_ = !has_volume_;
  inside_->setChecked(has_volume_);
  if (has_volume_) {
    dock_->hide();
    volume_->set_drawer(kept_volume_drawer());
  }
  arrange_slices();
  arrange_columns();
  if (has_volume_) volume_->setFocus(Qt::OtherFocusReason);
}

void PractisePage::toggle_fill() {
  View* const wanted = qobject_cast<View*>(focusWidget());
  View* const view = filled_ != nullptr ? nullptr : wanted != nullptr ? wanted : view3d_;
  const bool is_slice = std::find(slices_.begin(), slices_.end(), view) != slices_.end();
  if (view != nullptr && view != view3d_ && view != ultrasound_ && view != volume_ && !is_slice) return;
  filled_ = view;
  const bool whole = filled_ == nullptr;
  instruments_->setVisible(whole);
  left_->setVisible(whole || filled_ == view3d_);
  dock_->hide();
  right_->setVisible(whole || filled_ != view3d_);
  if (whole) {
    arrange_slices();
    return arrange_columns();
  }
  for (SliceView* slice : slices_) slice->setVisible(slice == filled_);
  ultrasound_->setVisible(ultrasound_ == filled_);
  volume_->setVisible(volume_ == filled_);
}

void PractisePage::focus_next(bool backwards) {
  std::vector<View*> order = {view3d_, ultrasound_, volume_};
  order.insert(order.end(), slices_.begin(), slices_.end());
  order.push_back(chart_);
  order.erase(std::remove_if(order.begin(), order.end(), [](const View* view) { return !view->isVisible(); }),
              order.end());
  if (order.empty()) return;
  const auto now = std::find(order.begin(), order.end(), focusWidget());
  const auto size = static_cast<std::ptrdiff_t>(order.size());
  const std::ptrdiff_t at = now == order.end() ? (backwards ? 0 : -1) : now - order.begin();
  order[static_cast<std::size_t>((at + (backwards ? size - 1 : 1)) % size)]->setFocus(Qt::TabFocusReason);
}

void PractisePage::toggle_ladder() {
  if (!aids_.ladder) return;
  ladder_->setVisible(!ladder_->isVisible());
}

void PractisePage::toggle_dock() {
  if (!aids_.ladder) return;  // it has the force model's own numbers, which tell the tissues
  const bool shown = !dock_->isVisible();
  if (filled_ != nullptr) toggle_fill();
  dock_->setVisible(shown);
  arrange_columns();
}

void PractisePage::toggle_numbers() {
  numbers_->setVisible(!numbers_->isVisible());
}

void PractisePage::set_case(const std::shared_ptr<const OpenCase>& patient) {
  for (View* view : views_) view->set_case(patient);
  take_measures(patient != nullptr ? patient->folder : std::filesystem::path());
}

void PractisePage::show_frame(const Frame& frame, const Changes& changes) {
  hold_->setChecked(frame.state == State::held);
  other_hand_->show_frame(frame);
  for (View* view : views_) {
    // Chart and dock collect data, and the banner appears, even while hidden.
    if (view->isVisible() || view == chart_ || view == banner_ || view == dock_) view->show_frame(frame, changes);
  }
  show_probe(frame);
  if (changes.warning || ladder_->width() != ladder_->sizeHint().width()) arrange_overlays();
}

void PractisePage::arrange_overlays() {
  const QSize all = view3d_->size();
  tip_->resize(tip_->sizeHint());
  tip_->move(margin, margin);
  int left_of_next = margin;
  for (QPushButton* each : {inside_, move_, undo_, reset_}) {
    if (each == nullptr) break;  // while the page is made
    if (each->isHidden()) continue;
    each->adjustSize();
    each->move(left_of_next, 2 * margin + tip_->height());
    left_of_next += each->width() + gap;
  }
  other_hand_->move(margin, 2 * margin + tip_->height() + (move_ != nullptr ? move_->height() + gap : 0));
  const int left = margin + cube;
  const int bullseye_width = std::min(472, all.width() - margin - left);
  bullseye_->setGeometry(left, all.height() - 92 - margin, bullseye_width, 92);
  const int ladder_width = ladder_->sizeHint().width(), ladder_left = all.width() - ladder_width - gap;
  const bool is_above_bullseye = ladder_left < left + bullseye_width + gap;
  const int ladder_bottom = is_above_bullseye ? bullseye_->y() - gap : all.height() - ladder_top - margin;
  ladder_->setGeometry(ladder_left, ladder_top, ladder_width, std::clamp(ladder_bottom - ladder_top, 120, 400));
  const QSize words = banner_->sizeHint();
  const int width = std::min(words.width(), all.width() - 2 * margin);
  banner_->setGeometry((all.width() - width) / 2, bullseye_->y() - words.height() - margin, width, words.height());
}

void PractisePage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange_overlays();
}

bool PractisePage::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view3d_ && event->type() == QEvent::Resize) arrange_overlays();
  if (event->type() == QEvent::MouseButtonDblClick && qobject_cast<QSplitterHandle*>(watched) != nullptr) {
    reset_layout();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace bodkin::app
