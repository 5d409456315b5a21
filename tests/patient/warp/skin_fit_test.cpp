// A patient in the skin of another body: elliptic cylinders with known skins.
#include "patient/warp/skin_fit.h"

#include <cmath>
#include <functional>
#include <random>

#include "patient/warp/warped_case.h"
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin::patient {
namespace {

using anatomy::tissue::fat;
using anatomy::tissue::muscle;

// Bodies along z between the ends of the volume, 2 mm a voxel; the back is towards +y.
anatomy::TissueVolume cylinder(double across, double deep, double hump, const Pose& placed = Pose::Identity()) {
  anatomy::Grid grid;
  grid.size = {140, 110, 110};
  grid.spacing = Vec3::Constant(2.0);
  grid.direction = placed.linear();
  grid.origin = placed * Vec3(-139.0, -109.0, -109.0);
  anatomy::TissueVolume tissues(grid);
  const Pose back = placed.inverse();
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 at = back * grid.to_patient(Vec3(i, j, k));
        const double depth = deep + hump * std::exp(-(at.x() * at.x() + at.z() * at.z()) / (2.0 * 40.0 * 40.0));
        const double share = std::hypot(at.x() / across, at.y() / (at.y() > 0.0 ? depth : deep));
        if (share < 1.0) tissues.at(i, j, k) = share < 0.8 ? muscle : fat;
      }
    }
  }
  return tissues;
}

TEST(SkinFit, a_body_that_is_only_moved_is_found_and_keeps_every_voxel) {
  Pose placed = Pose::Identity();
  placed.linear() = Eigen::AngleAxisd(0.12, Vec3(0.2, 1.0, 0.3).normalized()).toRotationMatrix();
  placed.translation() = Vec3(6.0, 15.0, -8.0);
  const anatomy::TissueVolume patient = cylinder(110.0, 80.0, 12.0), body = cylinder(110.0, 80.0, 12.0, placed);
  Pose start = placed;
  start.translation() += Vec3(3.0, 4.0, -3.0);
  const SkinFit fit(skin_of(patient), skin_of(body), start, Vec3(0.0, 92.0, 0.0), {});
  EXPECT_GT(fit.at_start().rms, 2.0);
  EXPECT_LT(fit.when_moved().rms, 0.2);
  EXPECT_LT(fit.when_bent().p95, 0.3);
  anatomy::Case of_patient;
  of_patient.tissues = patient;
  of_patient.ct = anatomy::CtVolume(patient.grid, std::int16_t{40});
  const anatomy::Case made = warped_case(of_patient, fit);
  std::size_t other = 0;
  for (std::size_t i = 0; i < patient.voxels.size(); ++i)
    other += patient.voxels[i] != made.tissues.voxels[i] ? 1U : 0U;
  EXPECT_LT(static_cast<double>(other), 0.002 * static_cast<double>(patient.voxels.size()));
}

TEST(SkinFit, brings_skin_to_skin_and_its_two_directions_are_one_map) {
  Pose placed = Pose::Identity();
  placed.linear() = Eigen::AngleAxisd(0.1, Vec3::UnitZ()).toRotationMatrix();
  placed.translation() = Vec3(4.0, 10.0, 0.0);
  const anatomy::TissueVolume patient = cylinder(105.0, 75.0, 0.0), body = cylinder(118.0, 84.0, 14.0, placed);
  const Vec3 entry(0.0, 75.0, 0.0);
  const SkinFit fit(skin_of(patient), skin_of(body), placed, entry, {});
  EXPECT_GT(fit.when_moved().rms, 1.5) << "these differ in shape";
  EXPECT_LT(fit.when_bent().rms, 0.25);
  EXPECT_LT(fit.when_bent().p95, 0.5);
  EXPECT_GE(fit.pairs(), 50U);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> along(-60.0, 60.0), deep(0.0, 60.0);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 place = entry + Vec3(along(random), -deep(random), along(random));
    EXPECT_LT((fit.to_patient(fit.to_body(place)) - place).norm(), 1e-5);
  }
  // Seen from outside, in the voxels: the warped body's surface is the mannequin's.
  anatomy::Case of_patient;
  of_patient.tissues = patient;
  of_patient.ct = anatomy::CtVolume(patient.grid, std::int16_t{40});
  of_patient.description.procedure.path = anatomy::NeedlePath{entry, entry - Vec3(0.0, 40.0, 0.0)};
  const anatomy::Case made = warped_case(of_patient, fit);
  const auto height = [&](const anatomy::TissueVolume& volume, double x, double z) {
    double y = 120.0;
    while (y > 0.0 && anatomy::nearest<anatomy::TissueId>(volume, placed * Vec3(x, y, z), 0) == 0) y -= 0.1;
    return y;
  };
  double sum = 0.0, squares = 0.0;
  int columns = 0;
  for (double x = -60.0; x <= 60.0; x += 4.0) {
    for (double z = -60.0; z <= 60.0; z += 4.0, ++columns) {
      const double missed = height(made.tissues, x, z) - height(body, x, z);
      sum += missed;
      squares += missed * missed;
    }
  }
  EXPECT_LT(std::abs(sum / columns), 0.3) << "mm";
  EXPECT_LT(std::sqrt(squares / columns), 1.3) << "mm, of voxels of 2 mm";
  EXPECT_NEAR(made.description.procedure.path->length(), 40.0, 1.0) << "the depth is kept";
  // The planned entry lies on the mannequin's skin.
  const Vec3 on_body = placed.inverse() * made.description.procedure.path->entry;
  EXPECT_NEAR(std::hypot(on_body.x() / 118.0, on_body.y() / 98.0), 1.0, 0.02);
}

TEST(SkinFit, refuses_what_it_cannot_lay_upon_each_other) {
  const anatomy::TissueVolume patient = cylinder(105.0, 75.0, 0.0);
  Pose far_away = Pose::Identity();
  far_away.translation() = Vec3(0.0, 0.0, 900.0);
  EXPECT_THROW(SkinFit(skin_of(patient), skin_of(patient), Pose::Identity(), Vec3(0.0, 900.0, 0.0), {}), InputError);
  SkinFitSettings settings;
  settings.reach = 29.0;
  EXPECT_THROW(check(settings), InputError);
  settings = {};
  settings.spacing = 4.0;
  EXPECT_THROW(check(settings), InputError);
  anatomy::TissueVolume air(patient.grid);
  EXPECT_THROW(skin_of(air), InputError);
}

}  // namespace
}  // namespace bodkin::patient
