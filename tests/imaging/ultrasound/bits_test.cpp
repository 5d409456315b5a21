// The same image to the last bit on any processor; without allocation or locks.
#include "tests/imaging/ultrasound/hand_made_patient.h"
#include "tests/sanitized.h"
#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

// Lumps of every kind of medium, with noise in their impedances.
std::shared_ptr<AcousticVolume> lumpy_patient() {
  AcousticTissue fat = checks::clear_medium(1.38, 0.5), muscle = checks::clear_medium(1.67, 0.7),
                 bone = checks::clear_medium(7.0, 10.0), gas = checks::clear_medium(0.0004, 12.0);
  fat.echo = -20.0;
  muscle.echo = -25.0;
  muscle.variation = 6.0;
  muscle.density = 0.6;
  bone.echo = -35.0;
  bone.density = 0.2;
  const std::vector<AcousticTissue> media = {fat, muscle, bone, gas};
  const auto volume = checks::hand_made(
      {.half_width = 35.0, .above = 8.0, .depth = 80.0, .half_thickness = 15.0, .voxel = 1.0}, media,
      [](const Vec3& p) {
        const double waves = std::sin(0.31 * p.x()) + std::sin(0.23 * p.y() + 0.1 * p.z()) + std::cos(0.2 * p.z());
        return p.y() < 6.0 ? 1 : waves > 1.6 ? 3 : waves < -1.9 ? 4 : waves > 0.0 ? 2 : 1;
      });
  for (std::size_t at = 0; at < volume->voxels.size(); ++at) {
    const double varied = volume->impedance(at) * (1.0 + 0.01 * hash_noise(7, static_cast<std::int64_t>(at)));
    volume->voxels[at] = AcousticVolume::voxel(static_cast<std::int16_t>(varied), volume->tissue(at));
  }
  return volume;
}

struct Scene {
  Pose pose;
  std::optional<NeedleInUltrasound> needle;
  std::vector<float> moved;
  std::optional<ScanDisplacement> displacement;
};

Scene random_scene(Random& random) {
  Scene scene;
  scene.pose = probe_pose(Vec3(random.uniform(-12.0, 12.0), random.uniform(-2.0, 4.0), random.uniform(-6.0, 6.0)),
                          Vec3(random.uniform(-0.3, 0.3), 1.0, random.uniform(-0.3, 0.3)),
                          Vec3(random.normal(), random.uniform(-0.2, 0.2), random.normal()));
  if (random.uniform() < 0.6) {
    scene.needle.emplace();
    scene.needle->pose = scene.pose * needle_pose(Vec3(random.uniform(-10.0, 10.0), random.uniform(10.0, 50.0),
                                                       random.uniform(-1.0, 1.0)),
                                                  Vec3(random.uniform(-1.0, 1.0), 1.0, random.uniform(-0.05, 0.05)));
  }
  if (random.uniform() < 0.6) {
    for (int i = 0; i < 3 * 7 * 9; ++i) scene.moved.push_back(static_cast<float>(random.uniform(-1.5, 1.5)));
    scene.displacement = {Vec3(-25.0, 0.0, 0.0), 10.0, 7, 9, scene.moved};
  }
  return scene;
}

UltrasoundDetail odd_detail(int threads) {
  UltrasoundDetail detail;  // sizes that fill no block
  detail.lines = 83;
  detail.samples = 131;
  detail.width = 101;
  detail.height = 90;
  detail.threads = threads;
  return detail;
}

std::vector<UltrasoundProbe> probes_of_every_kind() {
  return {checks::flat_probe(), checks::curved_probe(), checks::phased_probe()};
}

TEST(SameBits, on_every_processor_path_and_for_any_number_of_threads) {
  const auto patient = lumpy_patient();
  Random random(11);
  for (const UltrasoundProbe& probe : probes_of_every_kind()) {
    std::vector<Ultrasound> machines;
    machines.emplace_back(patient, probe, UltrasoundSettings{}, odd_detail(1), ProcessorPath::scalar);
    for (const ProcessorPath path : processor_paths())
      machines.emplace_back(patient, probe, UltrasoundSettings{}, odd_detail(1), path);
    for (const int threads : {2, 3}) machines.emplace_back(patient, probe, UltrasoundSettings{}, odd_detail(threads));
    int images = 0;
    for (int number = 0; number < (sanitized ? 5 : 12); ++number) {
      Scene scene = random_scene(random);
      const UltrasoundFrame first = machines.front().image(scene.pose, scene.needle, scene.displacement);
      images += first.why == NoImage::none ? 1 : 0;
      for (std::size_t other = 1; other < machines.size(); ++other) {
        const UltrasoundFrame& frame = machines[other].image(scene.pose, scene.needle, scene.displacement);
        ASSERT_EQ(frame.pixels, first.pixels) << "machine " << other << ", scene " << number << ", " << probe.name;
        ASSERT_EQ(frame.contact, first.contact);
      }
    }
    EXPECT_GT(images, 2) << probe.name;
  }
}

TEST(SameBits, whatever_was_drawn_before) {
  const auto patient = lumpy_patient();
  Random random(12);
  std::vector<Scene> scenes;
  for (int number = 0; number < 8; ++number) scenes.push_back(random_scene(random));
  Ultrasound machine(patient, checks::curved_probe(), {}, odd_detail(1));
  std::vector<std::vector<std::uint8_t>> pictures;
  for (const Scene& scene : scenes) {
    Ultrasound fresh(patient, checks::curved_probe(), {}, odd_detail(1));
    pictures.push_back(fresh.image(scene.pose, scene.needle, scene.displacement).pixels);
    EXPECT_EQ(machine.image(scene.pose, scene.needle, scene.displacement).pixels, pictures.back());
  }
  EXPECT_NE(pictures[0], pictures[1]);
  // And after any previous settings.
  UltrasoundSettings other;
  other.depth = 40.0;
  other.frequency = 2.5;
  machine.set(other);
  machine.image(scenes[0].pose);
  machine.set({});
  EXPECT_EQ(machine.image(scenes[0].pose, scenes[0].needle, scenes[0].displacement).pixels, pictures[0]);
}

TEST(RealTimePictures, take_no_memory_and_no_lock_after_the_first) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer watches the heap";
  const auto patient = lumpy_patient();
  for (const int threads : {1, 2}) {
    for (const UltrasoundProbe& probe : probes_of_every_kind()) {
      Ultrasound machine(patient, probe, {}, odd_detail(threads));
      Random random(13);
      machine.image(Pose::Identity());
      for (int number = 0; number < 10; ++number) {
        Scene scene = random_scene(random);
        const RealTimeGuard guard;
        machine.image(scene.pose, scene.needle, scene.displacement);
        ASSERT_EQ(RealTimeGuard::heap_calls(), 0u) << probe.name << ", " << threads << " threads";
        ASSERT_EQ(RealTimeGuard::lock_calls(), 0u) << probe.name << ", " << threads << " threads";
      }
    }
  }
}

}  // namespace
}  // namespace bodkin
