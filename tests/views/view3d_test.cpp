#include "views/view3d.h"

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <utility>
#include <vector>

#include "tests/views/made_up.h"
#include "views/orientation_cube.h"
#include "views/theme.h"
#include <gtest/gtest.h>

namespace bodkin::views {
namespace {

using bodkin_test::frame_at;
using bodkin_test::layered_patient;

// The made-up patient in voxels of 2 mm, whose surfaces are computed quickly.
std::shared_ptr<const OpenCase> coarse_patient() {
  static const std::shared_ptr<const OpenCase> made = [] {
    auto open = std::make_shared<OpenCase>(*layered_patient());
    anatomy::Grid grid;
    grid.size = {50, 50, 50};
    grid.spacing = Vec3::Constant(2.0);
    grid.origin = Vec3(-49.0, -49.0, -49.0);
    open->patient.tissues = anatomy::TissueVolume(grid);
    for (int k = 0; k < 50; ++k) {
      for (int j = 0; j < 40; ++j) {  // to y = 30 mm
        for (int i = 0; i < 50; ++i) open->patient.tissues.at(i, j, k) = anatomy::tissue::muscle;
      }
    }
    return open;
  }();
  return made;
}

// The view with its surfaces, 400 x 300.
class View3dTest : public testing::Test {
 protected:
  View3dTest() {
    view_.resize(400, 300);
    view_.show();
    view_.set_case(coarse_patient());
    EXPECT_TRUE(wait_until_ready());
    look(scene::StandardView::posterior);
  }

  bool wait_until_ready() {
    return QTest::qWaitFor(
        [this] {
          view_.show_frame({}, {});
          return view_.is_ready();
        },
        120000);
  }
  void show(const Frame& frame) {
    Frame now = frame;
    now.clock = clock_ += 1.0;
    view_.show_frame(now, Changes::all());
  }
  void look(scene::StandardView view) {
    scene::ViewSubject subject;
    subject.middle = Vec3(0.0, 10.0, 0.0);
    subject.height = 120.0;
    view_.set_camera(scene::standard_view(view, subject));
    show(frame_at(-5.0));
    show(frame_at(-5.0));
  }
  QPoint at(const Vec3& point) {
    const auto place = view_.scene()->projection().place(point);
    return {static_cast<int>(place->x), static_cast<int>(place->y)};
  }

