#include "views/slice_view.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "tests/views/made_up.h"
#include "views/theme.h"
#include <gtest/gtest.h>

namespace bodkin::views {
namespace {

using bodkin_test::frame_at;
using bodkin_test::layered_hounsfield;

// A view of a known size that shows the layered patient and a frame.
struct ShownSlice {
  SliceView view;

  explicit ShownSlice(SliceKind kind, const Frame& frame = frame_at(20.0)) : view(kind) {
    view.resize(400, 300);
    view.set_case(bodkin_test::layered_patient());
    view.show_frame(frame, Changes::all());
  }
  QImage picture() { return view.grab().toImage(); }
};

int expected_grey(const Vec3& point, const SliceLook& look) {
  return grey_of(layered_hounsfield(point), look.window, look.level);
}

TEST(SliceView, a_pixel_shows_the_value_of_its_place_through_window_and_level) {
  for (const SliceKind kind : {SliceKind::axial, SliceKind::coronal, SliceKind::sagittal, SliceKind::along_needle}) {
    ShownSlice slice(kind);
    SliceLook look = slice.view.look();
    look.window = 400.0;
    look.level = 60.0;
    look.tints = false;
    slice.view.set_look(look);
    const QImage picture = slice.picture();
    // Away from needle, crosshair and text.
    for (const QPoint place : {QPoint(120, 60), QPoint(300, 90), QPoint(140, 220), QPoint(290, 200)}) {
      const Vec3 point = slice.view.to_patient(QPointF(place) + QPointF(0.5, 0.5));
      if (point.cwiseAbs().maxCoeff() > 49.0) continue;
      EXPECT_NEAR(qRed(picture.pixel(place)), expected_grey(point, look), 1.5) << static_cast<int>(kind);
    }
  }
}

TEST(SliceView, of_a_patient_who_breathes_shows_what_has_moved_there) {
  auto open = std::make_shared<OpenCase>(*bodkin_test::layered_patient());
  anatomy::Breathing breathing;
  breathing.centre = Vec3(0.0, 10.0, 0.0);
  breathing.motion = Vec3(3.0, -4.0, -9.0);
  breathing.radius = 40.0;
  open->patient.description.breathing = breathing;
  for (const SliceKind kind : {SliceKind::axial, SliceKind::coronal, SliceKind::sagittal}) {
    Frame frame = frame_at(20.0);
    ShownSlice slice(kind, frame);
    slice.view.set_case(open);
    SliceLook look = slice.view.look();
    look.window = 400.0;
    look.level = 60.0;
    look.tints = look.hatched = false;
    slice.view.set_look(look);
    slice.view.show_frame(frame, Changes::all());
    const QImage breathed_out = slice.picture();
    frame.drawn_in = 0.75;
    slice.view.show_frame(frame, {});
    const QImage picture = slice.picture();
    EXPECT_NE(picture, breathed_out);
    for (const QPoint place :
         {QPoint(120, 60), QPoint(300, 90), QPoint(140, 220), QPoint(290, 200), QPoint(230, 120)}) {
      const Vec3 point = slice.view.to_patient(QPointF(place) + QPointF(0.5, 0.5));
      if (point.cwiseAbs().maxCoeff() > 40.0) continue;
      Vec3 material = point;
      for (int i = 0; i < 60; ++i) {
        const double inside = std::max(0.0, 1.0 - (material - breathing.centre).squaredNorm() / 1600.0);
        material = point - 0.75 * inside * inside * breathing.motion;
      }
      EXPECT_NEAR(qRed(picture.pixel(place)), expected_grey(material, look), 1.5) << static_cast<int>(kind);
    }
    frame.drawn_in = 0.0;
    slice.view.show_frame(frame, {});
    EXPECT_EQ(slice.picture(), breathed_out);
  }
}

// A probe moved everything by the same vector: each pixel shows the tissue that has moved there.
TEST(SliceView, of_a_patient_who_is_pressed_shows_what_has_moved_there) {
  const Vec3 moved(6.0, -3.0, -4.0);
  const imaging::PointLattice lattice =
      imaging::lattice_around({Vec3::Constant(-60.0), Vec3::Constant(60.0)}, 20.0, 1000);
  std::vector<float> displacements;
  for (std::size_t point = 0; point < lattice.points().size(); ++point)
    for (Eigen::Index axis = 0; axis < 3; ++axis) displacements.push_back(static_cast<float>(moved[axis]));
  for (const SliceKind kind : {SliceKind::axial, SliceKind::coronal, SliceKind::sagittal}) {
    Frame frame = frame_at(20.0);
    ShownSlice slice(kind, frame);
    SliceLook look = slice.view.look();
    look.window = 400.0;
    look.level = 60.0;
    look.tints = look.hatched = false;
    slice.view.set_look(look);
    const QImage at_rest = slice.picture();
    frame.moved_tissue = std::make_shared<const imaging::TissueDisplacement>(lattice, displacements);
    slice.view.show_frame(frame, {});
    const QImage picture = slice.picture();
    for (const QPoint place : {QPoint(120, 60), QPoint(300, 90), QPoint(140, 220), QPoint(290, 200)}) {
      const Vec3 point = slice.view.to_patient(QPointF(place) + QPointF(0.5, 0.5));
      if (point.cwiseAbs().maxCoeff() > 40.0) continue;
      EXPECT_NEAR(qRed(picture.pixel(place)), expected_grey(point - moved, look), 1.5) << static_cast<int>(kind);
    }
    frame.moved_tissue = nullptr;
    slice.view.show_frame(frame, {});
    EXPECT_EQ(slice.picture(), at_rest);
  }
}

TEST(SliceView, the_slice_at_the_tip_shows_the_voxel_of_the_tip) {
  for (const SliceKind kind : {SliceKind::axial, SliceKind::coronal, SliceKind::sagittal}) {
    const Frame frame = frame_at(20.0);
    ShownSlice slice(kind, frame);
    const Vec3 tip = frame.needle.translation();
    EXPECT_NEAR(slice.view.plane().distance(tip), 0.0, 1e-9);
    const QPointF at = slice.view.to_widget(tip);
    EXPECT_NEAR((slice.view.to_patient(at) - tip).norm(), 0.0, 1e-9);
    // The image under the needle's tip.
    SliceImage image;
    image.set_case(bodkin_test::layered_patient());
    SliceLook look;
    look.tints = look.hatched = false;
    const QImage picture = image.picture(slice.view.plane(), look);
    const QRgb pixel = picture.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
    EXPECT_NEAR(qRed(pixel), expected_grey(tip, look), 1.5);
    // Over it the tip has the colour of its tissue.
    const QColor drawn = slice.picture().pixelColor(at.toPoint());
    const QColor muscle = tissue_colour(anatomy::tissue::muscle, bodkin_test::layered_patient()->patient.library);
    EXPECT_NEAR(drawn.red(), muscle.red(), 12);
    EXPECT_NEAR(drawn.green(), muscle.green(), 12);
  }
}

// The ring around the target has the case's tolerance as its radius, wherever the slice is centred.
TEST(SliceView, the_target_is_ringed_by_its_tolerance) {
  const QColor teal = Theme::dark().plan;
  for (const SliceKind kind : {SliceKind::axial, SliceKind::coronal, SliceKind::sagittal}) {
    for (const double tolerance : {5.0, 9.0}) {
      Frame frame = frame_at(0.0);
      frame.has_needle = frame.follows_tip = false;
      frame.target_tolerance = tolerance;
      frame.plan->target += Vec3(6.0, -1.0, 4.0);
      ShownSlice slice(kind, frame);
      // The crosshair lies in the slice through the target, away from the target.
      const Vec3 aside(21.0, 13.0, 17.0), normal = slice.view.plane().normal();
      frame.crosshair = frame.plan->target + aside - aside.dot(normal) * normal;
      slice.view.show_frame(frame, Changes::all());
      const imaging::SlicePlane plane = slice.view.plane();
      const QImage picture = slice.picture();
      const auto is_teal = [&](const Vec3& place) {
        const QPointF at = slice.view.to_widget(place);
        for (int y = -1; y <= 1; ++y) {
          for (int x = -1; x <= 1; ++x) {
            const QPoint pixel(static_cast<int>(at.x()) + x, static_cast<int>(at.y()) + y);
            if (!picture.rect().contains(pixel)) continue;
            const QColor ink = picture.pixelColor(pixel);
            if (std::abs(ink.red() - teal.red()) < 60 && std::abs(ink.green() - teal.green()) < 60 &&
                std::abs(ink.blue() - teal.blue()) < 60)
              return true;
          }
        }
        return false;
      };
      const Vec3 back = frame.plan->entry - frame.plan->target;  // along the drawn path, which ends at the ring
      const Vec3 on_plane = (back - back.dot(normal) * normal).normalized();
      int ringed = 0, inside = 0, outside = 0, directions = 0;
      for (int degrees = 0; degrees < 360; degrees += 10) {
        const double angle = degrees * degree;
        const Vec3 way = std::cos(angle) * plane.right + std::sin(angle) * plane.down;
        if (way.dot(on_plane) > 0.7) continue;
        ++directions;
        ringed += is_teal(frame.plan->target + tolerance * way) ? 1 : 0;
        inside += is_teal(frame.plan->target + 0.6 * tolerance * way) ? 1 : 0;
        outside += is_teal(frame.plan->target + 1.4 * tolerance * way) ? 1 : 0;
      }
      EXPECT_GT(directions, 20);
      EXPECT_EQ(ringed, directions) << static_cast<int>(kind) << ", " << tolerance << " mm";
      EXPECT_EQ(inside, 0) << static_cast<int>(kind) << ", " << tolerance << " mm";
      EXPECT_EQ(outside, 0) << static_cast<int>(kind) << ", " << tolerance << " mm";
    }
  }
}

TEST(SliceView, an_attempt_whose_plan_is_hidden_does_not_begin_at_it) {
  OpenCase aside = *bodkin_test::layered_patient();
  const Vec3 off(25.0, 0.0, 0.0);  // from the centre of the image
  anatomy::NeedlePath& path = *aside.patient.description.procedure.path;
  path = {path.entry + off, path.target + off};
  const auto patient = std::make_shared<const OpenCase>(aside);
  const auto off_centre = [&](bool is_shown) {
    SliceView view(SliceKind::axial);
    view.resize(400, 300);
    view.set_case(patient);
    Frame frame = frame_at(0.0);
    frame.has_needle = frame.follows_tip = false;
    frame.crosshair = Vec3::Zero();
    frame.plan.reset();
    if (is_shown) frame.plan = path;
    view.show_frame(frame, Changes::all());
    return std::abs(view.to_widget(Vec3::Zero()).x() - 200.0);
  };
  EXPECT_LT(off_centre(false), 3.0) << "pixels";
  EXPECT_GT(off_centre(true), 20.0) << "with the plan it is the way to the target that is shown";
}

TEST(SliceView, the_conus_is_lettered_in_the_planes_that_pass_near_it) {
  const auto amber = [](const std::shared_ptr<const OpenCase>& patient, SliceKind kind, bool tints) {
    SliceView view(kind);
    view.resize(400, 300);
    view.set_case(patient);
    SliceLook look = view.look();
    look.tints = tints;
    view.set_look(look);
    view.show_frame(frame_at(20.0), Changes::all());
    const QImage picture = view.grab().toImage();
    const QColor ink = Theme::dark().caution;
    // To the right of the landmark, where the word is.
    const QPoint at = view.to_widget(patient->description().landmarks.front().position).toPoint();
    int pixels = 0;
    for (int y = at.y() - 12; y < at.y() + 12; ++y)
      for (int x = at.x() + 4; x < at.x() + 70; ++x)
        if (picture.rect().contains(x, y)) pixels += picture.pixelColor(x, y) == ink ? 1 : 0;
    return pixels;
  };
  OpenCase with_conus = *bodkin_test::layered_patient();
  const Vec3 tip = frame_at(20.0).needle.translation();
  with_conus.patient.description.landmarks = {{"conus", tip + Vec3(1.0, -8.0, 12.0)}};
  const auto patient = std::make_shared<const OpenCase>(with_conus);
  EXPECT_GT(amber(patient, SliceKind::sagittal, true), 15);
  EXPECT_EQ(amber(patient, SliceKind::axial, true), 0) << "12 mm from the plane";
  EXPECT_EQ(amber(patient, SliceKind::sagittal, false), 0) << "the CT alone";
}

TEST(SliceView, the_needle_is_white_along_the_computed_line) {
  Frame frame = frame_at(25.0);
  const Vec3 axis = Vec3(0.0, -0.95, 0.3).normalized();
  frame.needle = needle_pose(frame.needle.translation(), axis);
  ShownSlice slice(SliceKind::sagittal, frame);
  const QImage picture = slice.picture();
  int white = 0, checked = 0;
  for (double along = 3.0; along < 40.0; along += 0.5) {
    const QPointF at = slice.view.to_widget(frame.needle.translation() - along * axis);
    if (!picture.rect().adjusted(4, 4, -4, -4).contains(at.toPoint())) continue;
    if (std::abs(std::remainder(along, 10.0)) < 2.0) continue;  // a tick
    ++checked;
    white += qGreen(picture.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()))) > 190 ? 1 : 0;
    // The dark border next to the needle.
    const QPointF across(axis.z(), axis.y());
    const QPointF edge = at + 2.0 * QPointF(across.x(), across.y());
    EXPECT_LT(qGreen(picture.pixel(static_cast<int>(edge.x()), static_cast<int>(edge.y()))), 140) << along;
  }
  EXPECT_GT(checked, 30);
  EXPECT_EQ(white, checked);
}

