#include "app/pages/camera.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QTableWidget>
#include <chrono>
#include <cmath>
#include <exception>
#include <utility>

#include "station/probe_contact.h"
#include "station/ultrasound_request.h"
#include "views/language.h"
#include "views/theme.h"

#include "io/probe_library_file.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr const char* probe_of_page = "C5-2";
constexpr double depth_of_page = 90.0;  // mm
constexpr double percent = 0.01;
constexpr std::size_t most_latencies = 1000;
constexpr double usual_radius_x = 150.0, usual_radius_y = 185.0;  // pixels of the picture

QColor status_colour(tracking::TrackingStatus status) {
  switch (status) {
    case tracking::TrackingStatus::ok:
      return Theme::now().good;
    case tracking::TrackingStatus::uncertain:
      return Theme::now().caution;
    case tracking::TrackingStatus::lost:
      return Theme::now().danger;
  }
  return {};
}

station::UltrasoundChoice choice_of_page(const OpenCase& patient) {
  station::UltrasoundChoice choice;
  choice.probe = io::find_probe(probe_of_page);
  choice.settings.depth = depth_of_page;
  choice.request.view =
      patient.description().procedure.path ? imaging::ScanView::needle : imaging::ScanView::paramedian;
  return choice;
}

}  // namespace

CameraPage::~CameraPage() = default;

void CameraPage::set_case(std::shared_ptr<const OpenCase> patient) {
  if (patient == patient_) return;
  stop();
  patient_ = std::move(patient);
  for (SliceView* slice : slices_) slice->set_case(patient_);
  ultrasound_->set_case(patient_);
}

void CameraPage::enter() {
  QSettings settings;
  source_->setEditText(settings.value(QStringLiteral("camera/source")).toString());
  const char* const keys[files] = {"camera/calibration", "camera/bodies", "camera/registration"};
  for (int i = 0; i < files; ++i) paths_[i]->setText(settings.value(QLatin1String(keys[i])).toString());
  shown_ = {};
  shown_.plan = patient_->description().procedure.path;
  if (shown_.plan) shown_.crosshair = shown_.plan->target;
  Changes all;
  all.attempt = all.plan = all.crosshair = all.needle = all.theme = true;
  for (SliceView* slice : slices_) slice->show_frame(shown_, all);
  show_buttons();
  show_line();
  source_->setFocus(Qt::OtherFocusReason);
}

void CameraPage::leave() {
  stop();
  demo_.reset();
}

void CameraPage::start() {
  stop();
  const QString source = source_->currentText().trimmed();
  if (source.isEmpty()) return choose_source();
  QSettings settings;
  settings.setValue(QStringLiteral("camera/source"), source);
  const char* const keys[files] = {"camera/calibration", "camera/bodies", "camera/registration"};
  for (int i = 0; i < files; ++i) settings.setValue(QLatin1String(keys[i]), paths_[i]->text().trimmed());
  failure_.clear();
  scan_failure_.clear();
  reported_.clear();
  result_.reset();
  latencies_.clear();
  // An image is shown on arrival, not at the window's next frame, which may be 33 ms away.
  watch_ = std::make_unique<CameraWatch>(patient_, wanted_files(), path_in(registration), look(), [this] {
    QMetaObject::invokeMethod(
        this, [this] { update_camera_status(); }, Qt::QueuedConnection);
  });
  try {
    const station::UltrasoundChoice choice = choice_of_page(*patient_);
    ultrasound_->set_scan(choice);
    const station::LiveScan& scan = *ultrasound_->scan();
    machine_ = std::make_unique<ProbeMachine>(patient_, choice,
                                              ProbeMachine::Request{{scan.pose(), scan.settings()}, {}}, true);
  } catch (const std::exception& failure) {  // no skin there: without ultrasound
    machine_.reset();
    scan_failure_ = failure.what();
  }
  picture_->show_picture(nullptr);
  ct_->show_picture(nullptr);
  show_buttons();
}

std::filesystem::path CameraPage::path_in(File which) const {
  return paths_[which]->text().trimmed().toStdString();
}

