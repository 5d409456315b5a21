// The window as `bodkin perform CASE mouse` and `bodkin ultrasound CASE --live` open it, on a virtual display (Xvfb),
// driven by xdotool.
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>

#include "imaging/png_file.h"

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;

class OpenedWindow : public PatientCommand {
 protected:
  void SetUp() override {
    PatientCommand::SetUp();
    if (!std::filesystem::exists(BODKIN_BUILD "/bin/bodkin-app")) GTEST_SKIP() << "built without bodkin-app";
    if (std::system("command -v Xvfb > /dev/null && command -v xdotool > /dev/null") != 0) {
      GTEST_SKIP() << "Xvfb or xdotool is not installed";
    }
  }

  // Opens a display and the window, executes `person`, and waits for the end of the program: its exit code.
  static std::string run(const std::string& command, const std::string& person) {
    write("person.sh", R"(set -u
rm -f display code
Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 3> display > xvfb.log 2>&1 &
xvfb=$!
trap 'kill $xvfb' EXIT
for wait in $(seq 100); do [ -s display ] && break; sleep 0.1; done
export DISPLAY=:$(cat display) XDG_DATA_HOME=$PWD/data XDG_CONFIG_HOME=$PWD/config QT_QPA_PLATFORM=xcb XDG_RUNTIME_DIR=$PWD/runtime
mkdir -p -m 700 runtime
export ASAN_OPTIONS=${ASAN_OPTIONS:-}:detect_leaks=0  # of libraries that Qt loads
')" BODKIN_BUILD "/bin/bodkin' " +
                           command +
                           R"( > said 2> errors &
window=$(timeout 60 xdotool search --sync --name '^Bodkin$' | head -n 1)
xdotool windowfocus $window
)" + person + R"(
xdotool key ctrl+q
wait %2
echo $? > code
)");
    const std::string line = "cd '" + folder_.string() + "' && timeout 120 bash person.sh > log 2>&1";
    EXPECT_EQ(std::system(line.c_str()), 0) << text_of("log");
    return text_of("code") + text_of("errors");
  }
};

TEST_F(OpenedWindow, the_mouse_performs_and_the_session_is_where_it_was_asked_for) {
  EXPECT_EQ(run("perform patient mouse --resistance 'layered' --max-time 60 -o mouse.bodkin", R"(
for wait in $(seq 200); do ls mouse.bodkin* > /dev/null 2>&1 && break; sleep 0.1; done
sleep 2
xdotool mousemove --window $window 1000 250
xdotool click --repeat 40 --delay 60 5
sleep 1.5
xdotool key e
sleep 1.5)"),
            "0\n");
  const ::bodkin::session::Session session = ::bodkin::session::read_session(folder_ / "mouse.bodkin");
  EXPECT_TRUE(session.finished);
  double deepest = 0.0, strongest = 0.0;
  for (const auto& tick : session.ticks) {
    deepest = std::max(deepest, tick.output.depth);
    strongest = std::max(strongest, tick.output.requested.force.norm());
  }
  EXPECT_GT(deepest, 5.0);
  EXPECT_GT(strongest, 0.3);
  EXPECT_THAT(session.header.case_xml, HasSubstr("<layered")) << "the option's model, not the case's";
}

TEST_F(OpenedWindow, the_probe_is_moved_and_a_picture_saved) {
  EXPECT_EQ(run("ultrasound patient --live --lines 128 --samples 256 --needle -o snap.png", R"(
sleep 6
xdotool keydown Up; sleep 0.4; xdotool keyup Up
xdotool key space
xdotool key c
xdotool mousemove --window $window 380 300 click 1
xdotool mousemove --window $window 480 300 click 1
xdotool key s
for wait in $(seq 100); do [ -s snap-1.png ] && break; sleep 0.1; done)"),
            "0\n");
  const ::bodkin::imaging::ImageRgb image = ::bodkin::imaging::decode_png(text_of("snap-1.png"), "snap-1.png");
  EXPECT_GT(image.width, 1200) << "the CT is beside it";
  bool yellow = false;  // the caliper
  for (const ::bodkin::imaging::Rgb& pixel : image.pixels)
    yellow = yellow || pixel == ::bodkin::imaging::Rgb{255, 216, 77};
  EXPECT_TRUE(yellow);
}

TEST_F(OpenedWindow, without_a_display_is_one_sentence) {
  for (const std::string command : {"perform patient mouse", "ultrasound patient --live", "app patient"}) {
    for (const std::string display : {"", ":4711"}) {
      const Outcome outcome =
          run_bodkin(folder_, "--version > /dev/null; DISPLAY=" + display +
                                  " WAYLAND_DISPLAY= QT_QPA_PLATFORM= ASAN_OPTIONS=detect_leaks=0 '" BODKIN_BUILD
                                  "/bin/bodkin' -q " +
                                  command);
      EXPECT_EQ(outcome.exit_code, 2) << command;
      EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
      EXPECT_THAT(outcome.errors, HasSubstr("display"));
    }
  }
}

TEST_F(OpenedWindow, without_the_app_is_one_sentence) {
  for (const std::string command : {"perform patient mouse", "ultrasound patient --live"}) {
    const Outcome outcome = run_bodkin(
        folder_,
        "--version > /dev/null; BODKIN_APP_PROGRAM=/none/bodkin-app '" BODKIN_BUILD "/bin/bodkin' -q " + command);
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("bodkin-app"));
  }
}

TEST_F(OpenedWindow, what_cannot_be_performed_is_refused_before_a_window_opens) {
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"mouse --settings a=1", "the mouse has no settings"},
      {"mouse --second mouse", "--second is the mouse"},
      {"mouse --resistance soft", "soft"},
      {"mouse --body soft", "--body is 'soft'"},
      {"simulated --ultrasound C9-9", "--ultrasound: "},
      {"mouse --ultrasound 'C5-2 L14-5'", "'L14-5' after the probe C5-2, expected SETTING=VALUE"},
      {"mouse --ultrasound depth=5", "there is no setting 'depth', expected view, at, from, press_mm, depth_mm"},
      {"mouse --ultrasound depth_mm=deep", "depth_mm is 'deep', expected a number of mm"},
      {"mouse --ultrasound gain_dB=50", "gain_dB is '50', expected -40 to 40"},
      {"mouse --ultrasound 'C5-2 view=upside'", "--view is 'upside'; expected "},
      {"mouse --ultrasound 'C5-2 frequency_MHz=29'", "--ultrasound: "}};
  for (const auto& [words, sentence] : refused) {
    const Outcome outcome = bodkin("-q perform patient " + words + " -o refused.bodkin");
    EXPECT_EQ(outcome.exit_code, 2) << words << '\n' << outcome.text();
    EXPECT_THAT(outcome.errors, HasSubstr(sentence));
    EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "refused.bodkin"));
  }
  EXPECT_THAT(bodkin("-q devices check mouse").errors, HasSubstr("bodkin app"));
}

}  // namespace
}  // namespace bodkin_test
