#include "imaging/ultrasound/ultrasound_beam.h"

#include <algorithm>
#include <cmath>

namespace bodkin::imaging {

namespace {

constexpr double speed_in_tissue = 1.540;  // mm/us
constexpr double diffraction = 1.21;       // -6 dB width of a uniform aperture's main lobe, in lambda z / a
constexpr double sending_f_number = 2.5;
constexpr double shallowest = 1.0;  // mm; the formula of diffraction vanishes at the face

double one_way(double wavelength, double aperture, double focus, double depth) {
  const double z = std::max(depth, shallowest);
  return std::hypot(diffraction * wavelength * z / aperture, aperture * (1.0 - z / focus));
}

}  // namespace

double UltrasoundBeam::lateral(double depth) const {
  const double sending = one_way(wavelength, sent, focus, depth);
  const double z = std::max(depth, shallowest);
  const double open = std::min(aperture, z / f_number);
  const double listening = diffraction * wavelength * z / open;
  return sending * listening / std::hypot(sending, listening);
}

double UltrasoundBeam::elevation(double depth) const {
  return one_way(wavelength, height, lens, depth) / std::sqrt(2.0);
}

UltrasoundBeam ultrasound_beam(const anatomy::UltrasoundProbe& probe, const UltrasoundSettings& settings) {
  UltrasoundBeam beam;
  beam.wavelength = speed_in_tissue / (settings.frequency > 0.0 ? settings.frequency : probe.frequency);
  beam.pulse = 0.5 * probe.cycles * beam.wavelength;
  beam.aperture = probe.aperture();
  beam.focus = settings.focus;
  beam.sent = std::min(beam.aperture, settings.focus / sending_f_number);
  beam.height = probe.height;
  beam.lens = probe.lens;
  return beam;
}

}  // namespace bodkin::imaging
