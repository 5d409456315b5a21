#include "imaging/ultrasound/settings.h"

#include <string_view>

#include <fmt/format.h>

#include "anatomy/ultrasound_probe.h"
#include "core/error.h"

namespace bodkin::imaging {

namespace {

// Refuses NaN as well: it is in no range.
void check_setting(std::string_view field, double value, std::string_view unit, double low, double high) {
  if (value >= low && value <= high) return;
  throw InputError(fmt::format("ultrasound {0} is {1:g}{2}, expected {3:g} to {4:g}{2}; choose a value in between",
                               field, value, unit, low, high));
}

void check_count(std::string_view field, int value, int low, int high) {
  if (value >= low && value <= high) return;
  throw InputError(fmt::format("ultrasound {} is {}, expected a whole number from {} to {}; choose one in between",
                               field, value, low, high));
}

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
  check_setting("depth", settings.depth, " mm", 10.0, 400.0);
  check_setting("gain", settings.gain, " dB", -40.0, 40.0);
  check_setting("dynamic range", settings.dynamic_range, " dB", 20.0, 120.0);
  check_setting("focus", settings.focus, " mm", 5.0, 400.0);
  const bool in_band = settings.frequency >= probe.lowest && settings.frequency <= probe.highest;
  if (settings.frequency != 0.0 && !in_band) {
    throw InputError(
        fmt::format("ultrasound frequency is {:g} MHz, expected {:g} to {:g} MHz, the band of the probe {}; choose "
                    "one in between, or 0 for its centre",
                    settings.frequency, probe.lowest, probe.highest, probe.name));
  }
  for (std::size_t slider = 0; slider < settings.sliders.size(); ++slider)
    check_setting(fmt::format("slider {}", slider + 1), settings.sliders[slider], " dB", -20.0, 20.0);
}

void check(const UltrasoundDetail& detail) {
  check_count("lines", detail.lines, 16, 2048);
  check_count("samples", detail.samples, 32, 4096);
  check_count("width", detail.width, 16, 4096);
  check_count("height", detail.height, 16, 4096);
  const int slices = detail.slices;
  if (slices != 1 && slices != 3 && slices != 5 && slices != 7) {
    throw InputError(
        fmt::format("ultrasound slices is {}, expected 1, 3, 5 or 7 rays across the thickness of the slice; choose "
                    "one of them",
                    slices));
  }
  check_count("threads", detail.threads, 1, 64);
}

}  // namespace bodkin::imaging
