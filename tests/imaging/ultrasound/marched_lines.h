#pragma once

#include <array>
#include <bit>
#include <limits>
#include <vector>

#include "tests/imaging/ultrasound/hand_made_patient.h"

#include "imaging/ultrasound/scan_kernel.h"

namespace bodkin::checks {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;

// As many lines as the kernel takes at once, through a patient, marched by the kernel alone: echoes and remaining
// sound at every sample, before further processing.
struct MarchedLines {
  int samples = 0;
  std::vector<float> in_phase, quadrature, amplitude, strong_at, strong_echo;

  double echo(int line, int sample) const { return static_cast<double>(in_phase[at(line, sample)]); }
  double reaches(int line, int sample) const { return static_cast<double>(amplitude[at(line, sample)]); }
  // Of the samples from `from` on, before `to`.
  double sum(int line, int from, int to) const {
    double all = 0.0;
    for (int k = from; k < to; ++k) all += echo(line, k);
    return all;
  }
  std::size_t at(int line, int sample) const { return static_cast<std::size_t>(sample * scan::lanes + line); }
};

// How a line starts.
struct LineStart {
  Vec3 origin = Vec3::Zero();      // mm
  Vec3 direction = Vec3::UnitY();  // unit
  double gel = 0.0;                // samples before the skin
};

struct MarchSettings {
  double spacing = 0.25;  // mm
  int samples = 200;
  double frequency = 1.0;  // MHz
  double mirror = 0.6, bone_mirror = 0.75, bone_edge = 0.8;
  double matched = 1.6;  // MRayl
};

inline MarchedLines march_lines(const AcousticVolume& patient, const std::array<LineStart, scan::lanes>& starts,
                                const MarchSettings& settings, ProcessorPath path = best_processor_path()) {
  const auto samples = static_cast<std::size_t>(settings.samples);
  MarchedLines lines;
  lines.samples = settings.samples;
  for (std::vector<float>* rows : {&lines.in_phase, &lines.quadrature, &lines.amplitude})
    rows->assign(samples * scan::lanes, std::numeric_limits<float>::quiet_NaN());
  lines.strong_at.assign(scan::lanes, 0.0F);
  lines.strong_echo.assign(scan::lanes, 0.0F);

  std::array<std::array<float, scan::lanes>, 10> rows{};
  for (std::size_t l = 0; l < scan::lanes; ++l) {
    const Vec3 origin = patient.grid.to_index(starts[l].origin);
    const Vec3 step = settings.spacing * starts[l].direction.cwiseQuotient(patient.grid.spacing);
    for (int axis = 0; axis < 3; ++axis) {
      rows[static_cast<std::size_t>(axis)][l] = static_cast<float>(origin[axis]);
      rows[static_cast<std::size_t>(axis + 3)][l] = static_cast<float>(step[axis]);
      rows[static_cast<std::size_t>(axis + 6)][l] = static_cast<float>(starts[l].direction[axis]);
    }
    rows[9][l] = static_cast<float>(starts[l].gel);
  }
  std::vector<float> gain(samples, 1.0F);
  const std::vector<float> leaves(scan::lanes, 1e6F);  // never: lines stay in the patient
  std::vector<std::uint64_t> media(scan::media, 0);    // no texture: nothing but the fall
  for (std::size_t id = 0; id < patient.media.size(); ++id) {
    const AcousticTissue& medium = patient.media[id];
    const double both_ways =
        2.0 * medium.attenuation * std::pow(settings.frequency, medium.power) * settings.spacing / 10.0;
    media[id] = std::bit_cast<std::uint32_t>(static_cast<float>(std::pow(10.0, -both_ways / 20.0)));
  }

  scan::March march{};
  march.voxels = patient.voxels.data();
  for (int axis = 0; axis < 3; ++axis) {
    march.size[axis] = patient.grid.size[static_cast<std::size_t>(axis)];
    march.per_mm[axis] = static_cast<float>(1.0 / patient.grid.spacing[axis]);
  }
  march.media = media.data();
  march.mirror = static_cast<float>(settings.mirror);
  march.bone_mirror = static_cast<float>(settings.bone_mirror);
  march.bone_edge = static_cast<float>(settings.bone_edge);
  march.surface = 1.0F;
  march.matched = static_cast<float>(settings.matched / AcousticVolume::unit);
  march.speckle_gain = gain.data();
  march.samples = settings.samples;
  march.stride = scan::lanes;
  march.origin = {rows[0].data(), rows[1].data(), rows[2].data()};
  march.step = {rows[3].data(), rows[4].data(), rows[5].data()};
  march.direction = {rows[6].data(), rows[7].data(), rows[8].data()};
  march.lines = scan::lanes;
  march.gel_samples = rows[9].data();
  march.leaves = leaves.data();
  march.weight = 1.0F;
  march.first = true;
  march.in_phase = lines.in_phase.data();
  march.quadrature = lines.quadrature.data();
  march.amplitude = lines.amplitude.data();
  march.strong_at = lines.strong_at.data();
  march.strong_echo = lines.strong_echo.data();
  scan::kernel(path).march(march, 0);
  return lines;
}

// The same start for all of them.
inline MarchedLines march_one(const AcousticVolume& patient, const LineStart& start, const MarchSettings& settings) {
  std::array<LineStart, scan::lanes> starts;
  starts.fill(start);
  return march_lines(patient, starts, settings);
}

// Reflected pressure, for 1, from a surface met at an angle whose cosine is `cosine`: Fresnel's law with the engine's
// speeds of sound, 1040 m/s + 310 m/s per MRayl.
inline double fresnel(double before, double behind, double cosine = 1.0) {
  const double ratio = (1040.0 + 310.0 * behind) / (1040.0 + 310.0 * before);
  const double bent = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
  const double refracted = bent > 0.0 ? std::sqrt(bent) : 0.0;
  return (behind * cosine - before * refracted) / (behind * cosine + before * refracted);
}

// The probe's received share: a mirror's lobe and the part scattered in all directions.
inline double received(double mirror, double cosine) {
  return mirror * std::pow(cosine, 16.0) + (1.0 - mirror) * cosine * cosine;
}

}  // namespace bodkin::checks
