// Untrusted ultrasound probes: refused with a sentence, or physically possible.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/error.h"
#include "io/probe_library_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto probes = bodkin::io::parse_probes({reinterpret_cast<const char*>(data), size}, "probes.xml");
    for (const bodkin::anatomy::UltrasoundProbe& probe : probes) {
      const bool sound =
          probe.lowest <= probe.frequency && probe.frequency <= probe.highest && probe.aperture() > 0.0;
      if (!sound) std::abort();
    }
  } catch (const bodkin::InputError&) {
  }
  return 0;
}
