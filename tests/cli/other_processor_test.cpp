// A session replays to the bit on another processor. One without AVX2 and fused multiply-add is played by this one:
// the C library is told not to use them, and the sanitizers' programs have no versions for AVX2 (core/simd.h), so
// that they replay what the release program recorded with it.
#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli/bodkin_command.h"
#include "tests/sanitized.h"
#include <gmock/gmock.h>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

// For glibc before and since 2.33.
const std::string old_processor =
    "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4,-AVX512F,-AVX2_Usable,-FMA_Usable ";

// The program that records: the release build's, which has a mesher.
fs::path recorder() {
  return bodkin::sanitized ? fs::path(BODKIN_REPOSITORY) / "build/release/bin" : fs::path(BODKIN_BUILD) / "bin";
}

class OtherProcessor : public BodkinCommand {
 protected:
  static int shell(const std::string& command) {
    return std::system(("cd '" + folder_.string() + "' && " + command).c_str());
  }
  static std::string exponentials(const std::string& processor) {
    EXPECT_EQ(
        shell(processor + "python3 -c 'import math; print([math.exp(-1.2345e-5*i) for i in range(20000)])' > e"), 0);
    return text_of("e");
  }
  static int record(const std::string& arguments) {
    return shell("BODKIN_MESHER_WORKER='" + (recorder() / "bodkin-mesher").string() + "' '" +
                 (recorder() / "bodkin").string() + "' --quiet " + arguments + " > recorded.txt 2>&1");
  }
  // Records and replays one attempt.
  static void expect_the_same(const std::string& options) {
    ASSERT_EQ(record("run patient --overwrite --output s.bodkin --seed 3 " + options), 0) << options << "\n"
                                                                                          << text_of("recorded.txt");
    before_program() = old_processor;
    const Outcome replay = bodkin("--quiet replay s.bodkin");
    before_program().clear();
    EXPECT_EQ(replay.exit_code, 0) << options << "\n" << replay.text();
    EXPECT_THAT(replay.output, HasSubstr("identical: ")) << options;
  }
};

TEST_F(OtherProcessor, replays_sessions_to_the_bit) {
  if (!fs::exists(recorder() / "bodkin-mesher"))
    GTEST_SKIP() << recorder() << " has no bodkin-mesher: build the release preset first";
  if (exponentials("") == exponentials(old_processor))
    GTEST_SKIP() << "the C library has one exp() for this processor and for an older one";
  ASSERT_EQ(record("case synthesize lumbar patient --overwrite"), 0) << text_of("recorded.txt");
  ASSERT_EQ(record("case mesh patient"), 0) << text_of("recorded.txt");
  std::vector<std::string> attempts = {
      "--operator novice --mechanics physical --resistance embedded_needle --part relaxation",
      "--operator novice --mechanics physical --resistance three_component",
      "--mechanics physical --resistance tracking_wall --part relaxation --part shaft_friction --part needle_grasp "
      "--part fingertip --part bevel_tip --constraint pivot"};
  if (!bodkin::sanitized) {
    for (const char* model : {"layered", "fracture", "shaft_friction", "surface_proxy", "volume_proxy"})
      attempts.push_back(std::string("--operator novice --constraint rail --resistance ") + model);
    attempts.emplace_back("--operator expert_epidural --part syringe --part fingertip --constraint beam");
    attempts.emplace_back("--operator expert_lumbar_puncture --part csf_flow --part fingertip");
    attempts.emplace_back("--operator expert_acupuncture --resistance embedded_needle --part bevel_tip");
  }
  for (const std::string& attempt : attempts) expect_the_same(attempt);
}

// Also the simulated hand: the same seed gives the same attempt.
TEST_F(OtherProcessor, gives_the_same_attempts) {
  if (bodkin::sanitized) GTEST_SKIP() << "the hand is the release build's matter";
  if (exponentials("") == exponentials(old_processor))
    GTEST_SKIP() << "the C library has one exp() for this processor and for an older one";
  ASSERT_EQ(record("case synthesize lumbar patient --overwrite"), 0) << text_of("recorded.txt");
  for (const char* hand : {"novice", "expert_acupuncture", "expert_epidural"}) {
    const std::string attempt = std::string("run patient --overwrite --seed 5 --operator ") + hand;
    ASSERT_EQ(record(attempt + " --output here.bodkin"), 0) << text_of("recorded.txt");
    before_program() = old_processor;
    EXPECT_EQ(bodkin("--quiet " + attempt + " --output there.bodkin").exit_code, 0);
    before_program().clear();
    const std::string here = bodkin("--quiet replay here.bodkin").output;
    EXPECT_THAT(here, HasSubstr("identical: "));
    EXPECT_EQ(bodkin("--quiet replay there.bodkin").output, here) << hand;
  }
}

}  // namespace
}  // namespace bodkin_test
