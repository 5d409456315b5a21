// A probe placed on the skin, slid over it and swept, on a body with a known skin.
#include "imaging/ultrasound_screen/probe_on_skin.h"

#include <cmath>

#include <gtest/gtest.h>

#include "anatomy/tissue.h"
#include "core/error.h"
#include "imaging/ultrasound/probe.h"
#include "imaging/ultrasound_screen/scan_view.h"
#include "imaging/ultrasound_screen/skin.h"
#include "imaging/ultrasound_screen/sweep.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

constexpr double body_radius = 60.0;  // mm

// A cylinder along z through the origin, and a couch: a thin plate 25 mm behind it.
TissueVolume cylinder() {
  Grid grid;
  grid.size = {101, 101, 61};
  grid.spacing = Vec3::Constant(2.0);
  grid.origin = Vec3(-100, -100, -60);
  TissueVolume tissues(grid, tissue::air);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 at = grid.to_patient(Vec3(i, j, k));
        if (std::hypot(at.x(), at.y()) < body_radius) tissues.at(i, j, k) = tissue::muscle;
        if (at.y() > 84.0 && at.y() < 88.0) tissues.at(i, j, k) = tissue::soft;
      }
    }
  }
  return tissues;
}

TEST(Skin, is_found_from_inside_and_a_couch_is_none) {
  const TissueVolume tissues = cylinder();
  const auto skin = skin_along(tissues, Vec3(0, 0, 0), Vec3(0, 3, 0));
  ASSERT_TRUE(skin);
  EXPECT_NEAR((skin->place - Vec3(0, body_radius, 0)).norm(), 0.0, 1.5);
  EXPECT_GT(skin->outward.y(), 0.98);
  EXPECT_FALSE(skin_along(tissues, Vec3(0, 75, 0), Vec3(0, 1, 0)));  // begins in air
  EXPECT_FALSE(skin_along(tissues, Vec3(0, 0, 0), Vec3(0, 0, 1)));   // the image ends first
  EXPECT_FALSE(skin_along(tissues, Vec3(0, 0, 0), Vec3::Zero()));
  EXPECT_FALSE(skin_along(tissues, Vec3(0, 0, 900), Vec3(0, 1, 0)));  // outside
}

TEST(Skin, is_found_from_both_of_its_sides) {
  const TissueVolume tissues = cylinder();
  for (const double start : {40.0, 59.0, 61.0, 70.0}) {
    const auto skin = skin_near(tissues, Vec3(0, start, 10), Vec3::UnitY(), 25.0);
    ASSERT_TRUE(skin) << start;
    EXPECT_NEAR(skin->place.y(), body_radius, 1.5) << start;
  }
  EXPECT_FALSE(skin_near(tissues, Vec3(0, 20, 10), Vec3::UnitY(), 25.0));
  EXPECT_FALSE(skin_near(tissues, Vec3::Constant(std::nan("")), Vec3::UnitY(), 25.0));
}

TEST(ProbeOnSkin, slides_around_the_body_and_keeps_its_angle_to_the_skin) {
  const TissueVolume tissues = cylinder();
  const auto skin = skin_along(tissues, Vec3::Zero(), Vec3::UnitY());
  ASSERT_TRUE(skin);
  // Marked side to the patient's right: sliding along it goes around the cylinder.
  ProbeOnSkin hand(probe_pose(skin->place, -Vec3::UnitY(), -Vec3::UnitX()), skin->outward);
  for (int step = 0; step < 25; ++step) ASSERT_TRUE(hand.slide(tissues, 2.0, 0.0)) << step;
  const Vec3 face = hand.pose().translation();
  EXPECT_NEAR(std::hypot(face.x(), face.y()), body_radius, 2.0);
  EXPECT_NEAR(std::atan2(-face.x(), face.y()), 50.0 / body_radius, 0.1);
  const Vec3 inwards = -Vec3(face.x(), face.y(), 0.0).normalized();
  EXPECT_GT(hand.pose().linear().col(1).dot(inwards), std::cos(8.0 * degree));
  EXPECT_NEAR(hand.pose().linear().determinant(), 1.0, 1e-9);
}

TEST(ProbeOnSkin, stops_where_there_is_no_skin) {
  const TissueVolume tissues = cylinder();
  const auto skin = skin_along(tissues, Vec3(0, 0, 50), Vec3::UnitY());
  ASSERT_TRUE(skin);
  ProbeOnSkin hand(probe_pose(skin->place, -Vec3::UnitY(), Vec3::UnitZ()), skin->outward);
  bool stopped = false;
  for (int step = 0; step < 10 && !stopped; ++step) stopped = !hand.slide(tissues, 3.0, 0.0);
  EXPECT_TRUE(stopped);
  EXPECT_LT(hand.pose().translation().z(), 62.0);
  EXPECT_FALSE(hand.slide(tissues, 0.0, 0.0));
}

TEST(ProbeOnSkin, far_from_the_skin_it_moves_freely_and_finds_back) {
  const TissueVolume tissues = cylinder();
  ProbeOnSkin hand(probe_pose(Vec3(-90, 58, 0), -Vec3::UnitY(), Vec3::UnitX()));
  for (int step = 0; step < 30; ++step) ASSERT_TRUE(hand.slide(tissues, 3.0, 0.0)) << step;
  const Vec3 face = hand.pose().translation();
  EXPECT_NEAR(std::hypot(face.x(), face.y()), body_radius, 2.0);
}

