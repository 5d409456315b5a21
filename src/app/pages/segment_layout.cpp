// Layout and connections of the widgets of the page for structures.
#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <cmath>

#include "app/pages/segment.h"
#include "views/slice_image.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr int segment_panel_width = 276, segment_gap = 6, segment_margin = 12, segment_side = 380;  // pixels
constexpr int lowest_hu = -1024, highest_hu = 3071;
constexpr int first_low = 150;  // HU: bone

QLabel* segment_heading(const QString& text) {
  auto* made = new QLabel(text);
  made->setProperty("role", QStringLiteral("label"));
  return made;
}

template <typename Box, typename Number>
Box* number_box(const char* name, const QString& tip, Number low, Number high, Number value) {
  auto* made = new Box;
  made->setObjectName(QLatin1String(name));
  made->setAccessibleName(tip);
  made->setToolTip(tip);
  made->setRange(low, high);
  made->setValue(value);
  made->setFocusPolicy(Qt::ClickFocus);
  return made;
}

QCheckBox* check_box(const char* name, const QString& text, const QString& tip, bool on) {
  auto* made = new QCheckBox(text);
  made->setObjectName(QLatin1String(name));
  made->setAccessibleName(text);
  made->setToolTip(tip);
  made->setChecked(on);
  made->setFocusPolicy(Qt::NoFocus);
  return made;
}

}  // namespace

SegmentPage::SegmentPage(QWidget* parent)
    : Page(PageId::segment, KeyScope::segment, true, parent), relief_(new SegmentRelief) {
  setObjectName(QStringLiteral("segment"));
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(4);
  columns->addWidget(make_panel());
  const std::array<std::pair<SliceKind, const char*>, 3> kinds = {
      std::pair{SliceKind::axial, "segment.slice.axial"}, std::pair{SliceKind::sagittal, "segment.slice.sagittal"},
      std::pair{SliceKind::coronal, "segment.slice.coronal"}};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    slices_[i] = new SegmentSlice(kinds[i].first);
    slices_[i]->setObjectName(QLatin1String(kinds[i].second));
    slices_[i]->setAccessibleName(tr("Slice with the structures"));
    slices_[i]->setToolTip(tr("Left: the tool. Right drag: window. Wheel: next slice, with Ctrl nearer"));
    connect_slice(slices_[i]);
  }
  columns->addWidget(slices_[0], 1);
  auto* side = new QWidget;
  side->setFixedWidth(segment_side);
  auto* rows = new QVBoxLayout(side);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  rows->addWidget(slices_[1], 1);
  rows->addWidget(slices_[2], 1);
  relief_->setObjectName(QStringLiteral("segment.relief"));
  relief_->setAccessibleName(tr("The structure in 3-D"));
  relief_->setToolTip(tr("Right drag turns. Left: the tool, on the surface"));
  rows->addWidget(relief_, 1);
  columns->addWidget(side);
  connect(relief_, &SegmentRelief::pressed, this, [this](const Vec3& point) { begin_stroke(point, -1); });
  connect(relief_, &SegmentRelief::moved, this, [this](const Vec3& point) {
    if (!stroke_from_) return;
    stroke(point, point, -1);  // the surface may jump between two places
    stroke_from_ = point;
  });
  connect(relief_, &SegmentRelief::released, this, &SegmentPage::end_stroke);
}

SegmentPage::~SegmentPage() = default;

void SegmentPage::connect_slice(SegmentSlice* slice) {
  const auto normal_of = [this, slice] {
    int axis = 2;
    const Vec3 normal = slice->plane().right.cross(slice->plane().down);
    (patient_->patient.ct.grid.direction.transpose() * normal).cwiseAbs().maxCoeff(&axis);
    return axis;
  };
  connect(slice, &SegmentSlice::pressed, this,
          [this, normal_of](const Vec3& point) { begin_stroke(point, patient_ != nullptr ? normal_of() : 2); });
  connect(slice, &SegmentSlice::moved, this, [this](const Vec3& point) {
    if (tool_ == SegmentTool::look) return set_crosshair(point);
    if (!stroke_from_) return;
    stroke(*stroke_from_, point, stroke_normal_);
    stroke_from_ = point;
  });
  connect(slice, &SegmentSlice::released, this, &SegmentPage::end_stroke);
  connect(slice, &SegmentSlice::crosshair_moved, this, &SegmentPage::set_crosshair);
  connect(slice, &SegmentSlice::window_changed, this, [this](double window, double level) {
    for (SegmentSlice* each : slices_) each->set_window(window, level);
  });
}

QPushButton* SegmentPage::button(const char* name, const QString& text, const QString& tip) {
  auto* made = new QPushButton(text);
  made->setObjectName(QLatin1String(name));
  made->setAccessibleName(text);
  made->setToolTip(tip);
  made->setFocusPolicy(Qt::NoFocus);
  return made;
}

