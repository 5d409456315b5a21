#include "fem/moving/probe_press.h"

#include <cmath>
#include <limits>

#include "tests/fem/lattice_body.h"
#include "tests/fem/moving/rest.h"
#include "tests/simulation/real_time_guard.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using ::testing::HasSubstr;

// A box of 40 mm held at its bottom, with nodes every 5 mm, under a face that looks down at its top.
const BodyDescription& pressed_box() {
  static const BodyDescription body = [] {
    BodyDescription box = lattice_body(9, 40.0, 0.1, 10);
    box.materials.set(tissue::ligamentum_flavum, {0.020, 0.3});
    return box;
  }();
  return body;
}

Pose face_down(double x, double z, double lean = 0.0) {
  Pose pose = Pose::Identity();
  pose.linear() =
      (Eigen::AngleAxisd(lean, Vec3::UnitY()) * Eigen::AngleAxisd(180.0 * degree, Vec3::UnitX())).toRotationMatrix();
  pose.translation() = Vec3(x, 20.0, z);
  return pose;
}

ProbeFace small_face(double radius = 0.0) {
  ProbeFace face;
  face.width = 21.0;
  face.thickness = 11.0;
  face.radius = radius;
  return face;
}

TEST(ProbePress, takes_the_nodes_that_its_face_meets_and_no_others) {
  const BodyDescription& body = pressed_box();
  CorotationalBody moving(body, checks::to_rest());
  ProbePress press(body.mesh, body.fixed, small_face());
  EXPECT_EQ(press.surface().size(), 729U - 343U - 81U);
  press.press(face_down(20.0, 40.5), moving);
  EXPECT_EQ(press.held(), 0U);
  press.press(face_down(20.0, 36.0), moving);
  EXPECT_EQ(press.held(), 5U * 3U);
  std::size_t held = 0;
  for (std::uint32_t node = 0; node < moving.nodes(); ++node) {
    const Vec3& x = body.mesh.nodes[node];
    const bool under = x.z() == 40.0 && std::abs(x.x() - 20.0) < 10.5 && std::abs(x.y() - 20.0) < 5.5;
    EXPECT_EQ(moving.held(node) && !moving.fixed(node), under) << node;
    held += under ? 1 : 0;
  }
  EXPECT_EQ(held, press.held());
  press.lift(moving);
  EXPECT_EQ(press.held(), 0U);
  ASSERT_LE(checks::settle(moving, 1e-10), 20);
  // Not from the other side of the body.
  press.press(face_down(20.0, 10.0), moving);
  EXPECT_EQ(press.held(), 0U);
}

TEST(ProbePress, pushes_and_its_force_is_that_of_what_holds_the_body) {
  const BodyDescription& body = pressed_box();
  CorotationalBody moving(body, checks::to_rest());
  ProbePress press(body.mesh, body.fixed, small_face());
  double last = 0.0;
  for (const double depth : {1.0, 3.0, 6.0}) {
    for (int step = 0; step < 25; ++step) {
      press.press(face_down(20.0, 40.0 - depth), moving);
      moving.step();
      press.release_pulled_nodes(moving);
    }
    ASSERT_GT(press.held(), 8U);
    const Wrench felt = press.on_probe(moving);
    EXPECT_GT(felt.force.z(), last + 0.05);
    last = felt.force.z();
    Vec3 ground = Vec3::Zero();
    for (const std::uint32_t node : body.fixed) ground += moving.holding_force(node);
    EXPECT_LT((felt.force - ground).norm(), 1e-5);
    for (const std::uint32_t node : press.surface()) {
      if (!moving.held(node)) continue;
      EXPECT_NEAR(moving.position(node).z(), 40.0 - depth, 1e-9);
      EXPECT_GE(moving.holding_force(node).dot(Vec3(0.0, 0.0, -1.0)), -1e-6);
    }
  }
  // A rigid punch of 20 x 10 mm (half the area of its nodes' neighbours more) on soft tissue of 0.02 MPa: some N.
  EXPECT_GT(last, 0.3 * 6.0 * 0.02 * 20.0);
  EXPECT_LT(last, 3.0 * 6.0 * 0.02 * 40.0);
}

