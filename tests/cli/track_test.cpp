#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

// `bodkin track` as a user runs it.

#ifdef BODKIN_HAS_TRACKING

#include "tests/tracking/foreign_markers.h"
#include "tests/tracking/mirrored.h"
#include "tracking/footage_scene.h"
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

// Covariance and the mean over the rest are beside the measured pose.
TEST_F(Track, its_table_has_the_filtered_pose_and_the_covariance) {
  ASSERT_EQ(bodkin("--quiet scene render resting --frames 4 --width 800 --height 450 --still").exit_code, 0);
  ASSERT_EQ(bodkin("--quiet track resting --csv resting.csv").exit_code, 0);
  std::vector<std::vector<std::string>> rows;
  std::istringstream table(text_of("resting.csv"));
  for (std::string line; std::getline(table, line);) {
    std::vector<std::string>& cells = rows.emplace_back();
    std::istringstream text(line + ",|");  // the last cell may be empty
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    cells.pop_back();
  }
  ASSERT_EQ(rows.size(), 1U + 4U * 3U);
  const std::vector<std::string>& head = rows.front();
  ASSERT_EQ(head.size(), 14U + 7U + 21U);
  const auto value = [&](std::size_t row, const std::string& name) {
    const auto column = std::find(head.begin(), head.end(), name);
    EXPECT_NE(column, head.end()) << name;
    return std::stod(rows[row].at(static_cast<std::size_t>(column - head.begin())));
  };
  bool averaged = false;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    ASSERT_EQ(rows[row].size(), head.size()) << row;
    ASSERT_EQ(rows[row][2], "ok") << row;
    for (const char* axis : {"x", "y", "z"}) {
      const std::string name = axis;
      EXPECT_NEAR(value(row, "filtered_" + name + "_mm"), value(row, name + "_mm"), 2.0);
      averaged = averaged || value(row, "filtered_" + name + "_mm") != value(row, name + "_mm");
      EXPECT_GT(value(row, "cov_" + name + "_" + name), 0.0);
      EXPECT_GT(value(row, "cov_r" + name + "_r" + name), 0.0);
    }
    // A part of the tip's deviation is that of the body's origin.
    const double shift = value(row, "cov_x_x") + value(row, "cov_y_y") + value(row, "cov_z_z");
    EXPECT_LT(std::sqrt(shift), 3.0 * value(row, "tip_sd_mm") + 1.0);
    EXPECT_LT(std::abs(value(row, "cov_x_z")), std::sqrt(value(row, "cov_x_x") * value(row, "cov_z_z")) + 1e-12);
    const double length = std::hypot(value(row, "filtered_qw"), value(row, "filtered_qx"),
                                     std::hypot(value(row, "filtered_qy"), value(row, "filtered_qz")));
    EXPECT_NEAR(length, 1.0, 1e-5);
  }
  EXPECT_TRUE(averaged) << "at rest";
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

TEST_F(Track, names_pictures_that_are_mirrored) {
  using namespace ::bodkin;
  using namespace ::bodkin::tracking;
  ASSERT_EQ(bodkin("--quiet scene render turned --frames 2 --width 800 --height 450").exit_code, 0);
  for (int n = 0; n < 2; ++n) {
    const std::filesystem::path file = folder_ / fmt::format("turned/frame_{:05}.png", n);
    write_file(file, imaging::encode_png(mirrored(read_picture(file))));
  }
  const Outcome tracked = bodkin("track turned");
  EXPECT_EQ(tracked.exit_code, 2) << tracked.text();
  EXPECT_THAT(tracked.errors, HasSubstr("turned: the pictures are mirrored left to right; switch mirroring off"));
}

// As if a different sheet of markers, or one of another dictionary, had been printed.
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
