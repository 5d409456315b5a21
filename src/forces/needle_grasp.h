#pragma once

#include "anatomy/force_settings.h"

namespace bodkin::forces {

// Acupuncture's needle grasp: turning the needle winds tissue round it, which then holds it more firmly (Langevin et
// al. 2001).
//
//   factor = point (1 + max(one_way (1 - exp(-|n|/w)), two_way (1 - exp(-m/w))))
//
// n net turns since the entry, m turns back and forth (all turning less |n|), w turns_to_wind. Multiply the
// friction of the shaft (D and S of `layered`, Fc of `shaft_friction`) by it.
class NeedleGrasp {
 public:
  // Throws InputError for a setting outside its range.
  explicit NeedleGrasp(const anatomy::NeedleGraspSettings& settings);

  // `roll`: of the shaft, rad, with or without multiples of a turn; steps must be less than half a turn. Not finite:
  // as if unchanged. Returns the factor.
  double step(double roll) noexcept;
  void reset() noexcept;

  double turns() const noexcept { return net_; }  // n

 private:
  double factor() const noexcept;

  anatomy::NeedleGraspSettings settings_;
  bool started_ = false;
  double last_ = 0.0;   // rad
  double net_ = 0.0;    // turns
  double total_ = 0.0;  // turns
};

}  // namespace bodkin::forces
