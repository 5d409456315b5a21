#include "scene/camera.h"

#include "scene/camera_moves.h"
#include <gtest/gtest.h>

namespace bodkin::scene {
namespace {

Camera some_camera() {
  Camera camera;
  camera.eye = Vec3(120.0, 300.0, 40.0);
  camera.focus = Vec3(-3.0, 25.0, -26.0);
  return camera;
}

TEST(Camera, axes_are_right_down_and_away) {
  Camera camera;
  camera.eye = Vec3(0.0, 500.0, 0.0);  // behind a patient who faces to -y
  const Mat3 axes = camera.axes();
  EXPECT_TRUE(axes.col(0).isApprox(-Vec3::UnitX()));  // seen from behind, the patient's right is on the right
  EXPECT_TRUE(axes.col(1).isApprox(-Vec3::UnitZ()));
  EXPECT_TRUE(axes.col(2).isApprox(-Vec3::UnitY()));
  EXPECT_NEAR(some_camera().axes().determinant(), 1.0, 1e-12);
}

TEST(Projection, the_focus_is_in_the_middle_and_a_known_point_where_it_belongs) {
  Camera camera;
  camera.eye = Vec3(0.0, 500.0, 0.0);
  const Projection projection(camera, 800, 600);
  const Place middle = projection.place(Vec3::Zero()).value();
  EXPECT_NEAR(middle.x, 400.0, 1e-9);
  EXPECT_NEAR(middle.y, 300.0, 1e-9);
  EXPECT_NEAR(middle.nearness, 1.0 / 500.0, 1e-12);
  // Half the picture's height is 500 mm tan 15 degrees.
  const double half = 500.0 * std::tan(15.0 * degree);
  const Place top = projection.place(Vec3(-half, 0.0, half)).value();
  EXPECT_NEAR(top.x, 700.0, 1e-9);
  EXPECT_NEAR(top.y, 0.0, 1e-9);
  EXPECT_NEAR(projection.pixels_per_mm(Vec3::Zero()), 300.0 / half, 1e-9);
  EXPECT_FALSE(projection.place(Vec3(0.0, 498.0, 0.0)));
}

TEST(Projection, a_place_leads_back_to_its_point_and_its_ray_meets_it) {
  const Projection projection(some_camera(), 822, 504);
  const Vec3 point(30.0, -10.0, 44.0);
  const Place place = projection.place(point).value();
  EXPECT_LT((projection.point(place) - point).norm(), 1e-9);
  const ViewRay ray = projection.ray(place.x, place.y);
  EXPECT_LT((point - ray.origin).cross(ray.direction).norm(), 1e-9);
}

TEST(Projection, nearness_is_linear_along_a_line_and_a_line_through_the_eye_is_cut) {
  const Projection projection(some_camera(), 822, 504);
  const Vec3 a(-80.0, 10.0, 0.0), b(60.0, 90.0, -50.0);
  const Place first = projection.place(a).value(), last = projection.place(b).value();
  const Place between = projection.place(0.5 * (a + b)).value();
  const double share = (between.pixel() - first.pixel()).norm() / (last.pixel() - first.pixel()).norm();
  EXPECT_NEAR(between.nearness, first.nearness + share * (last.nearness - first.nearness), 1e-12);
  const Vec3 behind = projection.camera().eye + 50.0 * (projection.camera().eye - projection.camera().focus);
  const auto line = projection.line(Vec3::Zero(), behind);
  ASSERT_TRUE(line);
  EXPECT_NEAR(1.0 / (*line)[1].nearness, Projection::nearest, 1e-6);
  EXPECT_FALSE(projection.line(behind, behind + Vec3::UnitX()));
}

TEST(CameraMoves, turning_keeps_the_distance_and_follows_the_pointer) {
  const Camera before = some_camera(), after = turned(before, 0.2, 0.0);
  EXPECT_NEAR(after.distance(), before.distance(), 1e-9);
  EXPECT_EQ(after.focus, before.focus);
  // What is before the focus goes to the right, what is above it and near goes down.
  const Vec3 near = before.focus - 30.0 * before.axes().col(2);
  const Projection first(before, 800, 600), second(after, 800, 600);
  EXPECT_GT(second.place(near)->x, first.place(near)->x + 5.0);
  EXPECT_NEAR(second.place(near)->y, first.place(near)->y, 1e-6);
  const Projection third(turned(before, 0.0, 0.2), 800, 600);
  EXPECT_GT(third.place(near)->y, first.place(near)->y + 5.0);
}

TEST(CameraMoves, panning_moves_the_focal_plane_by_whole_pixels) {
  const Camera before = some_camera(), after = panned(before, 17.0, -9.0, 504);
  const Place place = Projection(after, 822, 504).place(before.focus).value();
  EXPECT_NEAR(place.x, 411.0 + 17.0, 1e-9);
  EXPECT_NEAR(place.y, 252.0 - 9.0, 1e-9);
}

TEST(CameraMoves, zooming_leaves_the_pointed_place_where_it_is) {
  const Camera before = some_camera();
  const Vec3 pointed(20.0, 60.0, -40.0);
  const Camera after = zoomed(before, 1.5, pointed);
  const Place first = Projection(before, 822, 504).place(pointed).value();
  const Place second = Projection(after, 822, 504).place(pointed).value();
  EXPECT_NEAR(first.x, second.x, 1e-9);
  EXPECT_NEAR(first.y, second.y, 1e-9);
  EXPECT_NEAR(second.nearness, 1.5 * first.nearness, 1e-9);
  Camera near = before;
  for (int i = 0; i < 100; ++i) near = zoomed(near, 2.0, pointed);
  EXPECT_NEAR(near.distance(), 60.0, 1e-6);
}

TEST(CameraMoves, standard_views_look_from_where_they_say_with_the_head_up) {
  ViewSubject subject;
  subject.middle = Vec3(1.0, 2.0, 3.0);
  const auto from = [&](StandardView view) {
    const Camera camera = standard_view(view, subject);
    EXPECT_EQ(camera.focus, subject.middle);
    return Vec3((camera.eye - camera.focus).normalized());
  };
  EXPECT_TRUE(from(StandardView::anterior).isApprox(-Vec3::UnitY()));
  EXPECT_TRUE(from(StandardView::posterior).isApprox(Vec3::UnitY()));
  EXPECT_TRUE(from(StandardView::left).isApprox(Vec3::UnitX()));
  EXPECT_TRUE(from(StandardView::right).isApprox(-Vec3::UnitX()));
  EXPECT_TRUE(from(StandardView::superior).isApprox(Vec3::UnitZ()));
  EXPECT_TRUE(from(StandardView::inferior).isApprox(-Vec3::UnitZ()));
  const Camera beside = standard_view(StandardView::operator_side, subject);
  EXPECT_LT(beside.axes().col(1).z(), -0.9);
  EXPECT_NEAR(Projection(beside, 800, 600).pixels_per_mm(subject.middle), 600.0 / subject.height, 1e-9);
  // A needle along the body's axis has no side; the view is still defined.
  subject.direction = Vec3::UnitZ();
  EXPECT_TRUE(standard_view(StandardView::operator_side, subject).eye.allFinite());
}

TEST(CameraMoves, a_flight_begins_and_ends_at_its_cameras_and_stays_finite) {
  ViewSubject subject;
  const Camera from = standard_view(StandardView::anterior, subject),
               to = standard_view(StandardView::posterior, subject);
  const CameraFlight flight(from, to, 0.4);
  EXPECT_LT((flight.at(0.0).eye - from.eye).norm(), 1e-6);
  EXPECT_EQ(flight.at(0.4), to);
  EXPECT_TRUE(flight.ended(0.4));
  EXPECT_FALSE(flight.ended(0.39));
  for (double t = 0.0; t < 0.4; t += 0.01) {
    EXPECT_TRUE(flight.at(t).eye.allFinite());
    EXPECT_NEAR(flight.at(t).distance(), from.distance(), 1e-6);
  }
}

}  // namespace
}  // namespace bodkin::scene
