// The window of `bodkin ultrasound --live` on a display that nobody sees (Xvfb), driven as a person would (xdotool).
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "imaging/png_file.h"
#include "imaging/ultrasound/probe.h"

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;

class LiveWindow : public PatientCommand {
 protected:
  void SetUp() override {
    PatientCommand::SetUp();
    if (std::system(
            "command -v Xvfb > /dev/null && command -v xdotool > /dev/null && command -v import > /dev/null") != 0) {
      GTEST_SKIP() << "Xvfb, xdotool or ImageMagick is not installed";
    }
  }
};

TEST_F(LiveWindow, is_driven_by_mouse_and_keys_and_saves_a_picture) {
  write("person.sh",
        R"(set -u
Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 3> display > xvfb.log 2>&1 &
xvfb=$!
trap 'kill $xvfb' EXIT
for wait in $(seq 100); do [ -s display ] && break; sleep 0.1; done
export DISPLAY=:$(cat display)
export ASAN_OPTIONS=${ASAN_OPTIONS:-}:detect_leaks=0  # of libraries that SDL loads, some gone again at the end
')" BODKIN_BUILD
        R"(/bin/bodkin' --json -q ultrasound patient --live --lines 128 --samples 256 -o snap.png > said 2> errors &
window=$(timeout 60 xdotool search --sync --name '^Bodkin: ' | head -n 1)
for wait in $(seq 100); do  # until it shows something
  import -window root first.png
  [ $(identify -format '%k' first.png) -gt 100 ] && break
  sleep 0.3
done
xdotool mousemove --window $window 400 300
xdotool mousedown 1
for i in $(seq 15); do xdotool mousemove_relative 4 0; sleep 0.02; done
xdotool mouseup 1
xdotool keydown Up; sleep 0.4; xdotool keyup Up
xdotool key 3 3 shift+6
sleep 0.5
import -window $window sliders.png  # the two that were moved are blue
convert sliders.png -crop 444x165+824+443 +repage -fill black +opaque 'rgb(76,194,255)' -format '%[fx:mean*w*h]' info: > blue
xdotool click --repeat 4 --delay 40 4
for wait in $(seq 60); do  # until it shows something else
  sleep 0.3
  import -window root second.png
  compare -metric AE first.png second.png moved.png 2> difference
  [ $(cat difference) -gt 5000 ] && break
done
xdotool key c
xdotool mousemove --window $window 380 300 click 1
xdotool mousemove --window $window 480 300 click 1
xdotool key s
for wait in $(seq 100); do [ -s snap-1.png ] && break; sleep 0.1; done
xdotool key Escape
wait %2
echo $? > code
)");
  const std::string command = "cd '" + folder_.string() + "' && bash person.sh > log 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << text_of("log");
  EXPECT_EQ(text_of("code"), "0\n") << text_of("errors") << text_of("log");
  EXPECT_GT(std::stod(text_of("difference")), 5000.0);  // the picture and the CT have moved
  const auto said = nlohmann::json::parse(text_of("said"));
  ASSERT_EQ(said.at("pictures").size(), 1U);
  const ::bodkin::imaging::ImageRgb image = ::bodkin::imaging::decode_png(text_of("snap-1.png"), "snap-1.png");
  EXPECT_GT(image.width, 1200);
  bool yellow = false;  // the caliper
  for (const ::bodkin::imaging::Rgb& pixel : image.pixels)
    yellow = yellow || pixel == ::bodkin::imaging::Rgb{255, 216, 77};
  EXPECT_TRUE(yellow);
  EXPECT_GT(std::stod(text_of("blue")), 50.0) << "the sliders are not shown";
}

TEST_F(LiveWindow, without_a_display_is_one_sentence) {
  const Outcome outcome =
      run_bodkin(folder_,
                 "--version > /dev/null; DISPLAY= WAYLAND_DISPLAY= "
                 "ASAN_OPTIONS=detect_leaks=0 '" BODKIN_BUILD "/bin/bodkin' -q ultrasound patient --live");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
  EXPECT_THAT(outcome.errors, HasSubstr("display"));
}

}  // namespace
}  // namespace bodkin_test