  View3d view_{QStringLiteral("practise")};
  double clock_ = 0.0;
};

TEST_F(View3dTest, has_names_for_scripts_and_a_text_for_everybody) {
  EXPECT_EQ(view_.objectName(), QStringLiteral("practise.view3d"));
  for (const scene::Preset preset : scene::presets) {
    const QString name = QStringLiteral("practise.preset.") + QString::fromLatin1(name_of(preset).data());
    auto* button = view_.findChild<QPushButton*>(name);
    ASSERT_NE(button, nullptr) << name.toStdString();
    EXPECT_FALSE(button->toolTip().isEmpty());
    EXPECT_FALSE(button->accessibleName().isEmpty());
    button->click();
    EXPECT_EQ(view_.preset(), preset);
    EXPECT_TRUE(button->isChecked());
  }
}

TEST_F(View3dTest, paints_the_picture_of_the_scene) {
  view_.findChild<QPushButton*>(QStringLiteral("practise.preset.skin"))->click();
  show(frame_at(-20.0));
  const QImage grabbed = view_.grab().toImage();
  const scene::Picture& picture = view_.scene()->picture();
  ASSERT_EQ(picture.width, 400);
  int different = 0;
  for (int y = 60; y < 200; ++y) {
    for (int x = 100; x < 390; ++x) different += (grabbed.pixel(x, y) & 0xFFFFFFU) != (picture.row(y)[x] & 0xFFFFFFU);
  }
  EXPECT_LT(different, 200) << "only the mark at the tip lies over it";
}

TEST_F(View3dTest, the_pointer_over_the_skin_aims_at_the_point_below_it) {
  QSignalSpy down(&view_, &View::put_down);
  std::vector<std::pair<Vec3, Vec3>> aimed;
  QObject::connect(&view_, &View::aimed,
                   [&](const Vec3& hit, const Vec3& outwards) { aimed.emplace_back(hit, outwards); });
  const Vec3 point(12.0, 30.0, -9.0);
  QTest::mouseClick(&view_, Qt::LeftButton, {}, at(point));
  ASSERT_EQ(aimed.size(), 1u);
  EXPECT_EQ(down.count(), 1);
  const auto& [hit, outwards] = aimed.front();
  EXPECT_LT((hit - point).norm(), 1.0);
  EXPECT_GT(outwards.dot(Vec3::UnitY()), 0.98);
  QTest::mouseClick(&view_, Qt::LeftButton, {}, QPoint(200, 1));  // outside the patient
  EXPECT_EQ(down.count(), 1);
}

TEST_F(View3dTest, the_patient_moves_as_breath_is_drawn_in) {
  auto open = std::make_shared<OpenCase>(*coarse_patient());
  anatomy::Breathing breathing;
  breathing.centre = Vec3(0.0, 30.0, 0.0);
  breathing.motion = Vec3(0.0, 9.0, 0.0);
  breathing.radius = 100.0;  // large compared with the triangles of a flat skin
  open->patient.description.breathing = breathing;
  view_.set_case(open);
  ASSERT_TRUE(wait_until_ready());
  look(scene::StandardView::posterior);
  const auto skin_along = [&](double x, double z) {
    const QPoint pixel = at(Vec3(x, 30.0, z));
    return view_.scene()->skin_at(pixel.x(), pixel.y())->point;
  };
  for (const auto& [x, z] :
       {std::pair(0.0, 0.0), std::pair(15.0, 0.0), std::pair(0.0, -30.0), std::pair(44.0, 20.0)}) {
    Frame frame = frame_at(-5.0);
    frame.drawn_in = 0.0;
    show(frame);
    const Vec3 before = skin_along(x, z);
    frame.drawn_in = 0.8;
    show(frame);
    const Vec3 after = skin_along(x, z);
    const double inside = std::max(0.0, 1.0 - (before - breathing.centre).squaredNorm() / (100.0 * 100.0));
    EXPECT_NEAR(after.y() - before.y(), 0.8 * 9.0 * inside * inside, 0.6) << x << " " << z;
  }
  // The dent is at the needle: its bottom moves with the skin.
  Frame frame = frame_at(2.0);
  frame.drawn_in = 0.8;
  frame.dimple.at = Vec3(0.0, 30.0 + 0.8 * 9.0, 0.0);
  frame.dimple.inwards = -Vec3::UnitY();
  frame.dimple.depth = 3.0;
  show(frame);
  const scene::SkinPatch& patch = view_.scene()->patch();
  EXPECT_NEAR(static_cast<double>(patch.mesh().points[patch.bottom()].y()), 30.0 + 0.8 * 9.0 - 3.0, 0.1);
}

TEST_F(View3dTest, wheel_pushes_and_zooms_with_control) {
  QSignalSpy pushed(&view_, &View::pushed);
  const auto wheel = [&](int delta, Qt::KeyboardModifiers modifiers) {
    QWheelEvent event(QPointF(200, 150), QPointF(200, 150), QPoint(), QPoint(0, delta), Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view_, &event);
  };
  wheel(-120, Qt::NoModifier);
  wheel(120, Qt::ShiftModifier);
  ASSERT_EQ(pushed.count(), 2);
  EXPECT_EQ(pushed[0][0].toDouble(), 1.0) << "down is inwards";
  EXPECT_FALSE(pushed[0][1].toBool());
  EXPECT_EQ(pushed[1][0].toDouble(), -1.0);
  EXPECT_TRUE(pushed[1][1].toBool());
  const double before = view_.camera().distance();
  wheel(120, Qt::ControlModifier);
  EXPECT_NEAR(view_.camera().distance(), before / 1.12, 1e-6);
  EXPECT_EQ(pushed.count(), 2);
}

TEST_F(View3dTest, the_hub_is_dragged_along_the_needle_millimetre_by_millimetre) {
  look(scene::StandardView::left);
  show(frame_at(5.0));
  QSignalSpy dragged(&view_, &View::dragged), tilted(&view_, &View::tilted);
  scene::NeedleLook needle;
  needle.pose = frame_at(5.0).needle;
  needle.shape = layered_patient()->description().needle;
  scene::Camera camera = view_.camera();
  camera.focus = scene::hub_middle(needle);
  camera.eye = camera.focus + Vec3(250.0, 0.0, 0.0);
  view_.set_camera(camera);
  show(frame_at(5.0));
  const Vec3 hub = scene::hub_middle(needle);
  const auto move = [&](const QPoint& from, const QPoint& to) {
    QTest::mousePress(&view_, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 10; ++i) {
      const QPointF now = QPointF(from) + (QPointF(to) - QPointF(from)) * (i / 10.0);
      QMouseEvent event(QEvent::MouseMove, now, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(&view_, &event);
    }
    QTest::mouseRelease(&view_, Qt::LeftButton, {}, to);
  };
  const Vec3 inwards = needle_axis(needle.pose);
  move(at(hub), at(hub + 20.0 * inwards));
  double sum = 0.0;
  for (const auto& arguments : dragged) sum += arguments[0].toDouble();
  EXPECT_GT(sum, 16.0);  // 20 mm, less the first pixels, which decide the kind of drag
  EXPECT_LT(sum, 21.0);
  EXPECT_EQ(tilted.count(), 0);
  dragged.clear();
  move(at(hub), at(hub + Vec3(0.0, 0.0, 15.0)));
  EXPECT_EQ(dragged.count(), 0);
  double cranial = 0.0;
  for (const auto& arguments : tilted) cranial += arguments[1].toDouble();
  EXPECT_GT(cranial, 0.0) << "the hub went to the head";
}

// Heng et al. 2004: the handle changes colour when the needle touches the body.
TEST_F(View3dTest, the_hub_has_another_colour_while_the_needle_touches_the_body) {
  look(scene::StandardView::left);
  scene::NeedleLook needle;
  needle.pose = frame_at(5.0).needle;
  needle.shape = layered_patient()->description().needle;
  scene::Camera camera = view_.camera();
  camera.focus = scene::hub_middle(needle);
  camera.eye = camera.focus + Vec3(250.0, 0.0, 0.0);
  view_.set_camera(camera);
  const auto colour_of_hub = [&](double depth) {
    Frame frame = frame_at(5.0);
    frame.depth = depth;
    show(frame);
    const QPoint middle = at(scene::hub_middle(needle));
    return view_.scene()->picture().row(middle.y())[middle.x()] & 0xFFFFFFU;
  };
  const std::uint32_t outside = colour_of_hub(-1.0), touching = colour_of_hub(0.5);
  const QColor plain(outside), seen(touching);
  EXPECT_GT(seen.blue() - plain.blue(), 40);
  EXPECT_GT(seen.blue(), seen.red() + 40);
  EXPECT_EQ(colour_of_hub(-1.0), outside);
}

TEST_F(View3dTest, drags_turn_keys_choose_views_and_the_cube_too) {
  const scene::Camera before = view_.camera();
  QTest::mousePress(&view_, Qt::LeftButton, {}, QPoint(200, 150));
  for (const int x : {210, 230, 260}) {
    QMouseEvent event(QEvent::MouseMove, QPointF(x, 150), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&view_, &event);
  }
  QSignalSpy down(&view_, &View::put_down);
  QTest::mouseRelease(&view_, Qt::LeftButton, {}, QPoint(260, 150));
  EXPECT_EQ(down.count(), 0) << "a drag is no click";
  EXPECT_FALSE(view_.camera() == before);
  const auto looks_from = [&] { return Vec3((view_.camera().eye - view_.camera().focus).normalized()); };
  QTest::keyClick(&view_, Qt::Key_3);
  show(frame_at(-5.0));
  show(frame_at(-5.0));
  EXPECT_TRUE(looks_from().isApprox(Vec3::UnitX(), 1e-6)) << "3 is the left side";
  const scene::Preset preset = view_.preset();
  QTest::keyClick(&view_, Qt::Key_P);
  EXPECT_NE(view_.preset(), preset);
  QTest::keyClick(&view_, Qt::Key_1);
  show(frame_at(-5.0));
  show(frame_at(-5.0));
  EXPECT_TRUE(looks_from().isApprox(Vec3::UnitY(), 1e-6)) << "1 is from behind";
  // The face in the middle of the cube is the one seen.
  QTest::keyClick(&view_, Qt::Key_Right);
  QTest::mouseClick(&view_, Qt::LeftButton, {}, QPoint(12 + 38, 300 - 12 - 38));
  show(frame_at(-5.0));
  EXPECT_TRUE(looks_from().isApprox(Vec3::UnitY(), 1e-6));
}

TEST_F(View3dTest, the_dimple_of_a_frame_is_as_deep_in_the_scene) {
  Frame frame = frame_at(3.0);
  frame.state = State::touching;
  frame.dimple.at = Vec3(0.4, 30.0, 0.2);
  frame.dimple.inwards = -Vec3::UnitY();
  frame.dimple.depth = 3.0;
  show(frame);
  const scene::SkinPatch& patch = view_.scene()->patch();
  const Vec3 bottom = patch.mesh().points[patch.bottom()].cast<double>();
  EXPECT_LT((bottom - Vec3(0.4, 27.0, 0.2)).norm(), 1e-3);
  const std::vector<float> displacements(3 * view_.deformable_points().size(), 0.25F);
  frame.displacements = displacements;
  frame.dimple.at = Vec3(4.0, 30.0, -3.0);  // elsewhere, but within the same requested points
  show(frame);
  EXPECT_EQ(view_.deformable_points().size() * 3, displacements.size());
  EXPECT_LT((patch.mesh().points[patch.bottom()].cast<double>() - Vec3(4.0, 27.0, -3.0)).norm(), 1e-3);
  int others = 0;
  QObject::connect(&view_, &View3d::points_changed, &view_, [&] { ++others; });
  frame.dimple.at = Vec3(17.0, 30.0, -3.0);  // so far away that other points are needed, once
  show(frame);
  show(frame);
  EXPECT_EQ(others, 1);
  EXPECT_LT((patch.entry() - frame.dimple.at).norm(), 1e-6);
  frame.displacements = {};
  frame.dimple.depth = 0.0;
  show(frame);
  EXPECT_NEAR(patch.mesh().points[patch.bottom()].y(), 30.0F, 0.6F);
}

TEST_F(View3dTest, stereo_shows_each_eye_its_own_picture) {
  show(frame_at(-20.0));
  const scene::Picture mono = view_.scene()->picture();
  QTest::keyClick(&view_, Qt::Key_Y);
  EXPECT_EQ(view_.stereo(), scene::Stereo::side_by_side);
  show(frame_at(-20.0));
  show(frame_at(-20.0));
  EXPECT_EQ(view_.scene()->width(), 200);
  const QImage both = view_.grab().toImage();
  EXPECT_EQ(both.width(), 400);
  // The needle is nearer than the focus: the right eye sees it farther left.
  const Vec3 hub = scene::hub_middle(scene::NeedleLook{.pose = frame_at(-20.0).needle});
  const auto left = scene::Projection(scene::eyes(view_.camera())[0], 200, 300).place(hub);
  const auto right = scene::Projection(scene::eyes(view_.camera())[1], 200, 300).place(hub);
  EXPECT_LT(right->x, left->x);
  QTest::keyClick(&view_, Qt::Key_Y);
  show(frame_at(-20.0));
  EXPECT_EQ(view_.stereo(), scene::Stereo::anaglyph);
  EXPECT_EQ(view_.scene()->width(), 400);
  QTest::keyClick(&view_, Qt::Key_Y);
  show(frame_at(-20.0));
  show(frame_at(-20.0));
  EXPECT_EQ(view_.stereo(), scene::Stereo::off);
  EXPECT_EQ(view_.scene()->picture().pixels.size(), mono.pixels.size());
}

TEST_F(View3dTest, saves_surfaces_and_pictures_or_says_why_not) {
  QTemporaryDir folder;
  EXPECT_TRUE(view_.save_surfaces(folder.path(), scene::SurfaceFormat::stl));
  EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("skin.stl"))));
  EXPECT_FALSE(view_.save_surfaces(QStringLiteral("/proc/no/such"), scene::SurfaceFormat::ply));
  EXPECT_TRUE(view_.save_picture(folder.filePath(QStringLiteral("view.png"))));
  EXPECT_EQ(QImage(folder.filePath(QStringLiteral("view.png"))).size(), view_.size());
  EXPECT_FALSE(view_.save_picture(QStringLiteral("/proc/no/such.png")));
}