tracking::FootageFiles CameraPage::wanted_files() const {
  tracking::FootageFiles wanted;
  wanted.source = source_->currentText().trimmed().toStdString();
  wanted.camera = path_in(camera);
  wanted.bodies = path_in(bodies);
  return wanted;
}

void CameraPage::record() {
  if (attempt_ != nullptr) return attempt_->end();
  if (watch_ == nullptr) return;
  result_.reset();
  try {
    std::optional<station::UltrasoundChoice> ultrasound;
    if (machine_ != nullptr) ultrasound = choice_of_page(*patient_);
    attempt_ = std::make_unique<TrackedAttempt>(patient_, wanted_files(), path_in(registration), ultrasound);
  } catch (const std::exception& failure) {
    reported_ = failure.what();
  }
  show_buttons();
}

void CameraPage::follow_attempt() {
  if (attempt_ == nullptr) return;
  const StationUpdate& news = attempt_->poll();
  reported_ = TrackedAttempt::sentence(news);
  if (!TrackedAttempt::is_over(news)) return;
  result_ = news.result;
  attempt_.reset();
  show_buttons();
}

void CameraPage::stop() {
  attempt_.reset();  // saves it
  watch_.reset();
  machine_.reset();
  scan_.reset();
  if (ultrasound_->scan() != nullptr) ultrasound_->set_scan(std::nullopt);
  camera_status_ = {};
  table_->setRowCount(0);
  show_buttons();
}

void CameraPage::start_demo() {
  stop();
  failure_.clear();
  demo_ = std::make_unique<DemoFootage>(folder_ / "footage");
  show_buttons();
}

void CameraPage::show_source(const std::filesystem::path& source) {
  for (QLineEdit* path : paths_) path->clear();  // it has files of its own
  use_source(QString::fromStdString(source.string()));
}

void CameraPage::use_source(const QString& source) {
  source_->setEditText(source);
  start();
}

void CameraPage::choose_source() {
  QMenu kinds(this);
  kinds.setObjectName(QStringLiteral("camera.menu"));
  QAction* const folder = kinds.addAction(tr("A folder of pictures"));
  QAction* const video = kinds.addAction(tr("A video"));
  QAction* const chosen = kinds.exec(source_->mapToGlobal(QPoint(0, source_->height())));
  QString found;
  if (chosen == folder) found = QFileDialog::getExistingDirectory(this, folder->text());
  if (chosen == video)
    found = QFileDialog::getOpenFileName(this, video->text(), {},
                                         tr("Videos (*.avi *.mp4 *.mkv *.mov *.webm);;All files (*)"));
  if (!found.isEmpty()) use_source(found);
}

void CameraPage::choose_file(File which) {
  const QString found = QFileDialog::getOpenFileName(this, paths_[which]->accessibleName(), {},
                                                     tr("Files of Bodkin (*.json);;All files (*)"));
  if (!found.isEmpty()) paths_[which]->setText(found);
}

tracking::AugmentedLook CameraPage::look() const {
  tracking::AugmentedLook look;
  look.radii = percent * oval_->value() * Eigen::Vector2d(usual_radius_x, usual_radius_y);
  look.threshold = percent * threshold_->value();
  look.preset = imaging::transfer_presets[static_cast<std::size_t>(preset_->currentIndex())];
  look.plan = plan_->isChecked();
  look.needle = needle_->isChecked();
  look.front_view = false;  // it is beside the picture
  look.status = false;      // so is the table
  return look;
}

void CameraPage::send_look() {
  if (watch_ != nullptr) watch_->set_look(look());
}

void CameraPage::advance(double clock) {
  if (demo_ != nullptr) {
    const DemoFootage::Status status = demo_->status();
    if (status.is_ready) {
      const std::filesystem::path folder = demo_->folder();
      demo_.reset();
      show_source(folder);
    } else if (!status.error.empty()) {
      failure_ = status.error;
      demo_.reset();
      show_buttons();
    }
  }
  shown_.clock = clock;
  update_camera_status();
  if (watch_ != nullptr && !camera_status_.error.empty()) {
    failure_ = camera_status_.error;
    stop();
  }
  follow_attempt();
  show_line();
}

