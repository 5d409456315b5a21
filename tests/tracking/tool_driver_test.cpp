// A real tool as the hand of a session: its pose, and refused input.
#include "tracking/tool_driver.h"

#include <cstdlib>
#include <filesystem>
#include <thread>
#include <utility>

#include "tests/tracking/foreign_markers.h"
#include "tests/tracking/mirrored.h"
#include "tracking/footage.h"
#include "tracking/footage_scene.h"
#include "tracking/station_footage.h"
#include "tracking/tool_sightings.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "anatomy/needle_path.h"
#include "core/files.h"
#include "haptics/device_port.h"
#include "imaging/png_file.h"

namespace bodkin::tracking {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class ToolDriver : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = fs::temp_directory_path() / ("bodkin-tools-" + std::to_string(getpid()));
    SceneOptions options;
    options.frames = 4;
    options.rate = 10.0;
    options.width = 800;
    options.height = 450;
    options.still = true;
    footage_ = render_scene(folder_ / "still", options);
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  static std::string source() { return (folder_ / "still").string(); }
  static Vec3 truth(const anatomy::NeedlePath& path, std::size_t body) {
    const std::vector<MarkerBody> bodies = station_bodies();
    const std::vector<Pose>& poses = footage_.frames[0].camera_from_body;
    return tool_in_patient(bodies[body], poses[body], poses[0], placed_along(path, scene_skin())).translation();
  }
  static haptics::DeviceState state_after(haptics::DevicePort& port, int ticks) {
    haptics::DeviceState state;
    for (int n = 0; n < ticks; ++n) {
      port.exchange({}, state);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return state;
  }
  static std::string refusal(const std::string& identity, const std::string& settings) {
    try {
      const haptics::DevicePort port(tool_driver(), identity, settings);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  }

  static inline fs::path folder_;
  static inline Footage footage_;
};

// The operator stands at the feet of a prone patient: right is -x, forwards is z, up is y.
Vec3 in_patient(const Vec3& hand, const Vec3& middle) {
  return middle + Vec3(-hand.x(), hand.z(), hand.y());
}

TEST_F(ToolDriver, two_tools_of_one_source_are_where_they_really_were) {
  const anatomy::NeedlePath path{{4.0, 80.0, -30.0}, {2.0, 30.0, -20.0}};
  const std::string words = "entry_mm=4,80,-30 target_mm=2,30,-20 patient_x_mm=4 patient_y_mm=110 patient_z_mm=-30";
  haptics::DevicePort needle(tool_driver(), source(), words);
  haptics::DevicePort probe(tool_driver(), source(), words + " body=probe");
  EXPECT_EQ(needle.abilities().peak_force, 0.0);
  EXPECT_EQ(probe.abilities().name, "tracked probe");
  needle.start();
  probe.start();
  const haptics::DeviceState of_needle = state_after(needle, 100), of_probe = state_after(probe, 100);
  const Vec3 middle(4.0, 110.0, -30.0);
  EXPECT_LT((in_patient(of_needle.hand.translation(), middle) - truth(path, 1)).norm(), 1.0);
  EXPECT_LT((in_patient(of_probe.hand.translation(), middle) - truth(path, 2)).norm(), 1.0);
  EXPECT_FALSE(of_needle.unseen());
  EXPECT_TRUE(state_after(needle, 400).ended()) << "the footage is over";
}

TEST_F(ToolDriver, follows_what_a_window_tracks_already) {
  auto shown = std::make_shared<ToolSightings>(station_bodies(), Similarity(), true);
  announce(source(), shown);
  std::vector<TrackedPose> poses(3);
  for (TrackedPose& pose : poses) pose.status = TrackingStatus::ok;
  shown->publish(poses, 1.0, 1.0);
  EXPECT_EQ(announced((folder_ / "still" / ".." / "still").string()), shown);
  std::jthread camera([&](const std::stop_token& stop) {
    for (double time = 2.0; !stop.stop_requested(); time += 0.01) {
      shown->publish(poses, time, time);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  });
  haptics::DevicePort port(tool_driver(), source(), "");
  port.start();
  const Vec3 tip = station_bodies()[1].tip;
  EXPECT_LT((in_patient(state_after(port, 50).hand.translation(), Vec3::Zero()) - tip).norm(), 1e-6)
      << "of the announced poses, not of the footage";
}

TEST_F(ToolDriver, says_what_is_to_be_known_of_its_pictures_while_the_tool_is_seen) {
  // From the third image on, at a quarter of the rate.
  const fs::path video = folder_ / "uneven.mkv";
  const std::string command = fmt::format(
      "ffmpeg -v error -framerate 10 -i '{}/frame_%05d.png' -vf \"setpts='if(lt(N,2),N,2+4*(N-2))*0.1/TB'\" "
      "-vsync passthrough -c:v ffv1 -pix_fmt gray '{}'",
      source(), video.string());
  ASSERT_EQ(std::system(command.c_str()), 0);  // NOLINT: a fixed command
  haptics::DevicePort port(tool_driver(), video.string(),
                           fmt::format("camera={0}/camera.json bodies={0}/bodies.json", source()));
  port.start();
  EXPECT_FALSE(state_after(port, 20).unseen());
  EXPECT_THAT(port.explain(), AllOf(HasSubstr("uneven.mkv"), HasSubstr("varies from 100 to 400 ms")));
  haptics::DevicePort even(tool_driver(), source(), "");
  even.start();
  EXPECT_FALSE(state_after(even, 20).unseen());
  EXPECT_EQ(even.explain(), "");
}

TEST_F(ToolDriver, says_in_one_sentence_what_is_wrong) {
  EXPECT_THAT(refusal("", ""), HasSubstr("no pictures are named"));
  EXPECT_THAT(refusal(source(), "body=scalpel"), HasSubstr("\"scalpel\"; expected needle, probe"));
  EXPECT_THAT(refusal(source(), "registration=/no/such.json"), HasSubstr("/no/such.json"));
  EXPECT_THAT(refusal(source(), "entry_mm=1,2"), HasSubstr("entry_mm"));
  EXPECT_THAT(refusal("/dev/no_such_camera", fmt::format("camera={}/camera.json", source())),
              HasSubstr("/dev/no_such_camera"));
  // Images without any of Bodkin's markers.
  const fs::path blank = folder_ / "blank";
  fs::create_directories(blank);
  for (const char* file : {"camera.json", "bodies.json"}) fs::copy_file(folder_ / "still" / file, blank / file);
  write_file(blank / "frame_00000.png", imaging::encode_png(colour_of(GreyImage(800, 450))));
  EXPECT_THAT(refusal(blank.string(), ""), AllOf(HasSubstr("the needle was not seen in 1 pictures"),
                                                 HasSubstr("no marker of the dictionary 4x4_50")));
  // Markers of another dictionary, and those of a board that belongs to no body.
  const auto folder_with = [](const char* name, const GreyImage& shown) {
    const fs::path made = folder_ / name;
    fs::create_directories(made);
    for (const char* file : {"camera.json", "bodies.json"}) fs::copy_file(folder_ / "still" / file, made / file);
    write_file(made / "frame_00000.png", imaging::encode_png(colour_of(shown)));
    return made.string();
  };
  EXPECT_THAT(refusal(folder_with("other_dictionary", foreign_markers(6, 800, 450)), ""),
              HasSubstr("no marker of the dictionary 4x4_50"));
  const MarkerBody board = board_body("board", 22, 4, 2, 40.0);
  Pose before_camera = Pose::Identity();
  before_camera.translation().z() = 500.0;
  const CameraModel camera = read_camera(folder_ / "still" / "camera.json");
  EXPECT_THAT(refusal(folder_with("board_alone", render_picture(camera, {}, {{&board, before_camera}}, 3)), ""),
              HasSubstr("markers are seen that are on no body (22, 23, 24, 25, 26, 27, ...)"));
  // An image mirrored by the camera is reported as mirrored.
  const fs::path mirrored = folder_ / "mirrored";
  fs::create_directories(mirrored);
  for (const char* file : {"camera.json", "bodies.json"}) fs::copy_file(folder_ / "still" / file, mirrored / file);
  const imaging::ImageRgb picture = tracking::mirrored(read_picture(folder_ / "still" / footage_.frames[0].file));
  write_file(mirrored / "frame_00000.png", imaging::encode_png(picture));
  EXPECT_THAT(refusal(mirrored.string(), ""), HasSubstr("mirrored left to right"));
  // Some markers are the mirror images of others: none of them may be taken for a body.
  Tracker tracker(read_camera(mirrored / "camera.json"), read_bodies(mirrored / "bodies.json"));
  for (const TrackedPose& pose : tracker.track(grey_of(picture), 0.0)) EXPECT_EQ(pose.status, TrackingStatus::lost);
}

}  // namespace
}  // namespace bodkin::tracking
