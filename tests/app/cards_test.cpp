// The cards over the pages: their facts about this Bodkin, and the compact layout of results.
#include "app/pages/cards.h"

#include <QLabel>
#include <QPushButton>

#include "app/models/allowed_frame.h"
#include "patient/acupuncture/body_case.h"
#include "tests/app/window_fixture.h"

namespace bodkin::app {
namespace {

class CardsWindow : public WindowFixture {};

TEST_F(CardsWindow, about_names_bodkin_and_its_libraries_with_their_versions) {
  click("start.about");
  auto* const about = find<AboutCard>("about");
  ASSERT_TRUE(about->isVisible());
  const QString words = find<QLabel>("about.versions")->text();
  for (const char* name : {"Bodkin", "Qt", "VTK", "ITK", "Eigen"}) {
    EXPECT_TRUE(words.contains(QLatin1String(name))) << name;
  }
  EXPECT_TRUE(words.contains(QStringLiteral(BODKIN_VERSION)));
  EXPECT_TRUE(words.contains(QString::fromLatin1(qVersion())));
  for (const auto& [name, version] : AboutCard::versions()) EXPECT_FALSE(version.isEmpty()) << name.toStdString();
  window_->run(Command::back);
  EXPECT_FALSE(about->isVisible());
  click("start.about");
  EXPECT_TRUE(about->isVisible());
  click("about.close");
  EXPECT_FALSE(about->isVisible());
}

TEST(Cards, results_have_no_empty_line_under_the_grade) {
  QWidget page;
  page.resize(1000, 700);
  ResultsCard card(&page);
  card.setGeometry(page.rect());
  page.show();
  card.show();
  AttemptResult result;
  result.verdict = training::Grade::dangerous;
  result.headline = "Dangerous: the tip entered a nerve root";
  result.remarks = {"You entered at L3/L4."};
  // Frame by frame, as in the window, first during the saving of the session.
  card.show_result(nullptr, {QStringLiteral("A nerve, met at 50 mm after 10 s")}, {});
  QTest::qWait(30);
  for (int frame = 0; frame < 5; ++frame) {
    card.show_result(&result, {QStringLiteral("A nerve, met at 50 mm after 10 s")}, {});
    QTest::qWait(10);
  }
  const auto* const grade = card.findChild<QLabel*>(QStringLiteral("results.grade"));
  const auto* const headline = card.findChild<QLabel*>(QStringLiteral("results.headline"));
  EXPECT_FALSE(card.findChild<QLabel*>(QStringLiteral("results.dangers"))->isVisible());
  EXPECT_LE(headline->geometry().top() - grade->geometry().bottom(), 14);
}

TEST(Cards, what_is_prepared_tells_how_long_its_step_still_takes) {
  QWidget page;
  PreparingCard card(&page);
  const auto* const time = card.findChild<QLabel*>(QStringLiteral("preparing.time"));
  card.show_progress(QStringLiteral("first"), 0.0, 2.0);
  EXPECT_EQ(time->text(), QStringLiteral("2 s so far"));
  card.show_progress(QStringLiteral("first"), 0.05, 3.0);
  EXPECT_EQ(time->text(), QStringLiteral("3 s so far")) << "too early to say";
  card.show_progress(QStringLiteral("first"), 0.25, 5.0);
  EXPECT_EQ(time->text(), QStringLiteral("5 s so far, about 9 s more for this step"));
  card.show_progress(QStringLiteral("first"), 0.97, 13.0);
  EXPECT_EQ(time->text(), QStringLiteral("13 s so far")) << "as good as done";
  card.show_progress(QStringLiteral("second"), 0.5, 14.0);
  EXPECT_EQ(time->text(), QStringLiteral("14 s so far")) << "another step, which has its own pace";
  card.show_progress(QStringLiteral("second"), 0.6, 17.0);
  EXPECT_EQ(time->text(), QStringLiteral("17 s so far, about 2 s more for this step"));
}

TEST(AllowedFrame, shows_where_it_should_have_gone_when_the_attempt_is_over) {
  Frame frame;
  frame.plan = anatomy::NeedlePath{Vec3::Zero(), Vec3(0.0, -40.0, 0.0)};
  training::PlanAids aids;
  aids.overlay = false;
  for (const State state : {State::ready, State::aiming, State::in_tissue, State::paused}) {
    frame.state = state;
    EXPECT_FALSE(allowed_frame(frame, aids).plan.has_value());
  }
  frame.state = State::ended;
  EXPECT_TRUE(allowed_frame(frame, aids).plan.has_value());
}

class FoundPoint : public WindowFixture {};

TEST_F(FoundPoint, is_needled_where_it_was_found_and_the_true_one_is_shown_at_the_end) {
  // A coarse block about a point of the leg.
  const patient::Atlas atlas(patient::BodyParameters{});
  const patient::AtlasPoint& point = *atlas.find("ST36");
  patient::BodyCase wanted;
  wanted.folder = data_folder() / "found" / "ST36";
  wanted.overwrite = true;
  wanted.point = "ST36";
  wanted.width = 120.0;
  wanted.spacing = 2.0;
  std::filesystem::create_directories(wanted.folder.parent_path());
  patient::write_body_case(atlas, wanted);
  const Vec3 found = point.place + Vec3(0.0, 0.0, 9.0);
  window_->needle_found_point(wanted.folder, found);
  Practice& practice = window_->practice();
  const auto is_down = [&] { return practice.state() == State::aiming || practice.state() == State::touching; };
  ASSERT_TRUE(wait([&] { return is_down() || !practice.failure().empty(); }, 120)) << practice.failure();
  // On the skin where it was found, not at the planned entry.
  ASSERT_TRUE(wait([&] { return (practice.frame().needle.translation() - found).norm() < 6.0; }, 60))
      << practice.frame().needle.translation().transpose() << ", found " << found.transpose();
  practice.push(20.0, false);
  ASSERT_TRUE(wait([&] { return practice.frame().depth > 4.0; }, 60)) << practice.frame().depth;
  practice.end();
  ASSERT_TRUE(wait([&] { return practice.state() == State::ended && practice.result().has_value(); }, 60));
  auto* const results = find<ResultsCard>("results");
  ASSERT_TRUE(wait([&] { return results->isVisible(); }, 60));
  click("results.look");
  EXPECT_FALSE(results->isVisible());
  window_->run(Command::back);
  EXPECT_TRUE(results->isVisible());
  practice.leave();
  QTest::qWait(50);
}

}  // namespace
}  // namespace bodkin::app
