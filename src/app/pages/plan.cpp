#include "app/pages/plan.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "views/language.h"
#include "views/theme.h"

#include "core/error.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr int panel_height = 212, slices_width = 440, card_margin = 12;  // pixels
constexpr std::size_t most_distances = 5;

QString words(const std::string& text) {
  return in_words(text);
}

QString degrees(double angle) {
  return QStringLiteral("%1°").arg(std::abs(angle) < 0.05 ? 0.0 : angle, 0, 'f', 1);
}

// The plan's page stays dark over pictures in both themes.
QString html_of(const QString& text, const QColor& colour, bool strong = false) {
  return QStringLiteral("<span style=\"color:%1;%2\">%3</span>")
      .arg(colour.name(), strong ? QStringLiteral("font-weight:500;") : QString(), text.toHtmlEscaped());
}

}  // namespace

PlanPage::PlanPage(QWidget* parent)
    : Page(PageId::plan, KeyScope::plan, true, parent),
      view3d_(new View3d(QStringLiteral("plan"))),
      legend_(new ClearanceLegend(view3d_)),
      summary_(new QLabel(view3d_)) {
  view3d_->set_preset(scene::Preset::skin);
  view3d_->set_opens_as_saved(false);
  view3d_->installEventFilter(this);
  legend_->setObjectName(QStringLiteral("plan.legend"));
  summary_->setObjectName(QStringLiteral("plan.summary"));
  summary_->setAttribute(Qt::WA_TransparentForMouseEvents);
  summary_->setTextFormat(Qt::RichText);
  summary_->setWordWrap(true);
  summary_->setFixedWidth(330);
  summary_->setStyleSheet(
      QStringLiteral("background: rgba(22,27,34,225); border-radius: 6px; padding: 10px; font-size: 13px;"));
  auto* left = new QVBoxLayout;
  left->setSpacing(0);
  left->addWidget(view3d_, 1);
  left->addWidget(make_panel());
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(4);
  columns->addLayout(left, 1);
  columns->addWidget(make_slices());
  connect(view3d_, &View3d::ready, this, [this] {
    if (model_ == nullptr) return;
    const auto surfaces = view3d_->scene()->shared_surfaces();
    model_->set_skin({surfaces, &surfaces->skin().points});
  });
}

PlanPage::~PlanPage() = default;