void CameraPage::update_camera_status() {
  if (watch_ == nullptr) return;
  CameraStatus status = watch_->status();
  const bool is_new = status.number != camera_status_.number;
  camera_status_ = std::move(status);
  if (is_new) show_camera_status();
}

void CameraPage::note_latency() {
  if (watch_ == nullptr || camera_status_.picture == nullptr || picture_->picture() != camera_status_.picture) return;
  const auto passed = std::chrono::steady_clock::now() - camera_status_.arrived;
  latencies_.push_back(std::chrono::duration<double>(passed).count());
  if (latencies_.size() > most_latencies) latencies_.pop_front();
}

void CameraPage::show_camera_status() {
  picture_->show_picture(camera_status_.picture);
  picture_->repaint();  // at once: slices and ultrasound take longer, and are not used for aiming
  show_bodies();
  Changes changes;
  changes.needle = changes.tissue = true;
  shown_.has_needle = camera_status_.needle.has_value();
  shown_.moved_tissue = moved_tissue();
  if (watch_ != nullptr) watch_->set_moved_tissue(shown_.moved_tissue);
  if (camera_status_.needle) {
    shown_.needle = shown_.hand = *camera_status_.needle;
    shown_.crosshair = camera_status_.needle->translation();
    const Vec3 tip =
        shown_.moved_tissue != nullptr ? shown_.moved_tissue->at_rest(shown_.crosshair) : shown_.crosshair;
    shown_.tissue = anatomy::nearest(patient_->patient.tissues, tip, anatomy::tissue::air);
    shown_.place = place_name(patient_->patient, tip);
    changes.crosshair = true;
  }
  for (SliceView* slice : slices_) slice->show_frame(shown_, changes);
  if (machine_ == nullptr) return;
  const station::LiveScan& scan = *ultrasound_->scan();
  std::optional<imaging::NeedleInUltrasound> needle;
  if (camera_status_.needle)
    needle = imaging::NeedleInUltrasound{*camera_status_.needle, patient_->description().needle};
  // A badly visible probe requests no image.
  if (camera_status_.probe) {
    const station::ScanSetup setup{station::probe_in_hand(*camera_status_.probe), scan.settings()};
    machine_->set({setup, needle});
    if (attempt_ != nullptr) attempt_->set_scan_setup(setup);
  }
  scan_ = camera_status_.probe ? machine_->picture() : nullptr;
  ct_->show_picture(camera_status_.probe ? machine_->ct() : nullptr);
  shown_.ultrasound = scan_.get();
  ultrasound_->show_frame(shown_, changes);
  if (const std::string trouble = machine_->take_trouble(); !trouble.empty()) ultrasound_->show_message(trouble);
  shown_.ultrasound = nullptr;
}

// Placed by the probe, and by the needle of a session.
std::shared_ptr<const imaging::TissueDisplacement> CameraPage::moved_tissue() const {
  std::shared_ptr<const imaging::TissueDisplacement> pressed, pushed;
  if (machine_ != nullptr && camera_status_.probe) pressed = machine_->moved_tissue();
  if (attempt_ != nullptr) pushed = attempt_->moved_tissue();
  if (pressed == nullptr || pushed == nullptr) return pressed != nullptr ? pressed : pushed;
  return std::make_shared<const imaging::TissueDisplacement>(pressed->plus(*pushed));
}

