// One tick of every force model, warm, along the motion of an expert's lumbar puncture recorded beforehand.
// `per_tick` is the mean over whole passes; `p50_ns` and `p99_ns` of the last benchmark are of single ticks of all
// models together (they include two clock readings, some 20 to 40 ns).
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "patient/synthetic/lumbar.h"
#include "session/operator_file.h"
#include <benchmark/benchmark.h>

#include "anatomy/tissue_surface.h"
#include "forces/beam.h"
#include "forces/bevel_tip.h"
#include "forces/csf_flow.h"
#include "forces/depth_profile.h"
#include "forces/fracture.h"
#include "forces/gravity_compensation.h"
#include "forces/layered.h"
#include "forces/line_spring.h"
#include "forces/needle_grasp.h"
#include "forces/pivot.h"
#include "forces/prony_relaxation.h"
#include "forces/rail.h"
#include "forces/shaft_friction.h"
#include "forces/spring_damper_wall.h"
#include "forces/surface_proxy.h"
#include "forces/syringe.h"
#include "forces/three_component.h"
#include "forces/tissue_path.h"
#include "forces/tracking_wall.h"
#include "forces/tracking_wall_leash.h"
#include "forces/volume_proxy.h"
#include "io/tissue_library_file.h"
#include "simulation/closed_loop.h"

namespace {

using namespace bodkin;
using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::io;
using namespace bodkin::patient;
using namespace bodkin::session;
using namespace bodkin::simulation;

constexpr double dt = 1e-3;

struct Tick {
  AxialMotion motion;
  Vec3 tip, axis;
  TissueId tissue;
};

// The patient, the field and the recording that all benchmarks share.
struct Scene {
  Case patient;
  std::vector<Tick> ticks;
  Vec3 entry, direction;
  TissuePath path{0.5, 200.0};
};

const Scene& scene() {
  static const Scene made = [] {
    Scene one;
    one.patient.library = default_tissue_library();
    SyntheticPatient torso = synthesize_lumbar({}, one.patient.library);
    one.patient.ct = std::move(torso.ct);
    one.patient.tissues = std::move(torso.tissues);
    one.entry = torso.path.entry;
    one.direction = torso.path.direction();
    one.path.restart(one.entry, one.direction);
    one.path.extend_to(150.0, one.patient.tissues);
    ClosedLoop loop(one.patient, load_operator("expert"), torso.path, 1);
    TickRecord record;
    while (!loop.finished()) {
      loop.step(record);
      const double v = record.output.velocity;
      const int direction = v > 0.5 ? 1 : (v < -0.5 ? -1 : 0);
      one.ticks.push_back({{record.output.depth, v, direction, direction == 0},
                           record.input.needle.translation(),
                           needle_axis(record.input.needle),
                           nearest(one.patient.tissues, Vec3(record.input.needle.translation()), tissue::air)});
    }
    return one;
  }();
  return made;
}

const HapticField& field() {
  static const HapticField made(scene().patient.ct, scene().patient.tissues, scene().patient.library, {});
  return made;
}

const Surface& skin() {
  static const Surface made = tissue_surface(scene().patient.tissues, body_tissues(), {});
  return made;
}

// Each model as a callable for a tick.
struct Models {
  TickEvents events;
  SpringDamperWall spring_damper_wall{{}};
  TrackingWall tracking_wall{scene().patient.library, {}, dt};
  TrackingWallLeash leash{scene().patient.library, {}, dt};
  DepthProfile depth_profile{scene().patient.library, {}, dt};
  Layered layered{scene().patient.library, {}, 1.0, dt, 200.0};
  Pivot pivot{{}, 90.0};
  Beam beam{{}, Needle{}, dt};
  LineSpring line_spring{{}, 1.0, dt};
  Rail rail{{}};
  VolumeProxy volume_proxy{scene().patient.library, {}, field(), dt};
  SurfaceProxy surface_proxy{{}, skin(), dt};
  GravityCompensation gravity{{.weight = 0.7, .slope = Vec3(1e-3, 0.0, 0.0)}};
  ShaftFriction shaft_friction{{}};
  std::array<ShaftFrictionTissue, 256> shaft_tissues =
      scene().patient.library.by_id(&TissueProperties::shaft_friction);
  ThreeComponent three_component{{}};
  Fracture fracture{{}};
  PronyRelaxation prony{std::vector<PronyTerm>{{0.3, 0.05}, {0.2, 0.5}}, dt};
  BevelTip bevel_tip{0.002, 200.0};
  Syringe syringe{scene().patient.library, {.filling = SyringeFilling::air}, dt};
  CsfFlow csf_flow{{}, dt};
  NeedleGrasp needle_grasp{{}};
  double last_depth = 0.0;

