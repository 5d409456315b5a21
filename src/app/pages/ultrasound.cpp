#include "app/pages/ultrasound.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <exception>
#include <utility>

#include "app/models/scan_picture.h"
#include "views/language.h"
#include "views/theme.h"

namespace bodkin::app {

using namespace views;

namespace {

// A case's name as the beginning of a file name.
std::string scan_name(std::string name) {
  const auto is_odd = [](char c) { return c == '/' || c == '\\' || c == ' '; };
  std::replace_if(name.begin(), name.end(), is_odd, '_');
  return (name.empty() ? "case" : name) + "-ultrasound";
}

}  // namespace

UltrasoundPage::UltrasoundPage(const std::filesystem::path& folder, QWidget* parent)
    : Page(PageId::ultrasound, KeyScope::ultrasound, false, parent),
      cases_(folder),
      view_(new UltrasoundView),
      title_(new QLabel),
      line_(new QLabel) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(16, 10, 16, 10);
  rows->setSpacing(8);
  auto* head = new QHBoxLayout;
  title_->setObjectName(QStringLiteral("ultrasound.title"));
  title_->setProperty("role", QStringLiteral("heading"));
  line_->setObjectName(QStringLiteral("ultrasound.line"));
  line_->setProperty("role", QStringLiteral("second"));
  head->addWidget(title_);
  head->addStretch(1);
  head->addWidget(line_);
  rows->addLayout(head);
  view_->setObjectName(QStringLiteral("ultrasound.view"));
  rows->addWidget(view_, 1);
  setFocusProxy(view_);
  connect(view_, &UltrasoundView::save_requested, this, &UltrasoundPage::save_picture);
}

void UltrasoundPage::scan(const std::filesystem::path& patient, const station::UltrasoundRequest& request,
                          const std::filesystem::path& output) {
  request_ = request;
  output_ = output;
  is_own_ = true;
  patient_.reset();
  cases_.open(patient);
}

void UltrasoundPage::set_case(std::shared_ptr<const OpenCase> patient) {
  of_window_ = std::move(patient);
}

void UltrasoundPage::enter() {
  if (!is_own_ && of_window_ != nullptr) return begin(of_window_);
  if (patient_ != nullptr) return begin(patient_);
  if (!cases_.status().is_busy) cases_.open_built_in();
}

void UltrasoundPage::leave() {
  machine_.reset();
  view_->set_scan(std::nullopt);
}

void UltrasoundPage::begin(std::shared_ptr<const OpenCase> patient) {
  patient_ = std::move(patient);
  title_->setText(QString::fromStdString(patient_->title));
  machine_.reset();
  picture_.reset();
  shown_needle_.reset();
  has_shown_ = false;
  try {
    view_->set_case(patient_);
    const station::UltrasoundChoice choice = station::choose_ultrasound(request_);
    view_->set_scan(choice, station::needle_of(request_, patient_->patient));
    const station::LiveScan& scan = *view_->scan();
    machine_ = std::make_unique<ProbeMachine>(patient_, choice,
                                              ProbeMachine::Request{{scan.pose(), scan.settings()}, scan.needle()});
    show_message(tr("Drag slides the probe, the wheel presses it. H: all keys, Esc: back"), false);
  } catch (const std::exception& trouble) {  // no skin there, no such probe
    show_message(in_words(trouble.what()), true);
  }
  view_->setFocus(Qt::OtherFocusReason);
}

void UltrasoundPage::show_message(const QString& sentence, bool is_trouble) {
  line_->setText(sentence);
  line_->setStyleSheet(is_trouble ? QStringLiteral("color: %1;").arg(Theme::now().danger.name()) : QString());
}

void UltrasoundPage::advance(double clock) {
  if (machine_ == nullptr) {
    if (std::shared_ptr<const OpenCase> opened = cases_.take()) return begin(std::move(opened));
    const CaseModel::Status status = cases_.status();
    if (status.is_busy) {
      show_message(tr("Preparing the patient: %1").arg(in_words(status.stage)), false);
    } else if (!status.error.empty()) {
      show_message(in_words(status.error), true);
    }
    return;
  }
  const station::LiveScan& scan = *view_->scan();
  const std::optional<imaging::NeedleInUltrasound> needle = scan.needle();
  machine_->set({{scan.pose(), scan.settings()}, needle});
  if (std::string trouble = machine_->take_trouble(); !trouble.empty()) view_->show_message(trouble);
  picture_ = machine_->picture();
  Frame frame;
  frame.clock = clock;
  frame.has_needle = needle.has_value();
  if (needle) frame.needle = needle->pose;
  frame.plan = patient_->description().procedure.path;
  frame.ultrasound = picture_.get();
  Changes changes;
  const bool same = needle.has_value() == shown_needle_.has_value() &&
                    (!needle || needle->pose.matrix() == shown_needle_->matrix());
  changes.needle = !same || !has_shown_;
  changes.plan = !has_shown_;
  has_shown_ = true;
  shown_needle_ = needle ? std::optional(needle->pose) : std::nullopt;
  view_->show_frame(frame, changes);
}

bool UltrasoundPage::press(const QKeySequence& keys) {
  return keys == QKeySequence(Qt::Key_Escape) && view_->close_help();
}

void UltrasoundPage::save_picture() {
  const station::LiveScan& scan = *view_->scan();
  std::filesystem::path base = output_;
  if (base.empty()) {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    base = std::filesystem::path(folder.toStdString()) / scan_name(patient_->description().name);
  }
  try {
    const imaging::OrientationMarkerSide mark = station::choose_ultrasound(request_).mark;
    const std::filesystem::path file = save_scan_picture(scan.screen(), mark, patient_->patient, scan.needle(), base);
    view_->show_message("Saved " + file.string());
  } catch (const std::exception& failed) {  // a full disk does not end a scan
    view_->show_message(failed.what());
  }
}

}  // namespace bodkin::app