TEST(ProbeOnSkin, is_pressed_along_its_depth_and_turned_on_the_spot) {
  ProbeOnSkin hand(probe_pose(Vec3(1, 2, 3), -Vec3::UnitY(), Vec3::UnitZ()));
  hand.press(5.0);
  EXPECT_NEAR((hand.pose().translation() - Vec3(1, -3, 3)).norm(), 0.0, 1e-12);
  hand.press(1000.0);
  EXPECT_EQ(hand.press(), 40.0);
  hand.press(0.0);
  hand.rotate(30.0 * degree);
  EXPECT_NEAR((hand.pose().linear().col(1) - Vec3(0, -1, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(hand.pose().linear().col(0).dot(Vec3::UnitZ()), std::cos(30.0 * degree), 1e-12);
  const Vec3 marked = hand.pose().linear().col(0), across = hand.pose().linear().col(2);
  hand.tilt(10.0 * degree);
  EXPECT_NEAR((hand.pose().linear().col(0) - marked).norm(), 0.0, 1e-12);
  hand.tilt(-10.0 * degree);
  hand.rock(10.0 * degree);
  EXPECT_NEAR((hand.pose().linear().col(2) - across).norm(), 0.0, 1e-12);
  EXPECT_NEAR((hand.pose().translation() - Vec3(1, 2, 3)).norm(), 0.0, 1e-12);
}

Case a_patient() {
  Case patient;
  patient.tissues = cylinder();
  patient.description.procedure.path = NeedlePath{Vec3(0, 60, -10), Vec3(0, 10, 0)};
  patient.description.landmarks = {{"here", Vec3(5, 5, 5)}};
  return patient;
}

TEST(ScanView, every_view_stands_on_the_skin_and_looks_inside) {
  const Case patient = a_patient();
  UltrasoundProbe probe;
  probe.pitch = 0.25;
  for (const char* name : {"paramedian", "sagittal", "transverse", "needle"}) {
    const std::optional<ScanView> view = scan_view_from(name);
    ASSERT_TRUE(view) << name;
    const Pose pose = place_probe(patient, probe, {*view, std::nullopt, std::nullopt}).pose();
    const Vec3 face = pose.translation();
    EXPECT_NEAR(std::hypot(face.x(), face.y()), body_radius, 2.0) << name;
    const Vec3 to_target = (Vec3(0, 10, 0) - face).normalized();
    EXPECT_GT(pose.linear().col(1).dot(to_target), *view == ScanView::needle ? 0.9 : 0.99) << name;
  }
  const Pose lengthwise = place_probe(patient, probe, {ScanView::sagittal, std::nullopt, std::nullopt}).pose();
  EXPECT_GT(lengthwise.linear().col(0).z(), 0.9);
  const Pose across = place_probe(patient, probe, {ScanView::transverse, std::nullopt, std::nullopt}).pose();
  EXPECT_LT(across.linear().col(0).x(), -0.99);
  // The needle lies in the slice of its view.
  const Pose beside = place_probe(patient, probe, {ScanView::needle, std::nullopt, std::nullopt}).pose();
  for (const Vec3& point : {patient.description.procedure.path->entry, patient.description.procedure.path->target}) {
    EXPECT_LT(std::abs((beside.inverse() * point).z()), 0.5);
  }
}

TEST(ScanView, what_is_missing_is_one_sentence) {
  Case patient = a_patient();
  EXPECT_TRUE(place_named(patient, "here"));
  EXPECT_FALSE(place_named(patient, "there"));
  EXPECT_FALSE(scan_view_from("upside_down"));
  const UltrasoundProbe probe;
  const auto refused = [&](const ScanRequest& request, const std::string& words) {
    try {
      place_probe(patient, probe, request);
      FAIL() << words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  refused({ScanView::kidney, std::nullopt, std::nullopt}, "kidney");
  refused({ScanView::sagittal, Vec3(0, 75, 0), std::nullopt}, "not in the body");
  refused({ScanView::sagittal, Vec3(0, 0, 0), Vec3::UnitZ()}, "CT ends");
  patient.description.procedure.path.reset();
  refused({ScanView::needle, std::nullopt, std::nullopt}, "planned path");
}

TEST(Sweep, goes_from_the_first_pose_to_the_last_evenly_in_time) {
  const TissueVolume tissues = cylinder();
  const Pose first = probe_pose(Vec3(0, 58, -20), -Vec3::UnitY(), Vec3::UnitZ());
  SweepMotion motion;
  motion.to = Vec3(30, 58, 20);
  motion.tilt = {-10.0 * degree, 10.0 * degree};
  motion.frames = 5;
  motion.rate = 10.0;
  const std::vector<SweepPose> poses = sweep_of(first, motion, tissues);
  ASSERT_EQ(poses.size(), 5U);
  EXPECT_NEAR(poses[4].time, 0.4, 1e-12);
  EXPECT_NEAR((poses[0].pose.translation() - first.translation()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((poses[2].pose.translation() - Vec3(15, 58, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((poses[4].pose.translation() - Vec3(30, 58, 20)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((poses[2].pose.linear() - first.linear()).norm(), 0.0, 1e-12);
  EXPECT_NEAR(poses[4].pose.linear().col(1).dot(first.linear().col(1)), std::cos(10.0 * degree), 1e-12);
  motion.on_skin = true;
  // 2 mm below the skin at the beginning, and so everywhere; the skin at x = 30 is at 52 mm.
  EXPECT_NEAR(sweep_of(first, motion, tissues)[4].pose.translation().y(), std::sqrt(3600.0 - 900.0) - 2.0, 2.0);
  motion.frames = 0;
  EXPECT_THROW(sweep_of(first, motion, tissues), InputError);
}

}  // namespace
}  // namespace bodkin
