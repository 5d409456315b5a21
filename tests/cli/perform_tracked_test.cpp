// `bodkin perform CASE tracked:FOOTAGE`: a real needle seen by a camera, recorded and scored like any other hand.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#ifdef BODKIN_HAS_TRACKING

#include "tracking/footage_scene.h"
#include "tracking/station_footage.h"
#include <fmt/format.h>

#include "core/files.h"
#include "imaging/png_file.h"

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using ::bodkin::Pose;
using ::bodkin::Vec3;
using ::bodkin::forces::EventKind;
using ::bodkin::session::Session;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class PerformTracked : public PatientCommand {
 protected:
  static void render(const std::string& name, const std::string& more) {
    if (fs::exists(folder_ / name)) return;
    const Outcome made =
        bodkin("--quiet scene render " + name + " --case patient --rate 10 --width 640 --height 360 " + more);
    ASSERT_EQ(made.exit_code, 0) << made.text();
  }

  static double metric(const json& score, const std::string& name) {
    for (const json& each : score.at("metrics")) {
      if (each.at("name") == name) return each.at("value").get<double>();
    }
    ADD_FAILURE() << "no metric " << name;
    return -1.0;
  }

  // The footage's true place of the needle's tip, and whether its image was left as rendered.
  struct Truth {
    std::vector<double> time;
    std::vector<Vec3> tip;
  };
  static Truth truth_of(const std::string& name, const ::bodkin::anatomy::NeedlePath& path) {
    using namespace ::bodkin::tracking;
    const Footage footage = open_footage(folder_ / name);
    const std::vector<MarkerBody> bodies = read_bodies(folder_ / name / "bodies.json");
    const auto place_of = [&](const std::string& body) {
      return static_cast<std::size_t>(std::find(footage.bodies.begin(), footage.bodies.end(), body) -
                                      footage.bodies.begin());
    };
    const auto needle =
        std::find_if(bodies.begin(), bodies.end(), [](const MarkerBody& body) { return body.name == "needle"; });
    Truth truth;
    for (const FootageFrame& frame : footage.frames) {
      truth.time.push_back(frame.time);
      truth.tip.push_back(tool_in_patient(*needle, frame.camera_from_body[place_of("needle")],
                                          frame.camera_from_body[place_of("mannequin")],
                                          placed_along(path, scene_skin()))
                              .translation());
    }
    return truth;
  }
  static Vec3 at(const Truth& truth, double time) {
    const auto after = std::upper_bound(truth.time.begin(), truth.time.end(), time);
    if (after == truth.time.end()) return truth.tip.back();
    const auto i = static_cast<std::size_t>(after - truth.time.begin());
    if (i == 0) return truth.tip.front();
    const double share = (time - truth.time[i - 1]) / (truth.time[i] - truth.time[i - 1]);
    return truth.tip[i - 1] + share * (truth.tip[i] - truth.tip[i - 1]);
  }
  // Distance of a tick's tip from the truth, mm. Ticks and footage each have their own time, and a busy machine
  // delays either: `time` advances to the nearest place within the next half second.
  static double off(const Truth& truth, const Vec3& tip, double& time) {
    double nearest = (tip - at(truth, time)).norm();
    const double from = time;
    for (int step = 1; step <= 50; ++step) {
      const double later = from + 0.01 * step, distance = (tip - at(truth, later)).norm();
      if (distance > nearest + 1e-3) continue;  // while the needle rests, the places differ by rounding alone
      nearest = std::min(nearest, distance);
      time = later;
    }
    return nearest;
  }
};

