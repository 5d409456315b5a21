#include "app/pages/scan.h"

#include <QButtonGroup>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "views/language.h"
#include "views/slice_image.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr int left_width = 372, scan_gap = 8, scan_margin = 12;  // pixels
constexpr double first_range = 60.0;                             // mm about the target that a case opens with

// A scanner's console is dark in any theme of the window.
const char* const console_style = R"(
#scan { background: #000000; }
#scan QWidget { font-family: "DejaVu Sans Mono"; color: #A8E0B0; }
#scan QLabel[role="scan_label"] { color: #6F8F78; font-size: 11px; }
#scan QPushButton { background: #101812; border: 1px solid #2F4A37; border-radius: 6px; padding: 6px 10px; }
#scan QPushButton:hover, #scan QPushButton:focus { border-color: #A8E0B0; }
#scan QPushButton:checked { background: #1E3A27; border-color: #A8E0B0; }
#scan QPushButton:disabled { color: #47604E; border-color: #1B2A20; }
#scan QPushButton[role="scan"] { background: #FFC23D; color: #141000; border: 3px solid #7A5A10; border-radius: 38px;
  font-size: 16px; font-weight: bold; }
#scan QPushButton[role="scan"]:hover { border-color: #FFE7B0; }
#scan QPushButton[role="scan"]:disabled { background: #3A3118; color: #7A6A40; border-color: #3A3118; }
#scan QDoubleSpinBox { background: #0A100C; border: 1px solid #2F4A37; border-radius: 6px; padding: 5px; font-size: 15px; }
#scan QProgressBar { background: #101812; }
#scan QProgressBar::chunk { background: #FFC23D; }
)";

QPushButton* scan_button(const char* name, const QString& text, const QString& tip, bool checkable) {
  auto* made = new QPushButton(text);
  made->setObjectName(QLatin1String(name));
  made->setAccessibleName(text);
  made->setToolTip(tip);
  made->setCheckable(checkable);
  made->setFocusPolicy(Qt::NoFocus);
  return made;
}

QLabel* scan_label(const QString& text) {
  auto* made = new QLabel(text);
  made->setProperty("role", QStringLiteral("scan_label"));
  return made;
}

}  // namespace

ScanPage::ScanPage(std::function<const Frame&()> frame, QWidget* parent)
    : Page(PageId::scan, KeyScope::scan, true, parent),
      frame_(std::move(frame)),
      scout_(new ScoutWidget),
      viewer_(new ScanViewer) {
  setObjectName(QStringLiteral("scan"));
  setAttribute(Qt::WA_StyledBackground);
  setStyleSheet(QLatin1String(console_style));
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(scan_margin, scan_margin, scan_margin, scan_margin);
  columns->setSpacing(scan_margin);
  columns->addWidget(make_left());
  columns->addWidget(make_right(), 1);
  connect(scout_, &ScoutWidget::range_changed, this, [this](double from, double to) {
    protocol_.from = from;
    protocol_.to = to;
    show_protocol();
  });
  connect(viewer_, &ScanViewer::slice_changed, this, [this] {
    const auto& slices = shown_ < scans_.size() ? scans_[shown_]->slices : std::vector<imaging::ScanSlice>{};
    const auto at = static_cast<std::size_t>(viewer_->slice());
    scout_->set_mark(at < slices.size() ? std::optional(slices[at].z) : std::nullopt);
  });
  connect(viewer_, &ScanViewer::mark_changed, this, [this] { target_->setEnabled(viewer_->mark().has_value()); });
}