QWidget* PlanPage::make_panel() {
  auto* panel = new QWidget;
  panel->setObjectName(QStringLiteral("panel"));
  panel->setAttribute(Qt::WA_StyledBackground);
  panel->setFixedHeight(panel_height);
  auto* rows = new QVBoxLayout(panel);
  rows->setContentsMargins(card_margin, 8, card_margin, 8);
  auto* line = new QHBoxLayout;
  auto* heading = new QLabel(tr("Paths"));
  heading->setProperty("role", QLatin1String("heading"));
  message_ = new QLabel;
  message_->setObjectName(QStringLiteral("plan.said"));
  message_->setProperty("role", QLatin1String("second"));
  message_->setWordWrap(true);
  structures_ = new QComboBox;
  structures_->setObjectName(QStringLiteral("plan.structure"));
  structures_->setAccessibleName(tr("Structure to aim at"));
  structures_->setToolTip(tr("The middle of this structure becomes the target"));
  structures_->setMaximumWidth(170);
  const auto button = [&](const char* name, const QString& text, const QString& tip) {
    auto* made = new QPushButton(text);
    made->setObjectName(QLatin1String(name));
    made->setAccessibleName(text);
    made->setToolTip(tip);
    return made;
  };
  undo_ = button("plan.undo", tr("Undo"), tr("Undo the last change (Ctrl+Z)"));
  redo_ = button("plan.redo", tr("Redo"), tr("Redo the last undone change (Ctrl+Shift+Z)"));
  practise_ = button("plan.practise", tr("Practise this"), tr("Go in along this path (Enter)"));
  practise_->setProperty("role", QLatin1String("primary"));
  line->addWidget(heading);
  line->addWidget(message_, 1);
  for (QWidget* each : {static_cast<QWidget*>(structures_), static_cast<QWidget*>(undo_),
                        static_cast<QWidget*>(redo_), static_cast<QWidget*>(practise_)})
    line->addWidget(each);
  rows->addLayout(line);
  paths_ = new QTableWidget(0, 6);
  paths_->setObjectName(QStringLiteral("plan.paths"));
  paths_->setAccessibleName(tr("Proposed paths, the best first"));
  paths_->setToolTip(tr("Click a path to take it"));
  paths_->setHorizontalHeaderLabels(
      {tr("Way in"), tr("Length"), tr("Cranial"), tr("Left"), tr("Nearest to avoid"), tr("Crosses")});
  paths_->verticalHeader()->hide();
  paths_->verticalHeader()->setDefaultSectionSize(24);
  paths_->setShowGrid(false);
  paths_->setSelectionBehavior(QAbstractItemView::SelectRows);
  paths_->setSelectionMode(QAbstractItemView::SingleSelection);
  paths_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  paths_->setFocusPolicy(Qt::NoFocus);
  paths_->setFrameShape(QFrame::NoFrame);
  paths_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  paths_->horizontalHeader()->setHighlightSections(false);
  const std::array<int, 5> widths = {170, 72, 66, 66, 190};
  for (std::size_t i = 0; i < widths.size(); ++i) paths_->setColumnWidth(static_cast<int>(i), widths[i]);
  paths_->horizontalHeader()->setStretchLastSection(true);
  rows->addWidget(paths_, 1);
  connect(undo_, &QPushButton::clicked, this, [this] { press(QKeySequence(QStringLiteral("Ctrl+Z"))); });
  connect(redo_, &QPushButton::clicked, this, [this] { press(QKeySequence(QStringLiteral("Ctrl+Shift+Z"))); });
  connect(practise_, &QPushButton::clicked, this, [this] { press(QKeySequence(QStringLiteral("Return"))); });
  connect(paths_, &QTableWidget::cellClicked, this, [this](int row, int) {
    if (model_ == nullptr) return;
    chosen_ = row;
    model_->adopt(static_cast<std::size_t>(row));
    show_plan();
  });
  connect(structures_, QOverload<int>::of(&QComboBox::activated), this, [this](int row) {
    if (model_ == nullptr || row <= 0) return;
    try {
      model_->choose_structure(structures_->itemData(row).toString().toStdString());
      frame_.crosshair = *model_->points().target;
      crosshair_moved_ = true;
    } catch (const InputError& error) {
      message_->setText(QString::fromUtf8(error.what()));
    }
    structures_->setCurrentIndex(0);
    show_plan();
  });
  return panel;
}

QWidget* PlanPage::make_slices() {
  auto* place = new QWidget;
  place->setFixedWidth(slices_width);
  auto* cells = new QGridLayout(place);
  cells->setContentsMargins(0, 0, 0, 0);
  cells->setSpacing(4);
  const auto measures = std::make_shared<Measures>();
  const auto add = [&](SliceKind kind, const char* name) {
    auto* slice = new SliceView(kind);
    slice->setObjectName(QLatin1String(name));
    slice->set_measures(measures);
    slice->installEventFilter(this);
    connect(slice, &View::crosshair_moved, this, [this](const Vec3& point) {
      frame_.crosshair = point;
      crosshair_moved_ = true;
    });
    slices_.push_back(slice);
    return slice;
  };
  cells->addWidget(add(SliceKind::sagittal, "plan.slice.sagittal"), 0, 0, 1, 2);
  cells->addWidget(add(SliceKind::axial, "plan.slice.axial"), 1, 0);
  cells->addWidget(add(SliceKind::coronal, "plan.slice.coronal"), 1, 1);
  cells->setRowStretch(0, 4);
  cells->setRowStretch(1, 3);
  for (SliceView* slice : slices_) {
    slice->setToolTip(
        tr("Click: the target. Shift and click: the way in. Drag the green points to change them. "
           "Wheel: scroll."));
    connect(slice, &SliceView::measures_changed, this, [this] {
      for (SliceView* each : slices_) each->update();
    });
  }
  return place;
}

void PlanPage::set_case(std::shared_ptr<const OpenCase> patient) {
  patient_ = std::move(patient);
  if (patient_ == shown_) return;
  leave();
  model_.reset();  // it holds the patient before
  shown_.reset();
}

