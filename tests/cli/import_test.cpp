// A session exported to 3D Slicer's and PLUS's files and imported again gets the same score.
#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;
using ImportCommand = PatientCommand;

TEST_F(ImportCommand, what_was_exported_is_scored_and_reported_as_before) {
  ASSERT_EQ(bodkin("-q run patient -o own.bodkin").exit_code, 0);
  const Outcome written =
      bodkin("-q export own.bodkin --sequence own.igs.mha --recorder-log own.xml --pose-rate 100");
  ASSERT_EQ(written.exit_code, 0) << written.errors;
  const auto judged = [](const std::string& session) {
    return nlohmann::json::parse(bodkin("-q --json score " + session).output);
  };
  const nlohmann::json before = judged("own.bodkin");
  for (const std::string file : {"own.igs.mha", "own.xml"}) {
    const Outcome imported = bodkin("-q --json import " + file + " patient --overwrite -o back.bodkin");
    ASSERT_EQ(imported.exit_code, 0) << imported.errors;
    EXPECT_GT(nlohmann::json::parse(imported.output).at("poses"), 100);
    EXPECT_TRUE(::bodkin::session::read_session(folder_ / "back.bodkin").finished);
    const nlohmann::json after = judged("back.bodkin");
    EXPECT_EQ(after.at("verdict"), before.at("verdict")) << file;
    EXPECT_EQ(after.at("reached"), before.at("reached")) << file;
    EXPECT_EQ(bodkin("-q report back.bodkin -o back.html").exit_code, 0);
    EXPECT_EQ(bodkin("-q replay back.bodkin").exit_code, 0) << "the ticks are those of the case";
  }
}

TEST_F(ImportCommand, refuses_what_is_no_recording_of_a_needle) {
  write("text.txt", "hello");
  write(
      "probe.xml",
      "<TransformRecorderLog><log TimeStampSec='0' TimeStampNSec='0' type='transform' DeviceName='ProbeToReference' "
      "transform='1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1'/></TransformRecorderLog>");
  const auto refusal = [](const std::string& arguments) {
    const Outcome refused = bodkin("-q import " + arguments + " -o never.bodkin");
    EXPECT_EQ(refused.exit_code, 2) << arguments;
    return refused.errors;
  };
  EXPECT_THAT(refusal("nothing.xml patient"), HasSubstr("nothing.xml: cannot be read"));
  EXPECT_THAT(refusal("text.txt patient"), HasSubstr("not a sequence of PLUS"));
  EXPECT_THAT(refusal("probe.xml patient"), HasSubstr("has no NeedleTipToReference; it has ProbeToReference"));
  EXPECT_THAT(refusal("probe.xml patient --points down"), HasSubstr("--points is 'down'"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "never.bodkin"));
}

}  // namespace
}  // namespace bodkin_test
