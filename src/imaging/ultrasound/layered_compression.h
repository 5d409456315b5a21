#pragma once

#include <span>
#include <vector>

#include "core/geometry.h"
#include "imaging/ultrasound/acoustic_volume.h"

namespace bodkin::imaging {

// Tissue under a probe that presses, where no finite-element field is at hand: along one line, springs in series by
// Young's moduli from the skin to the first bone, which does not move, or to a depth that does not. The softer a
// tissue, the more of the way it gives; none gives more than `most_strain` of its thickness, the rest goes deeper.
// Memory is taken at construction; everything else is noexcept and takes none.
class LayeredCompression {
 public:
  static constexpr double most_strain = 0.6;     // share of its rest thickness by which a layer shortens at most
  static constexpr double rigid_modulus = 10.0;  // MPa, from which a tissue is rigid: bone and metal
  static constexpr double soft_modulus = 0.02;   // MPa, of a tissue without a given modulus

  // `reach` mm below the resting skin nothing moves (10 to 400); sampled every `spacing` mm (0.05 to 5). Throws
  // InputError when one of them is out of range.
  explicit LayeredCompression(double reach = 80.0, double spacing = 0.5);

  // Settles the tissue below the face of a probe at `pose`, pushed `press` mm below the resting skin, along the
  // middle of its slice. Nothing is pressed where `press` is not above zero, or something is not a number.
  void settle(const AcousticVolume& patient, const Pose& pose, double press) noexcept;
  // The same along a line that leaves the face at `face` (patient, mm) into `direction` (unit).
  void settle(const AcousticVolume& patient, const Vec3& face, const Vec3& direction, double press) noexcept;
  // The same of layers that one gives: Young's moduli (MPa; 0: soft_modulus) every spacing() mm from the resting skin
  // on, cell by cell. Fewer than cells() end at something rigid, more are not looked at.
  void settle(std::span<const double> moduli, double press) noexcept;

  double spacing() const noexcept { return spacing_; }
  std::size_t cells() const noexcept { return moduli_.size(); }
  double press() const noexcept { return press_; }
  // mm below the resting skin where nothing moves: the first rigid tissue, or the reach.
  double far_end() const noexcept { return far_end_; }
  // mm by which the far end had to give way after all, since everything above was at its most strain; nearly always
  // 0.
  double excess() const noexcept { return excess_; }

  // mm below the resting skin of what now is `depth` mm below the face. Increases with depth, and is depth + press()
  // - excess() from the far end on; above the face, depth.
  double rest_depth(double depth) const noexcept;
  // mm along the line by which what now is `depth` mm below the face has moved: press() at the face, excess() at and
  // below the far end.
  double moved(double depth) const noexcept { return depth + press_ - rest_depth(depth); }
  // rest_depth every spacing() mm from the face on, cells() + 1 of them.
  std::span<const float> rest_depths() const noexcept { return rest_depths_; }

 private:
  void settle_layers(std::size_t layers, double press) noexcept;

  double spacing_, press_ = 0.0, far_end_ = 0.0, excess_ = 0.0;
  std::vector<double> moduli_;      // MPa, cell by cell from the resting skin; > 0 once settled
  std::vector<float> rest_depths_;  // mm
};

}  // namespace bodkin::imaging