void PlanPage::enter() {
  is_shown_ = true;
  if (patient_ == nullptr) return;
  if (model_ == nullptr) {
    shown_ = patient_;
    model_ = std::make_unique<PlanModel>(patient_);
    view3d_->set_case(patient_);
    for (SliceView* slice : slices_) slice->set_case(patient_);
    frame_ = {};
    frame_.state = State::ended;  // no needle, and none waits
    frame_.is_planning = true;
    frame_.follows_tip = false;
    frame_.target_tolerance = patient_->description().procedure.target_tolerance;
    if (const auto path = model_->path()) {
      frame_.crosshair = path->target;
    } else {
      const anatomy::Grid& lattice = patient_->patient.tissues.grid;
      frame_.crosshair =
          lattice.to_patient(0.5 * Vec3(lattice.size[0] - 1, lattice.size[1] - 1, lattice.size[2] - 1));
    }
    structures_->clear();
    structures_->addItem(tr("Aim at ..."));
    std::vector<anatomy::Structure> table = patient_->description().structures;
    std::stable_sort(table.begin(), table.end(), [](const auto& a, const auto& b) {
      return (a.tissue == "mass" ? 0 : 1) < (b.tissue == "mass" ? 0 : 1);  // lesions first
    });
    for (const anatomy::Structure& each : table)
      structures_->addItem(words(readable_structure(each.name)), words(each.name));
    structures_->setVisible(!table.empty());
  }
  entered_with_ = model_->path();
  crosshair_moved_ = true;
  model_->work(true);
  show_plan();
  show_proposals();
  view3d_->setFocus(Qt::OtherFocusReason);
}

void PlanPage::leave() {
  if (!is_shown_) return;
  is_shown_ = false;
  drag_ = Drag::none;
  if (model_ == nullptr) return;
  model_->commit();
  model_->work(false);
  const auto path = model_->path();
  const bool is_other =
      path && (!entered_with_ || path->entry != entered_with_->entry || path->target != entered_with_->target);
  if (is_other && model_->is_saved()) emit plan_changed(*path);
}

void PlanPage::advance(double clock) {
  clock_ = clock;
  if (model_ == nullptr) return;
  if (model_->poll()) {
    show_plan();
    show_proposals();
    show_map();
  }
  frame_.clock = clock;
  ++frame_.number;
  Changes changes;
  changes.plan = plan_moved_;
  changes.crosshair = crosshair_moved_;
  plan_moved_ = crosshair_moved_ = false;
  view3d_->show_frame(frame_, changes);
  for (SliceView* slice : slices_) slice->show_frame(frame_, changes);
}

bool PlanPage::press(const QKeySequence& keys) {
  if (model_ == nullptr) return false;
  const auto is = [&](const char* name) { return keys == QKeySequence(QLatin1String(name)); };
  if (is("Ctrl+Z")) {
    model_->undo();
  } else if (is("Ctrl+Shift+Z")) {
    model_->redo();
  } else if (is("Del")) {
    model_->remove();
  } else if (is("Tab")) {
    next_proposal();
  } else if (is("Return") || is("Enter")) {
    if (practise_->isEnabled()) emit practise_requested();
    return true;
  } else {
    return false;
  }
  show_plan();
  return true;
}

void PlanPage::next_proposal() {
  const int count = static_cast<int>(model_->result().proposals.size());
  if (count == 0) return;
  chosen_ = (chosen_ + 1) % count;
  model_->adopt(static_cast<std::size_t>(chosen_));
}

