#include "app/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QSettings>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/models/allowed_frame.h"
#include "app/models/data_folder.h"
#include "app/models/kept_sessions.h"
#include "app/pages/atlas.h"
#include "app/pages/camera.h"
#include "app/pages/cards.h"
#include "app/pages/devices.h"
#include "app/pages/models.h"
#include "app/pages/palette.h"
#include "app/pages/plan.h"
#include "app/pages/practise.h"
#include "app/pages/review.h"
#include "app/pages/scan.h"
#include "app/pages/segment.h"
#include "app/pages/start.h"
#include "app/pages/tour.h"
#include "app/pages/training.h"
#include "app/pages/ultrasound.h"
#include "app/pages/volume.h"
#include "app/spoken_language.h"
#include "views/language.h"
#include "views/theme.h"
#include "views/top_bar.h"

namespace bodkin::app {

using namespace views;

namespace {

// The page of each stage of the bar, and the stage of each page.
PageId page_of(Stage stage) noexcept {
  switch (stage) {
    case Stage::patient:
      return PageId::start;
    case Stage::scan:
      return PageId::scan;
    case Stage::plan:
      return PageId::plan;
    case Stage::practise:
      return PageId::practise;
    case Stage::review:
      return PageId::review;
  }
  return PageId::practise;
}

Stage stage_of(PageId page) noexcept {
  for (int i = 0; i < stage_count; ++i) {
    if (page_of(static_cast<Stage>(i)) == page) return static_cast<Stage>(i);
  }
  return Stage::patient;
}

constexpr int least_width = 1024, least_height = 640, first_width = 1280, first_height = 720;  // pixels

}  // namespace

MainWindow::MainWindow(const std::filesystem::path& folder)
    : practice_(folder),
      bar_(new TopBar),
      pages_(new QStackedWidget),
      start_(new StartPage),
      practise_(new PractisePage),
      preparing_(new PreparingCard(pages_)),
      pause_(new PauseCard(pages_)),
      results_(new ResultsCard(pages_)),
      keys_(new KeysCard(this)),
      about_(new AboutCard(this)),
      palette_(new Palette(this)),
      tour_(new Tour(practise_, &practise_->view3d())),
      ultrasound_(new UltrasoundPage(folder)) {
  setObjectName(QStringLiteral("window"));
  setWindowTitle(QStringLiteral("Bodkin"));
  setMinimumSize(least_width, least_height);
  resize(first_width, first_height);
  auto* ground = new QWidget;
  ground->setObjectName(QStringLiteral("ground"));
  ground->setAttribute(Qt::WA_StyledBackground);
  auto* rows = new QVBoxLayout(ground);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  bar_->setObjectName(QStringLiteral("bar"));
  bar_->setFixedHeight(TopBar::bar_height);
  rows->addWidget(bar_);
  rows->addWidget(pages_, 1);
  pages_->addWidget(start_);
  pages_->addWidget(practise_);
  setCentralWidget(ground);
  const QSettings settings;
  apply_theme(settings.value(QStringLiteral("dark"), true).toBool());
  restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
  connect_views();
  connect_cards();
  add_pages();
  offer_recovered();
  offer_plan();
  practice_.on_result([this](const AttemptResult& result) { take_attempt(result); });
  qApp->installEventFilter(this);
  connect(&clock_, &FrameClock::frame, this, &MainWindow::draw);
  clock_.start();
  draw(0.0);
}

MainWindow::~MainWindow() {
  qApp->removeEventFilter(this);
  clock_.stop();
}

void MainWindow::connect_views() {
  for (View* view : practise_->views()) {
    connect(view, &View::aimed, this, [this](const Vec3& point, const Vec3& outwards) {
      practice_.aim({point, outwards});
    });
    connect(view, &View::aim_left, this, [this] { practice_.aim_left(); });
    connect(view, &View::put_down, this, [this] { practice_.put_down(); });
    connect(view, &View::pushed, this, [this](double notches, bool fine) { practice_.push(notches, fine); });
    connect(view, &View::dragged, this, [this](double way) { practice_.drag(way); });
    connect(view, &View::tilted, this, [this](double right, double cranial) { practice_.tilt(right, cranial); });
    connect(view, &View::crosshair_moved, this, [this](const Vec3& point) { practice_.set_crosshair(point); });
    connect(view, &View::follow_tip_toggled, this, [this] { practice_.toggle_follow(); });
  }
  connect(practise_, &PractisePage::hold_requested, this, [this] { run(Command::hold); });
  connect(practise_, &PractisePage::moving_toggled, this, [this] { run(Command::move_body); });
  connect(practise_, &PractisePage::moving_undone, this, [this] { run(Command::undo_body); });
  connect(practise_, &PractisePage::moving_reset, this, [this] { run(Command::reset_body); });
  connect(&practise_->view3d(), &View3d::body_drag_started, this, [this] { practice_.begin_body_drag(); });
  connect(&practise_->view3d(), &View3d::body_placed, this, [this](const Vec3& middle, const Mat3& rotation) {
    practice_.place_body({middle, rotation});
  });
  connect(&practise_->view3d(), &View3d::points_changed, this,
          [this] { practice_.follow_points(practise_->view3d().deformable_points()); });
  connect_other_hand();
  connect(practise_, &PractisePage::again_requested, this, [this] { run(Command::again); });
  connect(practise_, &PractisePage::end_requested, this, [this] { run(Command::end); });
  connect(practise_, &PractisePage::warning_acknowledged, this, [this] { practice_.acknowledge(); });
  connect(bar_, &TopBar::home_requested, this, [this] { run(Command::back); });
  connect(bar_, &TopBar::device_page_requested, this, [this] { show_page(PageId::devices); });
  connect(bar_, &TopBar::servo_page_requested, this, [this] { run(Command::show_dock); });
  connect(bar_, &TopBar::help_requested, this, [this] { run(Command::show_keys); });
  connect(bar_, &TopBar::ultrasound_toggled, this, &MainWindow::show_ultrasound);
  connect(&practise_->ultrasound(), &UltrasoundView::scan_setup_changed, this,
          [this](const station::ScanSetup& setup) { practice_.set_scan_setup(setup); });
  connect(&practise_->ultrasound(), &UltrasoundView::save_requested, this, [this] { run(Command::save_picture); });
  for (const Stage stage : {Stage::scan, Stage::plan, Stage::review}) bar_->allow(stage, false);
  connect(bar_, &TopBar::stage_chosen, this, [this](Stage stage) {
    if (stage == Stage::patient) return page_ != nullptr ? show_page(PageId::start) : run(Command::back);
    show_page(page_of(stage));
  });
}

void MainWindow::connect_cards() {
  connect(start_, &StartPage::begin_requested, this, [this] { run(Command::begin); });
  connect(start_, &StartPage::procedure_chosen, this, &MainWindow::practise_procedure);
  connect(start_, &StartPage::tour_requested, this, [this] { run(Command::tour); });
  connect(start_, &StartPage::page_requested, this, &MainWindow::show_page);
  connect(start_, &StartPage::open_requested, this, [this] { run(Command::open_patient); });
  connect(start_, &StartPage::patient_chosen, this, [this](const QString& path) { open(path.toStdString()); });
  connect(start_, &StartPage::review_requested, this, [this](const QString& file) { review(file.toStdString()); });
  connect(start_, &StartPage::language_requested, this, [this](const QString& code) {
    choose_language(code);
    QApplication::setQuitOnLastWindowClosed(false);
    close();
    QApplication::exit(retranslate);
  });
  connect(start_, &StartPage::forget_requested, this, [this](const QString& file) {
    QSettings settings;
    const QString key = QStringLiteral("forgotten_sessions");
    settings.setValue(key, settings.value(key).toStringList() << file);
    offer_recovered();
  });
  connect(start_, &StartPage::plan_continued, this, [this] {
    const QSettings settings;
    follow_plan(settings.value(QStringLiteral("training/plan")).toString(),
                settings.value(QStringLiteral("training/trainee")).toString());
  });
  connect(start_, &StartPage::plan_left, this, [this] {
    QSettings().setValue(QStringLiteral("training/is_begun"), false);
    offer_plan();
  });
  connect(preparing_, &PreparingCard::cancel_requested, this, [this] { practice_.cancel(); });
  connect(pause_, &PauseCard::resume_requested, this, [this] {
    if (practice_.state() == State::device_lost) return practice_.again();
    if (practice_.state() == State::faulted) practice_.arm();
    practice_.pause(false);
  });
  connect(pause_, &PauseCard::mouse_requested, this, [this] { use_device({}, {}); });
  connect(pause_, &PauseCard::again_requested, this, [this] { practice_.again(); });
  connect(pause_, &PauseCard::end_requested, this, [this] { practice_.end(); });
  connect(pause_, &PauseCard::leave_requested, this, [this] { practice_.leave(); });
  connect(results_, &ResultsCard::again_requested, this, [this] { another_attempt(); });
  connect(results_, &ResultsCard::review_requested, this, [this] {
    if (practice_.result()) review(practice_.result()->session);
  });
  connect(results_, &ResultsCard::leave_requested, this, [this] { practice_.leave(); });
  connect(results_, &ResultsCard::look_requested, this, [this] {
    results_->hide();
    practice_.show_message(tr("The ring is at the planned entry. Esc brings the results back.").toStdString());
  });
  connect(keys_, &KeysCard::closed, keys_, &QWidget::hide);
  connect(about_, &AboutCard::closed, about_, &QWidget::hide);
  connect(start_, &StartPage::about_requested, this, &MainWindow::show_about);
}

// Adds every separate page.
void MainWindow::add_pages() {
  auto* const training = new TrainingPage;
  connect(training, &TrainingPage::follow_requested, this, &MainWindow::follow_plan);
  add_page(training, tr("Follow a plan"), tr("Stages that a teacher has laid out, and how far you are"));
  auto* const plan = new PlanPage;
  connect(plan, &PlanPage::plan_changed, this, [this](const anatomy::NeedlePath& path) { practice_.set_plan(path); });
  add_page(plan, tr("Plan"), tr("Choose where to go in, and the target"));
  review_ = new ReviewPage(data_folder() / "sessions");
  add_page(review_, tr("Review"), tr("See a session again, moment by moment"));
  add_page(new ScanPage([this]() -> const Frame& { return practice_.frame(); }), tr("CT scanner"),
           tr("Scan the patient again, with the needle in place"));
  add_page(new VolumePage([this]() -> const Frame& { return practice_.frame(); }), tr("Volume"),
           tr("The inside of the patient: bone, soft tissue, X-ray"));
  add_page(new SegmentPage, tr("Structures"), tr("Correct the structures of the segmentation, or make new ones"));
  devices_ = new DevicesPage;
  add_page(devices_, tr("Devices"), tr("Devices that hold the needle: find, check, calibrate"));
  atlas_ = new AtlasPage(data_folder());
  connect(atlas_, &AtlasPage::needling_requested, this,
          [this](const QString& folder, const Vec3& place) { needle_found_point(folder.toStdString(), place); });
  add_page(atlas_, tr("Acupuncture"), tr("Points and meridians on a whole body"));
  connect(devices_, &DevicesPage::use_requested, this, &MainWindow::use_device);
  const auto frame = [this]() -> const Frame& { return practice_.frame(); };
  auto* const models =
      new ModelsPage(frame, [this](const ModelSettings& settings) { return practice_.apply_models(settings); });
  connect(models, &ModelsPage::settings_chosen, this, [this](const auto& chosen) { practice_.set_models(chosen); });
  add_page(models, tr("Model settings"), tr("The values of the force model, one per step, and what they do"));
  add_page(ultrasound_, tr("Ultrasound"), tr("The probe in your hand, with the CT of the same plane"));
  add_page(new CameraPage(data_folder()), tr("Augmented reality"),
           tr("A camera sees a mannequin: shows the patient in it and the ultrasound at the probe"));
  const QSettings settings;
  use_device(settings.value(QStringLiteral("device/driver")).toString(),
             settings.value(QStringLiteral("device/identity")).toString());
}

// The device for practice from now on, also in later runs; an empty driver: the mouse.
void MainWindow::use_device(const QString& driver, const QString& identity) {
  std::optional<PracticeDevice> device;
  try {
    DeviceRow row;
    row.driver = driver.toStdString();
    row.identity = identity.toStdString();
    if (!row.is_mouse()) device = PracticeDevice{choice_of(row), driver.toStdString()};
  } catch (const std::exception& error) {  // a driver that no longer exists: the mouse always does
    practice_.show_message(error.what());
  }
  QSettings settings;
  settings.setValue(QStringLiteral("device/driver"), device ? driver : QString());
  settings.setValue(QStringLiteral("device/identity"), device ? identity : QString());
  devices_->set_used(device ? driver + QLatin1Char(':') + identity : QString());
  practice_.set_device(device);
  atlas_->set_device(device ? std::optional(device->choice) : std::nullopt);
}

// The newest session interrupted by a crash, until a person discards it.
void MainWindow::offer_recovered() {
  std::vector<std::filesystem::path> forgotten;
  for (const QString& file : QSettings().value(QStringLiteral("forgotten_sessions")).toStringList())
    forgotten.emplace_back(file.toStdString());
  const std::filesystem::path found = cut_off_session(kept_sessions(data_folder() / "sessions"), forgotten);
  start_->offer_recovered(QString::fromStdString(found.string()));
}

void MainWindow::review(const std::filesystem::path& session) {
  show_page(PageId::review);
  review_->open(session);
}

void MainWindow::add_page(Page* page, const QString& entry, const QString& tip) {
  more_pages_.push_back(page);
  pages_->addWidget(page);
  start_->add_entry(page->id(), entry, tip);
  for (int i = 0; i < stage_count; ++i) {
    if (page_of(static_cast<Stage>(i)) == page->id()) bar_->allow(static_cast<Stage>(i), true);
  }
  connect(page, &Page::page_requested, this, &MainWindow::show_page);
  connect(page, &Page::practise_requested, this, [this] { show_page(PageId::practise); });
  connect(page, &Page::patient_requested, this, [this](const QString& path) {
    if (practice_.state() == State::paused) practice_.leave();  // an attempt is saved and over
    leave_page();
    open(path.toStdString());
  });
}

void MainWindow::leave_page() {
  wanted_page_ = nullptr;
  if (page_ == nullptr) return;
  page_->leave();
  page_ = nullptr;
  if (has_paused_ && practice_.state() == State::paused) practice_.pause(false);
  has_paused_ = false;
}

void MainWindow::show_page(PageId id) {
  if (page_ != nullptr && page_->id() == id) return;
  if (!may_show(id)) return;
  const auto found =
      std::find_if(more_pages_.begin(), more_pages_.end(), [&](Page* page) { return page->id() == id; });
  leave_page();
  if (found == more_pages_.end()) {
    if (id == PageId::start) practice_.leave();
    if (id == PageId::practise && practice_.state() == State::no_case) practice_.choose_built_in();
    return show_state();
  }
  if ((*found)->needs_patient() && shown_ == nullptr) {
    wanted_page_ = *found;
    if (practice_.state() == State::no_case) practice_.choose_built_in();
    return;
  }
  if (is_attempt(practice_.state()) && practice_.state() != State::paused) {
    practice_.pause(true);
    has_paused_ = practice_.state() == State::paused;
  }
  page_ = *found;
  page_->enter();
  show_state();
  page_->setFocus(Qt::OtherFocusReason);
}

void MainWindow::open(const std::filesystem::path& patient) {
  if (patient.extension() == ".bodkin") return review(patient);
  practice_.choose(patient);
}

void MainWindow::perform(const std::filesystem::path& patient, const AttemptOptions& options) {
  asked_ultrasound_ = options.ultrasound;
  has_ultrasound_ = options.ultrasound.has_value();  // shown as soon as there is a patient
  practice_.perform(patient, options);
}

void MainWindow::scan(const std::filesystem::path& patient, const station::UltrasoundRequest& request,
                      const std::filesystem::path& output) {
  ultrasound_->scan(patient, request, output);
  show_page(PageId::ultrasound);
}

void MainWindow::draw(double clock) {
  const Frame& frame = practice_.advance(clock);
  if (practice_.patient() != shown_) {
    shown_ = practice_.patient();
    practise_->set_case(shown_);
    practise_->show_moving({});
    if (has_ultrasound_) show_ultrasound(shown_ != nullptr);
    bar_->set_case(shown_);
    for (Page* page : more_pages_) page->set_case(shown_);
    if (stage_ && shown_ != nullptr) begin_stage();
  }
  advance_plan(frame);
  follow_found_point();
  if (wanted_page_ != nullptr && shown_ != nullptr && frame.state == State::ready) show_page(wanted_page_->id());
  if (practice_.state() == State::no_case) wanted_page_ = nullptr;  // the patient could not be opened
  if (frame.state != shown_state_ || practice_.failure() != shown_failure_) {
    shown_state_ = frame.state;
    shown_failure_ = practice_.failure();
    show_state();
  }
  if (frame.state == State::preparing) {
    const CaseModel::Status status = practice_.preparation();
    const QString what = status.stage.empty() ? tr("preparing the session") : in_words(status.stage);
    preparing_->show_progress(what, status.fraction, status.seconds);
  }
  if (frame.state == State::ended) {
    results_->show_result(practice_.result() ? &*practice_.result() : nullptr, dangers(),
                          in_words(practice_.failure().empty() ? practice_.completion() : practice_.failure()));
  }
  Changes changes = practice_.changes();
  changes.theme = std::exchange(theme_changed_, false);
  bar_->show_frame(frame, changes);
  const training::PlanAids* const aids = stage_ ? &stage_->aids : seeking_aids_ ? &*seeking_aids_ : nullptr;
  const Frame allowed = aids != nullptr ? allowed_frame(frame, *aids) : frame;
  sounds_.follow(allowed);
  tour_->show_frame(frame);
  if (page_ != nullptr) page_->advance(clock);
  if (pages_->currentWidget() == practise_) practise_->show_frame(allowed, changes);
}

// The forbidden structures touched by the tip, worst first.
QStringList MainWindow::dangers() const {
  std::vector<TouchedDanger> met = practice_.dangers();
  std::stable_sort(met.begin(), met.end(),
                   [](const TouchedDanger& a, const TouchedDanger& b) { return a.warning.kind < b.warning.kind; });
  QStringList sentences;
  for (const TouchedDanger& danger : met) {
    sentences << tr("%1, met at %2 mm after %3 s")
                     .arg(in_words(danger.warning.title))
                     .arg(danger.depth, 0, 'f', 1)
                     .arg(danger.time, 0, 'f', 0);
  }
  return sentences;
}

void MainWindow::show_state() {
  const State state = practice_.state();
  const bool at_start = state == State::no_case;
  if (at_start) {
    start_->show_patients(practice_.cases().known());
    offer_plan();
    start_->show_message(in_words(practice_.failure()), !practice_.failure().empty());
  }
  const bool has_patient = practice_.patient() != nullptr;
  const bool shows_start = at_start || (state == State::preparing && !has_patient);
  pages_->setCurrentWidget(page_ != nullptr ? page_ : shows_start ? static_cast<QWidget*>(start_) : practise_);
  bar_->setVisible(page_ != nullptr || !shows_start);
  bar_->set_stage(stage_of(page_ != nullptr ? page_->id() : PageId::practise));
  preparing_->setVisible(state == State::preparing);
  const bool paused = state == State::paused || state == State::faulted || state == State::device_lost;
  pause_->show_reason(state, in_words(practice_.frame().message));
  pause_->setVisible(paused && page_ == nullptr);
  results_->setVisible(state == State::ended && page_ == nullptr);
  for (QWidget* card :
       {static_cast<QWidget*>(preparing_), static_cast<QWidget*>(pause_), static_cast<QWidget*>(results_)}) {
    card->setGeometry(pages_->rect());
    card->raise();
  }
  if (state == State::ready && page_ == nullptr) practise_->view3d().setFocus(Qt::OtherFocusReason);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  keys_->setGeometry(rect());
  about_->setGeometry(rect());
  palette_->setGeometry(rect());
  for (QWidget* card :
       {static_cast<QWidget*>(preparing_), static_cast<QWidget*>(pause_), static_cast<QWidget*>(results_)})
    card->setGeometry(pages_->rect());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  QSettings().setValue(QStringLiteral("geometry"), saveGeometry());
  practise_->save_layout();
  practice_.leave();  // a running session is saved when the window is destroyed
  leave_stage();
  event->accept();
}

}  // namespace bodkin::app
