// Touching the skin and the bones of the synthetic patient.
#include <algorithm>
#include <cmath>
#include <vector>

#include "patient/synthetic/lumbar.h"
#include <gtest/gtest.h>

#include "anatomy/tissue_surface.h"
#include "core/random.h"
#include "forces/fingertip.h"
#include "forces/surface_proxy.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

struct Lumbar {
  Lumbar() {
    const TissueLibrary library = default_tissue_library();
    patient = synthesize_lumbar({.spacing = 1.5}, library);
    skin = tissue_surface(patient.tissues, body_tissues(), {.edge = 3.0, .smoothing = 2.0});
    bone = tissue_surface(patient.tissues, bone_tissues(), {.edge = 1.5, .smoothing = 1.0});
  }
  SyntheticPatient patient;
  Surface skin, bone;
};

const Lumbar& lumbar() {
  static const Lumbar made;
  return made;
}

double enclosed(const Surface& surface) {
  double volume = 0.0;
  for (const auto& corners : surface.triangles()) {
    const auto at = [&](std::size_t i) { return surface.vertices()[static_cast<std::size_t>(corners[i])]; };
    volume += at(0).dot(at(1).cross(at(2))) / 6.0;
  }
  return volume;
}

double voxels_of(const TissueVolume& tissues, const TissueSet& region) {
  const auto count =
      std::count_if(tissues.voxels.begin(), tissues.voxels.end(), [&](TissueId id) { return region[id]; });
  return static_cast<double>(count) * tissues.grid.spacing.prod();
}

TEST(Palpation, surfaces_of_the_patient_are_closed_and_enclose_its_tissues) {
  EXPECT_TRUE(lumbar().skin.closed());
  EXPECT_TRUE(lumbar().bone.closed());
  const double body = voxels_of(lumbar().patient.tissues, body_tissues());
  const double bone = voxels_of(lumbar().patient.tissues, bone_tissues());
  EXPECT_NEAR(enclosed(lumbar().skin), body, 0.01 * body);
  EXPECT_NEAR(enclosed(lumbar().bone), bone, 0.05 * bone);
}

TEST(Palpation, the_skin_is_met_where_the_path_enters_and_pushes_back) {
  const NeedlePath& path = lumbar().patient.path;
  const Vec3 along = path.direction();
  SurfaceProxy model({}, lumbar().skin, 1e-3);
  TickEvents events;
  double met = 100.0;
  Vec3 force = Vec3::Zero();
  for (double way = -10.0; way <= 5.0; way += 0.05) {
    force = model.step(path.entry + way * along, events);
    if (force.norm() > 0.0) met = std::min(met, way);
  }
  EXPECT_NEAR(met, 0.0, 1.5);
  EXPECT_NEAR(force.norm(), 5.0 - met, 1.0);
  EXPECT_GT(-force.normalized().dot(along), 0.9);
}

// Depth of the first bone among the voxels straight forwards (-y) from `start`, mm; 60 where there is none before.
double first_bone(const Vec3& start) {
  double y = -10.0;
  while (y < 60.0 && !bone_tissues()[nearest(lumbar().patient.tissues, Vec3(start - Vec3(0.0, y, 0.0)), tissue::air)])
    y += 0.25;
  return y;
}

TEST(Palpation, tapping_down_the_spine_finds_the_spinous_processes_and_the_gaps_between_them) {
  const Vec3 entry = lumbar().patient.path.entry;
  SurfaceProxy model({}, lumbar().bone, 1e-3);
  TickEvents events;
  int taps = 0, agreeing = 0, shallow = 0, deep = 0;
  for (double z = 60.0; z > -60.0; z -= 2.0) {
    const Vec3 start = entry + Vec3(0.0, 0.0, z);
    double met = -10.0;
    model.reset();
    while (met < 60.0 && model.step(start - Vec3(0.0, met, 0.0), events).norm() == 0.0) met += 0.25;
    ++taps;
    // At the rim of a process a voxel more or less decides.
    for (const double rim : {0.0, 1.5, -1.5}) {
      if (std::abs(met - first_bone(start + Vec3(0.0, 0.0, rim))) >= 1.5) continue;
      ++agreeing;
      break;
    }
    shallow += met < 36.0 ? 1 : 0;
    deep += met > 40.0 ? 1 : 0;
  }
  EXPECT_GE(agreeing, taps * 9 / 10) << "of " << taps;
  EXPECT_GT(shallow, 15);
  EXPECT_GT(deep, 10);
}

