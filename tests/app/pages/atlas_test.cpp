// The atlas of acupuncture: its game without a window, its page painted into memory and driven by its widgets.
#include "app/pages/atlas.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "app/models/atlas_model.h"
#include "views/atlas_view.h"
#include <gtest/gtest.h>

#include "haptics/drivers/drivers.h"

namespace bodkin::app {
namespace {

const patient::Atlas& atlas_of_tests() {
  static const patient::Atlas atlas{patient::BodyParameters{}};
  return atlas;
}

// Shows the page and waits for its body; null if it does not appear.
AtlasView* opened(AtlasPage& page) {
  page.resize(900, 600);
  page.show();
  page.enter();
  auto* const view = page.findChild<AtlasView*>(QStringLiteral("atlas.view"));
  const auto ready = [&] {
    page.advance(0.0);
    return view->is_ready();
  };
  return view != nullptr && QTest::qWaitFor(ready, 120000) ? view : nullptr;
}

TEST(PointQuiz, measures_the_miss_to_the_nearer_of_left_and_right) {
  PointQuiz quiz(3);
  quiz.ask(atlas_of_tests());
  ASSERT_TRUE(quiz.asked());
  const patient::AtlasPoint* point = quiz.point();
  quiz.answer(point->mirrored() + Vec3(0.0, 0.0, 7.0));
  EXPECT_NEAR(quiz.miss(), 7.0, 1e-9);
  EXPECT_EQ(quiz.found(), 1);
  quiz.ask_again();
  EXPECT_EQ(quiz.point(), point);
  quiz.answer(point->place + Vec3(0.0, 0.0, 23.0));
  EXPECT_EQ(quiz.rounds(), 2);
  EXPECT_EQ(quiz.found(), 1);
  EXPECT_NEAR(quiz.mean_miss(), 15.0, 1e-9);
}

TEST(PointQuiz, takes_one_answer_to_a_question_and_asks_another_point_next) {
  PointQuiz quiz(5);
  for (int i = 0; i < 20; ++i) {
    const patient::AtlasPoint* before = quiz.point();
    quiz.ask(atlas_of_tests());
    EXPECT_NE(quiz.point(), before);
    quiz.answer(Vec3::Zero());
    quiz.answer(quiz.point()->place);
    EXPECT_GT(quiz.miss(), 1.0);
  }
  EXPECT_EQ(quiz.rounds(), 20);
}

TEST(AtlasPage, finds_a_point_by_search_shows_its_card_and_plays_the_game) {
  const QTemporaryDir folder;
  AtlasPage page(folder.path().toStdString());
  AtlasView* const view = opened(page);
  ASSERT_NE(view, nullptr);

  auto* search = page.findChild<QLineEdit*>(QStringLiteral("atlas.search"));
  auto* list = page.findChild<QListWidget*>(QStringLiteral("atlas.list"));
  auto* card = page.findChild<QLabel*>(QStringLiteral("atlas.card"));
  EXPECT_EQ(list->count(), 361);
  QTest::keyClicks(search, QStringLiteral("st36"));
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_TRUE(card->text().contains(QStringLiteral("Zusanli")));
  EXPECT_TRUE(card->text().contains(QStringLiteral("22 to 45 mm")));
  EXPECT_FALSE(card->text().contains(QStringLiteral("Luo-connecting")));
  // A luo-connecting point shows the end of its collateral.
  search->clear();
  QTest::keyClicks(search, QStringLiteral("luo"));
  EXPECT_GE(list->count(), 15);
  search->clear();
  QTest::keyClicks(search, QStringLiteral("pc6"));
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_TRUE(card->text().contains(QStringLiteral("Triple Energizer meridian"))) << card->text().toStdString();
  EXPECT_TRUE(card->text().contains(QStringLiteral("TE4")));
  search->clear();
  QTest::keyClicks(search, QStringLiteral("st36"));
  QTest::keyClick(search, Qt::Key_Return);
  // The view has moved to the point: it is near the middle, and a click there selects it.
  const patient::AtlasPoint& point = *atlas_of_tests().find("ST36");
  const auto at = view->place_of(point.place);
  ASSERT_TRUE(at.has_value());
  EXPECT_NEAR(at->x(), 0.5 * view->width(), 3.0);
  EXPECT_NEAR(at->y(), 0.5 * view->height(), 3.0);

  QTest::mouseClick(page.findChild<QPushButton*>(QStringLiteral("atlas.find")), Qt::LeftButton);
  EXPECT_TRUE(view->message().startsWith(QStringLiteral("Where is ")));
  QTest::mouseClick(view, Qt::LeftButton, Qt::NoModifier, QPoint(view->width() / 2, view->height() / 3));
  EXPECT_TRUE(view->message().contains(QStringLiteral("mm off"))) << view->message().toStdString();
  EXPECT_TRUE(page.findChild<QLabel*>(QStringLiteral("atlas.score"))->text().contains(QStringLiteral("of 1 found")));

  // The next point is also to be needled: nothing is revealed, and its case is requested.
  QTest::mouseClick(page.findChild<QPushButton*>(QStringLiteral("atlas.both")), Qt::LeftButton);
  std::string asked;
  std::optional<QPointF> there;
  Vec3 wanted = Vec3::Zero();
  for (int question = 0; question < 30 && !there; ++question) {  // another one where an arm hides it
    QTest::mouseClick(page.findChild<QPushButton*>(QStringLiteral("atlas.find")), Qt::LeftButton);
    asked = view->message().section(QStringLiteral("Where is "), 1).section(QLatin1Char(','), 0, 0).toStdString();
    wanted = atlas_of_tests().find(asked)->place;
    view->look_at(wanted, atlas_of_tests().find(asked)->normal);
    there = view->place_of(wanted);
  }
  ASSERT_TRUE(there.has_value()) << asked;
  QString made;
  Vec3 at_place = Vec3::Zero();
  QObject::connect(&page, &AtlasPage::needling_requested, &page, [&](const QString& where, const Vec3& place) {
    made = where;
    at_place = place;
  });
  QTest::mouseClick(view, Qt::LeftButton, Qt::NoModifier, there->toPoint());
  EXPECT_FALSE(view->message().contains(QStringLiteral("mm off")));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        page.advance(0.0);
        return !made.isEmpty();
      },
      120000));
  EXPECT_TRUE(made.endsWith(QString::fromStdString(asked)));
  EXPECT_LT((at_place - wanted).norm(), 12.0);
}