  Models() {
    const Vec3 entry = scene().entry, direction = scene().direction;
    tracking_wall.begin(entry, direction);
    leash.begin(entry, direction);
    depth_profile.begin(entry, direction);
    layered.begin();
    pivot.begin(entry, direction);
    beam.begin(entry, direction, entry);
    line_spring.begin(entry, direction);
    rail.begin(entry, direction);
  }
};

template <typename Call>
void run(benchmark::State& state, Call call) {
  const std::vector<Tick>& ticks = scene().ticks;
  Models models;
  double steps = 0.0;
  for (auto _ : state) {
    for (const Tick& tick : ticks) {
      models.events.clear();
      auto result = call(models, tick);
      benchmark::DoNotOptimize(result);
    }
    steps += static_cast<double>(ticks.size());
  }
  state.counters["per_tick"] = benchmark::Counter(steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

double advance(Models& m, const Tick& t) {
  return t.motion.depth - std::exchange(m.last_depth, t.motion.depth);
}

double shaft(Models& m, const Tick& t) {
  const Scene& s = scene();
  return m.shaft_friction.step(
      t.motion, shaft_contact(s.path.layers(), s.path.layer(), t.motion.depth, m.shaft_tissues), m.events);
}

void spring_damper_wall(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return m.spring_damper_wall.step(t.motion, t.tissue, m.events); });
}
BENCHMARK(spring_damper_wall)->Unit(benchmark::kMicrosecond);

void tracking_wall(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return m.tracking_wall.step(t.motion, t.tissue, m.events); });
}
BENCHMARK(tracking_wall)->Unit(benchmark::kMicrosecond);

void tracking_wall_leash(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return Vec3(m.leash.step(t.tip, t.motion, t.tissue, m.events)); });
}
BENCHMARK(tracking_wall_leash)->Unit(benchmark::kMicrosecond);

void depth_profile(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return m.depth_profile.step(t.motion, t.tissue, m.events); });
}
BENCHMARK(depth_profile)->Unit(benchmark::kMicrosecond);

void layered(benchmark::State& state) {
  run(state,
      [](Models& m, const Tick& t) { return m.layered.step(t.motion, scene().path.layers(), m.events).resistance; });
}
BENCHMARK(layered)->Unit(benchmark::kMicrosecond);

void pivot(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return Vec3(m.pivot.step(t.tip, t.axis)); });
}
BENCHMARK(pivot)->Unit(benchmark::kMicrosecond);

void beam(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return Vec3(m.beam.step(t.tip, t.axis)); });
}
BENCHMARK(beam)->Unit(benchmark::kMicrosecond);

void line_spring(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return Vec3(m.line_spring.step(t.tip)); });
}
BENCHMARK(line_spring)->Unit(benchmark::kMicrosecond);

void rail(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return m.rail.step(t.tip, t.axis); });
}
BENCHMARK(rail)->Unit(benchmark::kMicrosecond);

void volume_proxy_with_rail(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) {
    return std::pair(Vec3(m.volume_proxy.step(t.tip, &m.rail, m.events)),
                     Vec3(m.rail.torque(t.axis, t.motion.depth)));
  });
}
BENCHMARK(volume_proxy_with_rail)->Unit(benchmark::kMicrosecond);

void surface_proxy(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return Vec3(m.surface_proxy.step(t.tip, m.events)); });
  state.counters["triangles"] = static_cast<double>(skin().triangles().size());
}
BENCHMARK(surface_proxy)->Unit(benchmark::kMicrosecond);

