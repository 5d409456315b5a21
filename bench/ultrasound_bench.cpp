// The cost of an ultrasound image: the lumbar torso that `./run` uses under a C5-2, the probe moving a little from
// picture to picture. Times are those of the whole call, by the wall clock, and by the calling thread's processor
// time, which other jobs do not count in; the minimum of each is the speed of an otherwise idle machine.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "patient/synthetic/lumbar.h"
#include <benchmark/benchmark.h>

#include "imaging/ultrasound/ultrasound.h"
#include "io/probe_library_file.h"
#include "io/tissue_library_file.h"

namespace {

using namespace bodkin;
using namespace bodkin::anatomy;
using namespace bodkin::imaging;
using namespace bodkin::io;
using namespace bodkin::patient;

struct Patient {
  std::shared_ptr<const AcousticVolume> volume;
  UltrasoundProbe probe;
  std::vector<Pose> poses;  // the face on the skin
  NeedlePath path;
};

const Patient& patient() {
  static const Patient made = [] {
    Patient result;
    Case torso;
    torso.library = default_tissue_library();
    SyntheticPatient synthetic = synthesize_lumbar({}, torso.library);
    torso.ct = std::move(synthetic.ct);
    torso.tissues = std::move(synthetic.tissues);
    result.volume = acoustic_volume(torso, {});
    result.probe = find_probe("C5-2");
    result.path = synthetic.path;
    // Lengthwise, from beside the spinous processes, sliding and tilting.
    for (int number = 0; number < 64; ++number) {
      const double phase = 2.0 * 3.14159265358979323846 * number / 64.0;
      const Vec3 face = synthetic.path.entry + Vec3(8.0 + 6.0 * std::sin(phase), 0.0, 10.0 * std::cos(phase));
      const Vec3 look = synthetic.path.direction() + Vec3(-0.1 + 0.05 * std::cos(phase), 0.0, 0.0);
      result.poses.push_back(probe_pose(face, look, Vec3::UnitZ()));
    }
    return result;
  }();
  return made;
}

struct Scene {
  UltrasoundDetail detail;
  double press = 2.0;  // mm that the face is pushed in
  bool displaced = false;
  bool needle = false;
  ProcessorPath path = best_processor_path();
};

// Processor time of this thread, ms.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

void draw(benchmark::State& state, const Scene& scene) {
  const Patient& torso = patient();
  UltrasoundSettings settings;
  settings.depth = 100.0;
  Ultrasound machine(torso.volume, torso.probe, settings, scene.detail, scene.path);
  std::vector<float> moved;
  std::optional<ScanDisplacement> displacement;
  if (scene.displaced) {
    constexpr int side = 61;
    for (int point = 0; point < side * side; ++point) {
      const double depth = 2.0 * (point / side), across = 2.0 * (point % side) - 60.0;
      moved.push_back(static_cast<float>(0.3 * std::sin(0.1 * across)));
      moved.push_back(static_cast<float>(3.0 * std::exp(-0.02 * depth)));
      moved.push_back(static_cast<float>(0.2 * std::cos(0.1 * depth)));
    }
    displacement = {Vec3(-60.0, 0.0, 0.0), 2.0, side, side, moved};
  }
  std::optional<NeedleInUltrasound> needle;
  if (scene.needle) needle = {needle_pose(torso.path.target, torso.path.direction()), Needle{}};

  std::vector<Pose> poses = torso.poses;
  for (Pose& pose : poses) pose.translation() += scene.press * pose.linear().col(1);
  std::vector<double> times, processor;
  std::size_t number = 0;
  double contact = 0.0;
  for (const Pose& pose : poses) machine.image(pose, needle, displacement);  // warm
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    const double processor_start = processor_time();
    contact += machine.image(poses[number++ % poses.size()], needle, displacement).contact;
    processor.push_back(processor_time() - processor_start);
    times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(times.begin(), times.end());
  const auto at = [&times](double part) {
    return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
  };
  state.counters["min_ms"] = times.front();
  state.counters["median_ms"] = at(0.5);
  state.counters["p99_ms"] = at(0.99);
  state.counters["min_processor_ms"] = *std::min_element(processor.begin(), processor.end());
  state.counters["contact"] = contact / static_cast<double>(times.size());
}

UltrasoundDetail full(int width, int height, int threads) {
  UltrasoundDetail detail;
  detail.lines = detail.width = width;
  detail.samples = detail.height = height;
  detail.threads = threads;
  return detail;
}

// The feature set of Sutherland et al. 2013, without pressed tissue, 300 x 300, one thread.
void paper(benchmark::State& state) {
  draw(state, {.detail = paper_detail(), .press = 0.0});
}

// Everything, 300 x 300, by threads.
void everything(benchmark::State& state) {
  draw(state, {.detail = full(300, 300, static_cast<int>(state.range(0)))});
}

// Everything, tissue displaced and a needle in it, 300 x 300, by threads.
void everything_displaced(benchmark::State& state) {
  draw(state, {.detail = full(300, 300, static_cast<int>(state.range(0))), .displaced = true, .needle = true});
}

// Everything, one ray for the slice, 300 x 300.
void thin_slice(benchmark::State& state) {
  UltrasoundDetail detail = full(300, 300, static_cast<int>(state.range(0)));
  detail.slices = 1;
  draw(state, {.detail = detail});
}

// Everything, 820 x 616 (616 samples of each of 820 lines), by threads.
void large(benchmark::State& state) {
  draw(state, {.detail = full(820, 616, static_cast<int>(state.range(0)))});
}

// Everything, 300 x 300, one thread, by processor path.
void on_path(benchmark::State& state) {
  const auto number = static_cast<std::size_t>(state.range(0));
  if (number >= processor_paths().size()) {
    state.SkipWithError("this processor has no such path");
    return;
  }
  const ProcessorPath path = processor_paths()[number];
  state.SetLabel(std::string(name_of(path)));
  draw(state, {.detail = full(300, 300, 1), .path = path});
}

BENCHMARK(paper)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(everything)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(everything_displaced)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(thin_slice)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(large)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(on_path)->DenseRange(0, 3)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
