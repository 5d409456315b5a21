#pragma once

namespace bodkin {

// What a tissue is to sound (docs/ultrasound.md).
struct AcousticTissue {
  double impedance = 0.0;    // MRayl, of the tissue at its typical HU; 0.0001 to 100; 0 = from its HU alone
  double attenuation = 0.5;  // dB/cm at 1 MHz, one way; 0 to 100
  double power = 1.0;        // attenuation grows with frequency to this power; 0.5 to 2
  double echo = -38.0;       // dB, mean level of its speckle below a perfect mirror's echo; -200 (none) to 0
  double density = 1.0;      // share of the cells of the scatterer volume that scatter, 0 to 1; 1: fully developed
  double variation = 0.0;    // dB by which bundles along the fibres (here: head to foot) differ; 0 to 20
};

}  // namespace bodkin