QWidget* ScanPage::make_left() {
  auto* left = new QWidget;
  left->setFixedWidth(left_width);
  auto* rows = new QVBoxLayout(left);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(scan_gap);
  auto* heads = new QHBoxLayout;
  heads->addWidget(scan_label(tr("SCOUT")), 1);
  auto* views = new QButtonGroup(this);
  const std::pair<const char*, QString> names[] = {{"scan.scout.frontal", tr("Frontal")},
                                                   {"scan.scout.lateral", tr("Lateral")}};
  for (int i = 0; i < 2; ++i) {
    QPushButton* const made =
        scan_button(names[i].first, names[i].second, tr("The overview from the front or the side"), true);
    made->setChecked(i == 0);
    views->addButton(made, i);
    heads->addWidget(made);
    connect(made, &QPushButton::clicked, this, [this, i] { scout_->set_view(static_cast<imaging::ScoutView>(i)); });
  }
  rows->addLayout(heads);
  scout_->setObjectName(QStringLiteral("scan.scout"));
  scout_->setAccessibleName(tr("Scout"));
  scout_->setToolTip(tr("Drag the ends of the box to set the range, its middle to move it"));
  rows->addWidget(scout_, 1);
  make_protocol(rows);
  return left;
}

void ScanPage::make_protocol(QVBoxLayout* rows) {
  range_ = new QLabel;
  range_->setObjectName(QStringLiteral("scan.range"));
  rows->addWidget(range_);
  auto* fields = new QGridLayout;
  fields->setHorizontalSpacing(scan_gap);
  fields->addWidget(scan_label(tr("THICKNESS mm")), 0, 0);
  fields->addWidget(scan_label(tr("SPACING mm")), 0, 1);
  const auto field = [&](const char* name, const QString& text, double low, double high, double value) {
    auto* made = new QDoubleSpinBox;
    made->setObjectName(QLatin1String(name));
    made->setAccessibleName(text);
    made->setToolTip(text);
    made->setDecimals(1);
    made->setRange(low, high);
    made->setSingleStep(0.5);
    made->setValue(value);
    made->setFocusPolicy(Qt::ClickFocus);
    return made;
  };
  thickness_ = field("scan.thickness", tr("How thick a slice is; thick slices blur"), 0.5, 10.0, protocol_.thickness);
  spacing_ = field("scan.spacing", tr("From one slice to the next; more than the thickness leaves gaps"), 0.5, 20.0,
                   protocol_.spacing);
  fields->addWidget(thickness_, 1, 0);
  fields->addWidget(spacing_, 1, 1);
  for (QDoubleSpinBox* each : {thickness_, spacing_}) {
    connect(each, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] {
      protocol_.thickness = thickness_->value();
      protocol_.spacing = spacing_->value();
      show_protocol();
    });
  }
  kernels_ = new QButtonGroup(this);
  auto* kernel_row = new QHBoxLayout;
  kernel_row->setSpacing(4);
  const std::pair<const char*, QString> kernels[] = {
      {"scan.kernel.soft", tr("Soft")}, {"scan.kernel.standard", tr("Standard")}, {"scan.kernel.sharp", tr("Sharp")}};
  for (int i = 0; i < 3; ++i) {
    QPushButton* const made =
        scan_button(kernels[i].first, kernels[i].second, tr("Kernel: sharpness of edges against noise"), true);
    made->setChecked(i == 1);
    kernels_->addButton(made, i);
    kernel_row->addWidget(made);
    connect(made, &QPushButton::clicked, this, [this, i] { protocol_.kernel = static_cast<imaging::ScanKernel>(i); });
  }
  rows->addLayout(fields);
  rows->addLayout(kernel_row);
  auto* last = new QHBoxLayout;
  scan_ = scan_button("scan.start", tr("SCAN"), tr("Acquire the slices; press again to stop (S)"), false);
  scan_->setProperty("role", QStringLiteral("scan"));
  scan_->setFixedSize(76, 76);
  connect(scan_, &QPushButton::clicked, this, &ScanPage::start_or_cancel);
  last->addWidget(scan_);
  auto* words = new QVBoxLayout;
  progress_ = new QProgressBar;
  progress_->setObjectName(QStringLiteral("scan.progress"));
  progress_->setTextVisible(false);
  progress_->setRange(0, 1000);
  message_ = new QLabel;
  message_->setObjectName(QStringLiteral("scan.said"));
  message_->setWordWrap(true);
  words->addStretch(1);
  words->addWidget(progress_);
  words->addWidget(message_);
  words->addStretch(1);
  last->addLayout(words, 1);
  rows->addLayout(last);
}

