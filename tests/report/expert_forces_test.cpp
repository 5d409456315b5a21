#include "report/expert_forces.h"

#include <algorithm>

#include "session/operator_file.h"
#include "tests/training/lumbar_patient.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "training/simulated_attempt.h"

namespace bodkin {

using namespace bodkin::report;
namespace {

session::SessionHeader header_on(const anatomy::Case& patient) {
  session::SessionHeader header;
  header.path = *patient.description.procedure.path;
  header.haptics = patient.description.haptics;
  return header;
}

TEST(ExpertForces, hold_what_each_of_their_attempts_felt_on_the_way_in) {
  const anatomy::Case& patient = lumbar_patient();
  const session::SessionHeader header = header_on(patient);
  const auto range = expert_forces(patient, header, "expert");
  ASSERT_TRUE(range.has_value());
  ASSERT_GT(range->x.size(), 60U) << "half a millimetre each, down to the fluid";
  const session::Session attempt =
      training::simulate_attempt(patient, session::load_operator("expert"), header.path, 7);
  double deepest = 0.0;
  for (const simulation::TickRecord& record : attempt.ticks) {
    const simulation::TickOutput& output = record.output;
    if (!output.in_contact || output.depth < deepest) continue;
    deepest = output.depth;
    const auto here = std::find_if(range->x.begin(), range->x.end(),
                                   [&](double x) { return deepest >= x - 0.25 && deepest < x + 0.25; });
    if (here == range->x.end()) continue;
    EXPECT_LE(output.resistance, range->high[static_cast<std::size_t>(here - range->x.begin())] + 1e-12) << deepest;
  }
  EXPECT_GT(deepest, 35.0);
  for (std::size_t i = 0; i < range->x.size(); ++i) EXPECT_LE(range->low[i], range->high[i]);
  // The ligaments before the epidural space grip more than the fat below the skin.
  EXPECT_GT(*std::max_element(range->high.begin(), range->high.end()), 3.0);
}

TEST(ExpertForces, are_those_of_the_session_s_models_and_the_same_each_time) {
  const anatomy::Case& patient = lumbar_patient();
  session::SessionHeader header = header_on(patient);
  const auto layered = expert_forces(patient, header, "expert"), again = expert_forces(patient, header, "expert");
  header.haptics.resistance = anatomy::FractureSettings{};
  const auto fracture = expert_forces(patient, header, "expert");
  ASSERT_TRUE(layered && again && fracture);
  EXPECT_EQ(layered->high, again->high);
  EXPECT_NE(layered->high, fracture->high);
}

TEST(ExpertForces, are_none_for_a_deformable_body_or_without_a_path) {
  const anatomy::Case& patient = lumbar_patient();
  session::SessionHeader header = header_on(patient);
  EXPECT_THROW(expert_forces(patient, header, "nobody"), InputError);
  header.haptics.resistance = anatomy::EmbeddedNeedleSettings{};
  EXPECT_FALSE(expert_forces(patient, header, "expert").has_value());
  header = header_on(patient);
  header.path.entry = header.path.target;
  EXPECT_FALSE(expert_forces(patient, header, "expert").has_value());
}

}  // namespace
}  // namespace bodkin
