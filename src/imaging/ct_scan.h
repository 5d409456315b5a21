#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "imaging/slice.h"

namespace bodkin::imaging {

// The settings of a CT scanner's console.
enum class ScanKernel : std::uint8_t { soft, standard, sharp };

struct ScanProtocol {
  double from = 0.0, to = 100.0;  // mm along z (LPS, upwards) of the middles of the first slice and at most the last
  double thickness = 5.0;         // mm, 0.5 to 10
  double spacing = 5.0;           // mm between the middles of slices, 0.5 to 20; more than the thickness leaves gaps
  ScanKernel kernel = ScanKernel::standard;

  bool operator==(const ScanProtocol&) const = default;
};

// The error in a protocol, one sentence; empty: none.
std::string trouble_with(const ScanProtocol& protocol);
// Middles of the slices in the order of acquisition, from `from` towards `to`, mm.
std::vector<double> slice_positions(const ScanProtocol& protocol);

// A needle in the patient during the scan.
struct ScannedNeedle {
  Pose pose = Pose::Identity();         // of the tip, LPS mm; the third axis runs from hub to tip
  double radius = 0.36, length = 90.0;  // mm

  Vec3 hub() const { return pose.translation() - length * needle_axis(pose); }
};

// The common pixels of all slices of a patient: as fine as the CT, at most 512 along each side, around the whole CT.
// `z` of its corner is not used.
SlicePlane scan_plane(const anatomy::Grid& grid);

struct ScanSlice {
  double z = 0.0;                        // mm, of its middle
  std::vector<std::int16_t> hounsfield;  // height x width of the plane, row by row
};

inline constexpr std::int16_t metal_hounsfield = 3071;

// One slice: the mean of the CT over the thickness, and the needle as metal with its share of each pixel, but never
// fainter than metal in a scanner's image. Outside the CT is air.
ScanSlice take_slice(const anatomy::CtVolume& ct, const SlicePlane& plane, const ScanProtocol& protocol, double z,
                     const std::optional<ScannedNeedle>& needle);

// A scan: slices in the order of acquisition.
struct CtScan {
  ScanProtocol protocol;
  SlicePlane plane;
  std::optional<ScannedNeedle> needle;
  std::vector<ScanSlice> slices;  // in the order of slice_positions(); fewer if it was cancelled

  // The slice that contains a position along z; nullptr in a gap.
  const ScanSlice* slice_at(double z) const;
  // A pixel of a slice, LPS mm.
  Vec3 point(const ScanSlice& slice, double column, double row) const;
};

// A sagittal (at this column) or a coronal (at this row) image reformatted from a scan: HU, one row for each `pixel`
// mm from the top (largest z) down; gaps and unscanned parts have no value (nothing_scanned).
enum class Reformat : std::uint8_t { sagittal, coronal };
inline constexpr std::int16_t nothing_scanned = -32768;
struct ReformattedSlice {
  int width = 0, height = 0;
  double pixel = 1.0, top = 0.0;  // mm
  std::vector<std::int16_t> hounsfield;
};
ReformattedSlice reformatted(const CtScan& scan, Reformat direction, int at);

// The overview before a scan: all voxels summed from the front or the side as in an X-ray, as grey levels, z upwards.
enum class ScoutView : std::uint8_t { frontal, lateral };
struct Scout {
  int width = 0, height = 0;
  double pixel = 1.0;  // mm
  double top = 0.0;    // mm along z of the upper edge
  std::vector<std::uint8_t> grey;

  double bottom() const { return top - pixel * height; }
};
Scout make_scout(const anatomy::CtVolume& ct, ScoutView view, double pixel = 1.0);

}  // namespace bodkin::imaging
