#include "forces/volume_proxy.h"

#include <limits>
#include <numbers>

#include "tests/forces/default_tissues.h"
#include "tests/forces/model_checks.h"
#include "tests/forces/near.h"
#include "tests/sanitized.h"

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

// Force and proxy after one step from the origin, k 0.5, gradient along +z.
struct Step {
  Vec3 proxy, force;
};
Step step(const Vec3& tip, const ProxyProperties& properties, bool two_sided = false,
          const Vec3& normal = Vec3::UnitZ()) {
  const Vec3 proxy = advance_proxy(Vec3::Zero(), tip, normal, properties, 0.5, ProxyVariant::drag, two_sided, 1e-3);
  return {proxy, -0.5 * (tip - proxy)};
}

// Air above z = 0, then skin to 3, fat to 12, muscle to 30, bone below; 1 mm voxels, turned and moved in space.
struct Body {
  explicit Body(double spacing = 1.0) {
    Grid grid;
    grid.size = {static_cast<int>(24 / spacing), static_cast<int>(24 / spacing), static_cast<int>(60 / spacing)};
    grid.spacing = Vec3::Constant(spacing);
    grid.origin = Vec3(-12.0, -12.0, -10.0);
    ct = CtVolume(grid);
    tissues = TissueVolume(grid);
    for (int k = 0; k < grid.size[2]; ++k) {
      const double z = grid.to_patient(Vec3(0, 0, k)).z();
      const TissueId id = z < 0    ? tissue::air
                          : z < 3  ? tissue::skin
                          : z < 12 ? tissue::fat
                          : z < 30 ? tissue::muscle
                                   : tissue::cortical_bone;
      for (int j = 0; j < grid.size[1]; ++j) {
        for (int i = 0; i < grid.size[0]; ++i) {
          tissues.at(i, j, k) = id;
          ct.at(i, j, k) = static_cast<std::int16_t>(id == tissue::air             ? -1000
                                                     : id == tissue::cortical_bone ? 1200
                                                                                   : 40);
        }
      }
    }
  }
  CtVolume ct;
  TissueVolume tissues;
};

const Body& body() {
  static const Body made;
  return made;
}
const HapticField& field() {
  static const HapticField made(body().ct, body().tissues, checks::default_tissues(), {});
  return made;
}

struct Axial {  // along z on a rail, as a resistance
  explicit Axial(VolumeProxySettings settings = {}, double dt = 1e-3)
      : model(checks::default_tissues(), settings, field(), dt), rail({}) {
    rail.begin(Vec3(0.3, 0.2, 0.0), Vec3::UnitZ());
  }
  double operator()(const AxialMotion& motion) { return -model.step({0.3, 0.2, motion.depth}, &rail, events).z(); }
  VolumeProxy model;
  Rail rail;
  TickEvents events;
};

TEST(VolumeProxy, a_wall_lets_the_proxy_pass_above_its_threshold) {
  const Step one = step({0, 0, 5}, {.penetrability = 1.0});
  expect_near(one.proxy, {0, 0, 3});
  expect_near(one.force, {0, 0, -1});
}

TEST(VolumeProxy, friction_holds_across_the_gradient) {
  const Step one = step({3, 0, 1.5}, {.penetrability = 1.0, .friction = 0.25});
  expect_near(one.proxy, {2.5, 0, 0});
  expect_near(one.force, {-0.25, 0, -0.75});
}

TEST(VolumeProxy, drag_takes_the_proxy_back_a_little) {
  const Step one = step({3, 0, 1.5}, {.penetrability = 1.0, .friction = 0.25, .drag = 0.1});
  expect_near(one.proxy, {2.3, 0, 0});
  expect_near(one.force, {-0.35, 0, -0.75});
}

TEST(VolumeProxy, leaving_dense_tissue_is_free_unless_it_holds_on_both_sides) {
  const Step one = step({0, 0, -2}, {.penetrability = 1.0});
  expect_near(one.proxy, {0, 0, -2});
  expect_near(one.force, {0, 0, 0});
  expect_near(step({0, 0, -2}, {.penetrability = 1.0}, true).force, {0, 0, 1});  // as literal eq. 3 at 2 mm
  expect_near(step({0, 0, -5}, {.penetrability = 1.0}, true).force, {0, 0, 1});  // but no more than T_N
}

TEST(VolumeProxy, a_flat_field_has_friction_only) {
  const Step one = step({0, 0, 5}, {.penetrability = 1.0, .friction = 0.25}, false, Vec3::Zero());
  expect_near(one.force, {0, 0, -0.25});
  EXPECT_TRUE(step({0, 0, 0}, {}, false, Vec3::Zero()).force.allFinite());
}