TEST(ProbePress, never_pulls) {
  const BodyDescription& body = pressed_box();
  CorotationalSettings settings;
  settings.dt = 0.01;
  CorotationalBody moving(body, settings);
  ProbePress press(body.mesh, body.fixed, small_face());
  const auto go = [&](double from, double to, int steps) {
    for (int step = 1; step <= steps; ++step) {
      press.press(face_down(20.0, from + (to - from) * step / steps), moving);
      ASSERT_FALSE(moving.step().fault);
      press.release_pulled_nodes(moving);
      ASSERT_GE(press.on_probe(moving).force.z(), -1e-6 * static_cast<double>(press.held()));
    }
  };
  go(41.0, 34.0, 30);
  EXPECT_GT(press.held(), 8U);
  go(34.0, 34.0, 100);
  go(34.0, 41.0, 10);  // faster than the tissue comes back
  go(41.0, 41.0, 200);
  EXPECT_EQ(press.held(), 0U);
  for (const std::uint32_t node : press.surface())
    EXPECT_LT((moving.position(node) - moving.at_rest(node)).norm(), 0.01);
}

TEST(ProbePress, a_leaning_face_lets_go_on_the_side_that_would_be_pulled) {
  const BodyDescription& body = pressed_box();
  CorotationalBody moving(body, checks::to_rest());
  ProbePress press(body.mesh, body.fixed, small_face());
  const auto settle = [&](const Pose& pose) {
    for (int step = 0; step < 30; ++step) {
      press.press(pose, moving);
      moving.step();
      press.release_pulled_nodes(moving);
    }
  };
  settle(face_down(20.0, 38.5));
  EXPECT_EQ(press.held(), 15U);
  settle(face_down(20.0, 38.5, 0.4));  // now its one side would be 4 mm above the skin
  EXPECT_LT(press.held(), 15U);
  EXPECT_GT(press.held(), 2U);
  for (const std::uint32_t node : press.surface()) {
    if (!moving.held(node)) continue;
    EXPECT_GE(moving.holding_force(node).dot(face_down(20.0, 38.5, 0.4).linear().col(2)), -1e-6);
  }
}

TEST(ProbePress, a_convex_array_presses_with_its_middle_first) {
  const BodyDescription& body = pressed_box();
  CorotationalBody moving(body, checks::to_rest());
  ProbePress press(body.mesh, body.fixed, small_face(20.0));
  press.press(face_down(20.0, 39.9), moving);
  EXPECT_EQ(press.held(), 3U);  // one row across
  press.press(face_down(20.0, 39.0), moving);
  EXPECT_EQ(press.held(), 9U);
  press.press(face_down(20.0, 36.0), moving);
  EXPECT_EQ(press.held(), 15U);
  ASSERT_LE(checks::settle(moving, 1e-9), 50);
  for (const std::uint32_t node : press.surface()) {
    if (!moving.held(node)) continue;
    // Taken where they met the face, the first row at 39.9.
    const Vec3 at = face_down(20.0, 36.0).inverse() * moving.position(node);
    EXPECT_NEAR(std::hypot(at.x(), at.z() + 20.0), 20.0, 1e-9);
  }
}

TEST(ProbePress, a_pose_that_is_none_lifts_the_probe) {
  const BodyDescription& body = pressed_box();
  CorotationalBody moving(body, checks::to_rest());
  ProbePress press(body.mesh, body.fixed, small_face());
  Pose bent = face_down(20.0, 38.0);
  bent.linear() *= 1.1;
  Pose nowhere = face_down(20.0, 38.0);
  nowhere.translation().x() = std::numeric_limits<double>::quiet_NaN();
  for (const Pose& wrong : {bent, nowhere}) {
    press.press(face_down(20.0, 38.0), moving);
    EXPECT_EQ(press.held(), 15U);
    press.press(wrong, moving);
    EXPECT_EQ(press.held(), 0U);
  }
  const RealTimeGuard guard;
  press.press(face_down(20.0, 38.0), moving);
  press.release_pulled_nodes(moving);
  press.lift(moving);
  if (RealTimeGuard::available()) {
    EXPECT_EQ(RealTimeGuard::heap_calls(), 0U);
  }
}

TEST(ProbePress, refuses_a_face_out_of_range) {
  const BodyDescription& body = pressed_box();
  const auto refuses = [&body](const ProbeFace& face, const char* sentence) {
    try {
      const ProbePress press(body.mesh, body.fixed, face);
      ADD_FAILURE() << sentence;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(sentence));
    }
  };
  ProbeFace face;
  face.width = 0.0;
  refuses(face, "face of the probe: width is 0 mm, expected 1 to 200 mm");
  face = {};
  face.thickness = std::nan("");
  refuses(face, "face of the probe: thickness is nan mm");
  face = {};
  face.radius = 3.0;
  refuses(face, "face of the probe: radius is 3 mm, expected 5 to 500 mm");
  face = {};
  face.radius = 10.0;
  refuses(face, "face of the probe: width is 40 mm, expected 1 to 19 mm");
  face = {};
  face.reach = 0.0;
  refuses(face, "face of the probe: reach is 0 mm");
}

}  // namespace
}  // namespace bodkin
