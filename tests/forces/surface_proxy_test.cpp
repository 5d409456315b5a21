#include "forces/surface_proxy.h"

#include <cstring>
#include <limits>
#include <numbers>

#include "tests/forces/near.h"
#include "tests/forces/surface_shapes.h"
#include "tests/one_tick.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

constexpr double gap = SurfaceProxy::clearance;

const SurfaceProxySettings smooth = {.static_friction = 0.0, .dynamic_friction = 0.0};

// A proxy and the tip that leads it.
struct Touch {
  Touch(const SurfaceProxySettings& settings, const Surface& surface, const Vec3& start)
      : model(settings, surface, one_tick), tip(start) {
    model.step(tip, events);
  }
  // Straight to `to` at `speed` mm/s; the last force.
  Vec3 move(const Vec3& to, double speed = 100.0) {
    const Vec3 from = tip;
    const int ticks = std::max(1, static_cast<int>(std::ceil((to - from).norm() / (speed * one_tick) - 1e-9)));
    for (int i = 1; i <= ticks; ++i) force = model.step(tip = from + (to - from) * i / ticks, events);
    return force;
  }
  SurfaceProxy model;
  TickEvents events;
  Vec3 tip, force = Vec3::Zero();
};

TEST(SurfaceProxy, a_plane_pushes_back_along_its_normal_in_proportion_to_depth) {
  SurfaceProxySettings settings = smooth;
  settings.stiffness = 0.7;
  Touch touch(settings, shapes::plane(), {3.3, -2.1, 5.0});
  expect_near(touch.move({3.3, -2.1, 0.001}), Vec3::Zero(), 0.0);
  for (const double depth : {0.1, 1.0, 4.0, 2.0}) {
    expect_near(touch.move({3.3, -2.1, -depth}), {0, 0, 0.7 * depth}, 1.01 * 0.7 * gap);
    EXPECT_EQ(touch.model.constraints(), 1u);
  }
  expect_near(touch.move({-17.0, 24.0, -2.0}), {0, 0, 1.4}, 1.01 * 0.7 * gap);  // slid without friction
  expect_near(touch.move({-17.0, 24.0, 0.1}), Vec3::Zero(), 0.0);
  EXPECT_EQ(touch.model.constraints(), 0u);
}

TEST(SurfaceProxy, a_tilted_plane_does_the_same) {
  const Vec3 u = 60.0 * Vec3(1, 2, 3).normalized(), v = 60.0 * Vec3(2, -1, 0).normalized();
  const Vec3 n = u.cross(v).normalized(), corner(100.0, -250.0, 700.0);
  Touch touch(smooth, shapes::patches({{corner, u, v}}, 7), corner + 0.5 * u + 0.5 * v + 3.0 * n);
  expect_near(touch.move(corner + 0.2 * u + 0.9 * v - 2.5 * n, 300.0), 2.5 * n, 1.01 * gap);
}

TEST(SurfaceProxy, a_sphere_pushes_radially) {
  const double radius = 30.0;
  const Surface ball = shapes::sphere(radius, 5);
  double sag = 0.0, lean = 0.0;  // how deep facets lie below the sphere, mm, and how they lean, rad
  for (std::size_t t = 0; t < ball.triangles().size(); ++t) {
    for (const int corner : ball.triangles()[t]) {
      const double upright = ball.normal(t).dot(ball.vertices()[static_cast<std::size_t>(corner)]) / radius;
      sag = std::max(sag, radius * (1.0 - upright));
      lean = std::max(lean, std::acos(upright));
    }
  }
  Touch touch(smooth, ball, {0, 0, 40});
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    const Vec3 to = Vec3(random.normal(), random.normal(), random.normal()).normalized();
    // Around the ball, 2 mm deep.
    const Vec3 from = touch.tip.normalized();
    for (int s = 1; s <= 300; ++s) touch.move(28.0 * (from * (300 - s) + to * s).normalized(), 1e6);
    expect_near(touch.force, 2.0 * to, sag + 2.0 * lean + gap);  // within 0.09 N of 2 N
    EXPECT_GT((touch.model.proxy()).norm(), radius - sag - 1e-6);
  }
}

