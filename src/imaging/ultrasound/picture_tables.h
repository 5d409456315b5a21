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
#include "imaging/ultrasound/ultrasound_beam.h"

namespace bodkin::imaging {

// Look-up tables for an image, recomputed when a setting changes.
struct PictureTables {
  int stride = 0;        // lines, up to a whole number of scan::lanes
  float matched = 0.0F;  // AcousticVolume::unit

  std::vector<Vec3> line_origin, line_direction;  // by line, probe's frame
  std::vector<std::uint64_t> media;               // scan::media, in the format of scan::March
  struct Cells {
    std::array<float, 3> per_voxel{};  // along the lattice's axes
    std::array<float, 3> first{};      // of the lattice's first voxel
  };
  Cells cells, bundles;
  std::vector<float> speckle_gain;          // by sample: restores the level of speckle reduced by the widths
  std::vector<std::vector<float>> offsets;  // by pass of the slice, by sample: mm across the slice

  scan::Row row{};                // common to all rows
  std::vector<float> axial;       // weights of the pulse
  std::vector<float> lateral;     // by sample: (scan::edge + 1) weights of the beam
  std::vector<int> lateral_half;  // by sample
  std::vector<float> gain;        // by sample: amplitude of gain and time-gain compensation
  std::vector<float> clutter[2];  // samples x stride: noise of the face and what is next to it

  // The factor, at least 1, by which the pulse leaves less of an echo distributed evenly over `length` samples than
  // of one in a single sample.
  double ramp_loss(double length) const noexcept;
  // The fields that belong to one row, except `grey` and `work`.
  void describe(int sample, scan::Row& described) const noexcept;
};

PictureTables picture_tables(const AcousticVolume& patient, const anatomy::UltrasoundProbe& probe,
                             const UltrasoundSettings& settings, const UltrasoundDetail& detail,
                             const ScanLines& lines, const UltrasoundBeam& beam, const std::vector<SliceRay>& rays,
                             const std::vector<SlicePass>& passes);

}  // namespace bodkin::imaging
