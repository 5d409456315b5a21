// A tracked tool as the hand, sent by an independent server.
#include "link/tracking_driver.h"

#include <filesystem>

#include "link/contents.h"
#include "link/tracked_tool.h"
#include "session/session_file.h"
#include "station/hand_session.h"
#include "station/station.h"
#include "tests/io/scratch_folder.h"
#include "tests/link/library_server.h"
#include "tests/link/raw_client.h"
#include "tests/session/slab_case.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/error.h"
#include "haptics/device_port.h"

namespace bodkin::link {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

std::string identity_of(std::uint16_t port, const std::string& tool) {
  return fmt::format("127.0.0.1:{}/{}", port, tool);
}

// A needle that points at the floor of a room in which the patient lies prone: towards anterior, RAS +Y.
constexpr std::array<float, 12> down = {1, 0, 0, 30, 0, 0, 1, 40, 0, -1, 0, 50};

haptics::DeviceState state_of(haptics::DevicePort& port) {
  haptics::DeviceState state;
  port.exchange({}, state);
  return state;
}

TEST(TrackingDriver, a_pose_in_the_patient_becomes_the_hand_that_has_the_needle_there) {
  for (const LibraryServer::Kind kind : {LibraryServer::Kind::transform, LibraryServer::Kind::tracking_data}) {
    LibraryServer server("NeedleToReference", kind);
    server.set_matrix(down);
    haptics::DevicePort port(tracking_driver(), identity_of(server.port(), "NeedleToReference"),
                             "patient_x_mm=-20 patient_y_mm=-10 patient_z_mm=45");
    port.start();
    const haptics::DeviceState state = state_of(port);
    EXPECT_EQ(state.fault, haptics::DeviceFault::none);
    // RAS (30, 40, 50) is LPS (-30, -40, 50); less the middle (-10, -30, 5): right is -x, away z, up y.
    EXPECT_LT((state.hand.translation() - Vec3(10.0, 5.0, -30.0)).norm(), 1e-4) << state.hand.translation();
    EXPECT_LT((state.hand.linear().col(2) - -Vec3::UnitZ()).norm(), 1e-6) << "down";
    EXPECT_EQ(port.abilities().name, "tracked NeedleToReference");
    EXPECT_EQ(port.abilities().peak_force, 0.0);
  }
}

// The tracker sees a needle and the mannequin; the needle's place in the mannequin does not depend on the mannequin's
// place.
TEST(TrackingDriver, a_needle_is_taken_to_a_tracked_mannequin_wherever_it_lies) {
  const auto rows_of = [](const Pose& pose) {
    std::array<float, 12> rows{};
    for (Eigen::Index row = 0; row < 3; ++row)
      for (Eigen::Index column = 0; column < 4; ++column)
        rows[static_cast<std::size_t>(4 * row + column)] = static_cast<float>(pose.matrix()(row, column));
    return rows;
  };
  Pose needle = Pose::Identity();  // in the mannequin, RAS mm
  for (Eigen::Index row = 0; row < 3; ++row)
    for (Eigen::Index column = 0; column < 4; ++column)
      needle.matrix()(row, column) = static_cast<double>(down[static_cast<std::size_t>(4 * row + column)]);
  for (const double turn : {0.0, 1.1}) {
    Pose mannequin = Pose::Identity();
    mannequin.linear() = Eigen::AngleAxisd(turn, Vec3(0.3, -1.0, 0.4).normalized()).toRotationMatrix();
    mannequin.translation() = 100.0 * turn * Vec3(1.0, -2.0, 5.0);
    LibraryServer server("NeedleToTracker", LibraryServer::Kind::tracking_data);
    server.set_matrix(rows_of(mannequin * needle));
    server.set_reference(rows_of(mannequin));
    haptics::DevicePort port(tracking_driver(), identity_of(server.port(), "NeedleToTracker"),
                             "reference=ReferenceToTracker patient_x_mm=-20 patient_y_mm=-10 patient_z_mm=45");
    port.start();
    haptics::DeviceState state;
    EXPECT_TRUE(within(20s, [&] {
      state = state_of(port);
      return (state.hand.translation() - Vec3(10.0, 5.0, -30.0)).norm() < 1e-3;
    })) << state.hand.translation();
    EXPECT_LT((state.hand.linear().col(2) - -Vec3::UnitZ()).norm(), 1e-5);
  }
}

TEST(TrackingDriver, a_pose_of_the_hand_is_taken_in_the_trackers_own_axes) {
  LibraryServer server("StylusToTracker");
  server.set_matrix({1, 0, 0, 10, 0, 1, 0, 20, 0, 0, 1, 30});
  haptics::DevicePort port(
      tracking_driver(), identity_of(server.port(), "StylusToTracker"),
      "frame=hand axes=x,-z,y points=-z middle_x_mm=1 middle_y_mm=2 middle_z_mm=3 patient_x_mm=99");
  port.start();
  const haptics::DeviceState state = state_of(port);
  EXPECT_LT((state.hand.translation() - Vec3(9.0, -27.0, 18.0)).norm(), 1e-4);
  EXPECT_LT((state.hand.linear().col(2) - Vec3(0.0, 1.0, 0.0)).norm(), 1e-6);
  EXPECT_NEAR(state.hand.linear().determinant(), 1.0, 1e-9);
}

TEST(TrackingDriver, is_lost_while_the_tool_is_hidden_or_the_server_gone_and_comes_back_by_itself) {
  LibraryServer server("NeedleToReference");
  haptics::DevicePort port(tracking_driver(), identity_of(server.port(), "NeedleToReference"), "patience_ms=150");
  port.start();
  const auto has_fault = [&](haptics::DeviceFault fault) {
    return within(20s, [&] { return state_of(port).fault == fault; });
  };
  EXPECT_TRUE(has_fault(haptics::DeviceFault::none));
  server.hide(true);
  EXPECT_TRUE(has_fault(haptics::DeviceFault::communication_lost));
  EXPECT_THAT(port.explain(), HasSubstr("sends no NeedleToReference"));
  server.hide(false);
  EXPECT_TRUE(has_fault(haptics::DeviceFault::none));
  server.hide(true);
  server.hang_up();
  EXPECT_TRUE(has_fault(haptics::DeviceFault::communication_lost));
  server.hide(false);
  EXPECT_TRUE(has_fault(haptics::DeviceFault::none));
  EXPECT_EQ(server.clients(), 2);
}

TEST(TrackingDriver, what_is_not_there_or_misspelled_is_told_in_one_sentence) {
  const auto refusal = [](const std::string& identity, const std::string& settings) -> std::string {
    try {
      const haptics::DevicePort port(tracking_driver(), identity, settings);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "opened";
  };
  std::uint16_t port = 0;
  { port = Server(any_port()).port(); }
  EXPECT_THAT(refusal(identity_of(port, "Needle"), "first_pose_s=0.3"), HasSubstr("no server answers at 127.0.0.1:"));
  const LibraryServer server("ProbeToReference");
  EXPECT_THAT(refusal(identity_of(server.port(), "Needle"), "first_pose_s=0.3"), HasSubstr("sends no Needle: "));
  EXPECT_THAT(refusal("127.0.0.1:0/Needle", ""), HasSubstr("expected HOST or HOST:PORT"));
  EXPECT_THAT(refusal("127.0.0.1/NeedleTipToReferenceFrame", ""), HasSubstr("1 to 20 letters"));
  EXPECT_THAT(refusal("127.0.0.1/Needle", "frame=room"), HasSubstr("'room', expected patient"));
  EXPECT_THAT(refusal("127.0.0.1/Needle", "reference=Needle"), HasSubstr("expected another tool"));
  EXPECT_THAT(refusal(identity_of(server.port(), "ProbeToReference"), "reference=Table first_pose_s=0.3"),
              HasSubstr("sends no ProbeToReference with Table"));
  EXPECT_THAT(refusal("127.0.0.1/Needle", "axes=x,y,-z"), HasSubstr("not mirrored"));
  EXPECT_THAT(refusal("127.0.0.1/Needle", "points=down"), HasSubstr("'down', expected x"));
}

TEST(TrackedTool, a_matrix_with_scale_or_mirror_is_refused_and_single_precision_is_a_rotation_again) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  const auto read = [](const Pose& sent) {
    return pose_of_tool({"TRANSFORM", "Needle", 0.0, transform_content(sent)}, "Needle");
  };
  EXPECT_LT((read(pose)->linear() - pose.linear()).norm(), 1e-6);
  EXPECT_NEAR((read(pose)->linear().transpose() * read(pose)->linear() - Mat3::Identity()).norm(), 0.0, 1e-14);
  Pose scaled = pose, mirrored = pose;
  scaled.linear() *= 1.05;
  mirrored.linear().col(0) *= -1.0;
  EXPECT_THROW(read(scaled), InputError);
  EXPECT_THROW(read(mirrored), InputError);
  EXPECT_FALSE(pose_of_tool({"TRANSFORM", "Probe", 0.0, transform_content(pose)}, "Needle"));
  EXPECT_FALSE(pose_of_tool({"STATUS", "Needle", 0.0, {}}, "Needle"));
  EXPECT_THROW(pose_of_tool({"TDATA", "x", 0.0, Bytes(69, 0)}, "Needle"), InputError);
  for (const char* axis : {"x", "y", "z", "-x", "-y", "-z"}) {
    const Mat3 tool = tool_along(axis).value();
    EXPECT_NEAR(tool.determinant(), 1.0, 1e-12) << axis;
    EXPECT_EQ(tool.cwiseAbs().colwise().sum().maxCoeff(), 1.0) << axis;
  }
  EXPECT_EQ(tool_along("-y").value().col(2), Vec3(0.0, -1.0, 0.0));
  for (const char* axis : {"y", "z", "-y", "-z"})
    EXPECT_EQ(tool_along(axis).value().col(0), Vec3::UnitX()) << "the marked side of a probe stays where it is";
  EXPECT_FALSE(tool_along("--y") || tool_along("") || tool_along("w"));
}

TEST(TrackedMotion, passes_between_poses_without_a_jump_and_ends_where_they_are) {
  TrackedMotion motion;
  Pose pose = Pose::Identity();
  motion.begin(pose, 10.0);
  double time = 10.0, fastest = 0.0;
  Vec3 last = motion.at(time).translation();
  const auto move_on = [&](double until) {
    while (time < until) {
      time += 0.001;
      const Vec3 now = motion.at(time).translation();
      fastest = std::max(fastest, (now - last).norm() / 0.001);
      last = now;
    }
  };
  for (int i = 1; i <= 30; ++i) {  // 30 Hz, 300 mm/s
    move_on(10.0 + i / 30.0);
    pose.translation().x() = 10.0 * i;
    motion.take(pose, time);
  }
  EXPECT_LT(fastest, 320.0);
  move_on(time + 0.05);
  EXPECT_NEAR(last.x(), 300.0, 1e-9);
  move_on(time + 3.0);  // lost for a while, 400 mm further on
  pose.translation().x() = 700.0;
  motion.take(pose, time);
  move_on(time + 0.6);
  EXPECT_LT(fastest, 901.0);
  EXPECT_NEAR(last.x(), 700.0, 1e-9);
}

// Another thread ends the session, once the tool has reached its place.
TEST(TrackingDriver, a_tracked_needle_is_pushed_into_the_patient_and_recorded) {
  ScratchFolder folder;
  folder.write("case.xml", "<case/>");
  LibraryServer server("NeedleTipToReference");
  // Above the skin, the plane y = 0 of the slabs: LPS (0, 20, 0) is RAS (0, -20, 0); it points to LPS -y, RAS +Y.
  const auto at_height = [&](float height) { server.set_matrix({1, 0, 0, 0, 0, 0, 1, -height, 0, -1, 0, 0}); };
  at_height(20.0F);
  station::StationOptions options;
  using namespace anatomy::tissue;
  options.patient = slab_case({{skin, 2.0}, {fat, 12.0}, {muscle, 36.0}});
  options.case_folder = folder.path();
  options.device = {&tracking_driver(), identity_of(server.port(), "NeedleTipToReference"), ""};
  options.output = folder.path() / "s.bodkin";
  station::StationObserver nobody;
  station::Station station(std::move(options), nobody);
  std::jthread push([&] {
    for (float height = 20.0F; height > -12.0F; height -= 0.5F) {
      at_height(height);
      std::this_thread::sleep_for(10ms);
    }
    std::this_thread::sleep_for(500ms);
    station.end();
  });
  station.run();
  push.join();
  const session::Session session = session::read_session(folder.path() / "s.bodkin");
  EXPECT_TRUE(session.finished);
  ASSERT_FALSE(session.ticks.empty());
  const simulation::TickRecord& last = session.ticks.back();
  EXPECT_NEAR(last.input.needle.translation().y(), -11.5, 1e-3);
  EXPECT_NEAR(last.output.depth, 11.5, 1e-3);
  EXPECT_EQ(last.output.tissue, fat);
  ASSERT_FALSE(session.events.empty());
  EXPECT_EQ(session.events.front().event.kind, forces::EventKind::contact);
}

}  // namespace
}  // namespace bodkin::link
