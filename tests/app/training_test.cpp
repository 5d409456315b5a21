// A trainee follows a plan in the window: views of stages, counting attempts, stored results, continuation.
#include "app/pages/training.h"

#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <filesystem>

#include "app/models/allowed_frame.h"
#include "app/models/step_follower.h"
#include "app/pages/practise.h"
#include "station/scan_thread.h"
#include "tests/app/window_fixture.h"

#include "io/probe_library_file.h"
#include "io/tissue_library_file.h"
#include "training/procedure_file.h"
#include "training/store/store_place.h"

namespace bodkin::app {
namespace {

Frame frame_in(anatomy::TissueId tissue, double depth) {
  Frame frame;
  frame.has_needle = true;
  frame.depth = depth;
  frame.tissue = tissue;
  frame.place = "ligamentum flavum";
  frame.plan = anatomy::NeedlePath{Vec3::Zero(), Vec3(0, -50, 0)};
  frame.target_reached = true;
  return frame;
}

TEST(AllowedFrame, hides_what_a_stage_does_not_show_and_nothing_else) {
  const Frame frame = frame_in(anatomy::tissue::ligamentum_flavum, 40.0);
  const Frame blind = allowed_frame(frame, {.overlay = false, .ladder = false, .needle = false});
  EXPECT_FALSE(blind.plan.has_value());
  EXPECT_FALSE(blind.target_reached);
  EXPECT_TRUE(blind.place.empty());
  EXPECT_NE(blind.tissue, anatomy::tissue::ligamentum_flavum);
  EXPECT_EQ(allowed_frame(frame_in(anatomy::tissue::fat, 9.0), {.ladder = false}).tissue, blind.tissue)
      << "the colour of the tip must not tell tissues apart";
  EXPECT_FALSE(blind.has_needle);
  EXPECT_EQ(blind.depth, 40.0);
  const Frame all = allowed_frame(frame, {});
  EXPECT_TRUE(all.plan.has_value());
  EXPECT_EQ(all.tissue, anatomy::tissue::ligamentum_flavum);
  EXPECT_TRUE(all.has_needle);
}

// A patient with only landmarks and a path.
anatomy::Case patient_of(const anatomy::NeedlePath& path) {
  anatomy::Case patient;
  patient.library = io::default_tissue_library();
  patient.description.procedure.path = path;
  return patient;
}

TEST(StepFollower, names_the_step_after_the_farthest_that_was_reached) {
  StepFollower steps(training::find_procedure("lumbar_puncture"), patient_of({}));
  const auto now = [&] { return steps.next() == nullptr ? std::string("done") : steps.next()->title; };
  const auto happens = [&](forces::EventKind kind) {
    Frame frame;
    const std::vector<session::SessionEvent> events = {{0, {kind, anatomy::tissue::skin, 1.0, 0.0}}};
    frame.events = events;
    steps.follow(frame, nullptr);
  };
  EXPECT_EQ(now(), "Find the interspace");
  happens(forces::EventKind::contact);
  EXPECT_EQ(now(), "Cross the interspinous ligament");
  happens(forces::EventKind::withdrawn);  // not the end of the procedure
  EXPECT_EQ(now(), "Cross the interspinous ligament");
  steps.follow(frame_in(anatomy::tissue::ligamentum_flavum, 40.0), nullptr);  // beside the interspinous ligament
  EXPECT_EQ(now(), "Lose the resistance");
  steps.follow(frame_in(anatomy::tissue::cerebrospinal_fluid, 50.0), nullptr);
  EXPECT_EQ(now(), "Let fluid return");
  happens(forces::EventKind::withdrawn);
  EXPECT_EQ(now(), "done");
  steps.begin();
  EXPECT_EQ(now(), "Find the interspace");
}

// Along -y, 50 mm deep; a probe on the skin at the origin looks the same way.
TEST(StepFollower, a_step_of_the_ultrasound_is_over_when_the_picture_shows_it_and_no_sooner) {
  const anatomy::NeedlePath path{Vec3::Zero(), Vec3(0, -50, 0)};
  const training::Procedure procedure = training::find_procedure("ultrasound_guided_injection");
  ASSERT_EQ(procedure.steps.at(0).shown, "target");
  const anatomy::UltrasoundProbe probe = io::find_probe("L12-3");
  station::LiveImage picture;
  picture.setup.settings.depth = 60.0;
  picture.setup.probe.linear().col(0) = Vec3::UnitX();
  picture.setup.probe.linear().col(1) = -Vec3::UnitY();  // into the patient
  picture.setup.probe.linear().col(2) = -Vec3::UnitZ();
  const auto sees = [&](StepFollower& steps, const Vec3& face) {
    picture.setup.probe.translation() = face;
    Frame frame;
    frame.ultrasound = &picture;
    steps.follow(frame, &probe);
  };
  const auto touches_skin = [](StepFollower& steps) {
    Frame frame;
    const std::vector<session::SessionEvent> events = {
        {0, {forces::EventKind::contact, anatomy::tissue::skin, 1.0, 0.0}}};
    frame.events = events;
    steps.follow(frame, nullptr);
  };
  const auto title = [](const StepFollower& steps) { return steps.next()->title; };

  StepFollower steps(procedure, patient_of(path));
  EXPECT_EQ(title(steps), "Show the target");
  sees(steps, Vec3(0, 0, 6));
  EXPECT_EQ(title(steps), "Show the target") << "6 mm beside the slice";
  picture.frame.why = imaging::NoImage::no_contact;
  sees(steps, Vec3(0, 0, 1));
  EXPECT_EQ(title(steps), "Show the target") << "the picture is black";
  picture.frame.why = imaging::NoImage::none;
  touches_skin(steps);
  EXPECT_EQ(title(steps), "Show the target") << "the needle is ahead of the probe";
  sees(steps, Vec3(0, 0, 1));
  EXPECT_EQ(title(steps), "Advance in the slice") << "both are done";

  steps.begin();
  sees(steps, Vec3(0, 0, 1));
  EXPECT_EQ(title(steps), "Touch the skin");
  sees(steps, Vec3(0, 0, 30));
  EXPECT_EQ(title(steps), "Touch the skin") << "once is enough";

  steps.begin();
  touches_skin(steps);
  EXPECT_EQ(title(steps), "Advance in the slice") << "without a probe nothing can be shown";
}

class TrainingWindow : public WindowFixture {
 protected:
  void SetUp() override {
    std::filesystem::remove(training::store_place());
    QSettings().setValue(QStringLiteral("training/is_begun"), false);
    QFile file(plan_file());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(
        "<plan version=\"1\" name=\"two_stages\" title=\"Two stages\">"
        "<stage title=\"Everything\" case=\"built-in\" procedure=\"lumbar_puncture\" attempts=\"1\"/>"
        "<stage title=\"By feel\" case=\"built-in\" procedure=\"lumbar_puncture\" attempts=\"1\" overlay=\"false\" "
        "slices=\"false\" inside=\"false\" ladder=\"false\" sound=\"false\" hints=\"false\"/></plan>");
    file.close();
    open_window();
  }
  QString plan_file() const { return folder_.filePath(QStringLiteral("two.xml")); }
  bool wait(const std::function<bool()>& until, int seconds) { return QTest::qWaitFor(until, 1000 * seconds); }
  bool wait(State state, int seconds) {
    return wait([&] { return practice().state() == state; }, seconds);
  }
  Practice& practice() { return window_->practice(); }
  QString text(const char* name) { return find<QLabel>(name)->text(); }
  // Waits until the tip has this depth.
  bool push_to(double depth) {
    return wait(
        [&] {
          if (practice().frame().depth < depth) practice().push(1.0, false);
          return practice().frame().depth >= depth;
        },
        60);
  }
  bool end_attempt() {
    QTest::keyClick(window_.get(), Qt::Key_E);
    return wait([&] { return practice().state() == State::ended && practice().result().has_value(); }, 60);
  }
  // Through the page, as a trainee does.
  void begin_plan() {
    click("start.training");
    auto* const page = find<TrainingPage>("training");
    find<QLineEdit>("training.trainee")->setText(QStringLiteral("trainee-07"));
    page->choose(plan_file());
    ASSERT_TRUE(wait([&] { return page->is_ready(); }, 60));
    EXPECT_EQ(text("training.title"), QStringLiteral("Two stages"));
    click("training.follow");
    ASSERT_TRUE(wait(State::ready, 180)) << practice().failure();
  }
  void aim_at_plan() {
    const OpenCase& patient = *practice().patient();
    const anatomy::NeedlePath path = *patient.description().procedure.path;
    const std::optional<SkinPoint> skin =
        skin_on_ray(patient.patient.tissues, path.entry - 30.0 * path.direction(), path.direction(), 60.0);
    ASSERT_TRUE(skin.has_value());
    practice().aim(*skin);
    practice().put_down();
  }

