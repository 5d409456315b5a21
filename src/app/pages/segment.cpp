#include "app/pages/segment.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

#include "views/language.h"
#include "views/theme.h"

#include "core/error.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr double brush_step = 1.25;  // times as wide

// Colours that differ as much as they can from one label to the next.
std::uint32_t colour_of_label(int label) {
  return QColor::fromHsv((label * 137) % 360, 150, 240).rgb() & 0xFFFFFFU;
}

}  // namespace

void SegmentPage::set_case(std::shared_ptr<const OpenCase> patient) {
  patient_ = std::move(patient);
  if (patient_ == shown_) return;
  for (SegmentSlice* each : slices_) each->set_case(nullptr, nullptr);
  relief_->show_structure(nullptr, 0, 0);
  model_.reset();  // it holds the patient before
  shown_.reset();
}

void SegmentPage::enter() {
  if (patient_ == nullptr || model_ != nullptr) return;
  try {
    model_ = std::make_unique<SegmentModel>(patient_);
  } catch (const InputError& error) {
    return show_message(QString::fromUtf8(error.what()), true);
  }
  shown_ = patient_;
  tissue_->clear();
  tissue_->addItem(tr("by its HU"), QString());
  for (const anatomy::TissueProperties& each : patient_->patient.library.tissues()) {
    if (each.id != anatomy::tissue::air) tissue_->addItem(in_words(each.title), QString::fromStdString(each.name));
  }
  const anatomy::Grid& grid = patient_->patient.ct.grid;
  const auto& path = patient_->description().procedure.path;
  for (SegmentSlice* each : slices_) each->set_case(patient_, &model_->editor().labels());
  set_crosshair(path ? path->target
                     : grid.to_patient(0.5 * Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1)));
  show_message(model_->has_draft() ? tr("Changes that were not saved the last time are restored; Ctrl+Z undoes them.")
                                   : QString(),
               false);
  show_table();
  choose_tool(SegmentTool::look);
  show_labels(true);
  slices_[0]->setFocus(Qt::OtherFocusReason);
}

void SegmentPage::leave() {
  end_stroke();
  if (model_ == nullptr) return;
  try {
    model_->store_draft();
  } catch (const SystemError& error) {
    show_message(in_words(error.what()), true);
  }
}

