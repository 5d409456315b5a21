#include <filesystem>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

// `bodkin scene render` as a user runs it.

#ifdef BODKIN_HAS_TRACKING

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SceneRender : public BodkinCommand {};

TEST_F(SceneRender, makes_pictures_with_their_truth_the_same_for_the_same_seed) {
  const std::string options = " --quiet --frames 2 --width 320 --height 240 --seed 4";
  const Outcome made = bodkin("scene render one" + options);
  ASSERT_EQ(made.exit_code, 0) << made.text();
  ASSERT_EQ(bodkin("scene render two" + options).exit_code, 0);
  for (const char* file : {"frame_00000.png", "frame_00001.png", "camera.json", "bodies.json", "scene.json"})
    EXPECT_EQ(text_of(std::string("one/") + file), text_of(std::string("two/") + file)) << file;
  const nlohmann::json scene = nlohmann::json::parse(text_of("one/scene.json"));
  EXPECT_EQ(scene["frames"].size(), 2U);
  EXPECT_EQ(scene["frames"][0]["camera_from_body"].size(), 3U);
}

TEST_F(SceneRender, a_folder_that_holds_something_and_an_unknown_tone_curve_are_refused) {
  fs::create_directories(folder_ / "full");
  write("full/file", "x");
  const Outcome full = bodkin("scene render full --frames 1");
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_THAT(full.errors, HasSubstr("not empty"));
  const Outcome tone = bodkin("scene render new --tone sepia");
  EXPECT_EQ(tone.exit_code, 2);
  EXPECT_THAT(tone.errors, HasSubstr("--tone is 'sepia'"));
  EXPECT_FALSE(fs::exists(folder_ / "new"));
}

}  // namespace
}  // namespace bodkin_test

#endif
