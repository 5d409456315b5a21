// An untrusted measured curve: refused with a sentence, or samples usable in a fit.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "study/fitting/measured_curve.h"

#include "core/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const bodkin::study::MeasuredCurve curve = bodkin::study::parse_measured_curve(text, "curve.csv");
    if (curve.size() < 10 || curve.force.size() != curve.size()) std::abort();
    if (!curve.time.empty() && curve.time.size() != curve.size()) std::abort();
    for (std::size_t i = 0; i < curve.size(); ++i) {
      if (!std::isfinite(curve.depth[i]) || !(std::abs(curve.force[i]) <= 100.0)) std::abort();
      if (i > 0 && !curve.time.empty() && !(curve.time[i] > curve.time[i - 1])) std::abort();
    }
  } catch (const bodkin::InputError&) {
  }
  return 0;
}