void SegmentPage::set_crosshair(const Vec3& point) {
  if (model_ == nullptr) return;
  const anatomy::Grid& grid = patient_->patient.ct.grid;
  const Vec3 last(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  crosshair_ = grid.to_patient(grid.to_index(point).cwiseMax(Vec3::Zero()).cwiseMin(last));
  for (SegmentSlice* each : slices_) each->set_crosshair(crosshair_);
}

void SegmentPage::choose_tool(SegmentTool tool) {
  tool_ = tool;
  const bool has_brush = tool == SegmentTool::paint || tool == SegmentTool::erase;
  for (SegmentSlice* each : slices_) {
    each->set_brush(has_brush ? std::optional(radius_->value()) : std::nullopt);
    each->setCursor(has_brush ? Qt::BlankCursor : Qt::CrossCursor);
  }
  for (QAbstractButton* each : tools_->buttons()) each->setChecked(tools_->id(each) == static_cast<int>(tool));
}

patient::Overwriting SegmentPage::overwriting() const {
  return keep_->isChecked() ? patient::Overwriting::nothing : patient::Overwriting::all;
}

void SegmentPage::stroke(const Vec3& from, const Vec3& to, int normal) {
  const patient::Brush brush{radius_->value(), ball_->isChecked() || normal < 0, std::max(0, normal)};
  const std::uint16_t label = model_->active_label();
  if (tool_ == SegmentTool::paint) {
    model_->editor().paint(from, to, brush, label, overwriting());
  } else {
    model_->editor().erase(from, to, brush, label);
  }
  show_labels(false);
}

// `normal`: the axis across which the slice lies; negative: on the structure in 3-D.
void SegmentPage::begin_stroke(const Vec3& point, int normal) {
  if (model_ == nullptr || model_->status().is_busy) return;
  if (tool_ == SegmentTool::look) return set_crosshair(point);
  if (model_->active_label() == 0) return show_message(tr("Make a structure first: its name, then New."), true);
  set_crosshair(point);
  if (tool_ == SegmentTool::grow) return run_filter(patient::SegmentFilter::Kind::grow);
  stroke_from_ = point;
  stroke_normal_ = normal;
  stroke(point, point, normal);
}

void SegmentPage::end_stroke() {
  if (!stroke_from_ || model_ == nullptr) return;
  stroke_from_.reset();
  model_->editor().commit();
  show_labels(true);
}

void SegmentPage::run_filter(patient::SegmentFilter::Kind kind) {
  if (model_ == nullptr || model_->status().is_busy) return;
  if (model_->active_label() == 0) return show_message(tr("Make a structure first: its name, then New."), true);
  using Kind = patient::SegmentFilter::Kind;
  patient::SegmentFilter filter;
  filter.kind = kind;
  filter.low = low_->value();
  filter.high = high_->value();
  filter.reach = reach_->value();
  filter.radius = smoothness_->value();
  const anatomy::Grid& grid = patient_->patient.ct.grid;
  const Vec3 seed = grid.to_index(crosshair_);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int at = static_cast<int>(std::lround(seed[static_cast<int>(axis)]));
    filter.seed[axis] = std::clamp(at, 0, grid.size[axis] - 1);
  }
  (grid.direction.transpose() * Vec3::UnitZ()).cwiseAbs().maxCoeff(&filter.axis);  // the slices that were taken
  model_->run(filter, overwriting(), kind != Kind::smooth);
  show_status();
}

void SegmentPage::add_structure() {
  if (model_ == nullptr) return;
  try {
    model_->add(name_->text().trimmed().toStdString(), tissue_->currentData().toString().toStdString(), false);
  } catch (const InputError& error) {
    return show_message(QString::fromUtf8(error.what()), true);
  }
  name_->clear();
  slices_[0]->setFocus(Qt::OtherFocusReason);
  show_message(tr("Paint it, grow it from a click, or add a range of HU."), false);
  show_table();
  show_labels(true);
}

void SegmentPage::rename_structure() {
  if (model_ == nullptr) return;
  try {
    model_->rename(name_->text().trimmed().toStdString());
  } catch (const InputError& error) {
    return show_message(QString::fromUtf8(error.what()), true);
  }
  name_->clear();
  show_message({}, false);
  show_table();
}

void SegmentPage::remove_structure() {
  if (model_ == nullptr || model_->active() < 0) return;
  model_->remove();
  show_message(tr("It has no voxels any more. Saving drops it; Ctrl+Z brings it back."), false);
  show_table();
  show_labels(true);
}

void SegmentPage::show_table() {
  const QSignalBlocker quiet(list_);
  list_->clear();
  std::uint16_t largest = 0;
  for (const anatomy::Structure& each : model_->table()) largest = std::max(largest, each.label);
  colours_.assign(std::size_t{largest} + 1, 0x808080U);
  for (const anatomy::Structure& each : model_->table()) {
    colours_[each.label] = colour_of_label(each.label);
    QPixmap swatch(12, 12);
    swatch.fill(QColor(static_cast<QRgb>(colours_[each.label])));
    auto* const item = new QListWidgetItem(QIcon(swatch), in_words(readable_structure(each.name)), list_);
    const QString tissue = each.tissue.empty() ? tr("tissue by its HU") : QString::fromStdString(each.tissue);
    item->setToolTip(each.critical ? tr("%1; critical").arg(tissue) : tissue);
    if (each.critical) item->setText(tr("%1 (critical)").arg(item->text()));
  }
  list_->setCurrentRow(model_->active());
  show_active();
}

