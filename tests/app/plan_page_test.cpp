// The plan made by mouse in the real window: clicks, a drag, undo, contents of the case's file afterwards.
#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <algorithm>
#include <functional>

#include "app/main_window.h"
#include "app/models/data_folder.h"
#include "app/pages/plan.h"
#include <gtest/gtest.h>

#include "io/case_folder.h"

namespace bodkin::app {
namespace {

class PlanPageTest : public testing::Test {
 protected:
  void SetUp() override {
    window_ = std::make_unique<MainWindow>(data_folder());
    window_->resize(1280, 720);
    window_->show();
    window_->show_page(PageId::plan);  // opens the built-in patient first
    page_ = window_->findChild<PlanPage*>(QStringLiteral("plan"));
    ASSERT_NE(page_, nullptr);
    ASSERT_TRUE(wait([&] { return page_->model() != nullptr && page_->model()->report(); }, 180));
    ASSERT_TRUE(page_->model()->path());
    first_ = *page_->model()->path();
  }
  void TearDown() override {
    if (page_ == nullptr || page_->model() == nullptr) return;
    while (page_->model()->can_undo()) page_->model()->undo();  // other tests use the patient too
  }
  bool wait(const std::function<bool()>& until, int seconds) { return QTest::qWaitFor(until, 1000 * seconds); }
  anatomy::NeedlePath saved() { return *io::read_case_description(page_->model()->patient().folder).procedure.path; }
  SliceView* sagittal() { return page_->findChild<SliceView*>(QStringLiteral("plan.slice.sagittal")); }
  QPoint on_skin(const Vec3& point) {
    const auto place = page_->view3d().scene()->projection().place(point);
    const double scale = static_cast<double>(page_->view3d().width()) / page_->view3d().scene()->width();
    return QPointF(place->x * scale, place->y * scale).toPoint();
  }
  void key(int code, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(&page_->view3d(), static_cast<Qt::Key>(code), modifiers);
  }

