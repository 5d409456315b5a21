// A request for too few nodes is answered with the necessary number, which suffices.
#include <set>
#include <string>

#include "tests/cli/bodkin_command.h"
#include "tests/cli/mesher_rig.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class MeshAdvice : public BodkinCommand {
 protected:
  // The number advised instead of this one, which is too small; 0: none.
  static int advised(const std::string& patient, int nodes) {
    const Outcome few = bodkin("-q case mesh " + patient + " --nodes " + std::to_string(nodes));
    EXPECT_EQ(few.exit_code, 2) << patient << " " << nodes;
    EXPECT_THAT(few.errors, HasSubstr(" nodes are too few to hold the layers of the planned path"));
    const std::string give = "give --nodes ";
    const std::size_t at = few.errors.find(give);
    return at == std::string::npos ? 0 : std::stoi(few.errors.substr(at + give.size()));
  }

  static void expect_a_mesh(const std::string& patient, int nodes) {
    const Outcome made = bodkin("--json case mesh " + patient + " --nodes " + std::to_string(nodes));
    ASSERT_EQ(made.exit_code, 0) << patient << " " << nodes << ": " << made.errors;
    EXPECT_NEAR(json::parse(made.output).at("nodes").get<double>() / nodes, 1.0, 0.12) << patient;
  }

  // For any request one number is advised: the smallest; it works, and so do larger ones.
  static void expect_good_advice(const std::string& patient, const std::set<int>& too_few) {
    std::set<int> advice;
    for (const int nodes : too_few) advice.insert(advised(patient, nodes));
    ASSERT_EQ(advice.size(), 1U) << patient;
    const int least = *advice.begin();
    ASSERT_GT(least, *too_few.rbegin()) << patient;
    EXPECT_EQ(advised(patient, least * 85 / 100), least) << patient;
    expect_a_mesh(patient, least);
    expect_a_mesh(patient, least * 125 / 100);
  }
};

TEST_F(MeshAdvice, is_the_smallest_number_that_works_for_the_patient) {
  BODKIN_NEEDS_MESHER();
  ASSERT_EQ(bodkin("-q case synthesize lumbar default").exit_code, 0);
  expect_good_advice("default", {500, 8120, 10000});
}

TEST_F(MeshAdvice, is_the_smallest_number_that_works_for_others) {
  BODKIN_NEEDS_MESHER();
  ASSERT_EQ(bodkin("-q case synthesize lumbar coarse --spacing 3").exit_code, 0);
  expect_good_advice("coarse", {500, 3000});
  ASSERT_EQ(bodkin("-q case synthesize lumbar heavy --spacing 3 --weight 120 --height 1.68").exit_code, 0);
  expect_good_advice("heavy", {600});
  ASSERT_EQ(bodkin("-q case synthesize lumbar somebody --spacing 2 --vary --seed 3").exit_code, 0);
  expect_good_advice("somebody", {1000});
}

// Fluid in a single voxel, which is merged in any mesh: no number helps.
TEST_F(MeshAdvice, names_no_number_where_none_works) {
  BODKIN_NEEDS_MESHER();
  ASSERT_EQ(bodkin("-q case synthesize lumbar patient --spacing 2 --vary --seed 11").exit_code, 0);
  const Outcome refused = bodkin("-q case mesh patient");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("no mesh holds cerebrospinal fluid (2.0 mm thick, "));
  EXPECT_THAT(refused.errors, HasSubstr("or --merge-layers for a mesh without them"));
}

}  // namespace
}  // namespace bodkin_test
