#include "patient/synthetic/variant.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/random.h"

namespace bodkin::patient {
namespace {

// Rounded to `per_unit` steps in a unit, as people write it, with the same bits on every machine.
double in_steps(double value, double per_unit) {
  return std::floor(value * per_unit + 0.5) / per_unit;
}

}  // namespace

LumbarVariant draw_variant(std::uint64_t seed) {
  LumbarVariant drawn;
  LumbarParameters& patient = drawn.parameters;
  patient.seed = seed;
  Random age(mix64(seed ^ 0x414745ULL));
  patient.age = in_steps(age.uniform(20.0, 90.0), 1.0);

  Random build(mix64(seed ^ 0x4255494C44ULL));
  double sum = 0.0;  // of six uniform numbers: about normal, only by exact arithmetic
  for (int i = 0; i < 6; ++i) sum += build.uniform(-1.0, 1.0);
  patient.height = in_steps(std::clamp(1.70 + 0.09 * 0.7071 * sum, 1.45, 2.0), 100.0);
  const double share = build.uniform();
  const double body_mass_index = 19.0 + 14.0 * share + 12.0 * share * share * share;
  patient.weight = in_steps(std::clamp(body_mass_index * patient.height * patient.height, 40.0, 160.0), 1.0);

  Random posture(mix64(seed ^ 0x504F5354ULL));
  patient.flexion = in_steps(posture.uniform(0.3, 1.0), 20.0);

  Random spine(mix64(seed ^ 0x434F4242ULL));
  const bool is_curved = spine.uniform() < 0.25;
  const double angle = in_steps(spine.uniform(10.0, 35.0), 1.0);
  const bool is_to_the_left = spine.uniform() < 0.5;
  if (is_curved) patient.scoliosis = is_to_the_left ? angle : -angle;

  Random ligaments(mix64(seed ^ 0x4C4947ULL));
  const bool is_calcified = ligaments.uniform() < 0.8 * std::clamp((patient.age - 50.0) / 40.0, 0.0, 1.0);
  const double calcified = in_steps(ligaments.uniform(0.2, 0.8), 20.0);
  if (is_calcified) patient.calcification = calcified;

  Random needle(mix64(seed ^ 0x4E4545444C45ULL));
  constexpr std::array<int, 3> gauges = {20, 22, 25};
  drawn.gauge = gauges[static_cast<std::size_t>(needle.uniform() * 3.0)];
  return drawn;
}

}  // namespace bodkin::patient
