// Pictures of a patient made by hand, to be taken on one kind of processor and compared with those of another.
//   ultrasound_pictures OUTPUT        takes them, says the digest of each, and writes all pixels to OUTPUT
//   ultrasound_pictures MINE OTHER    compares two such files; fails where pictures differ by more than rounding
// A picture that is not the same on every processor path and for any number of threads fails, too.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/random.h"
#include "imaging/ultrasound/ultrasound.h"

namespace {

using namespace bodkin;
using namespace bodkin::anatomy;
using namespace bodkin::imaging;

TissueProperties tissue_of(TissueId id, const char* name, double hounsfield, const AcousticTissue& acoustic,
                           double young) {
  TissueProperties properties{.id = id, .name = name, .title = name, .hounsfield = hounsfield};
  properties.deformable.young = young;
  properties.acoustic = acoustic;
  return properties;
}

// The tissue at a place: skin at y = 8, fat and muscle in layers that wave, a vertebra's arch with a shadow to throw,
// a bubble of gas and a cyst.
TissueId tissue_at(const Vec3& place) {
  const double wave = 2.0 * std::sin(0.11 * place.x()) + 1.5 * std::sin(0.17 * place.z());
  if (place.y() < 8.0) return tissue::air;
  if (place.y() < 10.0) return tissue::skin;
  if ((place - Vec3(14.0, 48.0, 2.0)).norm() < 6.0) return tissue::gas;
  if ((place - Vec3(-18.0, 38.0, 0.0)).norm() < 8.0) return tissue::cerebrospinal_fluid;
  const double arch = (Vec3(place.x() + 2.0, 0.8 * (place.y() - 66.0), 0.3 * place.z())).norm();
  if (arch < 18.0) return arch > 16.0 ? tissue::cortical_bone : tissue::cancellous_bone;
  return place.y() < 20.0 + wave ? tissue::fat : tissue::muscle;
}

Case patient_by_hand() {
  Case patient;
  patient.library =
      TissueLibrary({tissue_of(tissue::air, "air", -1000.0, {0.0004, 12.0, 1.0, -200.0}, 0.0),
                     tissue_of(tissue::skin, "skin", 20.0, {1.7, 1.9, 1.1, -26.0}, 0.1),
                     tissue_of(tissue::fat, "fat", -90.0, {1.38, 0.5, 1.0, -41.0}, 0.01),
                     tissue_of(tissue::muscle, "muscle", 50.0, {1.67, 0.7, 1.1, -35.0, 0.7, 4.0}, 0.03),
                     tissue_of(tissue::cortical_bone, "cortical_bone", 1100.0, {7.8, 12.0, 1.0, -25.0, 0.2}, 0.0),
                     tissue_of(tissue::cancellous_bone, "cancellous_bone", 250.0, {2.8, 9.0, 1.0, -28.0}, 0.0),
                     tissue_of(tissue::cerebrospinal_fluid, "fluid", 5.0, {1.52, 0.02, 1.0, -75.0}, 0.0),
                     tissue_of(tissue::gas, "gas", -900.0, {0.0004, 12.0, 1.0, -200.0}, 0.0)});
  Grid grid;
  grid.size = {61, 71, 41};
  grid.spacing = Vec3(1.25, 1.25, 1.5);
  grid.origin = Vec3(-37.5, 0.0, -30.0);
  patient.tissues = TissueVolume(grid, tissue::air);
  patient.ct = CtVolume(grid, std::int16_t{-1000});
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const TissueId id = tissue_at(grid.to_patient(Vec3(i, j, k)));
        const double noise = 15.0 * hash_noise(5, static_cast<std::int64_t>(grid.offset(i, j, k)));
        patient.tissues.at(i, j, k) = id;
        patient.ct.at(i, j, k) = static_cast<std::int16_t>(patient.library.find(id)->hounsfield + noise);
      }
    }
  }
  return patient;
}