TEST_F(View3dTest, a_warning_frames_the_view_in_red) {
  Frame frame = frame_at(20.0);
  frame.warning = Warning{};
  show(frame);
  const QColor corner_colour = view_.grab().toImage().pixelColor(200, 1);
  EXPECT_EQ(corner_colour, Theme::dark().danger);
}

TEST_F(View3dTest, without_a_patient_it_is_plain) {
  view_.set_case(nullptr);
  EXPECT_FALSE(view_.is_ready());
  view_.show_frame(Frame{}, Changes::all());
  EXPECT_EQ(view_.grab().toImage().pixelColor(200, 100), Theme::dark().ground);
}

TEST(OrientationCube, a_click_on_a_letter_gives_its_view) {
  scene::ViewSubject subject;
  const QRectF place(0, 0, 80, 80);
  for (const scene::StandardView view :
       {scene::StandardView::anterior, scene::StandardView::posterior, scene::StandardView::left,
        scene::StandardView::right, scene::StandardView::superior, scene::StandardView::inferior}) {
    EXPECT_EQ(orientation_cube_face(place, scene::standard_view(view, subject).axes(), QPointF(40, 40)), view);
  }
  EXPECT_FALSE(
      orientation_cube_face(place, scene::standard_view(scene::StandardView::left, subject).axes(), QPointF(2, 2)));
}

}  // namespace
}  // namespace bodkin::views
