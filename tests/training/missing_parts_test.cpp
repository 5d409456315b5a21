#include <cstdint>
#include <string>

#include "session/operator_file.h"
#include "tests/training/lumbar_patient.h"
#include <gtest/gtest.h>

#include "training/procedure_file.h"
#include "training/score.h"
#include "training/simulated_attempt.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

// A patient without a fingertip and without fluid is judged by the rest, and the result says so.
TEST(Score, says_what_was_not_judged_for_want_of_a_part) {
  const anatomy::Case& patient = lumbar_patient();
  session::Session session = simulate_attempt(patient, session::load_operator("expert"),
                                              *patient.description.procedure.path, std::uint64_t{1});
  const auto said = [&](const std::string& procedure) -> std::string {
    const Score result =
        score(session, patient.description, find_procedure(procedure), {&patient.structures, &patient.tissues});
    for (const Finding& each : result.findings) {
      if (each.subject == "parts") return each.sentence;
    }
    return "";
  };
  EXPECT_NE(said("lumbar_puncture").find("neither the part fingertip nor csf_flow"), std::string::npos);
  EXPECT_EQ(said("epidural"), "");
  session.header.haptics.parts.fingertip.emplace();
  EXPECT_NE(said("lumbar_puncture").find("lacks the part csf_flow"), std::string::npos);
  session.header.haptics.parts.csf_flow.emplace();
  EXPECT_EQ(said("lumbar_puncture"), "");
}

}  // namespace
}  // namespace bodkin
