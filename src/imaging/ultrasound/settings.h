#pragma once

#include <array>

namespace bodkin::anatomy {
struct UltrasoundProbe;
}  // namespace bodkin::anatomy

namespace bodkin::imaging {

// What a sonographer sets on a machine.
struct UltrasoundSettings {
  double depth = 80.0;          // mm shown; 10 to 400
  double gain = 0.0;            // dB, of everything; -40 to 40
  double dynamic_range = 60.0;  // dB from black to white; 20 to 120
  double focus = 40.0;          // mm, where the beam is narrowest; 5 to 400
  double frequency = 0.0;       // MHz within the probe's band; 0 = its centre
  // dB of the eight sliders of the time-gain compensation, from the face to the depth; -20 to 20. The machine adds
  // what soft tissue takes away (0.7 dB/cm/MHz, there and back) by itself.
  std::array<double, 8> sliders{};
  bool gel = true;  // fills gaps of up to 5 mm between the face and the skin

  bool operator==(const UltrasoundSettings&) const = default;
};

// How finely a picture is computed, and which parts of the physics are.
struct UltrasoundDetail {
  int lines = 300;      // scanlines; 16 to 2048, computed 32 at a time
  int samples = 300;    // along a line; 32 to 4096
  int width = 300;      // pixels of the picture; 16 to 4096
  int height = 300;     // pixels; 16 to 4096
  int slices = 3;       // rays across the thickness of the slice: 1 (infinitely thin), 3, 5 or 7
  bool speckle = true;  // and with it the pulse's length and the beam's width
  bool reverberation = true;
  bool clutter = true;   // noise of the near field
  bool yielding = true;  // tissue gives way under a face that is pressed in; false: the face is where it is in the CT
  int threads = 1;       // 1 to 64
};

// The feature set of Sutherland et al. 2013: reflection, attenuation, shadow, bone edges, log compression, scan
// conversion.
UltrasoundDetail paper_detail();

// Throws InputError naming the field, what it is and what is expected, when a setting is out of range, not a number,
// or a frequency that the probe has not.
void check(const UltrasoundSettings& settings, const anatomy::UltrasoundProbe& probe);
// The same of a detail.
void check(const UltrasoundDetail& detail);

}  // namespace bodkin::imaging