// A device's needle acts as the pointer: the point that it touches is highlighted, named and its card shown.
TEST(AtlasPage, the_needle_of_a_device_touches_points) {
  const QTemporaryDir folder;
  AtlasPage page(folder.path().toStdString());
  AtlasView* const view = opened(page);
  ASSERT_NE(view, nullptr);
  auto* touch = page.findChild<QPushButton*>(QStringLiteral("atlas.touch"));
  auto* card = page.findChild<QLabel*>(QStringLiteral("atlas.card"));
  QTest::mouseClick(touch, Qt::LeftButton);
  EXPECT_FALSE(touch->isChecked()) << "there is only the mouse";
  EXPECT_TRUE(view->message().contains(QStringLiteral("Choose a device")));

  // With the hand in the middle of the workspace the tip is where the view looks; up is up, right is the viewer's.
  const patient::AtlasPoint& point = *atlas_of_tests().find("ST36");
  view->look_at(point.place, point.normal);
  Pose hand = Pose::Identity();
  view->show_needle(hand, 120.0);
  EXPECT_LT((*view->tip() - point.place).norm(), 1e-6);
  EXPECT_TRUE(card->text().contains(QStringLiteral("Zusanli")));
  EXPECT_TRUE(card->text().contains(QStringLiteral("Stomach meridian"))) << card->text().toStdString();
  hand.translation() = Vec3(0.0, 0.0, 30.0);  // a quarter of the workspace
  view->show_needle(hand, 120.0);
  EXPECT_NEAR((*view->tip() - point.place).z(), 105.0, 8.0) << "a quarter of the 420 mm that are seen";
  EXPECT_GT((*view->tip() - point.place).norm(), 100.0);

  // The device itself, read on a thread of its own until the page is left.
  page.set_device(station::DeviceChoice{haptics::find_driver("simulated"), "", ""});
  QTest::mouseClick(touch, Qt::LeftButton);
  view->show_needle(std::nullopt, 120.0);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        page.advance(0.0);
        return view->tip().has_value();
      },
      60000))
      << view->message().toStdString();
  page.leave();
  EXPECT_FALSE(touch->isChecked());
  EXPECT_FALSE(view->tip().has_value());
  // A device that does not open: only its sentence.
  page.set_device(station::DeviceChoice{haptics::find_driver("force_dimension"), "", "library=/nowhere/libdrd.so"});
  QTest::mouseClick(touch, Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        page.advance(0.0);
        return !touch->isChecked();
      },
      60000));
  EXPECT_TRUE(view->message().contains(QStringLiteral("/nowhere/libdrd.so"))) << view->message().toStdString();
}

}  // namespace
}  // namespace bodkin::app
