// An untrusted header of an ultrasound sequence: the result is sound, or nothing.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/sequence_header.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const bodkin::io::SequenceHeader header =
      bodkin::io::parse_sequence_header({reinterpret_cast<const char*>(data), size}, size % 3);
  if (header.orientation.size() > 3) std::abort();
  for (const double step : {header.across, header.down}) {
    if (step != 0.0 && !(step >= 1e-4 && step <= 100.0)) std::abort();
  }
  return 0;
}
