#include <filesystem>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

// `bodkin overlay` as a user runs it.

#ifdef BODKIN_HAS_TRACKING

#include <algorithm>
#include <cstdio>
#include <vector>

#include "tests/tracking/foreign_markers.h"
#include "tests/tracking/mirrored.h"
#include "tests/tracking/needle_ring.h"
#include "tracking/footage_scene.h"
#include "tracking/marker_body.h"
#include <fmt/format.h>

#include "core/files.h"
#include "imaging/png_file.h"

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

class Overlay : public PatientCommand {};

TEST_F(Overlay, draws_the_patient_into_every_picture_as_a_video_and_as_a_folder) {
  ASSERT_EQ(bodkin("--quiet scene render footage --frames 2 --width 800 --height 450").exit_code, 0);
  const Outcome video = bodkin("--json overlay patient footage -o overlay.avi --oval-width 160 --oval-height 200");
  ASSERT_EQ(video.exit_code, 0) << video.text();
  EXPECT_EQ(nlohmann::json::parse(video.output)["drawn"], 2);
  EXPECT_THAT(text_of("overlay.avi"), StartsWith("RIFF"));
  ASSERT_EQ(bodkin("--quiet overlay patient footage -o pictures --preset bone --no-needle").exit_code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "pictures/overlay_00001.png"));
  EXPECT_NE(text_of("pictures/overlay_00000.png"), text_of("footage/frame_00000.png"));
}

TEST_F(Overlay, says_how_long_each_stage_takes_and_adds_the_ultrasound) {
  ASSERT_EQ(bodkin("--quiet scene render timed --frames 2 --width 800 --height 450").exit_code, 0);
  const Outcome made = bodkin("--json overlay patient timed -o times.avi --ultrasound --times --full-resolution");
  ASSERT_EQ(made.exit_code, 0) << made.text();
  const nlohmann::json json = nlohmann::json::parse(made.output);
  EXPECT_GT(json["pictures_per_second"].get<double>(), 0.0);
  for (const char* stage : {"read and decode", "track", "ray cast", "blend and draw", "ultrasound", "write"}) {
    ASSERT_TRUE(json["times"].contains(stage)) << stage;
    EXPECT_LE(json["times"][stage]["median_ms"].get<double>(), json["times"][stage]["p95_ms"].get<double>()) << stage;
  }
  ASSERT_EQ(bodkin("--quiet overlay patient timed -o plain.avi --full-resolution").exit_code, 0);
  EXPECT_NE(text_of("times.avi"), text_of("plain.avi"));
}

TEST_F(Overlay, says_how_far_the_target_may_be_from_where_it_is_drawn) {
  ASSERT_EQ(bodkin("--quiet scene render placed --frames 2 --width 800 --height 450").exit_code, 0);
  write("fixed.csv", "a,10,0,5\nb,110.5,0,5\nc,10,80.4,5\nd,10,0,65\ne,70,50,25\n");
  write("moving.csv", "a,0,0,0\nb,100,0,0\nc,0,80,0\nd,0,0,60\ne,60,50,20\n");
  ASSERT_EQ(bodkin("--quiet register fixed.csv moving.csv --target 30,30,40 -o placed.json").exit_code, 0);
  const Outcome made = bodkin("--json overlay patient placed -o placed.avi --registration placed.json");
  ASSERT_EQ(made.exit_code, 0) << made.text();
  const nlohmann::json json = nlohmann::json::parse(made.output);
  EXPECT_EQ(json["tre_mm"], nlohmann::json::parse(text_of("placed.json"))["tre_mm"]);
  // A camera of about 1,000 pixels focal length that stands about 600 mm away.
  EXPECT_NEAR(json["tre_px"]["estimate"].get<double>() / json["tre_mm"]["estimate"].get<double>(), 1.3, 0.8);
  write("wrong.json", "{\"fixed_from_moving\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], \"tre_mm\": 5}");
  const Outcome wrong = bodkin("overlay patient placed -o wrong.avi --registration wrong.json");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.errors, HasSubstr("wrong.json: \"target_mm\""));
}

#ifdef BODKIN_HAS_MESHER
TEST_F(Overlay, a_probe_deforms_a_patient_that_has_a_mesh) {
  ASSERT_EQ(bodkin("--quiet scene render pressing --frames 3 --rate 10 --width 640 --height 360").exit_code, 0);
  fs::copy(folder_ / "patient", folder_ / "meshed", fs::copy_options::recursive);
  ASSERT_EQ(bodkin("--quiet case mesh meshed --nodes 2500 --merge-layers").exit_code, 0);
  for (const char* patient : {"patient", "meshed"}) {
    const std::string to = std::string("of_") + patient;
    const Outcome made = bodkin("--quiet overlay " + std::string(patient) + " pressing --ultrasound -o " + to);
    ASSERT_EQ(made.exit_code, 0) << made.text();
  }
  // The first image has no previous one to show motion.
  EXPECT_NE(text_of("of_patient/overlay_00002.png"), text_of("of_meshed/overlay_00002.png"));
}
#endif

