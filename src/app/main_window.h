#pragma once

#include <QMainWindow>
#include <filesystem>
#include <future>
#include <memory>
#include <vector>

#include "app/frame_clock.h"
#include "app/key_table.h"
#include "app/models/step_follower.h"
#include "app/models/training_run.h"
#include "app/page.h"
#include "app/practice.h"
#include "app/sounds.h"
#include "station/ultrasound_request.h"

class QStackedWidget;

namespace bodkin::views {
class TopBar;
}

namespace bodkin::app {

using namespace views;

class AboutCard;
class AtlasPage;
class DevicesPage;
class KeysCard;
class PauseCard;
class Palette;
class PractisePage;
class PreparingCard;
class ResultsCard;
class ReviewPage;
class StartPage;
class Tour;
class UltrasoundPage;

// Return value of QApplication::exec() after the choice of another language: recreate the window in it.
inline constexpr int retranslate = 75;

// The window: the bar, the pages below it, and the cards over them. It owns the practice and the frame clock,
// converts keys and buttons to commands, and executes commands.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  // `folder`: of patients and sessions.
  explicit MainWindow(const std::filesystem::path& folder);
  ~MainWindow() override;

  void open(const std::filesystem::path& patient);
  // A procedure that comes with Bodkin, on its own patient.
  void practise_procedure(const QString& name);
  // Follows the session of a remote station, "HOST" or "HOST:PORT", on its patient; an empty path: the copy of its
  // case in the current folder or among the patients of this window. Throws InputError if there is none.
  void follow(const std::string& server, const std::filesystem::path& patient);
  // As requested by `bodkin perform` and `bodkin ultrasound --live`.
  void perform(const std::filesystem::path& patient, const AttemptOptions& options);
  void scan(const std::filesystem::path& patient, const station::UltrasoundRequest& request,
            const std::filesystem::path& output);
  // Inserts the needle at a point found on the body; the path to the true point is hidden until the attempt is over.
  void needle_found_point(const std::filesystem::path& patient, const Vec3& place);
  void run(Command command);
  // Start and practise replace each other; other pages lie over them, and an attempt pauses meanwhile.
  void show_page(PageId id);
  // A trainee follows a plan, a file or one that comes with Bodkin, from the trainee's present stage.
  void follow_plan(const QString& plan, const QString& trainee);
  // Null: no plan is followed now.
  const TrainingRun* training_run() const { return run_.get(); }
  // A session file on the review page.
  void review(const std::filesystem::path& session);

  Practice& practice() { return practice_; }
  PractisePage& practise_page() { return *practise_; }
  FrameClock& clock() { return clock_; }
  const Sounds& sounds() const { return sounds_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void connect_views();
  void connect_other_hand();
  void connect_cards();
  void add_pages();
  void add_page(Page* page, const QString& entry, const QString& tip);
  void leave_page();
  void draw(double clock);
  void show_state();
  void offer_recovered();
  void offer_plan();
  void begin_stage();
  void leave_stage();
  void advance_plan(const Frame& frame);
  void take_attempt(const AttemptResult& result);
  void another_attempt();
  void show_about();
  void follow_found_point();
  // False if a stage of a plan does not allow the page; the reason is shown.
  bool may_show(PageId id);
  void use_device(const QString& driver, const QString& identity);
  QStringList dangers() const;
  void choose_patient();
  void show_palette();
  void begin_tour();
  void show_ultrasound(bool on);
  void show_volume();
  std::vector<KeyScope> scopes_of_keys() const;  // of what is shown now
  static station::UltrasoundChoice usual_ultrasound(bool has_path);
  void show_moving(bool on);
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
  AboutCard* about_;
  ReviewPage* review_ = nullptr;
  DevicesPage* devices_ = nullptr;
  AtlasPage* atlas_ = nullptr;
  Palette* palette_;
  Tour* tour_;
  Sounds sounds_;
  UltrasoundPage* ultrasound_;
  std::vector<Page*> more_pages_;  // in addition to start and practise
  Page* page_ = nullptr;           // the shown one of these
  Page* wanted_page_ = nullptr;    // to be shown once there is a patient
  bool has_paused_ = false;        // an attempt, because of the page
  std::shared_ptr<const OpenCase> shown_;
  std::string shown_failure_;
  bool has_ultrasound_ = false;
  bool theme_changed_ = true;                 // since the last frame
  std::future<PlanStanding> standing_;        // of the plan that is to be followed
  std::unique_ptr<TrainingRun> run_;          // the plan that is followed
  std::optional<training::PlanStage> stage_;  // of the attempts now; nothing: they belong to no plan
  int stage_number_ = 0;
  std::optional<training::PlanAids> seeking_aids_;  // for a point found by the trainee
  std::optional<Vec3> found_place_;                 // of that point, until the needle is there
  StepFollower steps_;
  QString plan_words_;                                         // progress in the plan, on strip and card
  std::optional<station::UltrasoundChoice> asked_ultrasound_;  // instead of the usual one
  State shown_state_ = State::ended;                           // so that the first frame shows the start
};

}  // namespace bodkin::app
