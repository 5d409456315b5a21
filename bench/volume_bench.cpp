// Wall time of the volume view's pictures on all cores: --benchmark_counters_tabular=true. The patient is the
// synthetic torso, brought to 256 voxels along each side.
#include <memory>

#include "patient/synthetic/lumbar.h"
#include <benchmark/benchmark.h>

#include "imaging/volume_rendering/cutaway.h"
#include "imaging/volume_rendering/ray_caster.h"
#include "io/tissue_library_file.h"

namespace bodkin::imaging {
namespace {

const anatomy::CtVolume& torso() {
  static const anatomy::CtVolume made = [] {
    const patient::SyntheticPatient patient = patient::synthesize_lumbar({}, io::default_tissue_library());
    const anatomy::Grid& from = patient.ct.grid;
    anatomy::Grid grid = from;
    grid.size = {256, 256, 256};
    for (int axis = 0; axis < 3; ++axis) {
      grid.spacing[axis] = from.spacing[axis] * from.size[static_cast<std::size_t>(axis)] / 256.0;
    }
    anatomy::CtVolume ct(grid);
    for (int k = 0; k < 256; ++k) {
      for (int j = 0; j < 256; ++j) {
        for (int i = 0; i < 256; ++i) {
          ct.at(i, j, k) =
              static_cast<std::int16_t>(anatomy::linear(patient.ct, grid.to_patient(Vec3(i, j, k)), -1000.0));
        }
      }
    }
    return ct;
  }();
  return made;
}

std::shared_ptr<const PreparedVolume> volume() {
  static const auto made = std::make_shared<const PreparedVolume>(prepare_volume(torso(), {}, {}));
  return made;
}

// Arguments: mode, preset, pixels along each side, tenths of a voxel of a step.
void a_turn(benchmark::State& state) {
  VolumeLook look;
  look.mode = static_cast<VolumeMode>(state.range(0));
  look.transfer = preset_function(static_cast<TransferPreset>(state.range(1)));
  const auto patient = volume();
  const RayCaster caster(patient, look, step_of(*patient, 0.1 * static_cast<double>(state.range(3))));
  const Vec3 middle = patient->grid.to_patient(Vec3::Constant(127.5));
  ThreadPool pool;
  std::vector<std::uint32_t> pixels;
  VolumeCamera camera;
  camera.width = camera.height = static_cast<int>(state.range(2));
  double angle = 0.0;
  for (auto _ : state) {
    angle += 0.26;
    const Vec3 ahead(std::cos(angle), std::sin(angle), 0.1);
    const Vec3 right = ahead.cross(Vec3::UnitZ()).normalized();
    const double pixel = 0.5 / camera.width;
    camera.eye = middle - 700.0 * ahead;
    camera.right = pixel * right;
    camera.down = pixel * ahead.normalized().cross(right);
    camera.first = ahead - 0.5 * (camera.width - 1) * (camera.right + camera.down);
    caster.draw(camera, pool, pixels);
    benchmark::DoNotOptimize(pixels.data());
  }
}
BENCHMARK(a_turn)
    ->ArgNames({"mode", "preset", "pixels", "step"})
    ->ArgsProduct({{0}, {0, 1, 2}, {256}, {20}})
    ->ArgsProduct({{0}, {0, 1, 2}, {512}, {10}})
    ->ArgsProduct({{1, 2, 3}, {0}, {256}, {20}})
    ->ArgsProduct({{1, 2, 3}, {0}, {512}, {10}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// The cost of a moving needle: the rays up to it through the pixels that it covers, on one thread.
void needle_pixels(benchmark::State& state) {
  const auto patient = volume();
  VolumeLook look;
  look.transfer = preset_function(TransferPreset::soft_tissue);
  const RayCaster caster(patient, look, step_of(*patient, 1.0));
  const Vec3 middle = patient->grid.to_patient(Vec3::Constant(127.5)), eye = middle - 700.0 * Vec3::UnitY();
  for (auto _ : state) {
    float opacity = 0.0F;
    for (int i = 0; i < 1500; ++i) {
      opacity += caster.cast(eye, Vec3(0.00005 * i, 1.0, 0.0).normalized(), 700.0).opacity;
    }
    benchmark::DoNotOptimize(opacity);
  }
}
BENCHMARK(needle_pixels)->Unit(benchmark::kMillisecond);

// The view into a mannequin that stands 600 mm before a camera of 1280 x 720: an oval of 250 x 350 pixels with
// see-through soft tissue, at a step of one voxel. Arguments: threads, whether the picture moves.
void an_oval(benchmark::State& state) {
  const auto patient = volume();
  VolumeLook look;
  look.transfer = preset_function(TransferPreset::soft_tissue);
  const RayCaster caster(patient, look, step_of(*patient, 1.0));
  const Vec3 middle = patient->grid.to_patient(Vec3::Constant(127.5));
  ThreadPool pool(static_cast<int>(state.range(0)));
  ImageRgb picture(1280, 720);
  double angle = 0.0;
  for (auto _ : state) {
    angle += 0.01;
    const Vec3 ahead = Vec3(0.3 * std::sin(angle), -1.0, 0.2).normalized();  // onto the back
    const Vec3 right = ahead.cross(Vec3::UnitZ()).normalized();
    PictureCamera camera;
    camera.patient_from_camera.linear() << right, ahead.cross(right), ahead;
    camera.patient_from_camera.translation() = middle - 600.0 * ahead;
    camera.ray = [](const Eigen::Vector2d& pixel) {
      return Vec3((pixel.x() - 639.5) / 1005.0, (pixel.y() - 359.5) / 1005.0, 1.0);
    };
    const Cutaway cast = cast_cutaway(caster, camera, {{640.0, 360.0}, {125.0, 175.0}, 0.7}, picture.width,
                                      picture.height, pool, state.range(1) != 0);
    blend_cutaway(cast, pool, picture);
    benchmark::DoNotOptimize(picture.pixels.data());
    state.counters["rays"] = cast.rays;
  }
}
BENCHMARK(an_oval)
    ->ArgNames({"threads", "moving"})
    ->ArgsProduct({{1, 2}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void another_look(benchmark::State& state) {
  const auto patient = volume();
  for (auto _ : state) benchmark::DoNotOptimize(RayCaster(patient, {}, 1.0));
}
BENCHMARK(another_look)->Unit(benchmark::kMillisecond)->UseRealTime();

void is_prepared(benchmark::State& state) {
  torso();
  for (auto _ : state) benchmark::DoNotOptimize(prepare_volume(torso(), {}, {}));
}
BENCHMARK(is_prepared)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(3);

}  // namespace
}  // namespace bodkin::imaging