// Images are read and tracked while others are drawn. The needle moves by up to 15 pixels between images.
TEST_F(Overlay, draws_every_picture_of_a_moving_needle_with_its_own_pose) {
  using namespace ::bodkin;
  using namespace ::bodkin::tracking;
  ASSERT_EQ(bodkin("--quiet scene render moving --frames 8 --rate 1 --width 800 --height 450").exit_code, 0);
  for (const char* const how : {"", "--no-needle"}) {
    const std::string to = *how == '\0' ? "with" : "without";
    const Outcome made =
        bodkin(fmt::format("--quiet overlay patient moving --no-plan --no-front-view --no-status {} -o {}", how, to));
    ASSERT_EQ(made.exit_code, 0) << made.text();
  }
  const Footage footage = open_footage(folder_ / "moving");
  const CameraModel camera = read_camera(folder_ / "moving/camera.json");
  const std::vector<MarkerBody> bodies = read_bodies(folder_ / "moving/bodies.json");
  const auto needle = static_cast<std::size_t>(
      std::find_if(bodies.begin(), bodies.end(), [](const MarkerBody& body) { return body.name == "needle"; }) -
      bodies.begin());
  const auto named = static_cast<std::size_t>(std::find(footage.bodies.begin(), footage.bodies.end(), "needle") -
                                              footage.bodies.begin());
  std::vector<Eigen::Vector2d> tips;
  for (const FootageFrame& frame : footage.frames)
    tips.push_back(camera.project(frame.camera_from_body[named] * bodies[needle].tip));
  double most = 0.0;
  int moved = 0;
  for (std::size_t n = 0; n < tips.size(); ++n) {
    const std::string file = fmt::format("overlay_{:05}.png", n);
    const Eigen::Vector2d ring =
        needle_ring(read_picture(folder_ / "with" / file), read_picture(folder_ / "without" / file), tips[n]);
    const double own = (ring - tips[n]).norm();
    most = std::max(most, own);
    EXPECT_LT(own, 2.5) << n;
    for (const std::size_t other : {n - 1, n + 1}) {
      if (other >= tips.size() || (tips[other] - tips[n]).norm() < 6.0) continue;
      ++moved;
      EXPECT_LT(own, 0.5 * (ring - tips[other]).norm()) << n << " as " << other;
    }
  }
  EXPECT_GT(moved, 8) << "the needle moves";
  std::printf("rings are %.1f px from the true tips at most\n", most);
}

TEST_F(Overlay, names_pictures_that_are_mirrored_and_draws_nothing_into_them) {
  using namespace ::bodkin;
  using namespace ::bodkin::tracking;
  ASSERT_EQ(bodkin("--quiet scene render turned --frames 2 --width 800 --height 450").exit_code, 0);
  for (int n = 0; n < 2; ++n) {
    const fs::path file = folder_ / fmt::format("turned/frame_{:05}.png", n);
    write_file(file, imaging::encode_png(mirrored(read_picture(file))));
  }
  const Outcome made = bodkin("overlay patient turned --no-status -o unturned");
  ASSERT_EQ(made.exit_code, 0) << made.text();
  EXPECT_THAT(made.errors, HasSubstr("turned: the pictures are mirrored left to right; switch mirroring off"));
  EXPECT_THAT(made.output, HasSubstr("2 pictures, the patient in 0 of them"));
  EXPECT_EQ(read_picture(folder_ / "unturned/overlay_00001.png").pixels,
            read_picture(folder_ / "turned/frame_00001.png").pixels);
}

TEST_F(Overlay, names_markers_that_are_on_no_body_and_misses_those_of_its_dictionary) {
  using namespace ::bodkin;
  using namespace ::bodkin::tracking;
  ASSERT_EQ(bodkin("--quiet scene render others --frames 2 --width 640 --height 360").exit_code, 0);
  std::vector<MarkerBody> bodies = station_bodies();
  for (MarkerBody& body : bodies) {
    for (MarkerFace& face : body.faces) face.id += face.id < 0 ? 0 : 25;
  }
  write_file(folder_ / "all.json", bodies_json(bodies));
  const Outcome none = bodkin("overlay patient others --bodies all.json -o none.avi");
  ASSERT_EQ(none.exit_code, 0) << none.text();
  EXPECT_THAT(none.errors, HasSubstr("others: markers are seen that are on no body (0, 1, 2,"));
  EXPECT_THAT(none.output, HasSubstr("2 pictures, the patient in 0 of them"));
  for (int n = 0; n < 2; ++n)
    write_file(folder_ / fmt::format("others/frame_{:05}.png", n),
               imaging::encode_png(colour_of(foreign_markers(6, 640, 360))));
  EXPECT_THAT(bodkin("overlay patient others -o foreign.avi").errors,
              HasSubstr("others: no marker of the dictionary 4x4_50 is in these pictures"));
}

TEST_F(Overlay, refuses_an_unknown_preset_and_a_folder_in_use) {
  const Outcome preset = bodkin("overlay patient footage --preset x-ray");
  EXPECT_EQ(preset.exit_code, 2);
  EXPECT_THAT(preset.errors, HasSubstr("--preset is 'x-ray'"));
  EXPECT_THAT(bodkin("overlay patient footage -o patient").errors, HasSubstr("--output is 'patient'"));
}

}  // namespace
}  // namespace bodkin_test

#endif