QWidget* ScanPage::make_right() {
  auto* right = new QWidget;
  auto* rows = new QVBoxLayout(right);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(scan_gap);
  viewer_->setObjectName(QStringLiteral("scan.viewer"));
  viewer_->setAccessibleName(tr("Slices of the scan"));
  viewer_->setToolTip(tr("Wheel: next slice; click: mark a lesion; right drag: window"));
  rows->addWidget(viewer_, 1);
  auto* windows = new QHBoxLayout;
  windows->setSpacing(4);
  for (const WindowPreset& preset : window_presets) {
    QPushButton* const made = scan_button("", QCoreApplication::translate("bodkin::views::SliceView", preset.name),
                                          tr("Window of grey levels"), false);
    made->setObjectName(QStringLiteral("scan.window.") +
                        QString::fromLatin1(preset.name).toLower().replace(' ', '_'));
    windows->addWidget(made);
    connect(made, &QPushButton::clicked, this, [this, &preset] { viewer_->set_window(preset.window, preset.level); });
  }
  windows->addStretch(1);
  cine_ = scan_button("scan.cine", tr("Cine"), tr("Runs through the slices (C)"), true);
  connect(cine_, &QPushButton::clicked, this, [this](bool on) { viewer_->set_cine(on); });
  windows->addWidget(cine_);
  rows->addLayout(windows);
  auto* last = new QHBoxLayout;
  last->addWidget(scan_label(tr("SCANS")));
  list_ = new QHBoxLayout;
  list_->setSpacing(4);
  list_buttons_ = new QButtonGroup(this);
  last->addLayout(list_);
  last->addStretch(1);
  target_ = scan_button("scan.target", tr("Use as target"),
                        tr("The marked lesion becomes the target of this patient's case"), false);
  target_->setEnabled(false);
  connect(target_, &QPushButton::clicked, this, &ScanPage::use_target);
  last->addWidget(target_);
  rows->addLayout(last);
  return right;
}

