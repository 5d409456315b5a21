#include <cstdlib>
#include <filesystem>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

// `bodkin track` as a user runs it.

#ifdef BODKIN_HAS_TRACKING

#include "tests/tracking/foreign_markers.h"
#include "tracking/marker_body.h"
#include <fmt/format.h>

#include "core/files.h"
#include "imaging/png_file.h"

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Track : public BodkinCommand {};

TEST_F(Track, finds_every_body_of_footage_close_to_the_truth) {
  ASSERT_EQ(bodkin("--quiet scene render footage --frames 3 --width 800 --height 450").exit_code, 0);
  const Outcome tracked = bodkin("--json track footage --csv poses.csv");
  ASSERT_EQ(tracked.exit_code, 0) << tracked.text();
  for (const nlohmann::json& body : nlohmann::json::parse(tracked.output)) {
    EXPECT_EQ(body["ok"], 3) << body;
    EXPECT_LT(body["tip_error_rms_mm"], 1.5) << body;
  }
  EXPECT_EQ(lines_of(text_of("poses.csv")), 10);
}

TEST_F(Track, follows_the_bodies_through_a_video_as_through_pictures) {
  ASSERT_EQ(bodkin("--quiet scene render film --frames 3 --width 800 --height 450 --jpeg 0").exit_code, 0);
  ASSERT_EQ(std::system(("ffmpeg -v error -framerate 30 -i '" + (folder_ / "film/frame_%05d.png").string() +
                         "' -c:v ffv1 -pix_fmt gray '" + (folder_ / "video.mkv").string() + "'")
                            .c_str()),
            0);
  const Outcome tracked =
      bodkin("--json track video.mkv --camera film/camera.json --bodies film/bodies.json --csv film.csv");
  ASSERT_EQ(tracked.exit_code, 0) << tracked.text();
  for (const nlohmann::json& body : nlohmann::json::parse(tracked.output)) EXPECT_EQ(body["ok"], 3) << body;
  EXPECT_EQ(lines_of(text_of("film.csv")), 10);
  EXPECT_THAT(bodkin("track video.mkv").errors, HasSubstr("not calibrated"));
  // A part of it, by time.
  const Outcome part = bodkin("--json track video.mkv --seconds 0.05 --camera film/camera.json");
  EXPECT_EQ(nlohmann::json::parse(part.output)[0]["ok"], 2) << part.text();
}

TEST_F(Track, says_what_is_missing_or_wrong) {
  EXPECT_THAT(bodkin("track nowhere").errors, HasSubstr("there is nothing of that name"));
  fs::create_directories(folder_ / "empty");
  EXPECT_THAT(bodkin("track empty").errors, HasSubstr("no pictures"));
  ASSERT_EQ(bodkin("--quiet scene render other --frames 1 --width 320 --height 240").exit_code, 0);
  fs::create_directories(folder_ / "plain");
  fs::copy_file(folder_ / "other/frame_00000.png", folder_ / "plain/a.png");
  const Outcome uncalibrated = bodkin("track plain");
  EXPECT_EQ(uncalibrated.exit_code, 2);
  EXPECT_THAT(uncalibrated.errors, HasSubstr("not calibrated"));
  ASSERT_EQ(bodkin("--quiet scene render larger --frames 1 --width 640 --height 480").exit_code, 0);
  const Outcome size = bodkin("track other --camera larger/camera.json");
  EXPECT_EQ(size.exit_code, 2);
  EXPECT_THAT(size.errors, HasSubstr("calibrated at 640 x 480"));
}

// As when another sheet of markers was printed, or another dictionary was chosen for it.
TEST_F(Track, names_markers_that_are_on_no_body_and_misses_those_of_its_dictionary) {
  using namespace ::bodkin;
  using namespace ::bodkin::tracking;
  ASSERT_EQ(bodkin("--quiet scene render others --frames 2 --width 640 --height 360").exit_code, 0);
  std::vector<MarkerBody> bodies = station_bodies();
  const auto shift = [](MarkerBody& body) {
    for (MarkerFace& face : body.faces) face.id += face.id < 0 ? 0 : 25;
  };
  shift(bodies[1]);
  write_file(folder_ / "one.json", bodies_json(bodies));
  const Outcome one = bodkin("track others --bodies one.json");
  EXPECT_EQ(one.exit_code, 0) << one.text();
  EXPECT_THAT(one.errors, HasSubstr("others: markers are seen that are on no body (12"));
  shift(bodies[0]);
  shift(bodies[2]);
  write_file(folder_ / "all.json", bodies_json(bodies));
  const Outcome all = bodkin("track others --bodies all.json");
  EXPECT_EQ(all.exit_code, 2) << all.text();
  EXPECT_THAT(all.errors, HasSubstr("others: markers are seen that are on no body ("));
  for (const int cells : {5, 6}) {
    for (int n = 0; n < 2; ++n)
      write_file(folder_ / fmt::format("others/frame_{:05}.png", n),
                 imaging::encode_png(colour_of(foreign_markers(cells, 640, 360))));
    const Outcome none = bodkin("track others");
    EXPECT_EQ(none.exit_code, 2) << none.text();
    EXPECT_THAT(none.errors, HasSubstr("others: no marker of the dictionary 4x4_50 is in these pictures"));
  }
}

}  // namespace
}  // namespace bodkin_test

#endif