// The text in the corner, the buttons, and the path drawn by the views.
void PlanPage::show_plan() {
  frame_.plan = model_->path();
  frame_.plan_broken.clear();
  if (!frame_.plan && model_->points().target)  // the ring alone
    frame_.plan = anatomy::NeedlePath{*model_->points().target, *model_->points().target};
  const Theme& theme = Theme::dark();
  QString text = html_of(tr("Choose where to go in"), theme.text, true);
  const auto& report = model_->report();
  if (report) {
    for (const patient::Crossed& each : report->blocked) frame_.plan_broken.emplace_back(each.from, each.to);
    const std::string level = model_->level();
    text = html_of(tr("%1 mm long").arg(report->path.length(), 0, 'f', 1), theme.text, true);
    if (!level.empty()) text += html_of(QStringLiteral("  ") + words(level), theme.plan, true);
    text +=
        QStringLiteral("<br>") +
        html_of(
            tr("%1, %2").arg(
                (report->cranial < 0.0 ? tr("%1 caudal") : tr("%1 cranial")).arg(degrees(std::abs(report->cranial))),
                (report->lateral < 0.0 ? tr("%1 to the right") : tr("%1 to the left"))
                    .arg(degrees(std::abs(report->lateral)))),
            theme.second);
    text += QStringLiteral("<br>") + html_of(tr("through %1").arg(words(model_->crossed_text())), theme.second);
    std::size_t shown = 0;
    for (const PlanModel::Distance& each : model_->distances()) {
      if (shown++ == most_distances) break;
      const bool is_close = each.distance < each.margin;
      const QString distance = each.distance > 0.0 ? tr("%1 mm").arg(each.distance, 0, 'f', 1) : tr("goes into it");
      QString line = tr("%1: %2").arg(words(each.title), distance);
      if (is_close) line += tr(", less than %1").arg(each.margin, 0, 'f', 1);
      text += QStringLiteral("<br>") + html_of(line, each.distance == 0.0 ? theme.danger
                                                     : is_close           ? theme.caution
                                                                          : theme.text);
    }
  } else {
    text += QStringLiteral("<br>") +
            html_of(tr("Click the skin. In a slice: click the target, or Shift and click the way in."), theme.second);
  }
  if (!model_->trouble().empty()) text += QStringLiteral("<br>") + html_of(words(model_->trouble()), theme.caution);
  if (summary_->text() != text) {
    summary_->setText(text);
    summary_->adjustSize();
  }
  undo_->setEnabled(model_->can_undo());
  redo_->setEnabled(model_->can_redo());
  practise_->setEnabled(model_->path().has_value() && model_->is_saved());
  plan_moved_ = true;
  place_overlays();
}

void PlanPage::show_proposals() {
  const PlanWork::Result& result = model_->result();
  const int count = static_cast<int>(result.proposals.size());
  paths_->setRowCount(count);
  for (int row = 0; row < count; ++row) {
    const ProposedPath& proposed = result.proposals[static_cast<std::size_t>(row)];
    const patient::PathReport& report = proposed.report;
    std::string last;
    QString crosses;
    for (const patient::Crossed& each : report.crosses) {
      const std::string title = patient_->patient.library.title(each.tissue);
      if (title != last) crosses += (crosses.isEmpty() ? QString() : QStringLiteral(", ")) + words(title);
      last = title;
    }
    QString nearest = tr("nothing within 30 mm");
    if (!report.near.empty()) {
      const auto least = std::min_element(report.near.begin(), report.near.end(),
                                          [](const auto& a, const auto& b) { return a.distance < b.distance; });
      nearest = tr("%1 mm, %2").arg(least->distance, 0, 'f', 1).arg(words(proposed.nearest));
    }
    const std::array<QString, 6> cells = {words(proposed.way),
                                          tr("%1 mm").arg(report.path.length(), 0, 'f', 1),
                                          degrees(report.cranial),
                                          degrees(report.lateral),
                                          nearest,
                                          crosses};
    for (std::size_t column = 0; column < cells.size(); ++column) {
      auto item = std::make_unique<QTableWidgetItem>(cells[column]);
      item->setToolTip(cells[column]);
      paths_->setItem(row, static_cast<int>(column), item.release());  // the table owns it
    }
  }
  QString sentence;
  if (!result.failure.empty()) {
    sentence = words(result.failure);
  } else if (!model_->points().target) {
    sentence = tr("Choose the target first: click it in a slice.");
  } else if (count == 0) {
    sentence = result.proposals_done ? words(result.why_none) : tr("Looking for paths ...");
  } else if (!result.proposals_done) {
    sentence = tr("Looking for more ...");
  } else {
    sentence = tr("Every one of these paths keeps its distance. Tab: next.");
  }
  message_->setText(sentence);
}

void PlanPage::show_map() {
  const PlanWork::Result& result = model_->result();
  if (!view3d_->is_ready() || result.map.size() != view3d_->scene()->surfaces().skin().points.size()) return;
  std::vector<std::uint32_t> tint(result.map.size());
  std::transform(result.map.begin(), result.map.end(), tint.begin(), tint_of);
  view3d_->set_skin_tint(tint);
  legend_->show_message(result.map_done ? QString() : tr("being computed"));
}

void PlanPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  place_overlays();
}

void PlanPage::place_overlays() {
  summary_->move(card_margin, card_margin);
  legend_->move(view3d_->width() - legend_->width() - card_margin,
                view3d_->height() - legend_->height() - card_margin);
}

}  // namespace bodkin::app
