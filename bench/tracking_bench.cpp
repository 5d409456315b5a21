// Processor time of each part of tracking at 1280 x 720, of all threads together: a board and three cubes that all
// move a little from picture to picture. Printed are the mean, the median and the spread of nine runs over the same
// eight pictures: the column "CPU" is that of one picture, or of one body in one picture.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tracking/footage.h"
#include "tracking/start_pose.h"
#include "tracking/tracker.h"
#include <benchmark/benchmark.h>

namespace bodkin::tracking {
namespace {

constexpr int pictures_in_all = 8, repetitions = 9;
constexpr double mm_a_picture = 2.0;  // of motion, 60 mm/s

struct Scene {
  CameraModel camera = footage_camera(1280, 720);
  std::vector<MarkerBody> bodies = station_bodies();
  std::vector<GreyImage> pictures;
  std::vector<std::vector<Pose>> truth;  // by picture and body
};

const Scene& scene() {
  static const Scene made = [] {
    Scene scene;
    scene.bodies.push_back(cube_body("third", 22, 60.0, 150.0));
    std::vector<Pose> poses(scene.bodies.size(), Pose::Identity());
    poses[0].linear() = Eigen::AngleAxisd(0.5, Vec3(1.0, 0.2, 0.0).normalized()).toRotationMatrix();
    poses[0].translation() = Vec3(-40.0, 60.0, 660.0);
    const Vec3 places[] = {{-170.0, -90.0, 600.0}, {20.0, -110.0, 620.0}, {190.0, -40.0, 580.0}};
    for (std::size_t cube = 1; cube < poses.size(); ++cube) {
      const double about = 0.5 + 0.1 * static_cast<double>(cube);
      poses[cube].linear() =
          (Eigen::AngleAxisd(about, Vec3::UnitY()) * Eigen::AngleAxisd(0.5, Vec3::UnitX())).toRotationMatrix();
      poses[cube].translation() = places[cube - 1];
    }
    for (int n = 0; n < pictures_in_all; ++n) {
      std::vector<PlacedBody> placed;
      for (std::size_t body = 0; body < poses.size(); ++body) {
        if (body > 0) poses[body].translation().x() += mm_a_picture;
        placed.push_back({&scene.bodies[body], poses[body]});
      }
      scene.pictures.push_back(render_picture(scene.camera, {}, placed, 40U + static_cast<std::uint64_t>(n)));
      scene.truth.push_back(poses);
    }
    return scene;
  }();
  return made;
}

void search_whole_picture(benchmark::State& state) {
  const Scene& of = scene();
  std::size_t n = 0;
  for (auto _ : state) benchmark::DoNotOptimize(search_markers(of.pictures[n++ % of.pictures.size()]));
}

// The places of the bodies in the previous image.
void search_boxes(benchmark::State& state) {
  const Scene& of = scene();
  std::size_t n = 0;
  for (auto _ : state) {
    const std::size_t at = 1 + n++ % (of.pictures.size() - 1);
    std::vector<PictureBox> boxes;
    for (std::size_t body = 0; body < of.bodies.size(); ++body) {
      if (const auto box = search_box(of.bodies[body], of.truth[at - 1][body], of.camera)) boxes.push_back(*box);
    }
    benchmark::DoNotOptimize(search_markers(of.pictures[at], boxes));
  }
}

// From the best start pose, as all corners of the body give it.
void refine_a_body(benchmark::State& state) {
  const Scene& of = scene();
  const auto body = static_cast<std::size_t>(state.range(0));
  const PhotometricRefinement refinement(of.camera);
  std::vector<int> ids;
  std::vector<FoundMarker> found = search_markers(of.pictures[0]);
  for (const FoundMarker& marker : found) {
    if (of.bodies[body].face_of(marker.id) != nullptr) ids.push_back(marker.id);
  }
  const std::vector<StartPose> starts = start_poses(of.camera, of.bodies[body], found);
  if (starts.empty()) return state.SkipWithError("the body is not seen");
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        refinement.refine(of.pictures[0], of.bodies[body], ids, starts.front().camera_from_body));
  }
  state.counters["markers"] = static_cast<double>(ids.size());
}

// A whole image: search, start poses, refinement of each, misfit. `every`: s between searches of the whole picture.
void track(benchmark::State& state, double every) {
  const Scene& of = scene();
  TrackerSettings settings;
  settings.search_every = every;
  Tracker tracker(of.camera, of.bodies, settings);
  const auto show = [&](std::size_t n) -> const std::vector<TrackedPose>& {
    return tracker.track(of.pictures[n % of.pictures.size()], static_cast<double>(n) / 30.0);
  };
  std::size_t n = 0;
  show(n++);
  int not_ok = 0;
  for (auto _ : state) {
    for (const TrackedPose& pose : show(n++)) not_ok += pose.status == TrackingStatus::ok ? 0 : 1;
  }
  state.counters["not ok"] = not_ok;
}

void track_in_boxes(benchmark::State& state) {
  track(state, 1e9);
}

void track_with_whole_searches(benchmark::State& state) {
  track(state, 0.0);
}

void settle(benchmark::internal::Benchmark* one) {
  one->Unit(benchmark::kMillisecond)
      ->MeasureProcessCPUTime()
      ->Repetitions(repetitions)
      ->ReportAggregatesOnly(true)
      ->MinTime(0.3);
}

BENCHMARK(search_whole_picture)->Apply(settle);
BENCHMARK(search_boxes)->Apply(settle);
BENCHMARK(refine_a_body)->DenseRange(0, 3)->Apply(settle);
BENCHMARK(track_in_boxes)->Apply(settle);
BENCHMARK(track_with_whole_searches)->Apply(settle);

}  // namespace
}  // namespace bodkin::tracking