TEST(VolumeProxy, drag_does_not_depend_on_speed_and_viscosity_does) {
  for (const double speed : {10.0, 50.0}) {
    Vec3 drag = Vec3::Zero(), viscous = Vec3::Zero(), tip = Vec3::Zero();
    for (int tick = 0; tick < 3000; ++tick) {
      tip.z() += speed * 1e-3;
      drag = advance_proxy(drag, tip, Vec3::UnitZ(), {1.0, 0.25, 0.1, 0.0}, 0.5, ProxyVariant::drag, false, 1e-3);
      viscous =
          advance_proxy(viscous, tip, Vec3::UnitZ(), {1.0, 0.25, 0.0, 0.01}, 0.5, ProxyVariant::viscous, false, 1e-3);
    }
    EXPECT_NEAR(0.5 * (tip - drag).z(), 1.1, 1e-9);
    EXPECT_NEAR(0.5 * (tip - viscous).z(), 1.0 + 0.01 * speed, 1e-9);
  }
  EXPECT_NEAR(0.5 * 1e-3 / (0.5 * 1e-3 + 0.01), 0.047619, 5e-7);
}

// N/s, the fastest fall of the force where a proxy that friction holds comes from muscle into fat, which does not.
double fastest_release(double rate) {
  VolumeProxySettings settings;
  settings.variant = ProxyVariant::drag;
  const double fat = field().sample({0.3, 0.2, 8.0}).value, muscle = field().sample({0.3, 0.2, 20.0}).value;
  settings.transfer = {{fat, {}}, {muscle, {.friction = 2.0}}};
  VolumeProxy model(checks::default_tissues(), settings, field(), 1.0 / rate);
  TickEvents events;
  double before = 0.0, fastest = 0.0;
  for (double depth = 20.0; depth > 4.0; depth -= 10.0 / rate) {
    const double force = model.step({0.3, 0.2, depth}, nullptr, events).norm();
    fastest = std::max(fastest, (before - force) * rate);
    before = force;
  }
  EXPECT_LT(before, 0.1) << "let go";
  return fastest;
}

TEST(VolumeProxy, drag_lets_go_at_one_speed_at_every_rate) {
  for (const double rate : {500.0, 1000.0, 2000.0}) {
    const double speed = fastest_release(rate) / VolumeProxySettings{}.stiffness;
    EXPECT_NEAR(speed, 200.0, 20.0) << rate;  // mm/s
  }
}

TEST(VolumeProxy, a_tip_off_the_rail_is_pulled_towards_it) {
  VolumeProxy model(checks::default_tissues(), {}, field(), 1e-3);
  Rail rail({});
  rail.begin(Vec3::Zero(), Vec3::UnitZ());
  TickEvents events;
  model.step({0, 0, 20}, &rail, events);
  const Vec3 force = model.step({0, 2, 20}, &rail, events);
  EXPECT_NEAR(force.y(), -1.0, 1e-9);
  EXPECT_NEAR(force.x(), 0.0, 1e-9);
}

