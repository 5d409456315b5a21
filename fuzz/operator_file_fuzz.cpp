// Untrusted operator files: any bytes are either refused with a sentence, or give an executable operator.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "session/operator_file.h"

#include "core/error.h"
#include "io/tissue_library_file.h"
#include "simulation/operator.h"
#include "simulation/operator_thresholds.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view document(reinterpret_cast<const char*>(data), size);
  static const bodkin::anatomy::Case patient = {.library = bodkin::io::default_tissue_library()};
  bodkin::simulation::OperatorScript script, known;
  try {
    script = bodkin::session::parse_operator(document, "operator.xml");
    known = bodkin::simulation::for_patient(script, patient);
  } catch (const bodkin::InputError&) {
    return 0;
  }
  // Every accepted operator is run against a varying force, and stays finite.
  bodkin::simulation::Operator actor(known, {{0, 100, 0}, {0, 50, 0}}, 1, 0.001);
  bodkin::Pose needle = actor.start();
  for (int tick = 0; tick < 2000; ++tick) {
    needle = actor.step({needle, bodkin::Vec3(0, tick % 500 * 0.01, 0)});
    if (!needle.matrix().allFinite()) std::abort();
  }
  if (bodkin::session::operator_json(script).empty()) std::abort();
  return 0;
}
