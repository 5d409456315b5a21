#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <functional>

#include "app/pages/scan.h"
#include "tests/views/made_up.h"
#include <gtest/gtest.h>

#include "io/case_folder.h"

namespace bodkin::app {
namespace {

using bodkin_test::frame_at;
using bodkin_test::layered_hounsfield;
using bodkin_test::layered_patient;

class ScanPageTest : public testing::Test {
 protected:
  ScanPageTest() : page_([this]() -> const Frame& { return frame_; }) {
    page_.resize(1200, 660);
    page_.show();
    page_.set_case(layered_patient());
    page_.enter();
  }
  template <typename Widget = QPushButton>
  Widget* find(const char* name) {
    auto* const found = page_.findChild<Widget*>(QLatin1String(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void click(const char* name) { QTest::mouseClick(find(name), Qt::LeftButton); }
  void scan() {
    click("scan.start");
    EXPECT_TRUE(wait_until_over());
  }
  bool wait(const std::function<bool()>& until) {
    return QTest::qWaitFor(
        [&] {
          page_.advance(clock_ += 0.01);
          return until();
        },
        120000);
  }
  bool wait_until_over() {
    return wait([&] { return !page_.is_scanning() && find("scan.start")->text() == "SCAN"; });
  }

  Frame frame_;
  ScanPage page_;
  double clock_ = 0.0;
};

TEST_F(ScanPageTest, a_scan_has_the_slices_of_its_protocol_with_the_hu_of_the_patient) {
  find<QDoubleSpinBox>("scan.thickness")->setValue(4.0);
  find<QDoubleSpinBox>("scan.spacing")->setValue(10.0);
  scan();
  ASSERT_EQ(page_.scans().size(), 1U);
  const imaging::CtScan& made = *page_.scans()[0];
  ASSERT_EQ(made.slices.size(), 7U);  // 60 mm about the target at z = 0
  EXPECT_DOUBLE_EQ(made.slices.front().z, 30.0);
  EXPECT_DOUBLE_EQ(made.slices.back().z, -30.0);
  EXPECT_FALSE(made.needle);
  const Eigen::Vector2d at = made.plane.place(Vec3(10.0, 0.0, 0.0));
  const std::int16_t value =
      made.slices[2]
          .hounsfield[static_cast<std::size_t>(std::lround(at.y()) * made.plane.width + std::lround(at.x()))];
  EXPECT_NEAR(value, layered_hounsfield(Vec3(10.0, 0.0, 10.0)), 3.0);
  EXPECT_TRUE(find<QLabel>("scan.range")->text().contains("gaps of 6.0 mm"));
}

TEST_F(ScanPageTest, the_second_scan_shows_the_needle_where_it_is) {
  scan();
  frame_ = frame_at(20.0);
  scan();
  ASSERT_EQ(page_.scans().size(), 2U);
  const imaging::CtScan& made = *page_.scans()[1];
  ASSERT_TRUE(made.needle);
  EXPECT_TRUE(find("scan.list.2")->text().contains("needle"));
  const imaging::ScanSlice* const slice = made.slice_at(frame_.needle.translation().z());
  ASSERT_NE(slice, nullptr);
  const auto at = [&](const Vec3& point) {
    const Eigen::Vector2d place = made.plane.place(point);
    return slice
        ->hounsfield[static_cast<std::size_t>(std::lround(place.y()) * made.plane.width + std::lround(place.x()))];
  };
  const Vec3 tip = frame_.needle.translation(), axis = needle_axis(frame_.needle);
  EXPECT_GT(at(tip - 10.0 * axis), 1000);
  EXPECT_LT(at(tip + 5.0 * axis), 200);
  click("scan.list.1");
  EXPECT_TRUE(find("scan.list.1")->isChecked());
}

TEST_F(ScanPageTest, the_box_on_the_scout_is_dragged) {
  auto* const scout = find<ScoutWidget>("scan.scout");
  const auto x = scout->width() / 2;
  const QPoint from(x, static_cast<int>(std::lround(scout->y_of(30.0)))), to(x, static_cast<int>(scout->y_of(10.0)));
  QTest::mousePress(scout, Qt::LeftButton, {}, from);
  QMouseEvent move(QEvent::MouseMove, to, scout->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(scout, &move);
  QTest::mouseRelease(scout, Qt::LeftButton, {}, to);
  EXPECT_NEAR(page_.protocol().from, 10.0, 1.0);
  EXPECT_DOUBLE_EQ(page_.protocol().to, -30.0);
}

TEST_F(ScanPageTest, stopping_keeps_the_slices_that_came) {
  find<QDoubleSpinBox>("scan.thickness")->setValue(10.0);
  find<QDoubleSpinBox>("scan.spacing")->setValue(0.5);
  click("scan.start");
  ASSERT_TRUE(wait([&] { return page_.scans()[0]->slices.size() >= 3; }));
  click("scan.start");
  ASSERT_TRUE(wait_until_over());
  EXPECT_GE(page_.scans()[0]->slices.size(), 3U);
  EXPECT_LT(page_.scans()[0]->slices.size(), 121U);
}

TEST_F(ScanPageTest, a_lesion_that_is_clicked_becomes_the_target_of_the_case) {
  QTemporaryDir folder;
  auto open = std::make_shared<OpenCase>(*layered_patient());
  open->folder = folder.path().toStdString();
  anatomy::CaseDescription& description = open->patient.description;
  description.ct_file = "ct.nrrd";
  description.tissues_file = "tissues.nrrd";
  page_.set_case(open);
  page_.enter();
  scan();
  auto* const viewer = find<ScanViewer>("scan.viewer");
  viewer->show_slice(4);  // z = 10
  const Vec3 lesion(12.0, -8.0, page_.scans()[0]->slices[4].z);
  QTest::mouseClick(viewer, Qt::LeftButton, {}, viewer->place(lesion).toPoint());
  ASSERT_TRUE(viewer->mark());
  EXPECT_NEAR((*viewer->mark() - lesion).norm(), 0.0, 0.5);
  QSignalSpy asked(&page_, &Page::patient_requested);
  click("scan.target");
  ASSERT_EQ(asked.count(), 1) << find<QLabel>("scan.said")->text().toStdString();
  const auto path = io::read_case_description(open->folder).procedure.path;
  ASSERT_TRUE(path);
  EXPECT_NEAR((path->target - lesion).norm(), 0.0, 0.5);
  EXPECT_EQ(path->entry, description.procedure.path->entry);
}

TEST_F(ScanPageTest, the_cine_runs_through_the_slices_and_the_wheel_steps) {
  scan();
  auto* const viewer = find<ScanViewer>("scan.viewer");
  const int before = viewer->slice();
  click("scan.cine");
  for (int i = 0; i < 5; ++i) page_.advance(clock_ += 0.11);
  EXPECT_NE(viewer->slice(), before);
  EXPECT_TRUE(page_.press(QKeySequence(Qt::Key_C)));
  const int stopped = viewer->slice();
  for (int i = 0; i < 5; ++i) page_.advance(clock_ += 0.11);
  EXPECT_EQ(viewer->slice(), stopped);
}

TEST(PathTo, a_target_without_an_entry_is_reached_from_the_nearest_skin) {
  auto open = std::make_shared<OpenCase>(*layered_patient());
  open->patient.description.procedure.path.reset();
  const auto path = path_to(*open, Vec3(0.0, 10.0, 0.0));  // 20 mm below the skin at y = 30
  ASSERT_TRUE(path);
  EXPECT_NEAR((path->entry - Vec3(0.0, 30.0, 0.0)).norm(), 0.0, 1.0);
  EXPECT_FALSE(path_to(*open, Vec3(0.0, 45.0, 0.0)));
}

}  // namespace
}  // namespace bodkin::app