std::vector<UltrasoundProbe> probes() {
  const UltrasoundProbe linear{.name = "linear", .frequency = 7.0, .lowest = 5.0, .highest = 14.0, .pitch = 0.3};
  const UltrasoundProbe curvilinear{.name = "curvilinear",
                                    .kind = ProbeKind::curvilinear,
                                    .frequency = 3.5,
                                    .pitch = 0.35,
                                    .radius = 50.0,
                                    .height = 12.0};
  const UltrasoundProbe phased{
      .name = "phased", .kind = ProbeKind::phased, .frequency = 2.5, .elements = 64, .pitch = 0.3, .sector = 90.0};
  return {linear, curvilinear, phased};
}

// A needle and a displacement, as far as a picture has them.
struct Scene {
  std::string name;
  Pose pose = Pose::Identity();
  std::optional<NeedleInUltrasound> needle;
  bool displaced = false;
  UltrasoundSettings settings;
  UltrasoundDetail detail;
};

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  const auto add = [&all](const char* name) -> Scene& {
    Scene& scene = all.emplace_back();
    scene.name = name;
    scene.pose = probe_pose(Vec3(-2.0, 8.0, 1.0), Vec3(0.05, 1.0, 0.03), Vec3(1.0, 0.1, 0.2));
    scene.settings.depth = 70.0;
    if (all.size() > 1) {  // an emulator is slow
      scene.detail.lines = 128;
      scene.detail.samples = 192;
      scene.detail.width = 200;
      scene.detail.height = 150;
    }
    return scene;
  };
  NeedleInUltrasound needle;
  needle.pose = needle_pose(Vec3(4.0, 44.0, 1.5), Vec3(0.5, 1.0, 0.02));
  add("everything");
  add("pressed in").pose.translation() += Vec3(0.0, 4.0, 0.0);
  add("needle").needle = needle;
  add("displaced").displaced = true;
  Scene& both = add("needle and displaced");
  both.needle = needle;
  both.displaced = true;
  Scene& aslant = add("aslant with other settings");
  aslant.pose = probe_pose(Vec3(10.0, 9.0, -5.0), Vec3(-0.3, 1.0, 0.2), Vec3(0.3, 0.0, 1.0));
  aslant.settings.gain = 6.0;
  aslant.settings.dynamic_range = 75.0;
  aslant.settings.focus = 25.0;
  aslant.settings.sliders = {-4.0, 0.0, 1.0, 2.0, 3.0, 0.0, -2.0, 5.0};
  add("without gel").settings.gel = false;
  add("five rays").detail.slices = 5;
  add("seven rays").detail.slices = 7;
  add("one ray").detail.slices = 1;
  add("no speckle").detail.speckle = false;
  add("no reverberation").detail.reverberation = false;
  add("no clutter").detail.clutter = false;
  Scene& paper = add("features of the paper");
  paper.detail = paper_detail();
  paper.detail.lines = paper.detail.samples = 160;
  Scene& odd = add("sizes that fill no block");
  odd.detail = {.lines = 83, .samples = 131, .width = 101, .height = 90};
  return all;
}

std::vector<float> displacement_values() {
  std::vector<float> moved;
  for (int i = 0; i < 3 * 9 * 9; ++i) moved.push_back(static_cast<float>(1.5 * hash_noise(9, i)));
  return moved;
}

std::uint64_t digest(const std::vector<std::uint8_t>& pixels) {
  std::uint64_t sum = 0;
  for (const std::uint8_t grey : pixels) sum = mix64(sum ^ grey);
  return sum;
}

