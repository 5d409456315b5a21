#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "imaging/ultrasound/acoustic_volume.h"
#include "imaging/ultrasound/probe.h"
#include "imaging/ultrasound/scan_kernel.h"
#include "imaging/ultrasound/scan_lines.h"
#include "imaging/ultrasound/settings.h"
#include "imaging/ultrasound/slice_rays.h"
#include "imaging/ultrasound/sound_beam.h"

namespace bodkin::imaging {

// What a picture looks up, computed when a setting changes.
struct PictureTables {
  int stride = 0;        // lines, up to a whole number of scan::lanes
  float matched = 0.0F;  // AcousticVolume::unit

  std::vector<Vec3> line_origin, line_direction;  // by line, probe's frame
  std::vector<std::uint64_t> media;               // scan::media, as scan::March has them
  struct Cells {
    std::array<float, 3> per_voxel{};  // along the lattice's axes
    std::array<float, 3> first{};      // of the lattice's first voxel
  };
  Cells cells, bundles;
  std::vector<float> speckle_gain;          // by sample: undoes what the widths take away from the speckle's level
  std::vector<std::vector<float>> offsets;  // by pass of the slice, by sample: mm across the slice

  scan::Row row{};                // what all rows share
  std::vector<float> axial;       // weights of the pulse
  std::vector<float> lateral;     // by sample: (scan::edge + 1) weights of the beam
  std::vector<int> lateral_half;  // by sample
  std::vector<float> gain;        // by sample: amplitude of gain and time-gain compensation
  std::vector<float> clutter[2];  // samples x stride: noise of the face and what is next to it

  // By how much the pulse leaves less of an echo that is spread evenly over `length` samples than of one in a single
  // sample; 1 and more.
  double ramp_loss(double length) const noexcept;
  // The fields of a row that are its own, but for `grey` and `work`.
  void describe(int sample, scan::Row& described) const noexcept;
};

PictureTables picture_tables(const AcousticVolume& patient, const anatomy::UltrasoundProbe& probe,
                             const UltrasoundSettings& settings, const UltrasoundDetail& detail,
                             const ScanLines& lines, const SoundBeam& beam, const std::vector<SliceRay>& rays,
                             const std::vector<SlicePass>& passes);

}  // namespace bodkin::imaging