TEST_F(PerformTracked, is_recorded_where_it_really_was_and_judged_by_the_procedure) {
  render("along", "");
  const Outcome outcome = bodkin("--json perform patient tracked:along -o along.bodkin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const Session session = ::bodkin::session::read_session(folder_ / "along.bodkin");
  EXPECT_TRUE(session.finished);
  EXPECT_EQ(json::parse(session.header.operator_settings).at("driver"), "tracked");
  const Truth truth = truth_of("along", session.header.path);
  double sum = 0.0, most = 0.0, time = 0.0;
  for (const auto& tick : session.ticks) {
    const double distance = off(truth, tick.input.needle.translation(), time);
    sum += distance * distance;
    most = std::max(most, distance);
  }
  const double rms = std::sqrt(sum / static_cast<double>(session.ticks.size()));
  EXPECT_LT(rms, 0.5) << "mm, at most " << most;
  EXPECT_GT(time, truth.time.back() - 1.0) << "all of the way";
  // Only the real mannequin holds a real needle on a line: the simulation does not constrain it to an axis.
  EXPECT_TRUE(std::none_of(session.events.begin(), session.events.end(),
                           [](const auto& one) { return one.event.kind == EventKind::hand_lost; }));
  const json score = json::parse(bodkin("--json score along.bodkin").output);
  EXPECT_EQ(score.at("reached"), true);
  EXPECT_EQ(score.at("final_position").at("tissue"), "cerebrospinal fluid");
  // The footage's needle ends exactly on the target.
  EXPECT_NEAR(metric(score, "final_axial_mm"), 0.0, 0.5);
  EXPECT_NEAR(metric(score, "final_lateral_mm"), 0.0, 0.5);
  EXPECT_EQ(metric(score, "times_unseen"), 0.0);
  EXPECT_EQ(metric(score, "unseen_s"), 0.0);
  EXPECT_EQ(bodkin("-q replay along.bodkin").exit_code, 0);
  EXPECT_EQ(bodkin("-q report along.bodkin -o along.html").exit_code, 0);
}

TEST_F(PerformTracked, beside_the_path_it_misses_by_as_much_as_it_really_does) {
  render("beside", "--aside 6");
  ASSERT_EQ(bodkin("-q perform patient tracked:beside -o beside.bodkin").exit_code, 0);
  const json score = json::parse(bodkin("--json score beside.bodkin").output);
  EXPECT_NEAR(metric(score, "final_lateral_mm"), 6.0, 0.6);
}

TEST_F(PerformTracked, a_needle_that_is_hidden_rests_and_the_session_says_for_how_long) {
  render("along", "");
  fs::copy(folder_ / "along", folder_ / "hidden");
  // On its way in, after 40 mm of a path that begins 40 mm above the skin: 1.2 s of blank images.
  for (int n = 40; n < 52; ++n) {
    using namespace ::bodkin;
    write_file(folder_ / "hidden" / fmt::format("frame_{:05}.png", n),
               imaging::encode_png(imaging::ImageRgb(640, 360)));
  }
  const Outcome outcome = bodkin("perform patient tracked:hidden -o hidden.bodkin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  EXPECT_THAT(outcome.errors, HasSubstr("the needle was not seen 1 time"));
  const Session session = ::bodkin::session::read_session(folder_ / "hidden.bodkin");
  const Truth truth = truth_of("hidden", session.header.path);
  bool unseen = false;
  double seconds = 0.0, time = 0.0;
  auto event = session.events.begin();
  const Vec3 last_seen = truth.tip[39];
  std::vector<double> from_last_seen;  // mm, in each tick in which it is not seen
  for (const auto& tick : session.ticks) {
    for (; event != session.events.end() && event->tick <= tick.tick; ++event) {
      if (event->event.kind == EventKind::hand_lost) unseen = true;
      if (event->event.kind == EventKind::hand_seen) {
        unseen = false;
        seconds = event->event.value;
        for (int i = 0; i < 4; ++i) off(truth, tick.input.needle.translation(), time);  // past what was hidden
      }
    }
    const Vec3 tip = tick.input.needle.translation();
    if (unseen) {
      from_last_seen.push_back((tip - last_seen).norm());
    } else {
      EXPECT_LT(off(truth, tip, time), 2.5) << "never where it is not, in tick " << tick.tick;
    }
  }
  // It rests at its last visible place, and then moves quickly to its new one.
  constexpr std::size_t way_there = 150;  // ticks
  ASSERT_GT(from_last_seen.size(), way_there);
  EXPECT_LT(*std::max_element(from_last_seen.begin(), from_last_seen.end() - way_there), 1.0);
  // From the last image to the first, and the way there. A late tick counts the same as one in time.
  double left_out = 0.0;  // s, at most
  ASSERT_TRUE(session.timings.has_value());
  for (const auto& bin : session.timings->lateness)
    if (bin.up_to > session.header.dt) left_out += bin.up_to * static_cast<double>(bin.count);
  EXPECT_LT(seconds, 1.3 + 0.07 + 0.1);
  EXPECT_GT(seconds, 1.3 + 0.07 - 0.1 - left_out);
  const json score = json::parse(bodkin("--json score hidden.bodkin").output);
  EXPECT_EQ(metric(score, "times_unseen"), 1.0);
  EXPECT_NEAR(metric(score, "unseen_s"), seconds, 1e-9);
  EXPECT_EQ(bodkin("-q replay hidden.bodkin").exit_code, 0);
}

TEST_F(PerformTracked, says_that_the_rate_of_its_video_varies) {
  ASSERT_EQ(bodkin("--quiet scene render brief --frames 5 --rate 10 --width 640 --height 360").exit_code, 0);
  // The last picture comes late.
  const std::string command = fmt::format(
      "ffmpeg -v error -framerate 10 -i '{0}/brief/frame_%05d.png' -vf \"setpts='if(lt(N,4),N,7)*0.1/TB'\" -vsync "
      "passthrough -c:v ffv1 -pix_fmt gray '{0}/uneven.mkv'",
      folder_.string());
  ASSERT_EQ(std::system(command.c_str()), 0);  // NOLINT: a fixed command
  const std::string files = "--settings 'camera=brief/camera.json bodies=brief/bodies.json'";
  const Outcome outcome = bodkin("perform patient tracked:uneven.mkv -o uneven.bodkin " + files);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  EXPECT_THAT(outcome.errors, HasSubstr("uneven.mkv: the time between pictures varies from 100 to 400 ms"));
  EXPECT_THAT(bodkin("perform patient tracked:brief -o even.bodkin").errors, Not(HasSubstr("varies")));
}

TEST_F(PerformTracked, what_it_cannot_do_is_one_sentence) {
  EXPECT_THAT(bodkin("perform patient tracked:/no/such -o x.bodkin").errors, HasSubstr("/no/such"));
  const Outcome mannequin = bodkin("perform patient tracked:/no/such --mannequin placed.json -o x.bodkin");
  EXPECT_EQ(mannequin.exit_code, 2);
  EXPECT_THAT(mannequin.errors, HasSubstr("--settings registration=placed.json"));
  EXPECT_FALSE(fs::exists(folder_ / "x.bodkin"));
  const Outcome aside = bodkin("scene render nowhere --aside 3");
  EXPECT_EQ(aside.exit_code, 2);
  EXPECT_THAT(aside.errors, HasSubstr("add --case CASE"));
}

}  // namespace
}  // namespace bodkin_test

#endif