QWidget* SegmentPage::make_panel() {
  auto* panel = new QWidget;
  panel->setObjectName(QStringLiteral("panel"));
  panel->setAttribute(Qt::WA_StyledBackground);
  panel->setFixedWidth(segment_panel_width);
  auto* rows = new QVBoxLayout(panel);
  rows->setContentsMargins(segment_margin, segment_margin, segment_margin, segment_margin);
  rows->setSpacing(segment_gap);
  auto* head = new QHBoxLayout;
  head->addWidget(segment_heading(tr("Structures")), 1);
  amount_ = segment_heading({});
  amount_->setObjectName(QStringLiteral("segment.amount"));
  head->addWidget(amount_);
  rows->addLayout(head);
  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("segment.structures"));
  list_->setAccessibleName(tr("Structures"));
  list_->setToolTip(tr("The structure that is worked on"));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setFocusPolicy(Qt::ClickFocus);
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (model_ == nullptr || row < 0) return;
    model_->choose(row);
    show_active();
    show_labels(true);
  });
  rows->addWidget(list_, 1);
  auto* naming = new QHBoxLayout;
  naming->setSpacing(4);
  name_ = new QLineEdit;
  name_->setObjectName(QStringLiteral("segment.name"));
  name_->setPlaceholderText(tr("name, of a new one or another"));
  name_->setAccessibleName(tr("Name of a new structure, or a new name for the chosen one"));
  rows->addWidget(name_);
  tissue_ = new QComboBox;
  tissue_->setObjectName(QStringLiteral("segment.tissue"));
  tissue_->setAccessibleName(tr("Tissue of the new structure"));
  tissue_->setToolTip(tr("Tissue that the structure is made of"));
  naming->addWidget(tissue_, 1);
  auto* add = button("segment.new", tr("New"), tr("Make a structure with this name and tissue"));
  connect(add, &QPushButton::clicked, this, &SegmentPage::add_structure);
  connect(name_, &QLineEdit::returnPressed, this, &SegmentPage::add_structure);
  naming->addWidget(add);
  rows->addLayout(naming);
  auto* chosen = new QHBoxLayout;
  chosen->setSpacing(4);
  rename_ = button("segment.rename", tr("Rename"), tr("Give the chosen structure the name typed above"));
  connect(rename_, &QPushButton::clicked, this, &SegmentPage::rename_structure);
  remove_ = button("segment.remove", tr("Remove"), tr("The chosen structure loses all its voxels; saving drops it"));
  connect(remove_, &QPushButton::clicked, this, &SegmentPage::remove_structure);
  critical_ = check_box("segment.critical", tr("critical"),
                        tr("Plans keep away from it, and a needle in it is a danger"), false);
  connect(critical_, &QCheckBox::toggled, this, [this](bool on) {
    if (model_ == nullptr) return;
    model_->set_critical(on);
    show_table();
  });
  for (QPushButton* each : {rename_, remove_}) {
    each->setStyleSheet(QStringLiteral("padding: 6px 8px;"));
    chosen->addWidget(each);
  }
  chosen->addWidget(critical_);
  rows->addLayout(chosen);
  make_tools(rows);
  make_filters(rows);
  make_foot(rows);
  return panel;
}

void SegmentPage::make_tools(QVBoxLayout* rows) {
  rows->addWidget(segment_heading(tr("Tool of the left button")));
  tools_ = new QButtonGroup(this);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  const std::array<std::array<QString, 2>, 4> texts = {
      std::array{tr("Look"), tr("Moves the crosshair (L)")}, std::array{tr("Paint"), tr("Adds to the structure (P)")},
      std::array{tr("Erase"), tr("Removes from the structure (E)")},
      std::array{tr("Grow"), tr("A click adds the connected voxels in the range of HU (G)")}};
  const std::array<const char*, 4> names = {"segment.tool.look", "segment.tool.paint", "segment.tool.erase",
                                            "segment.tool.grow"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    QPushButton* const made = button(names[i], texts[i][0], texts[i][1]);
    made->setCheckable(true);
    made->setStyleSheet(QStringLiteral("padding: 6px 8px;"));
    tools_->addButton(made, static_cast<int>(i));
    row->addWidget(made);
    connect(made, &QPushButton::clicked, this, [this, i] { choose_tool(static_cast<SegmentTool>(i)); });
  }
  rows->addLayout(row);
  auto* brush = new QHBoxLayout;
  radius_ = number_box<QDoubleSpinBox>("segment.radius", tr("Radius of the brush ([ and ])"), 0.3, 40.0, 4.0);
  radius_->setSuffix(tr(" mm"));
  radius_->setDecimals(1);
  ball_ = check_box("segment.ball", tr("3-D"), tr("A ball; without it a disc in the slice alone"), true);
  keep_ = check_box("segment.keep", tr("keep others"), tr("Other structures are not painted over"), false);
  brush->addWidget(radius_, 1);
  brush->addWidget(ball_);
  brush->addWidget(keep_);
  rows->addLayout(brush);
  connect(radius_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { choose_tool(tool_); });
}

