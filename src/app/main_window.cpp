#include "app/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDateTime>
#include <QFileDialog>
#include <QKeyEvent>
#include <QSettings>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <algorithm>

#include "app/pages/cards.h"
#include "app/pages/practise.h"
#include "app/pages/start.h"
#include "app/theme.h"
#include "app/views/top_bar.h"

#include "core/error.h"
#include "io/probe_library_file.h"

namespace bodkin::app {

namespace {

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
      keys_(new KeysCard(this)) {
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
  connect(practise_, &PractisePage::again_requested, this, [this] { run(Command::again); });
  connect(practise_, &PractisePage::end_requested, this, [this] { run(Command::end); });
  connect(practise_, &PractisePage::warning_acknowledged, this, [this] { practice_.acknowledge(); });
  connect(bar_, &TopBar::home_requested, this, [this] { run(Command::back); });
  connect(bar_, &TopBar::device_page_requested, this, [this] { run(Command::show_dock); });
  connect(bar_, &TopBar::servo_page_requested, this, [this] { run(Command::show_dock); });
  connect(bar_, &TopBar::help_requested, this, [this] { run(Command::show_keys); });
  connect(bar_, &TopBar::ultrasound_toggled, this, &MainWindow::show_ultrasound);
  connect(&practise_->ultrasound(), &UltrasoundView::scan_ordered, this,
          [this](const station::ScanOrder& order) { practice_.order_scan(order); });
  connect(&practise_->ultrasound(), &UltrasoundView::save_requested, this, [this] { run(Command::save_picture); });
  bar_->allow(Stage::review, false);
  connect(bar_, &TopBar::stage_chosen, this, [this](Stage stage) {
    if (stage == Stage::patient) run(Command::back);
  });
}

void MainWindow::connect_cards() {
  connect(start_, &StartPage::begin_requested, this, [this] { run(Command::begin); });
  connect(start_, &StartPage::open_requested, this, [this] { run(Command::open_patient); });
  connect(start_, &StartPage::patient_chosen, this, [this](const QString& path) { open(path.toStdString()); });
  connect(preparing_, &PreparingCard::cancel_requested, this, [this] { practice_.cancel(); });
  connect(pause_, &PauseCard::resume_requested, this, [this] {
    if (practice_.state() == State::faulted) practice_.arm();
    practice_.pause(false);
  });
  connect(pause_, &PauseCard::again_requested, this, [this] { practice_.again(); });
  connect(pause_, &PauseCard::end_requested, this, [this] { practice_.end(); });
  connect(pause_, &PauseCard::leave_requested, this, [this] { practice_.leave(); });
  connect(results_, &ResultsCard::again_requested, this, [this] { practice_.again(); });
  connect(results_, &ResultsCard::leave_requested, this, [this] { practice_.leave(); });
  connect(keys_, &KeysCard::closed, keys_, &QWidget::hide);
}

void MainWindow::open(const std::filesystem::path& patient) {
  practice_.choose(patient);
}

void MainWindow::draw(double clock) {
  const Frame& frame = practice_.advance(clock);
  if (practice_.patient() != shown_) {
    shown_ = practice_.patient();
    practise_->set_case(shown_);
    if (has_ultrasound_) show_ultrasound(shown_ != nullptr);
    bar_->set_case(shown_);
  }
  if (frame.state != shown_state_ || practice_.failure() != shown_failure_) {
    shown_state_ = frame.state;
    shown_failure_ = practice_.failure();
    show_state();
  }
  if (frame.state == State::preparing) {
    const CaseModel::Status status = practice_.preparation();
    const QString what = status.is_busy ? QString::fromStdString(status.stage) : tr("putting the station together");
    preparing_->show_progress(what, status.is_busy ? status.fraction : 1.0, status.seconds);
  }
  if (frame.state == State::ended) {
    results_->show_result(practice_.result() ? &*practice_.result() : nullptr, dangers(),
                          QString::fromStdString(practice_.failure()));
  }
  bar_->show_frame(frame, practice_.changes());
  if (pages_->currentWidget() == practise_) practise_->show_frame(frame, practice_.changes());
}

// What the tip must not have met, the worst first.
QStringList MainWindow::dangers() const {
  std::vector<MetDanger> met = practice_.dangers();
  std::stable_sort(met.begin(), met.end(),
                   [](const MetDanger& a, const MetDanger& b) { return a.warning.kind < b.warning.kind; });
  QStringList sentences;
  for (const MetDanger& danger : met) {
    sentences << tr("%1, met at %2 mm after %3 s")
                     .arg(QString::fromStdString(danger.warning.title))
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
    start_->say(QString::fromStdString(practice_.failure()), !practice_.failure().empty());
  }
  const bool has_patient = practice_.patient() != nullptr;
  pages_->setCurrentWidget(at_start || (state == State::preparing && !has_patient) ? static_cast<QWidget*>(start_)
                                                                                   : practise_);
  bar_->setVisible(pages_->currentWidget() == practise_);
  bar_->set_stage(state == State::ended ? Stage::review : Stage::practise);
  preparing_->setVisible(state == State::preparing);
  const bool paused = state == State::paused || state == State::faulted || state == State::device_lost;
  pause_->show_reason(state, QString::fromStdString(practice_.frame().message));
  pause_->setVisible(paused);
  results_->setVisible(state == State::ended);
  for (QWidget* card :
       {static_cast<QWidget*>(preparing_), static_cast<QWidget*>(pause_), static_cast<QWidget*>(results_)}) {
    card->setGeometry(pages_->rect());
    card->raise();
  }
  if (state == State::ready) practise_->view3d().setFocus(Qt::OtherFocusReason);
}

KeyScope MainWindow::page_scope() const {
  return pages_->currentWidget() == practise_ ? KeyScope::practise : KeyScope::start;
}

bool MainWindow::press(const QKeySequence& keys, bool before_views) {
  const KeyScope page = page_scope();
  if (before_views) {
    if (const std::optional<Command> command = reserved_command(page, keys)) return run(*command), true;
    return false;
  }
  for (const KeyScope scope : chain_of(page)) {
    if (const std::optional<Command> command = command_of(scope, keys)) return run(*command), true;
  }
  return false;
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  const bool is_press = event->type() == QEvent::KeyPress, is_release = event->type() == QEvent::KeyRelease;
  auto* const widget = qobject_cast<QWidget*>(watched);
  if ((!is_press && !is_release) || widget == nullptr || widget->window() != this || widget != focus_or_self())
    return QMainWindow::eventFilter(watched, event);
  const auto* const key = static_cast<QKeyEvent*>(event);
  if (is_release) {
    if ((key->key() == Qt::Key_PageDown || key->key() == Qt::Key_PageUp) && !key->isAutoRepeat())
      practice_.hold_key(0, false);
    return QMainWindow::eventFilter(watched, event);
  }
  const Qt::KeyboardModifiers modifiers = key->modifiers() & ~Qt::KeypadModifier;
  // A character that needs Shift ("?") is itself.
  const bool is_sign =
      key->key() < 0x80 && key->key() > Qt::Key_Space && !(key->key() >= Qt::Key_A && key->key() <= Qt::Key_Z);
  const int code = key->key() + static_cast<int>(is_sign ? modifiers & ~Qt::ShiftModifier : modifiers);
  return press(QKeySequence(code), true) || QMainWindow::eventFilter(watched, event);
}

QWidget* MainWindow::focus_or_self() {
  QWidget* const focus = focusWidget();
  return focus != nullptr ? focus : this;
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  const int code = event->key() + static_cast<int>(event->modifiers() & ~Qt::KeypadModifier);
  if (!press(QKeySequence(code), false)) QMainWindow::keyPressEvent(event);
}

void MainWindow::run(Command command) {
  switch (command) {
    case Command::show_keys:
      keys_->show_keys(page_scope() == KeyScope::practise
                           ? std::vector{KeyScope::practise, KeyScope::view3d, KeyScope::slice, KeyScope::window}
                           : std::vector{KeyScope::start, KeyScope::window});
      keys_->setGeometry(rect());
      keys_->setVisible(!keys_->isVisible());
      return keys_->raise();
    case Command::back:
      if (keys_->isVisible()) return keys_->hide();
      if (practice_.state() == State::preparing) return practice_.cancel();
      if (practice_.state() == State::ended) return practice_.leave();
      return practice_.pause(practice_.state() != State::paused);
    case Command::open_patient:
      return choose_patient();
    case Command::save_picture:
      return save_picture();
    case Command::full_screen:
      return isFullScreen() ? showNormal() : showFullScreen();
    case Command::toggle_theme:
      return apply_theme(!Theme::now().is_dark);
    case Command::leave_program:
      close();
      return;
    case Command::next_view:
      return practise_->focus_next(false);
    case Command::previous_view:
      return practise_->focus_next(true);
    case Command::begin:
      return practice_.choose_built_in();
    case Command::hold:
      return practice_.toggle_hold();
    case Command::push_in:
    case Command::push_in_finely:
      return practice_.hold_key(1, command == Command::push_in_finely);
    case Command::draw_out:
    case Command::draw_out_finely:
      return practice_.hold_key(-1, command == Command::draw_out_finely);
    case Command::withdraw:
      return practice_.withdraw();
    case Command::again:
      return practice_.again();
    case Command::end:
      return practice_.end();
    case Command::arm:
      return practice_.arm();
    case Command::show_numbers:
      return practise_->toggle_numbers();
    case Command::show_ladder:
      return practise_->toggle_ladder();
    case Command::show_dock:
      return practise_->toggle_dock();
    case Command::toggle_ultrasound:
      return show_ultrasound(!has_ultrasound_);
    case Command::fill:
      return practise_->toggle_fill();
    case Command::of_the_view:
      return;
  }
}

// With the probe lengthwise beside the planned way of the needle, which then lies in the slice.
void MainWindow::show_ultrasound(bool on) {
  if (shown_ == nullptr) on = false;
  std::optional<station::UltrasoundChoice> choice;
  try {
    if (on) {
      choice.emplace();
      choice->probe = io::find_probe("C5-2");
      choice->settings.depth = 90.0;
      const bool has_path = shown_->description().procedure.path.has_value();
      choice->request.view = has_path ? imaging::ScanView::needle : imaging::ScanView::paramedian;
    }
    practise_->show_ultrasound(choice);
    practice_.set_ultrasound(choice);
    has_ultrasound_ = on;
  } catch (const InputError& error) {  // no skin there
    practice_.say(error.what());
  }
  bar_->set_ultrasound(has_ultrasound_);
}

void MainWindow::choose_patient() {
  if (practice_.state() != State::no_case && practice_.state() != State::ended) return practice_.pause(true);
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of a case, or of DICOM images"));
  if (!folder.isEmpty()) open(folder.toStdString());
}

void MainWindow::save_picture() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QString name = QDateTime::currentDateTime().toString(QStringLiteral("'bodkin' yyyy-MM-dd hh.mm.ss'.png'"));
  grab().save(folder + QLatin1Char('/') + name);
}

void MainWindow::apply_theme(bool dark) {
  Theme::use(dark);
  qApp->setStyleSheet(Theme::now().style_sheet());
  QSettings().setValue(QStringLiteral("dark"), dark);
  update();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  keys_->setGeometry(rect());
  for (QWidget* card :
       {static_cast<QWidget*>(preparing_), static_cast<QWidget*>(pause_), static_cast<QWidget*>(results_)})
    card->setGeometry(pages_->rect());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  QSettings().setValue(QStringLiteral("geometry"), saveGeometry());
  practice_.leave();  // what runs is saved when the window goes
  event->accept();
}

}  // namespace bodkin::app