TEST(SliceView, a_distance_that_was_clicked_reads_50_mm) {
  ShownSlice slice(SliceKind::axial);
  auto measures = std::make_shared<Measures>();
  slice.view.set_measures(measures);
  QSignalSpy spy(&slice.view, &SliceView::measures_changed);
  const double pixel = slice.view.plane().pixel;
  const QPoint from(60, 150);
  const QPoint to(from.x() + static_cast<int>(std::lround(50.0 / pixel)), 150);
  QTest::keyClick(&slice.view, Qt::Key_M);
  QTest::mouseClick(&slice.view, Qt::LeftButton, {}, from);
  QTest::mouseClick(&slice.view, Qt::LeftButton, {}, to);
  ASSERT_EQ(measures->all().size(), 1U);
  EXPECT_NEAR(value_of(measures->all()[0]), 50.0, pixel);
  EXPECT_GE(spy.count(), 3);

  // The measurement stays; X deletes it under the pointer.
  QTest::mouseMove(&slice.view, QPoint(200, 250));
  QTest::keyClick(&slice.view, Qt::Key_X);
  EXPECT_EQ(measures->all().size(), 1U);
  QMouseEvent over(QEvent::MouseMove, QPointF(120, 151), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(&slice.view, &over);
  QTest::keyClick(&slice.view, Qt::Key_X);
  EXPECT_TRUE(measures->all().empty());
}

TEST(SliceView, a_right_click_cancels_what_is_being_measured) {
  ShownSlice slice(SliceKind::axial);
  auto measures = std::make_shared<Measures>();
  slice.view.set_measures(measures);
  QTest::keyClick(&slice.view, Qt::Key_Q);
  QTest::mouseClick(&slice.view, Qt::LeftButton, {}, QPoint(60, 150));
  EXPECT_TRUE(measures->waiting());
  QTest::mouseClick(&slice.view, Qt::RightButton, {}, QPoint(90, 150));
  EXPECT_FALSE(measures->waiting());
  EXPECT_TRUE(measures->all().empty());
}

TEST(SliceView, a_right_drag_sets_the_window_and_brackets_choose_presets) {
  ShownSlice slice(SliceKind::axial);
  const SliceLook before = slice.view.look();
  QTest::mousePress(&slice.view, Qt::RightButton, {}, QPoint(100, 100));
  QMouseEvent drag(QEvent::MouseMove, QPointF(150, 140), Qt::NoButton, Qt::RightButton, Qt::NoModifier);
  QApplication::sendEvent(&slice.view, &drag);
  QTest::mouseRelease(&slice.view, Qt::RightButton, {}, QPoint(150, 140));
  EXPECT_GT(slice.view.look().window, before.window) << "to the right: wider";
  EXPECT_LT(slice.view.look().level, before.level) << "down: lower, so the picture is brighter";
  QTest::keyClick(&slice.view, Qt::Key_BracketRight);
  EXPECT_EQ(slice.view.look().window, window_presets[0].window);
  QTest::keyClick(&slice.view, Qt::Key_BracketRight);
  EXPECT_EQ(slice.view.look().window, window_presets[1].window);
  QTest::keyClick(&slice.view, Qt::Key_BracketLeft);
  EXPECT_EQ(slice.view.look().level, window_presets[0].level);
}

TEST(SliceView, the_wheel_pushes_the_needle_in_an_attempt_and_scrolls_with_alt) {
  ShownSlice slice(SliceKind::axial);
  QSignalSpy pushed(&slice.view, &View::pushed);
  int moved = 0;
  QObject::connect(&slice.view, &View::crosshair_moved, [&] { ++moved; });
  const auto wheel = [&](int delta, Qt::KeyboardModifiers modifiers) {
    QWheelEvent event(QPointF(200, 100), QPointF(200, 100), QPoint(), QPoint(0, delta), Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&slice.view, &event);
  };
  wheel(-120, Qt::NoModifier);
  ASSERT_EQ(pushed.count(), 1);
  EXPECT_EQ(pushed[0][0].toDouble(), 1.0) << "down is in";
  EXPECT_FALSE(pushed[0][1].toBool());
  wheel(-120, Qt::ShiftModifier);
  EXPECT_TRUE(pushed[1][1].toBool());
  EXPECT_EQ(moved, 0);
  wheel(-120, Qt::AltModifier);
  EXPECT_EQ(moved, 1);
  EXPECT_EQ(pushed.count(), 2);
}

TEST(SliceView, zooming_keeps_what_is_under_the_pointer) {
  ShownSlice slice(SliceKind::coronal);
  const QPointF pointer(300, 80);
  const Vec3 before = slice.view.to_patient(pointer);
  const double field = slice.view.field();
  QWheelEvent event(pointer, pointer, QPoint(), QPoint(0, 240), Qt::NoButton, Qt::ControlModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(&slice.view, &event);
  EXPECT_LT(slice.view.field(), field);
  EXPECT_NEAR((slice.view.to_patient(pointer) - before).norm(), 0.0, 1e-9);
}

TEST(SliceView, a_left_click_asks_for_the_crosshair_there) {
  ShownSlice slice(SliceKind::sagittal);
  Vec3 asked = Vec3::Zero();
  QObject::connect(&slice.view, &View::crosshair_moved, [&](const Vec3& point) { asked = point; });
  QTest::mouseClick(&slice.view, Qt::LeftButton, {}, QPoint(120, 90));
  EXPECT_NEAR((asked - slice.view.to_patient(QPointF(120, 90))).norm(), 0.0, 1e-9);
}

TEST(SliceView, says_so_when_no_patient_is_open) {
  SliceView view(SliceKind::axial);
  view.resize(300, 200);
  EXPECT_FALSE(view.grab().isNull());
  view.set_case(bodkin_test::layered_patient());
  view.set_case(nullptr);
  view.show_frame(Frame{}, Changes::all());
  EXPECT_FALSE(view.grab().isNull());
}

TEST(SliceImage, computes_again_only_what_has_changed) {
  SliceImage image;
  image.set_case(bodkin_test::layered_patient());
  const imaging::SlicePlane plane = slice_plane(SliceKind::axial, {Vec3::Zero(), 80.0, 160, 120}, Vec3(0, -1, 0));
  SliceLook look;
  image.picture(plane, look);
  image.picture(plane, look);
  EXPECT_EQ(image.sampled(), 1);
  EXPECT_EQ(image.painted(), 1);
  look.level = 200.0;
  image.picture(plane, look);
  EXPECT_EQ(image.sampled(), 1);
  EXPECT_EQ(image.painted(), 2);
  look.slab.thickness = 10.0;
  image.picture(plane, look);
  EXPECT_EQ(image.sampled(), 2);
}

TEST(SliceImage, what_must_not_be_met_is_hatched) {
  SliceImage image;
  image.set_case(bodkin_test::layered_patient());
  const imaging::SlicePlane plane =
      slice_plane(SliceKind::sagittal, {Vec3(0, -25, 20), 40.0, 160, 160}, Vec3(0, -1, 0));
  SliceLook look;
  look.tints = false;
  const QImage hatched = image.picture(plane, look);
  look.hatched = false;
  const QImage plain = image.picture(plane, look);
  int inside = 0, outside = 0, marked_inside = 0, marked_outside = 0;
  for (int row = 0; row < 160; ++row) {
    for (int column = 0; column < 160; ++column) {
      const Vec3 point = plane.point(column, row);
      const double beside = std::hypot(point.y() + 25.0, point.z() - 20.0);
      const bool marked = hatched.pixel(column, row) != plain.pixel(column, row);
      if (beside < 3.0) {
        ++inside;
        marked_inside += marked ? 1 : 0;
      } else if (beside > 5.5) {
        ++outside;
        marked_outside += marked ? 1 : 0;
      }
    }
  }
  EXPECT_GT(inside, 300);
  EXPECT_NEAR(static_cast<double>(marked_inside) / inside, 2.0 / 9.0, 0.04);
  EXPECT_EQ(marked_outside, 0);
}

}  // namespace
}  // namespace bodkin::views