TEST(Palpation, no_hand_gets_under_the_skin_or_into_bone) {
  const TissueVolume& tissues = lumbar().patient.tissues;
  for (const bool on_bone : {false, true}) {
    const Surface& surface = on_bone ? lumbar().bone : lumbar().skin;
    SurfaceProxy model({}, surface, 1e-3);
    TickEvents events;
    Random random(31);
    const Vec3 home = lumbar().patient.path.entry - 15.0 * lumbar().patient.path.direction();
    Vec3 tip = home, speed = Vec3::Zero();
    model.step(tip, events);
    int touching = 0;
    for (int tick = 0; tick < 15000; ++tick) {
      speed = 0.99 * speed + 0.08 * Vec3(random.normal(), random.normal(), random.normal()) -
              5e-4 * (tip - home - 30.0 * lumbar().patient.path.direction());
      if (speed.norm() > 1.0) speed.normalize();  // 1 m/s
      tip += speed;
      const Vec3 force = model.step(tip, events);
      ASSERT_TRUE(force.norm() <= 8.5 + 1e-9);
      touching += force.norm() > 0.0 ? 1 : 0;
      // 3 mm under the surface there would be its tissue all around.
      int around = 0;
      for (const Vec3& side :
           {Vec3(3, 0, 0), Vec3(-3, 0, 0), Vec3(0, 3, 0), Vec3(0, -3, 0), Vec3(0, 0, 3), Vec3(0, 0, -3)}) {
        const TissueId id = nearest(tissues, Vec3(model.proxy() + side), tissue::air);
        around += (on_bone ? bone_tissues() : body_tissues())[id] ? 1 : 0;
      }
      ASSERT_LT(around, 6) << tick;
    }
    EXPECT_GT(touching, 1000);
  }
}

// N/mm that a finger meets, pressed 5 mm into the skin in front of `place`.
double firmness_at(const Vec3& place, const TissueVolume& tissues) {
  Fingertip finger(tissues, {}, 1.0, 1e-3);
  Vec3 skin = place + Vec3(0.0, 30.0, 0.0);
  while (nearest(tissues, skin, tissue::air) == tissue::air) skin.y() -= 0.5;
  FingertipState felt;
  for (int tick = 0; tick < 100; ++tick) {
    TickEvents events;
    felt = finger.step(skin - Vec3(0.0, 5.0, 0.0), -Vec3::UnitY(), events);
  }
  return felt.firmness;
}

TEST(Palpation, a_finger_finds_the_interspaces_softer_than_the_processes_between_them) {
  const SyntheticPatient patient = synthesize_lumbar({.spacing = 1.5}, default_tissue_library());
  std::vector<Vec3> interspaces;
  for (const char* name : {"L2_L3_skin", "L3_L4_skin", "L4_L5_skin"}) {
    for (const Landmark& each : patient.landmarks)
      if (each.name == name) interspaces.push_back(each.position);
  }
  ASSERT_EQ(interspaces.size(), 3U);
  for (std::size_t i = 1; i < interspaces.size(); ++i) {
    const double process = firmness_at(0.5 * (interspaces[i - 1] + interspaces[i]), patient.tissues);
    EXPECT_GT(process, 1.4 * firmness_at(interspaces[i - 1], patient.tissues)) << i;
    EXPECT_GT(process, 1.4 * firmness_at(interspaces[i], patient.tissues)) << i;
  }
}

}  // namespace
}  // namespace bodkin