TEST(SurfaceProxy, passing_the_edge_of_a_box_lets_go_of_one_face_and_finds_the_next) {
  const Surface box = shapes::box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 4);
  Touch touch(smooth, box, {9.0, 1.3, 12.0});
  expect_near(touch.move({9.0, 1.3, 9.5}), {0, 0, 0.5}, 2 * gap);
  // Out over the edge: free; back in from the side: the side face pushes.
  expect_near(touch.move({10.5, 1.3, 9.5}), Vec3::Zero(), 0.0);
  expect_near(touch.move({9.5, 1.3, 9.0}), {0.5, 0, 0}, 2 * gap);
  EXPECT_EQ(touch.model.constraints(), 1u);
}

TEST(SurfaceProxy, an_inner_edge_holds_with_two_faces_and_an_inner_corner_with_three) {
  const Surface room = shapes::box(Vec3(0, 0, 0), Vec3(30, 30, 30), 5, true);
  Touch touch(smooth, room, {10, 10, 10});
  expect_near(touch.move({8.3, -1.0, 9.1}), {0, 1, 0}, 2 * gap);
  EXPECT_EQ(touch.model.constraints(), 1u);
  expect_near(touch.move({8.3, -1.0, -2.0}), {0, 1, 2}, 2 * gap);
  EXPECT_EQ(touch.model.constraints(), 2u);
  expect_near(touch.move({-0.5, -1.0, -2.0}), {0.5, 1, 2}, 2 * gap);
  EXPECT_EQ(touch.model.constraints(), 3u);
  expect_near(touch.move({12.0, -1.0, -2.0}), {0, 1, 2}, 2 * gap);
  EXPECT_EQ(touch.model.constraints(), 2u);
  expect_near(touch.move({12.0, 3.0, 2.0}), Vec3::Zero(), 0.0);
}

TEST(SurfaceProxy, wedges_of_any_angle_hold_as_the_projection_says) {
  Random random(8);
  for (int trial = 0; trial < 300; ++trial) {
    std::array<Vec3, 3> normals;
    for (Vec3& n : normals) n = Vec3(random.normal(), random.normal(), random.normal()).normalized();
    const Vec3 pull(random.normal(), random.normal(), random.normal());
    const std::size_t count = static_cast<std::size_t>(random.uniform(0.0, 4.0));
    const ConstrainedMotion held = constrained_motion(pull, normals, count);
    // The projection is feasible, and no other point of the cone is nearer (checked along random ways).
    for (std::size_t i = 0; i < count; ++i) ASSERT_GE(normals[i].dot(held.slide), -1e-9);
    for (int other = 0; other < 200; ++other) {
      const Vec3 way =
          held.slide + random.uniform(0.0, 0.3) * Vec3(random.normal(), random.normal(), random.normal());
      bool feasible = true;
      for (std::size_t i = 0; i < count; ++i) feasible = feasible && normals[i].dot(way) >= 0.0;
      if (!feasible) continue;
      ASSERT_GE((pull - way).norm(), (pull - held.slide).norm() - 1e-9) << trial;
    }
    Vec3 sum = pull;
    for (std::size_t i = 0; i < count; ++i) sum += held.load[i] * normals[i];
    if (held.slide.norm() > 0.0) expect_near(sum, held.slide, 1e-9);
  }
}

