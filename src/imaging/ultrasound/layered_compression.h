#pragma once

#include <span>
#include <vector>

#include "core/geometry.h"
#include "imaging/ultrasound/acoustic_volume.h"

namespace bodkin::imaging {

// Tissue compressed by a probe without a finite-element field: along one line, springs in series by Young's moduli
// from the skin to the first bone, which does not move, or to a depth that does not. The softer a tissue, the larger
// its part of the compression; none is compressed by more than `most_strain` of its thickness, the rest goes deeper.
// Memory is allocated by the constructor; everything else is noexcept and allocates none.
class LayeredCompression {
 public:
  static constexpr double most_strain = 0.6;     // largest shortening of a layer as a fraction of its rest thickness
  static constexpr double rigid_modulus = 10.0;  // MPa, from which a tissue is rigid: bone and metal
  static constexpr double soft_modulus = 0.02;   // MPa, of a tissue without a given modulus

  // Nothing moves `reach` mm below the resting skin (10 to 400); sampled every `spacing` mm (0.05 to 5). Throws
  // InputError when one of them is out of range.
  explicit LayeredCompression(double reach = 80.0, double spacing = 0.5);

  // Computes the compression below the face of a probe at `pose`, pushed `press` mm below the resting skin, along the
  // middle of its slice. No compression if `press` is not above zero or an argument is NaN.
  void settle(const AcousticVolume& patient, const Pose& pose, double press) noexcept;
  // As above, along a line from the face at `face` (patient, mm) in `direction` (unit).
  void settle(const AcousticVolume& patient, const Vec3& face, const Vec3& direction, double press) noexcept;
  // As above, for given layers: Young's moduli (MPa; 0: soft_modulus) every spacing() mm from the resting skin, cell
  // by cell. Fewer than cells() end at something rigid; further ones are ignored.
  void settle(std::span<const double> moduli, double press) noexcept;

  double spacing() const noexcept { return spacing_; }
  std::size_t cells() const noexcept { return moduli_.size(); }
  double press() const noexcept { return press_; }
  // mm below the resting skin, depth without motion: the first rigid tissue, or the reach.
  double far_end() const noexcept { return far_end_; }
  // mm by which the far end moved after all, because everything above was at its largest strain; nearly always 0.
  double excess() const noexcept { return excess_; }

  // mm below the resting skin of the tissue now `depth` mm below the face. Increases with depth, and is depth +
  // press() - excess() from the far end on; above the face, depth.
  double rest_depth(double depth) const noexcept;
  // mm along the line, displacement of the tissue now `depth` mm below the face: press() at the face, excess() at and
  // below the far end.
  double moved(double depth) const noexcept { return depth + press_ - rest_depth(depth); }
  // rest_depth every spacing() mm from the face, cells() + 1 values.
  std::span<const float> rest_depths() const noexcept { return rest_depths_; }

 private:
  void settle_layers(std::size_t layers, double press) noexcept;

  double spacing_, press_ = 0.0, far_end_ = 0.0, excess_ = 0.0;
  std::vector<double> moduli_;      // MPa, cell by cell from the resting skin; > 0 once settled
  std::vector<float> rest_depths_;  // mm
};

}  // namespace bodkin::imaging
