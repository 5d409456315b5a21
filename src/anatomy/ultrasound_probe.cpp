#include "anatomy/ultrasound_probe.h"

#include <numbers>

namespace bodkin::anatomy {

namespace {

constexpr double widest_face = 180.0;  // degrees that a curved face may span
constexpr Range radius_of_a_curved_face = {5.0, 200.0};
constexpr Range sector_of_a_phased_face = {10.0, 120.0};

// A number that applies only to other kinds of probe.
void check_absent(const UltrasoundProbe& probe, const std::string& origin, std::string_view name, double value,
                  std::string_view unit, std::string_view owner) {
  if (value == 0.0) return;
  refuse_setting(origin, std::string(name) + " is " + number_words(value) + " " + std::string(unit) +
                             ", expected 0 of a " + to_string(probe.kind) + " probe; leave it out, it belongs to " +
                             std::string(owner) + " probes");
}

}  // namespace

std::string to_string(ProbeKind kind) {
  return value_text(kind);
}

void check(const UltrasoundProbe& probe, const std::string& origin) {
  const std::string place = origin + ": probe '" + probe.name + "'";
  if (probe.name.empty()) refuse_setting(place, "name is empty, expected what people call it, such as C5-2");
  bodkin::check<UltrasoundProbe>(probe, place);
  if (probe.kind == ProbeKind::curvilinear) {
    check_range(place, "radius_mm", probe.radius, radius_of_a_curved_face, "mm");
    const double face = probe.aperture() / probe.radius * 180.0 / std::numbers::pi;
    if (!(face <= widest_face)) {
      refuse_setting(place, "its face spans " + number_words(face) + " degrees, expected at most " +
                                number_words(widest_face) +
                                "; elements times pitch_mm is the length of the arc, check both");
    }
  } else {
    check_absent(probe, place, "radius_mm", probe.radius, "mm", "curvilinear");
  }
  if (probe.kind == ProbeKind::phased) {
    check_range(place, "sector_deg", probe.sector, sector_of_a_phased_face, "deg");
  } else {
    check_absent(probe, place, "sector_deg", probe.sector, "deg", "phased");
  }
}

}  // namespace bodkin::anatomy