TEST(SurfaceProxy, sticks_inside_the_static_cone_and_slides_on_the_dynamic_one) {
  const SurfaceProxySettings settings = {.static_friction = 0.5, .dynamic_friction = 0.3};
  Touch touch(settings, shapes::plane(), {0, 0, 1});
  touch.move({0, 0, -2});
  const Vec3 first = touch.model.proxy();
  expect_near(touch.move({0.99, 0, -2}), {-0.99, 0, 2}, 2 * gap);  // below atan 0.5: the proxy stays
  expect_near(touch.model.proxy(), first, 1e-9);
  EXPECT_FALSE(touch.model.sliding());
  expect_near(touch.move({1.02, 0, -2}), {-0.6, 0, 2}, 2 * gap);  // above: at the edge of the cone of 0.3
  expect_near(touch.move({9.0, 0, -2}), {-0.6, 0, 2}, 2 * gap);
  EXPECT_TRUE(touch.model.sliding());
  for (int tick = 0; tick < 25; ++tick) touch.move({9.0, 0, -2.0});  // at rest for 25 ms
  EXPECT_FALSE(touch.model.sliding());
  const Vec3 second = touch.model.proxy();
  touch.move({9.35, 0, -2});  // stopped: the static cone holds again
  expect_near(touch.model.proxy(), second, 1e-9);
  touch.move({9.6, 0, -2});
  EXPECT_NEAR(touch.move({9.65, 0, -2}).x(), -0.6, 2 * gap);  // slides again
  for (int tick = 0; tick < 10; ++tick) touch.move({9.65, 0, -2.0});
  EXPECT_NEAR(touch.move({9.7, 0, -2}).x(), -0.6, 2 * gap);  // a rest of 10 ms is too short to stick
  // Across: the force turns against the motion, its size stays that of the cone.
  const Vec3 force = touch.move({9.7, 20.0, -2});
  EXPECT_NEAR(force.head<2>().norm(), 0.6, 2 * gap);
  EXPECT_NEAR(force.y(), -0.6, 1e-3);
}

TEST(SurfaceProxy, friction_in_a_groove_is_that_of_both_walls) {
  // Two walls at 45 degrees: a spring d deep loads each by d / sqrt(2), so friction along is mu d sqrt(2).
  const Surface groove = shapes::patches(
      {{Vec3(-40, 0, 0), Vec3(80, 0, 0), Vec3(0, 20, 20)}, {Vec3(-40, -20, 20), Vec3(80, 0, 0), Vec3(0, 20, -20)}},
      8);
  const SurfaceProxySettings settings = {.static_friction = 0.4, .dynamic_friction = 0.4};
  Touch touch(settings, groove, {0, 0, 3});
  touch.move({0, 0, -1});
  EXPECT_EQ(touch.model.constraints(), 2u);
  expect_near(touch.move({10, 0, -1}), {-0.4 * std::numbers::sqrt2, 0, 1}, 5 * gap);
}

TEST(SurfaceProxy, viscosity_adds_a_force_in_proportion_to_speed) {
  for (const double speed : {10.0, 40.0}) {
    const SurfaceProxySettings settings = {.static_friction = 0.3, .dynamic_friction = 0.3, .viscosity = 0.02};
    Touch touch(settings, shapes::plane(), {0, 0, 1});
    touch.move({0, 0, -2});
    const Vec3 force = touch.move({20.0, 0, -2}, speed);
    EXPECT_NEAR(force.x(), -(0.3 * 2.0 + 0.02 * speed), 1e-3);
  }
}

TEST(SurfaceProxy, a_hand_on_the_lattice_of_the_corners_passes_no_edge_and_no_corner) {
  // Tip and vertices on whole and half millimetres: faces, edges and corners are met exactly.
  const Surface box = shapes::box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 10);
  const Surface room = shapes::box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 10, true);
  for (const double friction : {0.0, 0.3}) {
    const SurfaceProxySettings settings = {.static_friction = friction, .dynamic_friction = friction};
    SurfaceProxy outside(settings, box, one_tick), within(settings, room, one_tick);
    TickEvents events;
    Random random(5);
    Vec3 around(0, 0, 15), about(0, 0, 0);
    outside.step(around, events);
    within.step(about, events);
    for (int tick = 0; tick < 60000; ++tick) {
      for (Vec3* tip : {&around, &about}) {
        Vec3 way;
        for (int axis = 0; axis < 3; ++axis) way[axis] = std::floor(random.uniform(-1.0, 2.0));
        const Vec3 next = *tip + (tick % 3 == 0 ? 1.0 : 0.5) * way;
        if (next.cwiseAbs().maxCoeff() < 14.0) *tip = next;
      }
      outside.step(around, events);
      within.step(about, events);
      ASSERT_GE(outside.proxy().cwiseAbs().maxCoeff(), 10.0) << tick;
      ASSERT_LE(within.proxy().cwiseAbs().maxCoeff(), 10.0) << tick;
    }
  }
}

