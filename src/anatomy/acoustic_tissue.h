#pragma once

#include "core/parameter.h"
#include "core/settings_check.h"

namespace bodkin::anatomy {

// The acoustic properties of a tissue (docs/ultrasound.md).
struct AcousticTissue {
  double impedance = 0.0;
  double attenuation = 0.5;
  double power = 1.0;
  double echo = -38.0;
  double density = 1.0;
  double variation = 0.0;

  static constexpr double least_impedance = 0.0001;  // MRayl, a quarter of air's

  template <typename S = AcousticTissue>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"impedance_MRayl", &S::impedance, Range{0.0, 100.0}, "MRayl",
                  "at the tissue's typical HU; 0: from its HU alone", Origin::choice},
        Parameter{"attenuation_dB_per_cm_MHz", &S::attenuation, Range{0.0, 100.0}, "dB/cm", "at 1 MHz, one way",
                  Origin::choice},
        Parameter{"attenuation_power", &S::power, Range{0.5, 2.0}, "", "power of the frequency in the attenuation",
                  Origin::choice},
        Parameter{"echo_dB", &S::echo, Range{-200.0, 0.0}, "dB",
                  "mean level of its speckle below the echo of a perfect mirror; -200: none", Origin::choice},
        Parameter{"scatterer_density", &S::density, Range{0.0, 1.0}, "",
                  "share of the cells of the scatterer volume that scatter; 1: fully developed speckle",
                  Origin::choice},
        Parameter{"fibre_variation_dB", &S::variation, Range{0.0, 20.0}, "dB",
                  "by which bundles along the fibres (head to foot) differ", Origin::choice}};
  }
  static constexpr auto relations() {
    return std::tuple{Relation<AcousticTissue>{
        [](const AcousticTissue& tissue) { return tissue.impedance == 0.0 || tissue.impedance >= least_impedance; },
        "impedance_MRayl is above 0 and below 0.0001, expected 0.0001 to 100 MRayl, or 0 to take it from the HU"}};
  }
};

}  // namespace bodkin::anatomy
