#include "imaging/ultrasound/settings.h"

#include <string_view>

#include <fmt/format.h>

#include "anatomy/ultrasound_probe.h"
#include "core/error.h"

namespace bodkin::imaging {

namespace {

constexpr std::string_view of_ultrasound = "ultrasound";
constexpr Range slider_range = {-20.0, 20.0};  // dB

}  // namespace

UltrasoundDetail paper_detail() {
  UltrasoundDetail detail;
  detail.slices = 1;
  detail.speckle = false;
  detail.reverberation = false;
  detail.clutter = false;
  detail.yielding = false;
  return detail;
}

void check(const UltrasoundSettings& settings, const anatomy::UltrasoundProbe& probe) {
  bodkin::check(settings, of_ultrasound);
  const bool in_band = settings.frequency >= probe.lowest && settings.frequency <= probe.highest;
  if (settings.frequency != 0.0 && !in_band) {
    throw InputError(
        fmt::format("ultrasound frequency is {:g} MHz, expected {:g} to {:g} MHz, the band of the probe {}; choose "
                    "one in between, or 0 for its centre",
                    settings.frequency, probe.lowest, probe.highest, probe.name));
  }
  for (std::size_t slider = 0; slider < settings.sliders.size(); ++slider)
    check_range(of_ultrasound, fmt::format("slider {}", slider + 1), settings.sliders[slider], slider_range, "dB");
}

void check(const UltrasoundDetail& detail) {
  bodkin::check(detail, of_ultrasound);
}

}  // namespace bodkin::imaging