void ScanPage::set_case(std::shared_ptr<const OpenCase> patient) {
  scanner_.cancel();
  scans_.clear();
  while (QLayoutItem* item = list_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  patient_ = std::move(patient);
  viewer_->set_scan(nullptr);
  scout_->set_case(nullptr);
  progress_->setValue(0);
  const bool has_ct = patient_ && !patient_->patient.ct.empty();
  scan_->setEnabled(has_ct);
  show_message(patient_ && !has_ct ? tr("This patient has no CT to scan.") : QString(), true);
  if (!has_ct) return;
  const anatomy::Grid& lattice = patient_->patient.ct.grid;
  double middle = lattice.to_patient(0.5 * Vec3(lattice.size[0], lattice.size[1], lattice.size[2])).z();
  if (const auto& path = patient_->description().procedure.path) middle = path->target.z();
  protocol_.from = middle + 0.5 * first_range;
  protocol_.to = middle - 0.5 * first_range;
  show_protocol();
}

void ScanPage::enter() {
  if (patient_) scout_->set_case(patient_);
  const Frame& frame = frame_();
  std::optional<anatomy::NeedlePath> needle;
  if (patient_ && frame.has_needle && frame.depth > 0.0) {
    const double length = patient_->description().needle.length;
    needle = {Vec3(frame.needle.translation() - length * needle_axis(frame.needle)), frame.needle.translation()};
  }
  scout_->set_lines(patient_ ? patient_->description().procedure.path : std::nullopt, needle);
  viewer_->setFocus(Qt::OtherFocusReason);
}

void ScanPage::show_protocol() {
  const std::size_t count = imaging::slice_positions(protocol_).size();
  const double gaps = protocol_.spacing - protocol_.thickness;
  range_->setText(tr("%1 mm, %2 slices, %3")
                      .arg(std::abs(protocol_.to - protocol_.from), 0, 'f', 0)
                      .arg(count)
                      .arg(gaps > 0.05    ? tr("gaps of %1 mm").arg(gaps, 0, 'f', 1)
                           : gaps < -0.05 ? tr("overlapping %1 mm").arg(-gaps, 0, 'f', 1)
                                          : tr("no gaps")));
  scout_->set_protocol(protocol_);
}

void ScanPage::start_or_cancel() {
  if (scanner_.running()) {
    scanner_.cancel();
    return show_message(tr("Stopped; the slices acquired so far remain."), false);
  }
  const std::string trouble = imaging::trouble_with(protocol_);
  if (!patient_ || !trouble.empty()) return show_message(in_words(trouble), true);
  auto scan = std::make_shared<imaging::CtScan>();
  scan->protocol = protocol_;
  scan->plane = imaging::scan_plane(patient_->patient.ct.grid);
  const Frame& frame = frame_();
  if (frame.has_needle && frame.depth > 0.0) {
    const anatomy::Needle& shape = patient_->description().needle;
    scan->needle = {frame.needle, 0.5 * shape.outer_diameter, shape.length};
  }
  scanner_.start(patient_, protocol_, scan->needle);
  scans_.push_back(std::move(scan));
  add_to_list();
  show_scan(scans_.size() - 1);
  scan_->setText(tr("STOP"));
  show_message(tr("Scanning ..."), false);
}

void ScanPage::add_to_list() {
  const std::size_t index = scans_.size() - 1;
  const QString text = scans_[index]->needle ? tr("%1 needle in place").arg(index + 1) : QString::number(index + 1);
  QPushButton* const made = scan_button("", text, tr("Shows this scan"), true);
  made->setObjectName(QStringLiteral("scan.list.%1").arg(index + 1));
  list_buttons_->addButton(made, static_cast<int>(index));
  list_->addWidget(made);
  connect(made, &QPushButton::clicked, this, [this, index] { show_scan(index); });
}

void ScanPage::show_scan(std::size_t index) {
  shown_ = index;
  viewer_->set_scan(scans_[index]);
  target_->setEnabled(viewer_->mark().has_value());
  if (QAbstractButton* const shown = list_buttons_->button(static_cast<int>(index))) shown->setChecked(true);
}

void ScanPage::advance(double clock) {
  viewer_->advance(clock);
  if (scan_->text() != tr("STOP")) return;
  const bool was_running = scanner_.running();  // before the last slices are taken up
  imaging::CtScan& scan = *scans_.back();
  if (scanner_.collect(scan) > 0 && shown_ + 1 == scans_.size()) viewer_->set_scan(scans_.back());
  progress_->setValue(static_cast<int>(std::lround(1000.0 * scanner_.fraction())));
  if (was_running) return;
  scan_->setText(tr("SCAN"));
  if (scan.slices.size() == imaging::slice_positions(scan.protocol).size()) {
    show_message(tr("%1 slices. Click a lesion to mark it.").arg(scan.slices.size()), false);
  }
}

void ScanPage::use_target() {
  if (!patient_ || !viewer_->mark()) return;
  const std::optional<anatomy::NeedlePath> path = path_to(*patient_, *viewer_->mark());
  if (!path) return show_message(tr("The mark lies outside the body. Click a place inside it."), true);
  try {
    save_plan(*patient_, *path);
  } catch (const std::exception& failure) {
    return show_message(in_words(failure.what()), true);
  }
  show_message(
      tr("Saved as the target, %1 mm from the skin. The patient opens again with it.").arg(path->length(), 0, 'f', 0),
      false);
  emit patient_requested(QString::fromStdString(patient_->folder.string()));
}

void ScanPage::show_message(const QString& sentence, bool trouble) {
  message_->setText(sentence);
  message_->setStyleSheet(trouble ? QStringLiteral("color: #FF5A52") : QString());
}

bool ScanPage::press(const QKeySequence& keys) {
  switch (keys[0]) {
    case Qt::Key_S:
      start_or_cancel();
      return true;
    case Qt::Key_C:
      cine_->setChecked(!cine_->isChecked());
      viewer_->set_cine(cine_->isChecked());
      return true;
    default:
      return false;
  }
}

}  // namespace bodkin::app
