// The tick of every force model allocates nothing and locks nothing, on entry, on puncture, on bone, on withdrawal,
// on a second channel and on input that is no number.
#include <cmath>
#include <limits>
#include <vector>

#include "tests/one_tick.h"
#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>

#include "anatomy/tissue_surface.h"
#include "forces/beam.h"
#include "forces/bevel_tip.h"
#include "forces/csf_flow.h"
#include "forces/depth_profile.h"
#include "forces/fracture.h"
#include "forces/gravity_compensation.h"
#include "forces/needle_grasp.h"
#include "forces/pivot.h"
#include "forces/prony_relaxation.h"
#include "forces/shaft_friction.h"
#include "forces/spring_damper_wall.h"
#include "forces/surface_proxy.h"
#include "forces/syringe.h"
#include "forces/three_component.h"
#include "forces/tracking_wall.h"
#include "forces/tracking_wall_leash.h"
#include "forces/volume_proxy.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::io;
namespace {

struct Slab {  // skin, muscle, bone along z
  CtVolume ct;
  TissueVolume tissues;
  Slab() {
    Grid grid;
    grid.size = {16, 16, 80};
    grid.origin = Vec3(-8.0, -8.0, -10.0);
    ct = CtVolume(grid, 40);
    tissues = TissueVolume(grid);
    for (int k = 0; k < 80; ++k) {
      for (int j = 0; j < 16; ++j) {
        for (int i = 0; i < 16; ++i) {
          tissues.at(i, j, k) = k < 10   ? tissue::air
                                : k < 13 ? tissue::skin
                                : k < 50 ? tissue::muscle
                                         : tissue::cortical_bone;
        }
      }
    }
  }
};

struct Models {
  TissueLibrary library = default_tissue_library();
  Models(const HapticField& field, const Surface& skin)
      : volume_proxy(library, {}, field, one_tick), surface_proxy({}, skin, one_tick) {}

  SpringDamperWall spring_damper_wall{{}};
  TrackingWall tracking_wall{library, {}, one_tick};
  TrackingWallLeash leash{library, {}, one_tick};
  DepthProfile depth_profile{library, {}, one_tick};
  Pivot pivot{{}, 90.0};
  Beam beam{{}, Needle{}, one_tick};
  Rail rail{{}};
  VolumeProxy volume_proxy;
  SurfaceProxy surface_proxy;
  GravityCompensation gravity{{.weight = 0.5, .slope = Vec3(1e-3, 0.0, 0.0)}};
  ShaftFriction shaft{{}};
  std::array<ShaftFrictionTissue, 256> shaft_tissues = library.by_id(&TissueProperties::shaft_friction);
  std::vector<TissueId> layers = std::vector<TissueId>(200, tissue::muscle);
  ThreeComponent three_component{{}};
  Fracture fracture{{}};
  PronyRelaxation prony{std::vector<PronyTerm>{{}}, one_tick};
  BevelTip bevel{0.005, 100.0};
  Syringe syringe{library, {.filling = SyringeFilling::air}, one_tick};
  CsfFlow csf{{}, one_tick};
  NeedleGrasp grasp{{}};
  TickEvents events;
  double before = 0.0;

  void begin(const Vec3& entry) noexcept {
    tracking_wall.begin(entry, Vec3::UnitZ());
    leash.begin(entry, Vec3::UnitZ());
    depth_profile.begin(entry, Vec3::UnitZ());
    three_component.begin(entry, Vec3::UnitZ());
    fracture.begin(entry, Vec3::UnitZ());
    pivot.begin(entry, Vec3::UnitZ());
    rail.begin(entry, Vec3::UnitZ());
    beam.begin(entry, Vec3::UnitZ(), entry);
    shaft.begin();
    bevel.begin(Pose::Identity());
  }

  double step(double depth, const Vec3& entry, TissueId at_tip) noexcept {
    events.clear();
    const double way = depth - before;
    before = std::isfinite(depth) ? depth : before;
    const AxialMotion motion{depth, way / one_tick, way > 0.0 ? 1 : (way < 0.0 ? -1 : 0), way == 0.0};
    const Vec3 tip = entry + Vec3(0.2, 0.1, depth), axis = Vec3(0.02, 0.01, 1.0).normalized();
    double sum = spring_damper_wall.step(motion, at_tip, events) + tracking_wall.step(motion, at_tip, events) +
                 depth_profile.step(motion, at_tip, events) + three_component.step(motion, at_tip, events) +
                 fracture.step(motion, at_tip, events) + prony.step(depth) +
                 shaft.step(motion, shaft_contact(layers, 0.5, depth, shaft_tissues), events) +
                 syringe.step(0.5, at_tip).force + csf.step_manometer(0.5, false).height +
                 csf.step_drip(0.5, false).flow + grasp.step(depth);
    sum += leash.step(tip, motion, at_tip, events).norm() + pivot.step(tip, axis).norm() +
           beam.step(tip, axis).norm() + volume_proxy.step(tip, &rail, events).norm() +
           surface_proxy.step(tip + Vec3(0.3 * depth, 0.0, 0.0), events).norm() + rail.step(tip, axis).torque.norm() +
           gravity.step(tip).norm() + bevel.step(way, 0.001).translation().norm();
    return sum;
  }
};

TEST(ModelsRealTime, no_model_allocates_or_locks) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer watches the heap itself";
  const Slab slab;
  const HapticField field(slab.ct, slab.tissues, default_tissue_library(), {});
  Models models(field, tissue_surface(slab.tissues, body_tissues(), {}));
  std::size_t heap = 1, locks = 1;
  double sum = 0.0;
  {
    const RealTimeGuard guard;
    for (int entry = 0; entry < 3; ++entry) {
      const Vec3 place(2.0 * entry, 0.0, 0.0);
      models.begin(place);
      for (int tick = 0; tick < 6000; ++tick) {
        const double depth = tick < 2500 ? -2.0 + 0.018 * tick : (tick < 3500 ? 43.0 : 43.0 - 0.018 * (tick - 3500));
        sum += models.step(depth, place, field.tissue(place + Vec3(0.0, 0.0, depth)));
      }
      models.step(std::numeric_limits<double>::quiet_NaN(), place, tissue::air);
      models.step(std::numeric_limits<double>::infinity(), place, tissue::air);
    }
    heap = RealTimeGuard::heap_calls();
    locks = RealTimeGuard::lock_calls();
  }
  EXPECT_EQ(heap, 0u);
  EXPECT_EQ(locks, 0u);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace bodkin
