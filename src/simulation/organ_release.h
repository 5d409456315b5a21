#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "anatomy/case.h"

namespace bodkin::simulation {

// If the case says so (force_in_organs="none"), the force falls to zero while the tip is in an organ, whatever the
// model (Kwon et al. 2001: "force goes to zero when a critical organ is touched"). An organ is a structure that the
// case marks as critical, or the tissues `organ` and `lung`, except bone and the structure of the planned target. The
// force fades linearly within 50 ms, and returns within 200 ms behind the organ, so that it never jumps.
class OrganRelease {
 public:
  static constexpr double fade = 0.05;      // s, from the full force to zero; our choice
  static constexpr double come_back = 0.2;  // s, from zero to the full force; our choice

  OrganRelease(const anatomy::Case& patient, double dt);

  // A new insertion: full force.
  void begin() noexcept { share_ = 1.0; }
  // One tick in contact, with the tip and its tissue. Returns the fraction of the force that is felt, 0 to 1; exactly
  // 1 if the case does not use this.
  double step(const Vec3& tip, anatomy::TissueId tissue) noexcept;

 private:
  bool is_organ(const Vec3& tip, anatomy::TissueId tissue) const noexcept;

  const anatomy::Case& patient_;
  bool is_on_;
  double falling_, rising_;  // of the share in one tick
  double share_ = 1.0;
  std::array<bool, 256> organ_tissue_{};  // by TissueId
  std::vector<bool> critical_;            // by label
  std::array<bool, 256> bone_{};
};

}  // namespace bodkin::simulation
