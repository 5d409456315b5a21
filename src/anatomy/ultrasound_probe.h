#pragma once

#include <cstdint>
#include <string>

#include "core/parameter.h"
#include "core/settings_check.h"

namespace bodkin::anatomy {

enum class ProbeKind : std::uint8_t { linear, curvilinear, phased };
constexpr std::array<std::string_view, 3> enumeration_names(ProbeKind) {
  return {"linear", "curvilinear", "phased"};
}

// "linear", "curvilinear" or "phased".
std::string to_string(ProbeKind kind);

// An ultrasound probe as described by its data sheet. Its frame is PLUS's "Transducer": origin in the middle of the
// crystals' face, x towards the orientation marker, y away from the probe into the patient, z across the slice (x
// cross y).
struct UltrasoundProbe {
  std::string name;   // as users call it: "C5-2"
  std::string title;  // "curvilinear, abdomen and spine"
  ProbeKind kind = ProbeKind::linear;
  double frequency = 5.0;
  double lowest = 2.0;
  double highest = 5.0;
  int elements = 128;
  double pitch = 0.3;
  double radius = 0.0;
  double sector = 0.0;
  double height = 6.0;
  double lens = 60.0;
  double cycles = 2.0;
  double depth = 80.0;
  std::string source;  // of the numbers

  template <typename S = UltrasoundProbe>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &S::name, "as people call it", Origin::literature},
        Parameter{"title", &S::title, "what it is, for people", Origin::literature},
        Parameter{"kind", &S::kind, "shape of the face and of the field of view", Origin::literature},
        Parameter{"frequency_MHz", &S::frequency, Range{1.0, 30.0}, "MHz", "centre", Origin::literature},
        Parameter{"lowest_MHz", &S::lowest, Range{0.1, 100.0}, "MHz", "of its band; at most frequency_MHz",
                  Origin::literature},
        Parameter{"highest_MHz", &S::highest, Range{0.1, 100.0}, "MHz", "of its band; at least frequency_MHz",
                  Origin::literature},
        Parameter{"elements", &S::elements, Range{16.0, 1024.0}, "", "crystals along the face", Origin::literature},
        Parameter{"pitch_mm", &S::pitch, Range{0.02, 2.0}, "mm", "between elements along the face",
                  Origin::literature},
        Parameter{"radius_mm", &S::radius, Range{0.0, 200.0}, "mm",
                  "of the face; curvilinear: 5 or more, otherwise 0", Origin::literature},
        Parameter{"sector_deg", &S::sector, Range{0.0, 120.0}, "deg",
                  "from the first line to the last; phased: 10 or more, otherwise 0: the face decides",
                  Origin::literature},
        Parameter{"height_mm", &S::height, Range{0.5, 30.0}, "mm", "of an element across the slice",
                  Origin::literature},
        Parameter{"lens_mm", &S::lens, Range{5.0, 300.0}, "mm", "where the lens focuses across the slice",
                  Origin::literature},
        Parameter{"cycles", &S::cycles, Range{0.5, 10.0}, "periods", "in the pulse at half its amplitude",
                  Origin::choice},
        Parameter{"depth_mm", &S::depth, Range{10.0, 400.0}, "mm", "that it shows when nobody has chosen",
                  Origin::choice},
        Parameter{"source", &S::source, "where the numbers come from", Origin::literature}};
  }
  static constexpr auto relations() {
    return std::tuple{AtMost{&UltrasoundProbe::lowest, &UltrasoundProbe::frequency},
                      AtMost{&UltrasoundProbe::frequency, &UltrasoundProbe::highest}};
  }

  // mm along the face, from the first element to the last.
  double aperture() const { return elements * pitch; }
};

// Throws InputError naming `origin`, the field, its value and the expected range when the probe is physically
// impossible.
void check(const UltrasoundProbe& probe, const std::string& origin);

}  // namespace bodkin::anatomy