void SegmentPage::show_active() {
  const bool has_one = model_->active() >= 0;
  for (QWidget* each :
       {static_cast<QWidget*>(rename_), static_cast<QWidget*>(remove_), static_cast<QWidget*>(critical_)})
    each->setEnabled(has_one);
  const QSignalBlocker quiet(critical_);
  critical_->setChecked(has_one && model_->table()[static_cast<std::size_t>(model_->active())].critical);
}

void SegmentPage::show_labels(bool also_relief) {
  if (model_ == nullptr) return;
  const std::uint16_t active = model_->active_label();
  for (SegmentSlice* each : slices_) each->show_labels(model_->editor().version(), active, colours_);
  undo_->setEnabled(model_->editor().can_undo());
  redo_->setEnabled(model_->editor().can_redo());
  if (!also_relief) return;
  relief_->show_structure(&model_->editor().labels(), active,
                          active < colours_.size() ? colours_[active] : 0xFFFFFFU);
  const double voxel = patient_->patient.ct.grid.spacing.prod() / 1000.0;
  amount_->setText(tr("%1 ml").arg(static_cast<double>(model_->editor().count(active)) * voxel, 0, 'f', 1));
}

void SegmentPage::show_status() {
  if (model_ == nullptr) return;
  const SegmentModel::Status status = model_->status();
  progress_->setVisible(status.is_busy);
  cancel_->setVisible(status.is_busy);
  progress_->setValue(static_cast<int>(1000.0 * status.fraction));
  for (QPushButton* each : filters_) each->setEnabled(!status.is_busy);
  save_->setEnabled(!status.is_busy && model_->has_changes());
  if (status.is_busy) return show_message(in_words(status.stage) + QStringLiteral(" ..."), false);
  if (!status.error.empty()) return show_message(in_words(status.error), true);
}

void SegmentPage::show_message(const QString& sentence, bool is_trouble) {
  message_->setText(sentence);
  message_->setStyleSheet(is_trouble ? QStringLiteral("color: %1;").arg(Theme::now().danger.name()) : QString());
}

void SegmentPage::advance(double /*clock*/) {
  if (model_ == nullptr) return;
  if (model_->poll()) {
    show_status();
    const SegmentModel::Status status = model_->status();
    if (!status.is_busy) {
      show_labels(true);
      if (status.error.empty() && !status.is_saved) show_message({}, false);
      if (status.is_saved && status.error.empty()) {
        QStringList notes;
        for (const std::string& note : status.notes) notes << in_words(note);
        show_message(
            tr("Saved. The patient is opened again with its new tissues. %1").arg(notes.join(QLatin1Char(' '))),
            false);
        emit patient_requested(QString::fromStdString(patient_->folder.string()));
        return;
      }
    }
  }
  save_->setEnabled(!model_->status().is_busy && model_->has_changes());
}

bool SegmentPage::press(const QKeySequence& keys) {
  if (model_ == nullptr) return false;
  const auto is = [&](const char* name) { return keys == QKeySequence(QLatin1String(name)); };
  const bool is_free = !model_->status().is_busy;
  if (is("Ctrl+Z")) {
    if (is_free) model_->editor().undo();
  } else if (is("Ctrl+Shift+Z")) {
    if (is_free) model_->editor().redo();
  } else if (is("[") || is("]")) {
    radius_->setValue(radius_->value() * (is("]") ? brush_step : 1.0 / brush_step));
    return true;
  } else if (is("L") || is("P") || is("E") || is("G")) {
    choose_tool(is("L")   ? SegmentTool::look
                : is("P") ? SegmentTool::paint
                : is("E") ? SegmentTool::erase
                          : SegmentTool::grow);
    return true;
  } else if (is("V")) {
    covered_->toggle();
    return true;
  } else {
    return false;
  }
  show_labels(true);
  return true;
}

}  // namespace bodkin::app
