#include "anatomy/ultrasound_probe.h"

#include <array>
#include <charconv>
#include <numbers>

#include "core/error.h"

namespace bodkin {

namespace {

constexpr std::array<const char*, 3> probe_kind_names = {"linear", "curvilinear", "phased"};
constexpr double widest_face = 180.0;  // degrees that a curved face may span

// Where a probe comes from, and complaints about its fields.
struct ProbeDoubt {
  const UltrasoundProbe& probe;
  const std::string& origin;

  static std::string text(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
  }
  [[noreturn]] void refuse(const std::string& sentence) const {
    throw InputError(origin + ": probe '" + probe.name + "': " + sentence);
  }
  // Refuses NaN as well: it is in no range.
  void within(const char* field, double value, const char* unit, double low, double high,
              const char* remedy = "take it from the probe's data sheet") const {
    if (value >= low && value <= high) return;
    refuse(std::string(field) + " is " + text(value) + unit + ", expected " + text(low) + " to " + text(high) + unit +
           "; " + remedy);
  }
  void zero(const char* field, double value, const char* unit, const char* owner) const {
    if (value == 0.0) return;
    refuse(std::string(field) + " is " + text(value) + unit + ", expected 0 of a " + to_string(probe.kind) +
           " probe; leave it out, it belongs to " + owner + " probes");
  }
};

}  // namespace

std::string to_string(ProbeKind kind) {
  return probe_kind_names.at(static_cast<std::size_t>(kind));
}

void check(const UltrasoundProbe& probe, const std::string& origin) {
  const ProbeDoubt doubt{probe, origin};
  if (probe.name.empty()) doubt.refuse("name is empty, expected what people call it, such as C5-2");
  doubt.within("frequency", probe.frequency, " MHz", 1.0, 30.0);
  const char* const centred = "the centre frequency lies within the band";
  doubt.within("lowest frequency", probe.lowest, " MHz", 0.1, probe.frequency, centred);
  doubt.within("highest frequency", probe.highest, " MHz", probe.frequency, 100.0, centred);
  doubt.within("elements", probe.elements, "", 16, 1024);
  doubt.within("pitch", probe.pitch, " mm", 0.02, 2.0);
  doubt.within("height", probe.height, " mm", 0.5, 30.0);
  doubt.within("lens focus", probe.lens, " mm", 5.0, 300.0);
  doubt.within("cycles", probe.cycles, "", 0.5, 10.0);
  doubt.within("depth", probe.depth, " mm", 10.0, 400.0, "choose what it usually shows");
  if (probe.kind == ProbeKind::curvilinear) {
    doubt.within("radius", probe.radius, " mm", 5.0, 200.0);
    const double face = probe.aperture() / probe.radius * 180.0 / std::numbers::pi;
    if (!(face <= widest_face)) {
      doubt.refuse("its face spans " + ProbeDoubt::text(face) + " degrees, expected at most " +
                   ProbeDoubt::text(widest_face) + "; elements times pitch is the length of the arc, check both");
    }
  } else {
    doubt.zero("radius", probe.radius, " mm", "curvilinear");
  }
  if (probe.kind == ProbeKind::phased)
    doubt.within("sector", probe.sector, " degrees", 10.0, 120.0);
  else
    doubt.zero("sector", probe.sector, " degrees", "phased");
}

}  // namespace bodkin
