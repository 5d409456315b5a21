#pragma once

#include <array>
#include <tuple>

#include "core/settings_check.h"

namespace bodkin::anatomy {
struct UltrasoundProbe;
}  // namespace bodkin::anatomy

namespace bodkin::imaging {

// The settings of a machine.
struct UltrasoundSettings {
  double depth = 80.0;
  double gain = 0.0;
  double dynamic_range = 60.0;
  double focus = 40.0;
  double frequency = 0.0;
  // dB of the eight sliders of the time-gain compensation, from the face to the depth; -20 to 20. The machine itself
  // compensates the attenuation of soft tissue (0.7 dB/cm/MHz, there and back).
  std::array<double, 8> sliders{};
  bool gel = true;  // fills gaps of up to 5 mm between the face and the skin

  bool operator==(const UltrasoundSettings&) const = default;

  template <typename S = UltrasoundSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"depth_mm", &S::depth, Range{10.0, 400.0}, "mm", "shown", Origin::choice},
        Parameter{"gain_dB", &S::gain, Range{-40.0, 40.0}, "dB", "of everything", Origin::choice},
        Parameter{"dynamic_range_dB", &S::dynamic_range, Range{20.0, 120.0}, "dB", "from black to white",
                  Origin::choice},
        Parameter{"focus_mm", &S::focus, Range{5.0, 400.0}, "mm", "where the beam is narrowest", Origin::choice},
        Parameter{"frequency_MHz", &S::frequency, Range{0.0, 100.0}, "MHz", "within the probe's band; 0: its centre",
                  Origin::choice}};
  }
};

// The resolution of an image's computation, and the parts of the physics that are computed.
struct UltrasoundDetail {
  int lines = 300;  // computed 32 at a time
  int samples = 300;
  int width = 300;
  int height = 300;
  int slices = 3;
  bool speckle = true;  // including the pulse's length and the beam's width
  bool reverberation = true;
  bool clutter = true;   // noise of the near field
  bool yielding = true;  // tissue yields under a pressed face; false: the face is where it is in the CT
  int threads = 1;

  template <typename S = UltrasoundDetail>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"lines", &S::lines, Range{16.0, 2048.0}, "", "scanlines", Origin::choice},
        Parameter{"samples", &S::samples, Range{32.0, 4096.0}, "", "along a line", Origin::choice},
        Parameter{"width", &S::width, Range{16.0, 4096.0}, "", "pixels of the picture", Origin::choice},
        Parameter{"height", &S::height, Range{16.0, 4096.0}, "", "pixels of the picture", Origin::choice},
        Parameter{"slices", &S::slices, Range{1.0, 7.0}, "",
                  "rays across the thickness of the slice, an odd number; 1: infinitely thin", Origin::choice},
        Parameter{"threads", &S::threads, Range{1.0, 64.0}, "", "that compute", Origin::choice}};
  }
  template <typename S = UltrasoundDetail>
  static constexpr auto relations() {
    return std::tuple{
        Relation<S>{[](const S& s) { return s.slices % 2 == 1; }, "slices is an even number, expected 1, 3, 5 or 7"}};
  }
};

// The feature set of Sutherland et al. 2013: reflection, attenuation, shadow, bone edges, log compression, scan
// conversion.
UltrasoundDetail paper_detail();

// Throws InputError naming the field, its value and the expected range, when a setting is out of range or NaN, or for
// a frequency that the probe does not have.
void check(const UltrasoundSettings& settings, const anatomy::UltrasoundProbe& probe);
// As above, for a detail.
void check(const UltrasoundDetail& detail);

}  // namespace bodkin::imaging