  QTemporaryDir folder_;
};

TEST_F(TrainingWindow, leads_through_its_stages_keeps_the_results_and_goes_on_after_the_window_was_closed) {
  begin_plan();
  auto* const page = find<PractisePage>("practise");
  EXPECT_TRUE(wait([&] { return text("practise.plan").startsWith(QStringLiteral("Stage 1 of 2: Everything")); }, 60));
  EXPECT_TRUE(text("practise.step").startsWith(QStringLiteral("Find the interspace")));
  EXPECT_TRUE(find("practise.slice.sagittal")->isVisible());
  window_->show_page(PageId::plan);
  EXPECT_FALSE(find("plan")->isVisible()) << "it shows where to go in";
  // Without skin contact it is not an attempt.
  ASSERT_TRUE(end_attempt());
  EXPECT_TRUE(window_->training_run()->standing().attempts.empty());
  click("results.again");
  ASSERT_TRUE(wait(State::ready, 60)) << practice().failure();
  ASSERT_TRUE(push_to(4.0));
  ASSERT_TRUE(end_attempt());
  EXPECT_TRUE(wait([&] { return text("results.plan").startsWith(QStringLiteral("Stage 2 of 2: By feel")); }, 60));
  click("results.again");  // "Next stage"
  ASSERT_TRUE(wait(State::ready, 60)) << practice().failure();

  // By feel: nothing that reveals the path.
  EXPECT_FALSE(find("practise.slice.sagittal")->isVisible());
  EXPECT_FALSE(page->findChild<DepthLadder*>()->isVisible());
  EXPECT_FALSE(page->findChild<TipLabel*>()->isVisible());
  EXPECT_EQ(page->view3d().preset(), scene::Preset::skin);
  page->view3d().set_preset(scene::Preset::bones);
  EXPECT_EQ(page->view3d().preset(), scene::Preset::skin);
  window_->run(Command::show_dock);
  window_->run(Command::show_ladder);
  EXPECT_FALSE(find("practise.dock")->isVisible());
  EXPECT_FALSE(page->findChild<DepthLadder*>()->isVisible());
  window_->run(Command::toggle_ultrasound);
  EXPECT_FALSE(find("practise.ultrasound")->isVisible());
  EXPECT_TRUE(text("practise.step").isEmpty());
  practice().push(3.0, false);  // the needle does not know the planned entry
  QTest::qWait(100);
  EXPECT_EQ(practice().state(), State::ready);

  // Closed and reopened: the store has the progress.
  window_.reset();
  open_window();
  ASSERT_TRUE(find("start.plan.continue")->isVisible());
  EXPECT_TRUE(text("start.plan").contains(QStringLiteral("Two stages")));
  click("start.plan.continue");
  ASSERT_TRUE(wait(State::ready, 180)) << practice().failure();
  EXPECT_EQ(window_->training_run()->stage_number(), 2);
  EXPECT_FALSE(find("practise.slice.sagittal")->isVisible());
  aim_at_plan();
  ASSERT_TRUE(push_to(4.0));
  ASSERT_TRUE(end_attempt());
  EXPECT_TRUE(wait([&] { return text("results.plan") == QStringLiteral("The plan is finished"); }, 60));
  click("results.again");
  auto* const training = find<TrainingPage>("training");
  ASSERT_TRUE(wait([&] { return training->isVisible() && training->is_ready(); }, 60));
  EXPECT_EQ(find<LearningCurve>("training.curve") == nullptr, false);
  EXPECT_EQ(static_cast<LearningCurve*>(find("training.curve"))->attempts(), 2U);
  training::ResultStore store(training::store_place());
  const std::vector<training::AttemptRecord> kept = store.attempts("trainee-07");
  ASSERT_EQ(kept.size(), 2U);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(kept[static_cast<std::size_t>(i)].plan, "two_stages");
    EXPECT_EQ(kept[static_cast<std::size_t>(i)].stage, i + 1);
    EXPECT_TRUE(std::filesystem::exists(kept[static_cast<std::size_t>(i)].file));
  }
  // All views are permitted again.
  window_->run(Command::back);
  window_->run(Command::begin);
  ASSERT_TRUE(wait(State::ready, 60)) << practice().failure();
  EXPECT_TRUE(find("practise.slice.sagittal")->isVisible());
}

// The probe lies over the planned way of the needle: its picture shows the target.
TEST_F(TrainingWindow, goes_on_from_the_step_that_the_ultrasound_shows) {
  QFile file(plan_file());
  ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
  file.write(
      "<plan version=\"1\" name=\"two_stages\" title=\"Two stages\">"
      "<stage title=\"Probe\" case=\"built-in\" procedure=\"ultrasound_guided_injection\" attempts=\"1\" "
      "ultrasound=\"true\"/></plan>");
  file.close();
  begin_plan();
  EXPECT_TRUE(wait([&] { return text("practise.step").startsWith(QStringLiteral("Touch the skin")); }, 60))
      << text("practise.step").toStdString();
}

TEST_F(TrainingWindow, counts_an_attempt_that_was_given_up_or_cut_off_by_closing_the_window) {
  begin_plan();
  ASSERT_TRUE(push_to(4.0));
  window_->close();
  window_.reset();
  training::ResultStore store(training::store_place());
  EXPECT_EQ(store.attempts("trainee-07").size(), 1U);
}

TEST_F(TrainingWindow, says_in_one_sentence_why_a_plan_cannot_be_followed) {
  click("start.training");
  auto* const page = find<TrainingPage>("training");
  find<QLineEdit>("training.trainee")->setText(QStringLiteral("trainee-07"));
  page->choose(QStringLiteral("/no/such/plan.xml"));
  ASSERT_TRUE(wait([&] { return page->is_ready(); }, 60));
  EXPECT_TRUE(text("training.line").contains(QStringLiteral("/no/such/plan.xml")));
  EXPECT_FALSE(find("training.follow")->isEnabled());
}

}  // namespace
}  // namespace bodkin::app