int take_pictures(const char* file) {
  const Case patient = patient_by_hand();
  const auto volume = acoustic_volume(patient, {});
  const std::vector<float> moved = displacement_values();
  const ScanDisplacement displacement{Vec3(-32.0, 0.0, 0.0), 8.0, 9, 9, moved};
  std::ofstream output(file, std::ios::binary);
  // The patient itself comes first: impedances are computed, too.
  std::vector<std::uint8_t> bytes;
  for (std::size_t at = 0; at < volume->voxels.size(); ++at)
    bytes.push_back(static_cast<std::uint8_t>(volume->impedance(at) >> 6));
  output << "impedances," << bytes.size() << ",1\n";
  output.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  bool equal = true;
  for (const UltrasoundProbe& probe : probes()) {
    for (const Scene& scene : scenes()) {
      std::vector<std::uint8_t> first;
      const auto take = [&](ProcessorPath path, int threads) {
        UltrasoundDetail detail = scene.detail;
        detail.threads = threads;
        Ultrasound machine(volume, probe, scene.settings, detail, path);
        const UltrasoundFrame& frame =
            machine.image(scene.pose, scene.needle, scene.displaced ? std::optional(displacement) : std::nullopt);
        if (first.empty()) first = frame.pixels;
        if (frame.why != NoImage::none || first != frame.pixels) {
          std::printf("%s, %s: %s on the path %s with %d threads\n", probe.name.c_str(), scene.name.c_str(),
                      frame.why != NoImage::none ? "no picture" : "another picture",
                      std::string(name_of(path)).c_str(), threads);
          equal = false;
        }
      };
      for (const ProcessorPath path : processor_paths()) take(path, 1);
      take(best_processor_path(), 2);
      double sum = 0.0;
      for (const std::uint8_t grey : first) sum += grey;
      const std::string name = std::string(probe.name) + ": " + scene.name;
      std::printf("%016llx  mean %7.3f  %s\n", static_cast<unsigned long long>(digest(first)),
                  sum / static_cast<double>(first.size()), name.c_str());
      output << name << ',' << scene.detail.width << ',' << scene.detail.height << '\n';
      output.write(reinterpret_cast<const char*>(first.data()), static_cast<std::streamsize>(first.size()));
    }
  }
  output.close();
  return equal && output ? EXIT_SUCCESS : EXIT_FAILURE;
}

struct Picture {
  std::string name;
  std::vector<std::uint8_t> pixels;
};

// Reads what take_pictures() wrote: "name,width,height\n" and the pixels, again and again.
std::vector<Picture> read_pictures(const char* file) {
  std::ifstream input(file, std::ios::binary);
  std::vector<Picture> pictures;
  std::string name, width, height;
  while (std::getline(input, name, ',') && std::getline(input, width, ',') && std::getline(input, height)) {
    Picture picture{name, std::vector<std::uint8_t>(std::stoul(width) * std::stoul(height))};
    input.read(reinterpret_cast<char*>(picture.pixels.data()), static_cast<std::streamsize>(picture.pixels.size()));
    if (!input) return {};
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

int compare_pictures(const char* mine, const char* other) {
  constexpr double most_pixels = 1e-4;  // the share of all pixels that may differ, by one grey
  const std::vector<Picture> a = read_pictures(mine), b = read_pictures(other);
  if (a.size() < 2 || a.size() != b.size()) {
    std::printf("%s holds %zu pictures, %s %zu\n", mine, a.size(), other, b.size());
    return EXIT_FAILURE;
  }
  std::size_t differing = 0, all = 0;
  int most = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    if (a[n].name != b[n].name || a[n].pixels.size() != b[n].pixels.size()) {
      std::printf("'%s' is beside '%s'\n", a[n].name.c_str(), b[n].name.c_str());
      return EXIT_FAILURE;
    }
    if (*std::max_element(a[n].pixels.begin(), a[n].pixels.end()) < 100) {
      std::printf("'%s' is black: there is nothing to compare\n", a[n].name.c_str());
      return EXIT_FAILURE;
    }
    std::size_t here = 0;
    for (std::size_t i = 0; i < a[n].pixels.size(); ++i) {
      const int off = std::abs(int{a[n].pixels[i]} - int{b[n].pixels[i]});
      most = std::max(most, off);
      here += off > 0 ? 1 : 0;
    }
    if (here > 0) std::printf("%zu of %zu differ: %s\n", here, a[n].pixels.size(), a[n].name.c_str());
    differing += here;
    all += a[n].pixels.size();
  }
  std::printf("%zu pictures, %zu pixels; %zu differ, by %d at most\n", a.size(), all, differing, most);
  return most <= 1 && static_cast<double>(differing) <= most_pixels * static_cast<double>(all) ? EXIT_SUCCESS
                                                                                               : EXIT_FAILURE;
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 2) return take_pictures(arguments[1]);
  if (count == 3) return compare_pictures(arguments[1], arguments[2]);
  std::fputs("usage: ultrasound_pictures OUTPUT | MINE OTHER\n", stderr);
  return EXIT_FAILURE;
}
