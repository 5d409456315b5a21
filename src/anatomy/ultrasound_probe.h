#pragma once

#include <cstdint>
#include <string>

namespace bodkin {

enum class ProbeKind : std::uint8_t { linear, curvilinear, phased };

// "linear", "curvilinear" or "phased".
std::string to_string(ProbeKind kind);

// An ultrasound probe as its data sheet gives it. Its frame is PLUS's "Transducer": origin in the middle of the
// crystals' face, x to the marked side, y away from the probe into the patient, z across the slice (x cross y).
struct UltrasoundProbe {
  std::string name;   // as people call it: "C5-2"
  std::string title;  // "curvilinear, abdomen and spine"
  ProbeKind kind = ProbeKind::linear;
  double frequency = 5.0;  // MHz, centre; 1 to 30
  double lowest = 2.0;     // MHz, of its band; <= frequency
  double highest = 5.0;    // MHz; >= frequency
  int elements = 128;      // 16 to 1024
  double pitch = 0.3;      // mm between elements along the face; 0.02 to 2
  double radius = 0.0;     // mm, of the face; curvilinear: 5 to 200; otherwise 0
  double sector = 0.0;  // degrees from the first line to the last; phased: 10 to 120; otherwise 0, the face decides
  double height = 6.0;  // mm of an element across the slice; 0.5 to 30
  double lens = 60.0;   // mm, where the lens focuses across the slice; 5 to 300
  double cycles = 2.0;  // periods in the pulse at half its amplitude; 0.5 to 10
  double depth = 80.0;  // mm that it shows when nobody has chosen; 10 to 400
  std::string source;   // where the numbers come from

  // mm along the face, from the first element to the last.
  double aperture() const { return elements * pitch; }
};

// Throws InputError naming `origin`, the field, what it is and what is expected, when the probe could not exist.
void check(const UltrasoundProbe& probe, const std::string& origin);

}  // namespace bodkin
