// A whole session over the network: a station with a simulated hand, and an independent client.
#include "link/session_feed.h"

#include <algorithm>
#include <optional>

#include "link/contents.h"
#include "session/session_file.h"
#include "station/station.h"
#include "tests/link/library_client.h"
#include "tests/link/served_session.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/drivers/simulated.h"

namespace bodkin::link {
namespace {

using namespace std::chrono_literals;
using anatomy::tissue::fat;
using anatomy::tissue::muscle;
using anatomy::tissue::skin;
using ::testing::HasSubstr;

TEST(SessionFeed, a_client_follows_a_whole_insertion_by_pose_force_and_event) {
  ServedSession session("speed_mm_s=40 start_mm=10 depth_mm=20 wait_s=0.5");
  LibraryClient client(session.port());
  session.start();
  std::vector<std::string> events;
  std::string about;
  double deepest = 0.0, force = 0.0, last_time = -1.0, lowest = 1e9;
  int poses = 0, points = 0, lines = 0, sensors = 0;
  client.wait_for("", 20s, [&](const Message& message) {
    if (message.type == "TRANSFORM" && message.device == "NeedleTipToReference") {
      ++poses;
      lowest = std::min(lowest, read_transform(message.content).translation().y());
    }
    if (message.type == "NDARRAY" && message.device == "Force") {
      const NumberArray rows = read_array(message.content);
      EXPECT_EQ(rows.size.at(1), 6);
      for (std::size_t row = 0; row + 5 < rows.values.size(); row += 6) {
        EXPECT_GT(rows.values[row], last_time) << "every tick once, in order";
        last_time = rows.values[row];
        deepest = std::max(deepest, rows.values[row + 1]);
        force = std::max(force, rows.values[row + 2]);
      }
    }
    if (message.type == "STRING" && message.device == "Event") events.push_back(read_string(message.content));
    if (message.type == "STRING" && message.device == "Case") about = read_string(message.content);
    points += static_cast<int>(message.type == "POINT" && message.content.size() == 2 * 136);
    sensors += static_cast<int>(message.type == "SENSOR");
    lines += static_cast<int>(message.type == "POLYDATA" && message.device == "PlannedPath");
    return session.finished();
  });
  session.join();
  EXPECT_TRUE(session.result().run.operator_finished);
  EXPECT_GT(poses, 10);
  EXPECT_GT(deepest, 15.0);
  EXPECT_NEAR(-lowest, deepest, 2.0) << "the pose and the depth tell the same; the back is the plane y = 0";
  EXPECT_GT(force, 0.2);
  EXPECT_GE(points, 1);
  EXPECT_GE(lines, 1);
  EXPECT_GT(sensors, 20) << "force and energy with each batch";
  EXPECT_THAT(about, HasSubstr("\"layers\":[["));
  EXPECT_THAT(about, HasSubstr("\"length_mm\""));
  const session::Session recorded = session::read_session(session.file());
  EXPECT_TRUE(recorded.finished);
  ASSERT_FALSE(events.empty());
  EXPECT_THAT(events.front(), HasSubstr("\"contact\""));
  EXPECT_THAT(events, ::testing::Contains(HasSubstr("\"puncture\"")));
}

// What the visual server of a trainer on two machines draws: the skin that the needle dents on the other one.
TEST(SessionFeed, a_client_sees_the_skin_go_down_with_the_tip_until_it_gives_way) {
  ServedSession session("speed_mm_s=8 start_mm=5 depth_mm=12 wait_s=0.2 tremor_mm=0");
  LibraryClient client(session.port());
  session.start();
  double depth = 0.0, dent = 0.0, deepest_dent = 0.0;
  std::optional<double> at_rest;  // lowest place of the skin, of the message that greets
  bool has_punctured = false;
  int dented = 0;
  client.wait_for("", 20s, [&](const Message& message) {
    if (message.type == "NDARRAY" && message.device == "Force") {
      const NumberArray rows = read_array(message.content);
      if (rows.values.size() >= 6) depth = rows.values[rows.values.size() - 5];
    }
    if (message.type == "STRING" && message.device == "Event")
      has_punctured = has_punctured || read_string(message.content).find("\"puncture\"") != std::string::npos;
    if (message.type == "POLYDATA" && message.device == "Skin") {
      double lowest = 1e9;
      for (const Vec3& point : read_surface_points(message.content)) lowest = std::min(lowest, point.y());
      if (!at_rest) at_rest = lowest;
      dent = *at_rest - lowest;  // the needle goes in along -y
      deepest_dent = std::max(deepest_dent, dent);
      if (!has_punctured && depth > 0.3 && dent > 0.3) {
        ++dented;
        EXPECT_NEAR(dent, depth, 0.3) << "the skin lies before the tip";
      }
    }
    return session.finished();
  });
  session.join();
  EXPECT_TRUE(has_punctured);
  EXPECT_NEAR(at_rest.value_or(1e9), 0.0, 0.5) << "the back is the plane y = 0, to half a voxel";
  EXPECT_GT(dented, 5);
  EXPECT_GT(deepest_dent, 1.0);
  EXPECT_NEAR(dent, 0.0, 0.05) << "the needle is out: the skin lies as it was";
}

TEST(SessionFeed, commands_hold_the_needle_and_end_the_session_and_unknown_ones_are_answered) {
  ServedSession session("speed_mm_s=5 start_mm=10 depth_mm=20 wait_s=20");
  LibraryClient client(session.port());
  session.start();
  const auto answer = [&](const std::string& id, const std::string& text) {
    client.send_string("CMD_" + id, text);
    std::string reply;
    EXPECT_TRUE(client.wait_for("STRING", 5s, [&](const Message& message) {
      if (message.device != "ACK_" + id) return false;
      reply = read_string(message.content);
      return true;
    }));
    return reply;
  };
  EXPECT_THAT(answer("1", "<Command Name='Freeze' On='true'/>"), HasSubstr("SUCCESS"));
  EXPECT_TRUE(client.wait_for("STRING", 5s, [](const Message& message) {
    return message.device == "State" && read_string(message.content).find("\"held\":true") != std::string::npos;
  }));
  EXPECT_THAT(answer("2", "<Command Name='SaveConfig' Filename='/etc/passwd'/>"), HasSubstr("is not known"));
  EXPECT_THAT(answer("3", "<Command Name='SetUsParameter' DepthMm='50'/>"), HasSubstr("has no ultrasound"));
  EXPECT_THAT(answer("4", "not even XML"), HasSubstr("FAIL"));
  EXPECT_THAT(answer("5", "<Command Name='Freeze' On='perhaps'/>"), HasSubstr("expected true or false"));
  EXPECT_THAT(answer("6", "<Command Name='StopRecording'/>"), HasSubstr("SUCCESS"));
  session.join();
  EXPECT_TRUE(session::read_session(session.file()).finished);
}

TEST(SessionFeed, a_client_fetches_the_ct_sets_a_parameter_and_begins_again) {
  ServedSession session("speed_mm_s=5 start_mm=10 depth_mm=20 wait_s=20");
  LibraryClient client(session.port());
  session.start();
  std::string told;
  const auto answer = [&](const std::string& id, const std::string& text) {
    client.send_string("CMD_" + id, text);
    std::string reply;
    EXPECT_TRUE(client.wait_for("STRING", 10s, [&](const Message& message) {
      if (message.device == "ModelParameters") told = read_string(message.content);
      if (message.device != "ACK_" + id) return false;
      reply = read_string(message.content);
      return true;
    }));
    return reply;
  };
  EXPECT_THAT(answer("1", "<Command Name='GetModelParameters' Part='skin'/>"), HasSubstr("SUCCESS"));
  EXPECT_THAT(told, HasSubstr("\"break_force_N\""));
  const std::string set = "<Command Name='SetModelParameter' Part='skin' Parameter='break_force_N' ";
  EXPECT_THAT(answer("2", set + "Value='-3'/>"), HasSubstr("expected"));
  EXPECT_THAT(answer("3", set + "Value='0.625'/>"), HasSubstr("SUCCESS"));
  EXPECT_THAT(answer("4", "<Command Name='GetModelParameters' Part='skin'/>"), HasSubstr("SUCCESS"));
  EXPECT_THAT(told, HasSubstr("0.625"));
  EXPECT_THAT(answer("5", "<Command Name='LoadCase' Case='other'/>"), HasSubstr("a session runs already"));
  client.ask_for_image("CT");
  const anatomy::CtVolume ct = served_slabs().ct;
  EXPECT_TRUE(client.wait_for("IMAGE", 20s, [&](const Message& message) {
    return message.device == "CT" && message.content.size() == 72 + 2 * ct.voxels.size();
  }));
  EXPECT_FALSE(session.finished()) << "the session went on meanwhile";
  EXPECT_THAT(answer("6", "<Command Name='Reset'/>"), HasSubstr("begins again"));
  session.join();
  const session::Session recorded = session::read_session(session.file());
  EXPECT_TRUE(recorded.finished);
  EXPECT_FALSE(recorded.changes.empty()) << "the needle that is in felt it, and the session says so";
  EXPECT_TRUE(session.commands().wants_again());
  ASSERT_TRUE(session.commands().models());
  EXPECT_EQ(anatomy::TissueLibrary(session.commands().models()->tissues).find("skin")->layered.break_force, 0.625);
}

TEST(SessionFeed, clients_that_vanish_in_the_middle_take_nothing_with_them) {
  ServedSession session("speed_mm_s=40 start_mm=10 depth_mm=20 wait_s=1");
  session.start();
  for (int i = 0; i < 30 && !session.finished(); ++i) {
    LibraryClient client(session.port());
    client.wait_for("TRANSFORM", 1s, [](const Message&) { return true; });
  }
  session.join();
  EXPECT_TRUE(session.result().run.operator_finished);
  EXPECT_EQ(session.result().run.records_lost, 0U);
}

}  // namespace
}  // namespace bodkin::link