TEST(VolumeProxy, field_has_the_gradient_of_a_linear_image_exactly) {
  Grid grid;
  grid.size = {12, 14, 16};
  grid.spacing = Vec3(0.7, 1.0, 1.3);
  grid.direction = Eigen::AngleAxisd(0.6, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  grid.origin = Vec3(5.0, -3.0, 2.0);
  const Vec3 slope(10.0, -20.0, 30.0);  // HU/mm
  CtVolume ct(grid);
  for (int k = 0; k < 16; ++k) {
    for (int j = 0; j < 14; ++j) {
      for (int i = 0; i < 12; ++i) {
        ct.at(i, j, k) = static_cast<std::int16_t>(std::lround(400.0 + slope.dot(grid.to_patient(Vec3(i, j, k)))));
      }
    }
  }
  const TissueVolume tissues(grid, tissue::muscle);
  HapticFieldSettings settings;
  settings.ct_range = 2.7;  // 0.001 per HU
  settings.lowest_hounsfield = -1000.0;
  settings.highest_hounsfield = 1700.0;
  const HapticField made(ct, tissues, checks::default_tissues(), settings);
  const Vec3 point = grid.to_patient(Vec3(5.3, 6.8, 7.1));
  const FieldSample here = made.sample(point);
  ASSERT_TRUE(here.inside);
  EXPECT_NEAR(here.value, 0.3 + 1.4 + slope.dot(point) * 1e-3, 1e-3);
  EXPECT_NEAR((here.gradient - slope * 1e-3).norm(), 0.0, 2e-3);
  EXPECT_FALSE(made.sample(grid.to_patient(Vec3(-0.6, 5.0, 5.0))).inside);
  EXPECT_FALSE(made.sample(Vec3::Constant(NAN)).inside);
}

TEST(VolumeProxy, field_gradient_is_the_derivative_of_a_smooth_field) {
  const Vec3 point(0.4, -0.3, 11.8);
  const double h = 0.5;
  const double slope =
      (field().sample(point + Vec3(0, 0, h)).value - field().sample(point - Vec3(0, 0, h)).value) / (2.0 * h);
  EXPECT_NEAR(field().sample(point).gradient.z(), slope, 0.15 * std::abs(slope));
  EXPECT_NEAR(field().sample(point).gradient.head<2>().norm(), 0.0, 1e-9);
}

TEST(VolumeProxy, goes_through_a_body_with_the_forces_of_its_tissues) {
  Axial axial;
  checks::Hand hand(-8.0);
  double peak = 0.0;
  const auto watch = [&](const AxialMotion& motion) {
    const double force = axial(motion);
    peak = std::max(peak, force);
    return force;
  };
  EXPECT_EQ(checks::move(hand, -5.0, 10.0, watch), 0.0);
  checks::move(hand, 8.0, 10.0, watch);
  EXPECT_GT(peak, 1.0);  // the wall of the skin
  EXPECT_LE(peak, 1.5 + 0.6);
  EXPECT_NEAR(checks::move(hand, 24.0, 10.0, watch), 0.6, 0.01);  // friction 0.3 and drag 0.3 inside muscle
  checks::move(hand, 42.0, 10.0, watch);
  EXPECT_GT(peak, 5.0);  // bone
}

TEST(VolumeProxy, takes_a_transfer_function_of_the_value) {
  VolumeProxySettings settings;
  settings.transfer = {{0.1, {}}, {0.5, {.friction = 1.0}}};
  Axial axial(settings);
  checks::Hand hand(-8.0);
  // Muscle: V = 0.3 + 0.2 * 240/1700, so the friction is (V - 0.1)/0.4 N.
  EXPECT_NEAR(checks::move(hand, 21.0, 10.0, axial), (0.3 + 0.2 * 240.0 / 1700.0 - 0.1) / 0.4, 1e-3);
}

TEST(VolumeProxy, has_the_properties_of_every_model) {
  for (const bool two_sided : {false, true}) {
    for (const ProxyVariant variant : {ProxyVariant::drag, ProxyVariant::viscous}) {
      VolumeProxySettings settings;
      settings.two_sided = two_sided;
      settings.variant = variant;
      SCOPED_TRACE(testing::Message() << "two-sided " << two_sided << ", viscous "
                                      << (variant == ProxyVariant::viscous));
      const auto make = [&] { return Axial(settings); };
      checks::finite_on_any_input(make);
      checks::passive_on_random_closed_paths(make, 40.0, 50.0, 1.0, sanitized ? 15 : 150);
      checks::same_bits_on_repetition(make, 40.0);
      checks::bounded_when_saturated(make, 8.5);
      checks::no_growth_under_reversal_at_every_tick(make, 2.0);
      checks::no_growth_under_reversal_at_every_tick(make, 20.0);
      checks::steady_force_is_the_same_at_half_the_tick([&](double dt) { return Axial(settings, dt); }, 24.0, 10.0,
                                                        0.5 * 0.01 + 1e-6);
    }
  }
}

TEST(VolumeProxy, is_passive_on_free_paths_in_space) {
  VolumeProxy model(checks::default_tissues(), {}, field(), 1e-3);
  Random random(11);
  TickEvents events;
  for (int path = 0; path < 100; ++path) {
    const Vec3 start(0.0, 0.0, -5.0);
    Vec3 at = start, force = model.step(at, nullptr, events);
    double work = 0.0;
    for (int leg = 0; leg < 6; ++leg) {
      const Vec3 from = at, to = leg == 5 ? start
                                          : Vec3(random.uniform(-8.0, 8.0), random.uniform(-8.0, 8.0),
                                                 random.uniform(-2.0, 40.0));
      for (int i = 1; i <= 1500; ++i) {
        const Vec3 next = from + (to - from) * i / 1500;
        const Vec3 now = model.step(next, nullptr, events);
        work -= 0.5 * (force + now).dot(next - at);
        at = next;
        force = now;
      }
    }
    ASSERT_GE(work, -1e-3) << path;
  }
}

TEST(VolumeProxy, is_finite_and_bounded_in_space) {
  VolumeProxy model(checks::default_tissues(), {}, field(), 1e-3);
  TickEvents events;
  const double values[] = {
      0.0, 5.0, -300.0, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
  for (const double a : values) {
    for (const double b : values) {
      for (const double c : values) {
        EXPECT_LE(model.step({a, b, c}, nullptr, events).norm(), 8.5 + 1e-9);
        EXPECT_LE(model.step({0, 0, 15}, nullptr, events).norm(), 8.5 + 1e-9);
      }
    }
  }
}

TEST(VolumeProxy, refuses_what_it_cannot_use) {
  EXPECT_THROW(VolumeProxy(checks::default_tissues(), {.stiffness = 0.0}, field(), 1e-3), InputError);
  VolumeProxySettings settings;
  settings.transfer = {{0.5, {}}, {0.1, {}}};
  EXPECT_THROW(VolumeProxy(checks::default_tissues(), settings, field(), 1e-3), InputError);
  EXPECT_THROW(HapticField(CtVolume{}, TissueVolume{}, checks::default_tissues(), {}), InputError);
}

}  // namespace
}  // namespace bodkin