void SegmentPage::make_filters(QVBoxLayout* rows) {
  rows->addWidget(segment_heading(tr("Range of HU, and how far from the crosshair")));
  auto* range = new QHBoxLayout;
  range->setSpacing(4);
  low_ = number_box<QSpinBox>("segment.low", tr("Lowest HU"), lowest_hu, highest_hu, first_low);
  high_ = number_box<QSpinBox>("segment.high", tr("Highest HU"), lowest_hu, highest_hu, highest_hu);
  reach_ = number_box<QDoubleSpinBox>("segment.reach", tr("mm about the crosshair; 0: no limit"), 0.0, 300.0, 30.0);
  reach_->setDecimals(0);
  reach_->setSuffix(tr(" mm"));
  reach_->setSpecialValueText(tr("all"));
  range->addWidget(low_);
  range->addWidget(high_);
  range->addWidget(reach_);
  rows->addLayout(range);
  using Kind = patient::SegmentFilter::Kind;
  auto* cells = new QGridLayout;
  cells->setSpacing(4);
  const auto filter = [&](const char* name, const QString& text, const QString& tip, Kind kind) {
    QPushButton* const made = button(name, text, tip);
    connect(made, &QPushButton::clicked, this, [this, kind] { run_filter(kind); });
    filters_.push_back(made);
    return made;
  };
  cells->addWidget(filter("segment.threshold", tr("Threshold"), tr("Adds all voxels of the range"), Kind::threshold),
                   0, 0);
  cells->addWidget(filter("segment.fill", tr("Fill between slices"),
                          tr("Interpolate the structure in the axial slices between painted ones"), Kind::fill),
                   0, 1);
  cells->addWidget(
      filter("segment.smooth", tr("Smooth"), tr("Removes specks, holes and steps that are smaller"), Kind::smooth), 1,
      0);
  smoothness_ = number_box<QDoubleSpinBox>("segment.smoothness", tr("Size of what Smooth removes"), 0.3, 10.0, 1.0);
  smoothness_->setDecimals(1);
  smoothness_->setSuffix(tr(" mm"));
  cells->addWidget(smoothness_, 1, 1);
  rows->addLayout(cells);
}

void SegmentPage::make_foot(QVBoxLayout* rows) {
  covered_ = check_box("segment.covered", tr("Structures over the CT (V)"), tr("Off: the CT alone"), true);
  connect(covered_, &QCheckBox::toggled, this, [this](bool on) {
    for (SegmentSlice* each : slices_) each->set_covered(on);
  });
  rows->addWidget(covered_);
  message_ = new QLabel;
  message_->setObjectName(QStringLiteral("segment.said"));
  message_->setWordWrap(true);
  message_->setMinimumHeight(34);
  rows->addWidget(message_);
  auto* working = new QHBoxLayout;
  progress_ = new QProgressBar;
  progress_->setObjectName(QStringLiteral("segment.progress"));
  progress_->setTextVisible(false);
  progress_->setRange(0, 1000);
  progress_->hide();
  cancel_ = button("segment.cancel", tr("Cancel"), tr("Stops the work; nothing is changed"));
  cancel_->hide();
  connect(cancel_, &QPushButton::clicked, this, [this] {
    if (model_ != nullptr) model_->cancel();
  });
  working->addWidget(progress_, 1);
  working->addWidget(cancel_);
  rows->addLayout(working);
  auto* last = new QHBoxLayout;
  last->setSpacing(4);
  undo_ = button("segment.undo", tr("Undo"), tr("Undo the last step (Ctrl+Z)"));
  redo_ = button("segment.redo", tr("Redo"), tr("Redo the last undone change (Ctrl+Shift+Z)"));
  save_ = button("segment.save", tr("Save"), tr("Save into the case; tissues and path are computed again"));
  save_->setProperty("role", QStringLiteral("primary"));
  connect(undo_, &QPushButton::clicked, this, [this] { press(QKeySequence(QStringLiteral("Ctrl+Z"))); });
  connect(redo_, &QPushButton::clicked, this, [this] { press(QKeySequence(QStringLiteral("Ctrl+Shift+Z"))); });
  connect(save_, &QPushButton::clicked, this, [this] {
    if (model_ == nullptr) return;
    model_->save();
    show_status();
  });
  for (QPushButton* each : {undo_, redo_, save_}) {
    each->setEnabled(false);
    last->addWidget(each, each == save_ ? 2 : 1);
  }
  rows->addLayout(last);
}

}  // namespace bodkin::app