TEST(SurfaceProxy, nothing_goes_through_a_thin_wall) {
  // A wall of 0.05 mm, hit at up to 1 m/s (1 mm a tick) and by jumps of 30 mm, straight, slanted and on its seams.
  const Surface wall = shapes::box(Vec3(-50, -50, -0.05), Vec3(50, 50, 0), 10);
  Random random(4);
  for (const double friction : {0.0, 0.5}) {
    SurfaceProxy model({.static_friction = friction, .dynamic_friction = friction}, wall, one_tick);
    TickEvents events;
    Vec3 tip(0, 0, 2);
    model.step(tip, events);
    for (int tick = 0; tick < 60000; ++tick) {
      const double reach = tick % 1000 == 0 ? 30.0 : 1.0;
      Vec3 next = tip + reach * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      if (tick % 7 == 0) next.x() = 10.0 * std::round(next.x() / 10.0);  // along seams
      if (tick % 11 == 0) next.y() = next.x();                           // along diagonals
      if (std::abs(next.x()) > 45.0 || std::abs(next.y()) > 45.0 || std::abs(next.z()) > 6.0) continue;
      tip = next;
      const Vec3 force = model.step(tip, events);
      ASSERT_GT(model.proxy().z(), 0.0) << tick;
      ASSERT_GE(force.z(), -1e-12);
    }
  }
}

