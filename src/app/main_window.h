#pragma once

#include <QMainWindow>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/frame_clock.h"
#include "app/key_table.h"
#include "app/practice.h"

class QStackedWidget;

namespace bodkin::app {

class KeysCard;
class PauseCard;
class PractisePage;
class PreparingCard;
class ResultsCard;
class StartPage;
class TopBar;

// The window: the bar, the pages below it, and the cards over them. It owns the practice and the frame clock, turns
// keys and buttons into commands, and commands into what they do.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  // `folder`: where patients and sessions are kept.
  explicit MainWindow(const std::filesystem::path& folder);
  ~MainWindow() override;

  void open(const std::filesystem::path& patient);
  void run(Command command);

  Practice& practice() { return practice_; }
  PractisePage& practise_page() { return *practise_; }
  FrameClock& clock() { return clock_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void connect_views();
  void connect_cards();
  void draw(double clock);
  void show_state();
  QStringList dangers() const;
  void choose_patient();
  void show_ultrasound(bool on);
  void save_picture();
  void apply_theme(bool dark);
  QWidget* focus_or_self();
  KeyScope page_scope() const;
  bool press(const QKeySequence& keys, bool before_views);

  Practice practice_;
  FrameClock clock_;
  TopBar* bar_;
  QStackedWidget* pages_;
  StartPage* start_;
  PractisePage* practise_;
  PreparingCard* preparing_;
  PauseCard* pause_;
  ResultsCard* results_;
  KeysCard* keys_;
  std::shared_ptr<const OpenCase> shown_;
  std::string shown_failure_;
  bool has_ultrasound_ = false;
  State shown_state_ = State::ended;  // so that the first frame shows the start
};

}  // namespace bodkin::app