  std::unique_ptr<MainWindow> window_;
  PlanPage* page_ = nullptr;
  anatomy::NeedlePath first_;
};

TEST_F(PlanPageTest, a_click_in_a_slice_is_the_target_and_undo_takes_it_back) {
  SliceView* const slice = sagittal();
  const QPoint at = slice->to_widget(first_.target + Vec3(0.0, 1.0, -5.0)).toPoint();
  const Vec3 expected = slice->to_patient(at);
  QTest::mouseClick(slice, Qt::LeftButton, Qt::NoModifier, at);
  ASSERT_TRUE(page_->model()->path());
  EXPECT_LT((page_->model()->path()->target - expected).norm(), 0.01);
  EXPECT_TRUE(page_->model()->is_saved()) << page_->model()->trouble();
  EXPECT_LT((saved().target - expected).norm(), 0.01);
  EXPECT_LT((saved().entry - first_.entry).norm(), 0.01);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(saved().target, first_.target);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_LT((saved().target - expected).norm(), 0.01);
  QTest::mouseClick(page_->findChild<QPushButton*>(QStringLiteral("plan.undo")), Qt::LeftButton);
  EXPECT_EQ(saved().target, first_.target);
}

TEST_F(PlanPageTest, a_click_on_the_skin_is_the_entry_and_it_can_be_dragged_in_a_slice) {
  ASSERT_TRUE(wait([&] { return page_->view3d().is_ready(); }, 120));
  const Vec3 beside = first_.entry + Vec3(12.0, 0.0, 0.0);
  ASSERT_TRUE(wait(
      [&] {
        const auto place = page_->view3d().scene()->projection().place(beside);
        return place && page_->view3d().scene()->skin_at(place->x, place->y).has_value();
      },
      60))
      << "the first picture";
  const QPoint at = on_skin(beside);
  QTest::mouseClick(&page_->view3d(), Qt::LeftButton, Qt::NoModifier, at);
  const Vec3 entry = page_->model()->path()->entry;
  EXPECT_NEAR((entry - first_.entry).norm(), 12.0, 5.0);
  EXPECT_EQ(page_->model()->path()->target, first_.target);
  // On the patient's skin, although a smoothed surface was clicked.
  const anatomy::TissueVolume& tissues = page_->model()->patient().patient.tissues;
  EXPECT_NE(anatomy::nearest(tissues, entry, anatomy::tissue::air), anatomy::tissue::air);
  EXPECT_EQ(anatomy::nearest(tissues, Vec3(entry - 1.0 * page_->model()->path()->direction()),
                             anatomy::TissueId{anatomy::tissue::soft}),
            anatomy::tissue::air);
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_EQ(saved().entry, first_.entry);

  SliceView* const slice = sagittal();
  const QPoint from = slice->to_widget(first_.entry).toPoint(), to = from + QPoint(0, 40);
  QTest::mousePress(slice, Qt::LeftButton, Qt::NoModifier, from);
  for (const QPoint& place : {from + QPoint(0, 20), to}) {
    QMouseEvent move(QEvent::MouseMove, place, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(slice, &move);
  }
  EXPECT_EQ(saved().entry, first_.entry);  // during the drag nothing is written
  QTest::mouseRelease(slice, Qt::LeftButton, Qt::NoModifier, to);
  EXPECT_LT(saved().entry.z(), first_.entry.z() - 4.0);
  EXPECT_EQ(saved().target, first_.target);
}

TEST_F(PlanPageTest, proposals_keep_their_margins_and_one_is_practised) {
  auto* const table = page_->findChild<QTableWidget*>(QStringLiteral("plan.paths"));
  ASSERT_TRUE(wait([&] { return page_->model()->result().proposals_done; }, 60));
  ASSERT_GT(table->rowCount(), 0) << page_->model()->result().why_none;
  for (const ProposedPath& each : page_->model()->result().proposals) EXPECT_GE(each.report.room.spare, 0.0);
  const QPoint at = table->visualItemRect(table->item(0, 0)).center();
  QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, at);
  const anatomy::NeedlePath chosen = *page_->model()->path();
  EXPECT_LT((saved().entry - chosen.entry).norm(), 0.01);
  QTest::mouseClick(page_->findChild<QPushButton*>(QStringLiteral("plan.practise")), Qt::LeftButton);
  ASSERT_TRUE(
      wait([&] { return window_->practice().state() == State::ready && window_->practice().frame().plan; }, 60));
  EXPECT_LT((window_->practice().frame().plan->entry - chosen.entry).norm(), 0.01);
  EXPECT_LT((window_->practice().frame().plan->target - chosen.target).norm(), 0.01);
}

TEST_F(PlanPageTest, the_colours_of_the_skin_are_the_clearances_and_grow_from_the_entry) {
  ASSERT_TRUE(wait([&] { return page_->view3d().is_ready(); }, 120));
  ASSERT_TRUE(wait([&] { return page_->model()->result().map_done && !page_->model()->result().map.empty(); }, 120));
  const PlanWork::Result& result = page_->model()->result();
  const auto& skin = page_->view3d().scene()->surfaces().skin().points;
  ASSERT_EQ(result.map.size(), skin.size());
  int open = 0, blocked = 0;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    EXPECT_NE(result.map[i].kind, EntrySuitability::Kind::unknown);
    blocked += result.map[i].kind == EntrySuitability::Kind::blocked ? 1 : 0;
    if (result.map[i].kind != EntrySuitability::Kind::open) continue;
    if (++open % 20 != 1) continue;
    const Vec3 point = skin[i].cast<double>();
    const auto entry = patient::find_skin_exit(page_->model()->patient().patient.tissues, first_.target,
                                               (point - first_.target).normalized(), 400.0);
    ASSERT_TRUE(entry);
    // Without the last 10 mm, common to all paths.
    const Vec3 back = *entry - first_.target;
    const Vec3 before_end = first_.target + std::min(10.0, 0.5 * back.norm()) * back.normalized();
    double least = 7.0;
    for (const patient::Clearance& each : patient::clearances(*result.obstacles, {*entry, before_end}, 7.0))
      least = std::min(least, each.distance);
    EXPECT_NEAR(result.map[i].clearance, least, 0.01);
  }
  EXPECT_GT(open, 3);
  EXPECT_GT(blocked, open);
  // Nerve roots 2.2 mm from the target do not hide the better paths.
  float best = 0.0F;
  for (const EntrySuitability& each : result.map) best = std::max(best, each.clearance);
  EXPECT_GT(best, 3.0F);
}

TEST_F(PlanPageTest, a_path_through_bone_is_told_and_its_stretch_in_bone_is_known) {
  // Towards the head the path leads through a spinous process.
  for (double up = 4.0; up < 34.0 && !(page_->model()->report() && page_->model()->report()->room.blocked); up += 3.0)
    page_->model()->move_entry(first_.entry + Vec3(0.0, 0.0, up));
  ASSERT_TRUE(page_->model()->report());
  EXPECT_TRUE(page_->model()->report()->room.blocked);
  EXPECT_FALSE(page_->model()->report()->blocked.empty());
  EXPECT_FALSE(page_->model()->trouble().empty());
  page_->model()->move_entry(first_.entry);
}

}  // namespace
}  // namespace bodkin::app
