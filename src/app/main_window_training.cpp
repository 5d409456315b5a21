// A trainee follows a plan in the window: stages, permitted views, results into the store.
#include <QSettings>
#include <algorithm>
#include <array>
#include <chrono>
#include <exception>

#include "app/hand/aim.h"
#include "app/main_window.h"
#include "app/pages/cards.h"
#include "app/pages/practise.h"
#include "app/pages/start.h"
#include "views/language.h"
#include "views/top_bar.h"

#include "training/procedure_file.h"

namespace bodkin::app {

using namespace views;

namespace {

// Pages that show or change the subject of a stage.
constexpr std::array closed_pages = {PageId::plan,   PageId::scan,       PageId::volume, PageId::segment,
                                     PageId::models, PageId::ultrasound, PageId::camera};

constexpr double found_reach = 30.0;  // mm about a found place, searched for its skin

bool is_closed(PageId id) {
  return std::find(closed_pages.begin(), closed_pages.end(), id) != closed_pages.end();
}

}  // namespace

void MainWindow::follow_plan(const QString& plan, const QString& trainee) {
  if (standing_.valid()) return;
  QSettings settings;
  settings.setValue(QStringLiteral("training/plan"), plan);
  settings.setValue(QStringLiteral("training/trainee"), trainee);
  standing_ = std::async(std::launch::async, read_standing, plan.toStdString(), trainee.toStdString());
}

// The plan in progress, also for the next start of the window.
void MainWindow::offer_plan() {
  const QSettings settings;
  const QString title = settings.value(QStringLiteral("training/title")).toString();
  const bool is_begun = settings.value(QStringLiteral("training/is_begun"), false).toBool() && !title.isEmpty();
  start_->offer_plan(is_begun ? tr("%1, %2").arg(title, settings.value(QStringLiteral("training/trainee")).toString())
                              : QString());
}

void MainWindow::begin_stage() {
  QSettings settings;
  const std::optional<training::PlanStage> stage = run_->stage();
  settings.setValue(QStringLiteral("training/title"), in_words(run_->standing().use.plan.title));
  settings.setValue(QStringLiteral("training/is_begun"), stage.has_value());
  leave_page();
  const bool is_same = stage_ && stage && stage_->patient == stage->patient && practice_.patient() != nullptr;
  if (!stage) {
    if (practice_.state() != State::no_case) practice_.leave();
    leave_stage();
    run_->finish();  // the page looks it up in the store
    return show_page(PageId::training);
  }
  const bool had_ultrasound = has_ultrasound_;
  stage_ = stage;
  stage_number_ = run_->stage_number();
  plan_words_ = in_words(standing_words(run_->standing()));
  practice_.set_stage(stage_);
  has_ultrasound_ = stage_->aids.ultrasound;
  sounds_.allow(stage_->aids.sound);
  for (const Stage page : {Stage::scan, Stage::plan}) bar_->allow(page, false);
  practise_->set_aids(stage_->aids);
  if (is_same) {
    if (had_ultrasound != has_ultrasound_) show_ultrasound(has_ultrasound_);
    if (practice_.state() == State::ended || is_attempt(practice_.state())) practice_.again();
    steps_ = StepFollower(stage_->procedure.empty()
                              ? training::procedure_of_case(practice_.patient()->description().procedure.name)
                              : training::find_procedure(stage_->procedure),
                          practice_.patient()->patient);
    return;
  }
  if (practice_.state() != State::no_case) practice_.leave();
  // From the first attempt on; a patient of a plan has a planned path.
  asked_ultrasound_.reset();
  practice_.set_ultrasound(has_ultrasound_ ? std::optional(usual_ultrasound(true)) : std::nullopt);
  if (!has_ultrasound_) practise_->show_ultrasound({});
  bar_->set_ultrasound(has_ultrasound_);
  if (stage_->patient == training::built_in_patient) {
    practice_.choose_built_in();
  } else {
    practice_.choose(stage_->patient);
  }
}

// All views are permitted again.
void MainWindow::leave_stage() {
  if (!stage_) return;
  practice_.finish();  // its result belongs to the plan
  stage_.reset();
  practice_.set_stage({});
  practice_.set_ultrasound({});
  has_ultrasound_ = false;
  practise_->show_ultrasound({});
  bar_->set_ultrasound(false);
  practise_->set_aids({.ultrasound = true});
  practise_->show_plan({}, {});
  results_->show_plan({}, {});
  sounds_.allow(true);
  for (const Stage page : {Stage::scan, Stage::plan}) bar_->allow(page, true);
}

bool MainWindow::may_show(PageId id) {
  if (!stage_) return true;
  const bool is_closed_now = is_closed(id) || (id == PageId::review && is_attempt(practice_.state()));
  if (is_closed_now) practice_.show_message(tr("The plan that you follow does not allow this now.").toStdString());
  return !is_closed_now;
}

// A saved attempt. One without contact between needle and patient does not count.
void MainWindow::take_attempt(const AttemptResult& result) {
  if (!stage_ || run_ == nullptr || !result.record || result.time_in_body <= 0.0) return;
  run_->keep(*result.record);
  plan_words_ = in_words(standing_words(run_->standing()));
}

void MainWindow::another_attempt() {
  if (stage_ && practice_.state() == State::ended) {
    if (!practice_.result() && practice_.failure().empty()) return;  // it is being scored
    if (run_->stage_number() != stage_number_) return begin_stage();
  }
  practice_.again();
}

void MainWindow::advance_plan(const Frame& frame) {
  if (standing_.valid() && standing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    PlanStanding standing = standing_.get();
    if (!standing.trouble.empty()) {
      start_->show_message(in_words(standing.trouble), true);
      practice_.show_message(standing.trouble);
    } else {
      leave_stage();
      run_ = std::make_unique<TrainingRun>(std::move(standing));
      begin_stage();
    }
  }
  if (run_ == nullptr) return;
  if (const std::string note = run_->take_note(); !note.empty()) practice_.show_message(note);
  if (!stage_) return;
  if (practice_.state() == State::no_case) return leave_stage();
  // The previous attempt, the last of its stage, was abandoned by beginning another.
  const State state = practice_.state();
  const bool is_fresh = state == State::ready || state == State::aiming;
  if (is_fresh && run_->stage_number() != stage_number_) return begin_stage();
  QString step;
  if (stage_->aids.hints) {
    if (practice_.changes().attempt) steps_.begin();
    steps_.follow(frame, practice_.ultrasound() ? &practice_.ultrasound()->probe : nullptr);
    if (const training::Step* const next = steps_.next())
      step = in_words(next->title) + QStringLiteral(". ") + in_words(next->text);
  }
  practise_->show_plan(plan_words_, step);
  if (state == State::ended) {
    const int now = run_->stage_number();
    const bool is_over = now > static_cast<int>(run_->standing().use.plan.stages.size());
    results_->show_plan(practice_.result() ? plan_words_ : QString(), now == stage_number_ ? QString()
                                                                      : is_over            ? tr("The plan   A")
                                                                                           : tr("Next stage   A"));
  }
}

void MainWindow::needle_found_point(const std::filesystem::path& patient, const Vec3& place) {
  leave_stage();
  if (practice_.state() != State::no_case) practice_.leave();
  leave_page();
  training::PlanStage stage;
  stage.aids.overlay = false;
  practice_.set_stage(stage);
  practise_->set_aids(stage.aids);
  seeking_aids_ = stage.aids;
  found_place_ = place;
  open(patient);
}

// Moves the needle to the found point, once; all views are permitted again when the patient is left.
void MainWindow::follow_found_point() {
  if (!seeking_aids_) return;
  const State state = practice_.state();
  if (state == State::no_case || stage_) {
    seeking_aids_.reset();
    found_place_.reset();
    if (!stage_) {
      practice_.set_stage({});
      practise_->set_aids({.ultrasound = true});
    }
    return;
  }
  if (!found_place_ || state != State::ready || practice_.patient() == nullptr) return;
  const anatomy::TissueVolume& tissues = practice_.patient()->patient.tissues;
  const anatomy::NeedlePath& path = *practice_.patient()->description().procedure.path;
  // The skin under the place: the body of the atlas is drawn coarser than that of the case.
  const Vec3 inwards = path.direction();
  if (const auto skin = skin_on_ray(tissues, *found_place_ - found_reach * inwards, inwards, 2.0 * found_reach)) {
    practice_.aim(*skin);
    practice_.put_down();
    practice_.show_message(
        tr("The needle is where you found the point. Push; the true point is shown when you end.").toStdString());
  }
  found_place_.reset();
}

}  // namespace bodkin::app
