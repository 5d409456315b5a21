// Structures corrected by mouse and keys in the real window, up to the case that is saved.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>
#include <algorithm>
#include <functional>

#include "app/main_window.h"
#include "app/models/data_folder.h"
#include "app/pages/segment.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/case_folder.h"
#include "io/image_worker.h"
#include "io/nrrd_writer.h"

namespace bodkin::app {
namespace {

const Vec3 ball_middle(10.0, 0.0, 0.0);
constexpr double ball_radius = 12.0;  // mm

// A body of 80 HU, 120 mm wide, with a ball of 400 HU in it, lies in air. Voxels of 2 mm.
anatomy::CtVolume body_with_ball() {
  anatomy::Grid grid;
  grid.size = {76, 76, 40};
  grid.spacing = Vec3::Constant(2.0);
  grid.origin = {-75.0, -75.0, -39.0};
  anatomy::CtVolume ct(grid, -1000);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 p = grid.to_patient(Vec3(i, j, k));
        if (p.head<2>().norm() < 60.0) ct.at(i, j, k) = 60;
        if ((p - ball_middle).norm() < ball_radius) ct.at(i, j, k) = 400;
      }
    }
  }
  return ct;
}

std::filesystem::path case_with_ball() {
  const std::filesystem::path folder = data_folder() / "patients" / "ball";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder.parent_path());
  const std::filesystem::path image = data_folder() / "ball.nrrd";
  io::write_nrrd(body_with_ball(), image);
  const nlohmann::json request = {{"folder", folder.string()},
                                  {"ct", image.string()},
                                  {"name", "Ball"},
                                  {"entry", {10.0, 59.0, 0.0}},
                                  {"target", {10.0, 20.0, 0.0}}};
  io::run_image_worker("case-new", request.dump(), image.string(), {});
  return folder;
}