// Whether `point` is inside, by counting what a ray to far away passes.
bool inside(const Surface& surface, const Vec3& point) {
  double angle = 0.0;  // solid angle, Van Oosterom and Strackee 1983
  for (const auto& corners : surface.triangles()) {
    const auto at = [&](std::size_t i) {
      return Vec3(surface.vertices()[static_cast<std::size_t>(corners[i])] - point);
    };
    const Vec3 a = at(0), b = at(1), c = at(2);
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle > 2.0 * std::numbers::pi;
}

TEST(SurfaceProxy, stays_outside_a_rough_body_whatever_the_hand_does) {
  // A lump with ridges, pits and needles: edges and corners of every kind.
  const Surface ball = shapes::sphere(10.0, 3);
  Random random(6);
  std::vector<Vec3> vertices = ball.vertices();
  for (Vec3& vertex : vertices) vertex *= random.uniform(0.6, 1.4);
  const Surface lump(vertices, ball.triangles());
  for (const double friction : {0.0, 0.4}) {
    SurfaceProxy model({.static_friction = friction, .dynamic_friction = 0.5 * friction}, lump, one_tick);
    TickEvents events;
    Vec3 tip(0, 0, 20);
    model.step(tip, events);
    Vec3 speed = Vec3::Zero();
    for (int tick = 0; tick < 40000; ++tick) {
      speed = 0.98 * speed + 0.15 * Vec3(random.normal(), random.normal(), random.normal()) - 0.002 * tip;
      if (speed.norm() > 1.0) speed.normalize();  // 1 m/s
      tip += speed;
      model.step(tip, events);
      if (tick % 100 != 0) continue;
      ASSERT_FALSE(inside(lump, model.proxy())) << tick;
    }
    EXPECT_FALSE(inside(lump, model.proxy()));
  }
}

// The hand moves the tip while the proxy rests, which stores its work in the spring; then the proxy follows, which
// must return no energy. So the hand's total work is at least the energy still in the spring.
void expect_passive(const SurfaceProxySettings& settings) {
  const Surface ball = shapes::sphere(10.0, 3);
  Random shape(6), random(12);
  std::vector<Vec3> vertices = ball.vertices();
  for (Vec3& vertex : vertices) vertex *= shape.uniform(0.85, 1.15);
  SurfaceProxy model(settings, Surface(vertices, ball.triangles()), one_tick);
  TickEvents events;
  const auto stored = [&](const Vec3& tip) { return 0.5 * settings.stiffness * (tip - model.proxy()).squaredNorm(); };
  for (int path = 0; path < 60; ++path) {
    const Vec3 start(0, 0, 16);
    Vec3 at = start;
    double work = 0.0;
    model.reset();
    model.step(at, events);
    for (int leg = 0; leg < 6; ++leg) {
      const Vec3 to = leg == 5 ? start : Vec3(9.0 * Vec3(random.normal(), random.normal(), random.normal()));
      const Vec3 from = at;
      for (int i = 1; i <= 600; ++i) {
        const Vec3 next = from + (to - from) * i / 600;
        const double before = stored(at);
        at = next;
        const double paid = stored(at);
        work += paid - before;
        model.step(at, events);
        ASSERT_LE(stored(at), paid * (1.0 + 1e-12)) << path;
      }
    }
    ASSERT_GE(work, stored(at) - 1e-9) << path;
  }
}

TEST(SurfaceProxy, following_gives_no_energy_on_closed_paths) {
  for (const double friction : {0.0, 0.3}) {
    for (const double viscosity : {0.0, 0.02}) {
      expect_passive({.static_friction = 1.5 * friction, .dynamic_friction = friction, .viscosity = viscosity});
    }
  }
}

TEST(SurfaceProxy, is_passive_on_random_closed_paths) {
  // Trapezium rule over the forces that the hand feels, on a smooth ball where it is accurate.
  for (const double friction : {0.0, 0.3}) {
    SurfaceProxy model({.static_friction = friction, .dynamic_friction = friction, .limit = 3.0},
                       shapes::sphere(20.0, 4), one_tick);
    TickEvents events;
    Random random(21);
    double least = 1e9;
    for (int path = 0; path < 100; ++path) {
      const Vec3 start(0, 0, 25);
      Vec3 at = start, force = model.step(at, events);
      double work = 0.0;
      for (int leg = 0; leg < 6; ++leg) {
        const Vec3 to =
            leg == 5 ? start : Vec3(random.uniform(-12, 12), random.uniform(-12, 12), random.uniform(15, 22));
        const Vec3 from = at;
        for (int i = 1; i <= 1000; ++i) {
          const Vec3 next = from + (to - from) * i / 1000;
          const Vec3 now = model.step(next, events);
          work -= 0.5 * (force + now).dot(next - at);
          at = next;
          force = now;
        }
      }
      least = std::min(least, work);
    }
    EXPECT_GE(least, friction > 0.0 ? 0.0 : -1e-3);
  }
}

TEST(SurfaceProxy, the_force_is_continuous_over_the_edges_of_a_smooth_body) {
  const double radius = 30.0;
  const Surface ball = shapes::sphere(radius, 5);
  double bend = 0.0;
  for (std::size_t t = 0; t < ball.triangles().size(); ++t) {
    for (const int other : ball.neighbours()[t]) {
      bend =
          std::max(bend, std::acos(std::min(1.0, ball.normal(t).dot(ball.normal(static_cast<std::size_t>(other))))));
    }
  }
  Touch touch(smooth, ball, Vec3(0, 0, 33));
  const double depth = 3.0;
  touch.move({0, 0, radius - depth});
  Vec3 before = touch.force;
  double most = 0.0;
  const Vec3 axis = Vec3(0.3, 1.0, 0.1).normalized();
  for (int tick = 1; tick <= 20000; ++tick) {  // 27 mm radius, 30 mm/s: 0.03 mm a tick
    const Vec3 tip = Eigen::AngleAxisd(tick * 0.03 / (radius - depth), axis) * Vec3(0, 0, radius - depth);
    const Vec3 force = touch.model.step(tip, touch.events);
    most = std::max(most, (force - before).norm());
    before = force;
  }
  // An edge turns the normal by at most `bend`, and with it a force k depth; near a vertex two edges may be passed.
  EXPECT_LE(most, 2.0 * depth * bend + 0.03);
}

TEST(SurfaceProxy, a_tip_that_starts_inside_feels_nothing_until_it_has_left) {
  const Surface box = shapes::box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 4);
  Touch touch(smooth, box, {1, 2, 3});
  expect_near(touch.move({5, 4, 3}), Vec3::Zero(), 0.0);
  expect_near(touch.move({5, 4, 12}), Vec3::Zero(), 0.0);
  expect_near(touch.move({5, 4, 8}), {0, 0, 2}, 2 * gap);
  touch.model.reset();
  expect_near(touch.move({5, 4, 7}), Vec3::Zero(), 0.0);
}