// Palpation: circles of 30 mm at 200 mm/s around the entry, 3 mm under the skin, sliding over a triangle every 7
// ticks.
void surface_proxy_stroking(benchmark::State& state) {
  Models models;
  const Vec3 centre = scene().entry + 3.0 * scene().direction;
  const Vec3 u = scene().direction.unitOrthogonal(), v = scene().direction.cross(u);
  models.surface_proxy.step(scene().entry - 10.0 * scene().direction, models.events);
  std::vector<double> single;
  double angle = 0.0;
  for (auto _ : state) {
    angle += 0.2 / 30.0;
    const Vec3 tip = centre + 30.0 * (std::cos(angle) * u + std::sin(angle) * v);
    const auto before = std::chrono::steady_clock::now();
    Vec3 force = models.surface_proxy.step(tip, models.events);
    benchmark::DoNotOptimize(force);
    single.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - before).count());
  }
  std::sort(single.begin(), single.end());
  state.counters["p50_ns"] = single[single.size() / 2];
  state.counters["p99_ns"] = single[single.size() * 99 / 100];
  state.counters["p99.9_ns"] = single[single.size() * 999 / 1000];
}
BENCHMARK(surface_proxy_stroking)->Unit(benchmark::kMicrosecond);

void gravity_compensation(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return Vec3(m.gravity.step(t.tip)); });
}
BENCHMARK(gravity_compensation)->Unit(benchmark::kMicrosecond);

void shaft_friction(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return shaft(m, t); });
}
BENCHMARK(shaft_friction)->Unit(benchmark::kMicrosecond);

void three_component(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return m.three_component.step(t.motion, t.tissue, m.events); });
}
BENCHMARK(three_component)->Unit(benchmark::kMicrosecond);

void fracture(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return m.fracture.step(t.motion, t.tissue, m.events); });
}
BENCHMARK(fracture)->Unit(benchmark::kMicrosecond);

void prony_relaxation(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return m.prony.step(t.motion.depth); });
}
BENCHMARK(prony_relaxation)->Unit(benchmark::kMicrosecond);

void bevel_tip(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return Vec3(m.bevel_tip.step(advance(m, t), 1e-4).translation()); });
}
BENCHMARK(bevel_tip)->Unit(benchmark::kMicrosecond);

void syringe(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return m.syringe.step(0.2, t.tissue).force; });
}
BENCHMARK(syringe)->Unit(benchmark::kMicrosecond);

void csf_flow(benchmark::State& state) {
  run(state, [](Models& m, const Tick&) { return m.csf_flow.step_manometer(1.0, false).height; });
}
BENCHMARK(csf_flow)->Unit(benchmark::kMicrosecond);

void needle_grasp(benchmark::State& state) {
  run(state, [](Models& m, const Tick& t) { return m.needle_grasp.step(0.01 * t.motion.depth); });
}
BENCHMARK(needle_grasp)->Unit(benchmark::kMicrosecond);

// All of them in one tick; the sum prevents the compiler from removing the calls.
double everything(Models& m, const Tick& t) {
  const Scene& s = scene();
  double sum = m.spring_damper_wall.step(t.motion, t.tissue, m.events) +
               m.tracking_wall.step(t.motion, t.tissue, m.events) +
               m.depth_profile.step(t.motion, t.tissue, m.events) +
               m.layered.step(t.motion, s.path.layers(), m.events).resistance + shaft(m, t) +
               m.three_component.step(t.motion, t.tissue, m.events) + m.fracture.step(t.motion, t.tissue, m.events) +
               m.prony.step(t.motion.depth) + m.syringe.step(0.2, t.tissue).force +
               m.csf_flow.step_manometer(1.0, false).height + m.needle_grasp.step(0.01 * t.motion.depth);
  const Vec3 vector = m.leash.step(t.tip, t.motion, t.tissue, m.events) + m.pivot.step(t.tip, t.axis) +
                      m.beam.step(t.tip, t.axis) + m.line_spring.step(t.tip) +
                      m.volume_proxy.step(t.tip, &m.rail, m.events) + m.rail.step(t.tip, t.axis).torque +
                      m.gravity.step(t.tip) + m.bevel_tip.step(advance(m, t), 1e-4).translation();
  return sum + vector.sum();
}

void all_models_together(benchmark::State& state) {
  const std::vector<Tick>& ticks = scene().ticks;
  Models models;
  std::vector<double> single;
  for (auto _ : state) {
    single.clear();
    single.reserve(ticks.size());
    for (const Tick& tick : ticks) {
      models.events.clear();
      const auto before = std::chrono::steady_clock::now();
      double sum = everything(models, tick);
      benchmark::DoNotOptimize(sum);
      single.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - before).count());
    }
  }
  std::sort(single.begin(), single.end());
  state.counters["p50_ns"] = single[single.size() / 2];
  state.counters["p99_ns"] = single[single.size() * 99 / 100];
}
BENCHMARK(all_models_together)->Unit(benchmark::kMicrosecond);

}  // namespace