class SegmentWindow : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = case_with_ball();
    window_.resize(1280, 720);
    window_.show();
    window_.open(folder_);
    ASSERT_TRUE(wait([&] { return window_.practice().state() == State::ready; })) << window_.practice().failure();
    window_.show_page(PageId::segment);
    ASSERT_TRUE(wait([&] { return page().model() != nullptr; }));
  }
  SegmentPage& page() { return *window_.findChild<SegmentPage*>(QStringLiteral("segment")); }
  template <typename Widget>
  Widget* find(const char* name) {
    auto* const found = window_.findChild<Widget*>(QLatin1String(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  bool wait(const std::function<bool()>& until) { return QTest::qWaitFor(until, 120000); }
  void click(const char* name) { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }
  // Waits until the filter's work is an undo step.
  bool finish() {
    return wait([&] { return !page().model()->status().is_busy && find<QPushButton>("segment.fill")->isEnabled(); });
  }
  void key(int code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&page().slice(0), static_cast<Qt::Key>(code), modifiers);
  }
  void drag(const Vec3& from, const Vec3& to) {
    SegmentSlice& slice = page().slice(0);
    const QPoint a = slice.place(from).toPoint(), b = slice.place(to).toPoint();
    QTest::mousePress(&slice, Qt::LeftButton, Qt::NoModifier, a);
    for (const QPoint& at : {(a + b) / 2, b}) {
      QMouseEvent move(QEvent::MouseMove, at, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(&slice, &move);
    }
    QTest::mouseRelease(&slice, Qt::LeftButton, Qt::NoModifier, b);
  }
  void make(const char* name, const char* tissue) {
    find<QLineEdit>("segment.name")->setText(QString::fromLatin1(name));
    auto* const tissues = find<QComboBox>("segment.tissue");
    tissues->setCurrentIndex(tissues->findData(QString::fromLatin1(tissue)));
    click("segment.new");
  }
  std::size_t count() { return page().model()->editor().count(page().model()->active_label()); }

  std::filesystem::path folder_;
  MainWindow window_{data_folder()};
};

std::size_t voxels_of_ball() {
  const anatomy::CtVolume ct = body_with_ball();
  return static_cast<std::size_t>(std::count(ct.voxels.begin(), ct.voxels.end(), std::int16_t{400}));
}

TEST_F(SegmentWindow, a_lesion_is_grown_from_a_click_undone_and_saved_with_its_tissue) {
  click("segment.threshold");
  EXPECT_TRUE(find<QLabel>("segment.said")->text().contains("Make a structure first"));
  make("lesion", "mass");
  ASSERT_EQ(page().model()->active_label(), 1);
  page().set_crosshair(ball_middle);
  key(Qt::Key_G);
  // First beside the ball: a sentence, and no change.
  QTest::mouseClick(&page().slice(0), Qt::LeftButton, Qt::NoModifier,
                    page().slice(0).place(Vec3(-20.0, 0.0, 0.0)).toPoint());
  ASSERT_TRUE(finish());
  EXPECT_TRUE(find<QLabel>("segment.said")->text().contains("60 HU"))
      << find<QLabel>("segment.said")->text().toStdString();
  EXPECT_EQ(count(), 0U);
  QTest::mouseClick(&page().slice(0), Qt::LeftButton, Qt::NoModifier, page().slice(0).place(ball_middle).toPoint());
  ASSERT_TRUE(finish());
  EXPECT_EQ(count(), voxels_of_ball());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(count(), 0U);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(count(), voxels_of_ball());
  // In 3-D the surface is where the ball ends: 12 mm about its middle, to a voxel.
  const std::optional<Vec3> surface = page().relief().surface_at(QPointF(page().relief().rect().center()));
  ASSERT_TRUE(surface.has_value());
  EXPECT_NEAR((*surface - ball_middle).norm(), ball_radius, 2.0);

  const auto before = window_.practice().patient();
  click("segment.save");
  ASSERT_TRUE(wait([&] {
    return (window_.practice().patient() != before && window_.practice().state() == State::ready) ||
           (page().model() != nullptr && !page().model()->status().error.empty());
  }));
  const anatomy::Case saved = io::load_case(folder_);
  ASSERT_EQ(saved.description.structures.size(), 1U);
  EXPECT_EQ(saved.description.structures[0].name, "lesion");
  EXPECT_EQ(saved.description.structures[0].tissue, "mass");
  EXPECT_EQ(anatomy::nearest(saved.structures, ball_middle, std::uint16_t{0}), 1);
  EXPECT_EQ(anatomy::nearest(saved.tissues, ball_middle, anatomy::tissue::air), anatomy::tissue::mass);
  EXPECT_NE(anatomy::nearest(saved.tissues, Vec3(-30.0, 0.0, 0.0), anatomy::tissue::air), anatomy::tissue::mass);
  EXPECT_TRUE(io::check_case(folder_).empty());
  ASSERT_TRUE(saved.description.procedure.path.has_value());
  EXPECT_EQ(saved.description.procedure.path->target, Vec3(10.0, 20.0, 0.0)) << "a path that is sound stays";
}

TEST_F(SegmentWindow, structures_are_renamed_marked_as_critical_and_removed) {
  make("vessel", "");
  page().set_crosshair(ball_middle);
  key(Qt::Key_G);
  QTest::mouseClick(&page().slice(0), Qt::LeftButton, Qt::NoModifier, page().slice(0).place(ball_middle).toPoint());
  ASSERT_TRUE(finish());
  const std::size_t voxels = count();
  ASSERT_GT(voxels, 0U);
  find<QLineEdit>("segment.name")->setText(QStringLiteral("other"));
  click("segment.new");
  click("segment.rename");
  EXPECT_TRUE(find<QLabel>("segment.said")->text().contains("name"));
  find<QLineEdit>("segment.name")->setText(QStringLiteral("vessel"));
  click("segment.rename");
  EXPECT_TRUE(find<QLabel>("segment.said")->text().contains("already"));
  find<QLineEdit>("segment.name")->setText(QStringLiteral("left renal artery"));
  click("segment.rename");
  EXPECT_EQ(page().model()->table()[1].name, "left_renal_artery");
  find<QListWidget>("segment.structures")->setCurrentRow(0);
  auto* const critical = find<QCheckBox>("segment.critical");
  EXPECT_FALSE(critical->isChecked());
  critical->click();
  EXPECT_TRUE(page().model()->table()[0].critical);
  find<QListWidget>("segment.structures")->setCurrentRow(1);
  EXPECT_FALSE(critical->isChecked());
  find<QListWidget>("segment.structures")->setCurrentRow(0);
  EXPECT_TRUE(critical->isChecked());
  click("segment.remove");
  EXPECT_EQ(count(), 0U);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(count(), voxels);
  const auto before = window_.practice().patient();
  click("segment.save");
  ASSERT_TRUE(wait([&] {
    return (window_.practice().patient() != before && window_.practice().state() == State::ready) ||
           (page().model() != nullptr && !page().model()->status().error.empty());
  }));
  const anatomy::Case saved = io::load_case(folder_);
  ASSERT_EQ(saved.description.structures.size(), 1U) << "the other has no voxel";
  EXPECT_EQ(saved.description.structures[0].name, "vessel");
  EXPECT_TRUE(saved.description.structures[0].critical);
}

TEST_F(SegmentWindow, paint_erase_fill_and_smooth_do_what_they_say) {
  make("marker", "");
  page().set_crosshair(Vec3(-20.0, 0.0, -11.0));
  key(Qt::Key_P);
  find<QDoubleSpinBox>("segment.radius")->setValue(8.0);
  find<QAbstractButton>("segment.ball")->setChecked(false);
  drag(Vec3(-30.0, 0.0, -11.0), Vec3(-10.0, 0.0, -11.0));
  const std::size_t stroke = count();
  const double area = (20.0 * 16.0 + M_PI * 64.0) / 4.0;  // in voxels of 2 mm, in one slice
  EXPECT_NEAR(static_cast<double>(stroke), area, 0.12 * area);
  page().set_crosshair(Vec3(-20.0, 0.0, 9.0));
  drag(Vec3(-30.0, 0.0, 9.0), Vec3(-10.0, 0.0, 9.0));
  EXPECT_NEAR(static_cast<double>(count()), 2.0 * static_cast<double>(stroke), 0.1 * static_cast<double>(stroke));
  click("segment.fill");
  ASSERT_TRUE(finish());
  EXPECT_NEAR(static_cast<double>(count()), 11.0 * static_cast<double>(stroke), 0.8 * static_cast<double>(stroke));
  key(Qt::Key_E);
  find<QAbstractButton>("segment.ball")->setChecked(true);
  const std::size_t before = count();
  page().set_crosshair(Vec3(-20.0, 0.0, 1.0));
  drag(Vec3(-20.0, 0.0, 1.0), Vec3(-20.0, 0.0, 1.0));
  EXPECT_LT(count(), before);
  EXPECT_EQ(anatomy::nearest(page().model()->editor().labels(), Vec3(-20.0, 0.0, 1.0), std::uint16_t{9}), 0);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(count(), before) << "a stroke is one step";
  find<QDoubleSpinBox>("segment.smoothness")->setValue(3.0);
  click("segment.smooth");
  ASSERT_TRUE(finish());
  EXPECT_LT(count(), before) << "its corners go";
  EXPECT_GT(static_cast<double>(count()), 0.7 * static_cast<double>(before));
  // The drawing: the structure's colour over the grey, only the CT when it is removed.
  page().set_crosshair(Vec3(-20.0, 0.0, 1.0));
  const QPoint inside = page().slice(0).place(Vec3(-22.0, 3.0, 1.0)).toPoint();
  const QColor covered = page().slice(0).picture().pixelColor(inside);
  EXPECT_GT(covered.saturation(), 40);
  key(Qt::Key_V);
  EXPECT_EQ(page().slice(0).picture().pixelColor(inside).saturation(), 0);
}

TEST_F(SegmentWindow, what_was_not_saved_is_there_again_and_one_step_takes_it_back) {
  make("marker", "");
  page().set_crosshair(Vec3(-20.0, 0.0, 1.0));
  key(Qt::Key_P);
  drag(Vec3(-30.0, 0.0, 1.0), Vec3(-10.0, 0.0, 1.0));
  const std::size_t painted = count();
  ASSERT_GT(painted, 0U);
  // As after a restart: another window opens the patient.
  window_.show_page(PageId::start);
  ASSERT_TRUE(wait([&] { return window_.practice().state() == State::no_case; }));
  MainWindow next(data_folder());
  next.resize(1280, 720);
  next.show();
  next.open(folder_);
  ASSERT_TRUE(wait([&] { return next.practice().state() == State::ready; })) << next.practice().failure();
  next.show_page(PageId::segment);
  auto& again = *next.findChild<SegmentPage*>(QStringLiteral("segment"));
  ASSERT_TRUE(wait([&] { return again.model() != nullptr; }));
  EXPECT_EQ(again.model()->editor().count(again.model()->active_label()), painted);
  ASSERT_EQ(again.model()->table().size(), 1U);
  EXPECT_EQ(again.model()->table()[0].name, "marker");
  EXPECT_TRUE(next.findChild<QLabel*>(QStringLiteral("segment.said"))->text().contains("not saved the last time"));
  EXPECT_TRUE(io::check_case(folder_).empty()) << "the case itself is as it was";
  EXPECT_TRUE(again.press(QKeySequence(QStringLiteral("Ctrl+Z"))));
  EXPECT_EQ(again.model()->editor().count(again.model()->active_label()), 0U);
}

}  // namespace
}  // namespace bodkin::app