TEST(SurfaceProxy, repeats_to_the_same_bits) {
  std::vector<double> runs[2];
  for (auto& run : runs) {
    Touch touch({}, shapes::sphere(10.0, 3), {0, 0, 12});
    Random random(9);
    for (int tick = 0; tick < 5000; ++tick) {
      const Vec3 force = touch.move(
          touch.tip + 0.3 * Vec3(random.normal(), random.normal(), random.normal()) - 0.01 * touch.tip, 1e6);
      run.insert(run.end(), {force.x(), force.y(), force.z()});
    }
  }
  EXPECT_EQ(0, std::memcmp(runs[0].data(), runs[1].data(), runs[0].size() * sizeof(double)));
}

TEST(SurfaceProxy, is_finite_and_limited_on_any_input) {
  SurfaceProxy model({}, shapes::sphere(10.0, 3), one_tick);
  TickEvents events;
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const double values[] = {0.0, -0.0, 1e-300, 5.0, -300.0, 9e3, 1e300, inf, nan};
  model.step({0, 0, 20}, events);
  for (const double a : values) {
    for (const double b : values) {
      for (const double c : values) {
        events.clear();
        const Vec3 before = model.proxy(), tip(a, b, c);
        const Vec3 force = model.step(tip, events);
        ASSERT_LE(force.norm(), 8.5 + 1e-9) << tip.transpose();
        if (tip.norm() <= 1e4) continue;
        EXPECT_EQ(force.norm(), 0.0);
        ASSERT_EQ(events.size(), 1u);
        EXPECT_EQ(events.begin()->kind, EventKind::fault);
        EXPECT_EQ((model.proxy() - before).norm(), 0.0);
      }
    }
  }
}

TEST(SurfaceProxy, an_empty_surface_is_air) {
  Touch touch({}, Surface{}, {0, 0, 0});
  expect_near(touch.move({5, 5, 5}), Vec3::Zero(), 0.0);
}

TEST(SurfaceProxy, refuses_what_it_cannot_use) {
  const Surface plane = shapes::plane();
  EXPECT_THROW(SurfaceProxy({.stiffness = 0.0}, plane, one_tick), InputError);
  EXPECT_THROW(SurfaceProxy({.static_friction = 0.1, .dynamic_friction = 0.2}, plane, one_tick), InputError);
  EXPECT_THROW(SurfaceProxy({.dynamic_friction = -0.1}, plane, one_tick), InputError);
  EXPECT_THROW(SurfaceProxy({.viscosity = std::nan("")}, plane, one_tick), InputError);
  EXPECT_THROW(SurfaceProxy({.limit = 0.0}, plane, one_tick), InputError);
  EXPECT_THROW(SurfaceProxy({}, plane, 0.0), InputError);
}

}  // namespace
}  // namespace bodkin
