#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>

#include "app/kept_drawer.h"
#include "app/pages/volume.h"
#include "tests/scene/software_display.h"
#include "tests/views/made_up.h"
#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

using bodkin_test::frame_at;
using bodkin_test::layered_patient;

constexpr int patience = 120000;  // ms; software OpenGL on a busy machine takes seconds for a picture

// Water with a column of bone along the path of the needle, coarse for speed.
std::shared_ptr<const OpenCase> bony_patient() {
  static const std::shared_ptr<const OpenCase> made = [] {
    auto open = std::make_shared<OpenCase>(*layered_patient());
    anatomy::Grid lattice;
    lattice.size = {50, 50, 50};
    lattice.spacing = Vec3::Constant(2.0);
    lattice.origin = Vec3::Constant(-49.0);
    open->patient.ct = anatomy::CtVolume(lattice, -1000);
    open->patient.tissues = anatomy::TissueVolume(lattice);
    for (int k = 0; k < 50; ++k) {
      for (int j = 0; j < 40; ++j) {
        for (int i = 0; i < 50; ++i) open->patient.ct.at(i, j, k) = std::abs(i - 10) < 4 ? 1000 : 0;
      }
    }
    return open;
  }();
  return made;
}

class VolumePageTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {  // what is kept stays in a folder of its own
    settings_ = std::make_unique<QTemporaryDir>();
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings_->path());
    QCoreApplication::setOrganizationName(QStringLiteral("bodkin"));
    QCoreApplication::setApplicationName(QStringLiteral("volume-page-tests"));
  }
  static void TearDownTestSuite() { settings_.reset(); }
  VolumePageTest() : page_([this]() -> const Frame& { return frame_; }) {
    keep_volume_drawer(scene::VolumeDrawer::processor);
    page_.resize(800, 500);
    page_.show();
    frame_ = frame_at(20.0);
    page_.set_case(bony_patient());
    page_.enter();
    settle();
  }
  void settle() {
    page_.advance(clock_ += 0.05);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
          page_.advance(clock_ += 0.05);
          return page_.view().is_settled();
        },
        patience));
  }
  // So soon that the camera still counts as moving.
  void await_picture_of(const scene::Camera& camera) {
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          page_.advance(clock_ += 0.00001);
          return page_.view().picture().base()->request.camera == camera;
        },
        patience));
  }
  std::uint32_t pixel(const Vec3& point) {
    const scene::VolumePicture& shown = page_.view().picture();
    const auto at = shown.projection().place(point);
    EXPECT_TRUE(at);
    return shown.picture().row(static_cast<int>(at->y))[static_cast<int>(at->x)];
  }
  template <typename Widget>
  Widget* find(const char* name) {
    auto* const found = page_.findChild<Widget*>(QLatin1String(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void click(const char* name) { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }

  static std::unique_ptr<QTemporaryDir> settings_;
  Frame frame_;
  VolumePage page_;
  double clock_ = 0.0;
};

std::unique_ptr<QTemporaryDir> VolumePageTest::settings_;

int red(std::uint32_t colour) {
  return static_cast<int>(colour >> 16U & 0xFFU);
}

TEST_F(VolumePageTest, bone_is_seen_in_every_mode_and_water_in_the_sum_alone) {
  const Vec3 bone(-29.0, 20.0, 0.0), water(30.0, 20.0, 20.0);
  page_.view().choose_view(scene::StandardView::posterior);
  for (const char* mode : {"volume.mode.colour", "volume.mode.grey", "volume.mode.maximum"}) {
    click(mode);
    settle();
    EXPECT_GT(red(pixel(bone)), 90) << mode;
    EXPECT_GT(red(pixel(bone)), red(pixel(water)) + 60) << mode;
  }
  click("volume.mode.sum");
  settle();
  EXPECT_GT(red(pixel(water)), 40);
  EXPECT_GT(red(pixel(bone)), red(pixel(water)) + 40);
}

TEST_F(VolumePageTest, a_needle_is_seen_before_bone_and_faint_behind_it) {
  page_.view().choose_view(scene::StandardView::left);  // from +x, on the slab of bone about x = -29
  imaging::VolumeLook look = page_.view().look();
  look.transfer.colours = {{0.0, 0xFF0000}};
  page_.view().set_look(look);
  const auto green_with_needle_at = [&](double x) {
    frame_.plan.reset();
    frame_.needle = needle_pose(Vec3(x, -5.0, 0.0), -Vec3::UnitY());
    page_.enter();
    settle();
    int most = 0;  // of the few pixels across
    for (double z = -1.0; z <= 1.0; z += 0.1) {
      most = std::max(most, static_cast<int>(pixel(Vec3(x, 12.0, z)) >> 8U & 0xFFU));
    }
    return most;
  };
  const int before = green_with_needle_at(-10.0), behind = green_with_needle_at(-45.0);
  EXPECT_GT(before, 90);
  EXPECT_LT(behind, before / 2);
  EXPECT_GT(behind, 0);
}

TEST_F(VolumePageTest, a_point_of_the_curve_is_dragged_and_the_picture_follows) {
  auto* const curve = find<OpacityCurve>("volume.curve");
  page_.view().choose_view(scene::StandardView::posterior);
  settle();
  const int before = red(pixel(Vec3(30.0, 20.0, 20.0)));
  // The second point of the bone preset from 150 HU to -100 HU and up: water becomes opaque.
  const imaging::OpacityPoint point = curve->function().opacity[1];
  const QPoint from = curve->place(point.hounsfield, point.opacity).toPoint();
  const QPoint to = curve->place(-100.0, 0.5).toPoint();
  QTest::mousePress(curve, Qt::LeftButton, {}, from);
  QMouseEvent move(QEvent::MouseMove, to, curve->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(curve, &move);
  QTest::mouseRelease(curve, Qt::LeftButton, {}, to);
  settle();
  EXPECT_NEAR(curve->function().opacity[1].hounsfield, -100.0, 20.0);
  EXPECT_NEAR(page_.view().look().transfer.opacity_at(-100.0), 0.5, 0.05);
  EXPECT_GT(red(pixel(Vec3(30.0, 20.0, 20.0))), before + 40);
}

TEST_F(VolumePageTest, sliders_shift_and_thicken_the_preset) {
  find<QSlider>("volume.threshold")->setValue(100);
  find<QSlider>("volume.density")->setValue(25);
  const imaging::TransferFunction preset = imaging::preset_function(imaging::TransferPreset::bone);
  EXPECT_EQ(page_.view().look().transfer, imaging::adjusted(preset, 100.0, 2.0));
  click("volume.preset.skin");
  EXPECT_EQ(find<QSlider>("volume.threshold")->value(), 0);
  EXPECT_EQ(page_.view().look().transfer,
            imaging::adjusted(imaging::preset_function(imaging::TransferPreset::skin), 0.0, 1.0));
}

TEST_F(VolumePageTest, keys_change_mode_and_preset_and_a_drag_turns) {
  EXPECT_TRUE(page_.press(QKeySequence(Qt::Key_M)));
  EXPECT_EQ(page_.view().look().mode, imaging::VolumeMode::grey);
  EXPECT_TRUE(page_.press(QKeySequence(Qt::Key_P)));
  EXPECT_TRUE(find<QPushButton>("volume.preset.soft_tissue")->isChecked());
  EXPECT_FALSE(page_.press(QKeySequence(Qt::Key_Z)));
  const Vec3 eye = page_.view().camera().eye;
  QTest::mousePress(&page_.view(), Qt::LeftButton, {}, QPoint(200, 200));
  QMouseEvent move(QEvent::MouseMove, QPointF(260, 200), QPointF(260, 200), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(&page_.view(), &move);
  EXPECT_GT((page_.view().camera().eye - eye).norm(), 50.0);
}

TEST_F(VolumePageTest, while_the_camera_moves_the_picture_is_coarse_and_fine_after) {
  scene::Camera camera = page_.view().camera();
  camera = scene::turned(camera, 0.3, 0.0);
  page_.view().set_camera(camera);
  page_.advance(clock_ += 0.01);
  await_picture_of(camera);
  const scene::VolumeRequest coarse = page_.view().picture().base()->request;
  EXPECT_GE(coarse.voxels, 2.0);
  EXPECT_LE(coarse.voxels, 4.0) << "on a machine that is slow";
  EXPECT_LE(coarse.width * coarse.height, 66000);
  settle();
  EXPECT_EQ(page_.view().picture().base()->request.width, page_.view().width());
}

TEST_F(VolumePageTest, what_draws_is_chosen_and_kept_and_a_card_that_is_not_there_is_one_sentence) {
  EXPECT_TRUE(find<QPushButton>("volume.drawer.processor")->isChecked());
  EXPECT_EQ(find<QLabel>("volume.drawn_by")->text(), QStringLiteral("The processor draws."));
  const char* const display = std::getenv("DISPLAY");
  const std::string before = display == nullptr ? "" : display;
  unsetenv("DISPLAY");
  click("volume.drawer.card");
  settle();
  if (display != nullptr) setenv("DISPLAY", before.c_str(), 1);
  EXPECT_EQ(kept_volume_drawer(), scene::VolumeDrawer::card);
  EXPECT_EQ(page_.view().drawer(), scene::VolumeDrawer::card);
  EXPECT_FALSE(find<QPushButton>("volume.drawer.processor")->isChecked());
  EXPECT_EQ(find<QLabel>("volume.drawn_by")->text(),
            QStringLiteral("The processor draws: no graphics card can be reached, because there is no X11 display."));
  EXPECT_FALSE(page_.view().picture().base()->by_card);
  click("volume.drawer.automatic");
  EXPECT_EQ(kept_volume_drawer(), scene::VolumeDrawer::automatic);
}

TEST_F(VolumePageTest, a_card_draws_all_of_the_view_at_once_while_the_camera_moves) {
  const scene::SoftwareDisplay display;
  if (!display.is_there()) GTEST_SKIP() << "Xvfb is not installed";
  click("volume.drawer.card");
  settle();
  ASSERT_TRUE(page_.view().picture().base()->by_card) << page_.view().refusal();
  EXPECT_TRUE(find<QLabel>("volume.drawn_by")->text().startsWith(QStringLiteral("llvmpipe")));
  // Bone is at the ray caster's place, the needle in front of it.
  page_.view().choose_view(scene::StandardView::posterior);
  settle();
  EXPECT_GT(red(pixel(Vec3(-29.0, 20.0, 0.0))), red(pixel(Vec3(30.0, 20.0, 20.0))) + 60);
  const scene::Camera camera = scene::turned(page_.view().camera(), 0.3, 0.0);
  page_.view().set_camera(camera);
  page_.advance(clock_ += 0.01);
  await_picture_of(camera);
  const scene::VolumeRequest moving = page_.view().picture().base()->request;
  EXPECT_FALSE(moving.may_be_cut_short);
  EXPECT_LE(moving.voxels, 2.0) << "finer than the processor's";
  EXPECT_GT(moving.width * moving.height, 66000) << "more rays than the processor's";
}

}  // namespace
}  // namespace bodkin::app