void CameraPage::show_bodies() {
  table_->setRowCount(static_cast<int>(camera_status_.bodies.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const BodyDetection& body = camera_status_.bodies[static_cast<std::size_t>(row)];
    const bool lost = body.status == tracking::TrackingStatus::lost;
    const QString dash = QStringLiteral("–");
    const std::string status(tracking::name_of(body.status));
    const QString cells[] = {in_words(body.name),
                             in_words(status),
                             lost ? dash : QStringLiteral("±%1").arg(body.deviation, 0, 'f', 2),
                             lost ? dash : QString::number(body.residual, 'f', 3),
                             lost ? dash : QString::number(body.edge_ratio, 'f', 2),
                             QString::number(body.markers)};
    for (int column = 0; column < table_->columnCount(); ++column) {
      QTableWidgetItem* item = table_->item(row, column);
      if (item == nullptr) {
        auto made = std::make_unique<QTableWidgetItem>();
        item = made.get();
        table_->setItem(row, column, made.release());
      }
      if (item->text() != cells[column]) item->setText(cells[column]);
      if (column == 1) item->setForeground(status_colour(body.status));
    }
  }
}

void CameraPage::show_line() {
  QString words;
  bool trouble = false;
  const auto with_tip = [this](const QString& other) {
    if (camera_status_.tip.empty()) return other;
    return (camera_status_.tip_on_bone ? tr("Tip on bone: %1.") : tr("Tip in: %1."))
               .arg(in_words(camera_status_.tip)) +
           QStringLiteral(" ") + other;
  };
  if (demo_ != nullptr) {
    words = tr("Rendering a mannequin, a needle and a probe in front of a camera: %1 %")
                .arg(100.0 * demo_->status().fraction, 0, 'f', 0);
  } else if (!failure_.empty()) {
    words = in_words(failure_);
    trouble = true;
  } else if (watch_ == nullptr) {
    words = tr("Choose a camera (/dev/video0), a video or a folder of pictures, or press Demonstration.");
  } else if (!camera_status_.note.empty()) {
    words = with_tip(in_words(camera_status_.note));
    trouble = true;
  } else if (!reported_.empty()) {
    words = in_words(reported_);
  } else if (camera_status_.number == 0) {
    words = tr("Opening the pictures and preparing the patient.");
  } else {
    words = with_tip(tr("%1 pictures/s, each shown %2 ms after it arrived.")
                         .arg(camera_status_.rate, 0, 'f', 0)
                         .arg(latencies_.empty() ? 0.0 : 1000.0 * latencies_.back(), 0, 'f', 0));
    if (!scan_failure_.empty())
      words += QStringLiteral(" ") + tr("Without ultrasound: %1").arg(in_words(scan_failure_));
    trouble = camera_status_.tip_on_bone;
  }
  if (watch_ != nullptr && failure_.empty()) {
    if (camera_status_.large_oval) words += QStringLiteral(" ") + tr("Large oval: drawn at half the resolution.");
    if (!camera_status_.source_note.empty())
      words += QStringLiteral(" ") + in_words(camera_status_.source_note) + QLatin1Char('.');
  }
  if (line_->text() != words) line_->setText(words);
  line_->setStyleSheet(trouble ? QStringLiteral("color: %1;").arg(Theme::now().danger.name()) : QString());
  picture_->show_words(words);
}

void CameraPage::show_buttons() {
  start_->setText(watch_ == nullptr ? tr("Start") : tr("Stop"));
  start_->setEnabled(demo_ == nullptr);
  pause_->setEnabled(watch_ != nullptr);
  pause_->setChecked(watch_ != nullptr && watch_->is_paused());
  render_->setEnabled(demo_ == nullptr && watch_ == nullptr);
  record_->setText(attempt_ == nullptr ? tr("Record") : tr("Finish"));
  record_->setEnabled(watch_ != nullptr && patient_ != nullptr && patient_->description().procedure.path.has_value());
  review_->setEnabled(result_.has_value());
}

bool CameraPage::press(const QKeySequence& keys) {
  if (keys == QKeySequence(Qt::Key_Space)) {
    if (watch_ == nullptr) {
      if (demo_ == nullptr) start();
    } else {
      watch_->pause(!watch_->is_paused());
      show_buttons();
    }
    return true;
  }
  if (keys == QKeySequence(Qt::Key_R)) return record(), true;
  const int step = 10;
  if (keys == QKeySequence(Qt::Key_Plus)) return oval_->setValue(oval_->value() + step), true;
  if (keys == QKeySequence(Qt::Key_Minus)) return oval_->setValue(oval_->value() - step), true;
  if (keys == QKeySequence(Qt::Key_P))
    return preset_->setCurrentIndex((preset_->currentIndex() + 1) % preset_->count()), true;
  return false;
}

}  // namespace bodkin::app
