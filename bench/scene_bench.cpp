// CPU time of the 3-D view's frames: run with --benchmark_counters_tabular=true; the column CPU counts one thread,
// the only one that draws.
#include <memory>

#include "patient/synthetic/lumbar.h"
#include "scene/camera_moves.h"
#include "scene/view_software.h"
#include <benchmark/benchmark.h>

#include "io/tissue_library_file.h"

namespace bodkin::scene {
namespace {

struct Patient {
  std::shared_ptr<const PatientSurfaces> surfaces;
  anatomy::NeedlePath path;
};

const Patient& synthetic_patient() {
  static const Patient patient = [] {
    const patient::SyntheticPatient made = patient::synthesize_lumbar({}, io::default_tissue_library());
    return Patient{std::make_shared<PatientSurfaces>(make_surfaces(made.tissues)), made.path};
  }();
  return patient;
}

SoftwareView view_of(int width, int height, Preset preset = Preset::cut_away) {
  const Patient& patient = synthetic_patient();
  SoftwareView view(patient.surfaces);
  view.set_size(width, height);
  ViewSubject subject;
  subject.middle = 0.5 * (patient.path.entry + patient.path.target);
  subject.direction = patient.path.direction();
  view.set_camera(standard_view(StandardView::operator_side, subject));
  view.set_preset(preset);
  view.set_opening({subject.middle});
  view.set_entry(patient.path.entry, patient.path.direction());
  SceneMarks marks;
  marks.path = patient.path;
  view.set_marks(marks);
  view.draw();
  return view;
}

NeedleLook needle_at(double depth) {
  const anatomy::NeedlePath& path = synthetic_patient().path;
  NeedleLook needle;
  needle.pose = needle_pose(path.entry + depth * path.direction(), path.direction());
  return needle;
}

void needle_moves(benchmark::State& state) {
  SoftwareView view = view_of(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  double depth = 0.0;
  for (auto _ : state) {
    depth = depth > 50.0 ? 0.0 : depth + 0.2;
    view.set_needles({needle_at(depth)});
    benchmark::DoNotOptimize(view.draw());
  }
}
BENCHMARK(needle_moves)->Args({822, 504})->Args({1210, 814})->Args({1920, 1080})->Unit(benchmark::kMillisecond);

void skin_dimples(benchmark::State& state) {
  SoftwareView view = view_of(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), Preset::skin);
  const anatomy::NeedlePath& path = synthetic_patient().path;
  double depth = 0.0;
  for (auto _ : state) {
    depth = depth > 8.0 ? 0.1 : depth + 0.05;
    view.set_needles({needle_at(depth)});
    view.set_dent(SkinDent{path.entry, path.direction(), depth});
    benchmark::DoNotOptimize(view.draw());
  }
  state.counters["triangles"] = static_cast<double>(view.patch().mesh().triangles.size());
}
BENCHMARK(skin_dimples)->Args({822, 504})->Args({1210, 814})->Args({1920, 1080})->Unit(benchmark::kMillisecond);

// The last argument: samples along each side of a pixel, 1 while the camera turns, 2 when it has come to rest.
void camera_turns(benchmark::State& state) {
  SoftwareView view = view_of(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  view.set_detail(static_cast<int>(state.range(2)));
  view.set_needles({needle_at(30.0)});
  for (auto _ : state) {
    view.set_camera(turned(view.camera(), 0.02, 0.005));
    benchmark::DoNotOptimize(view.draw());
  }
  state.counters["triangles"] = static_cast<double>(view.surfaces().triangles());
}
BENCHMARK(camera_turns)
    ->Args({822, 504, 1})
    ->Args({822, 504, 2})
    ->Args({1210, 814, 1})
    ->Args({1210, 814, 2})
    ->Args({1920, 1080, 1})
    ->Args({1920, 1080, 2})
    ->Unit(benchmark::kMillisecond);

void surfaces_are_made(benchmark::State& state) {
  const patient::SyntheticPatient made = patient::synthesize_lumbar({}, io::default_tissue_library());
  for (auto _ : state) benchmark::DoNotOptimize(make_surfaces(made.tissues));
}
BENCHMARK(surfaces_are_made)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace bodkin::scene
