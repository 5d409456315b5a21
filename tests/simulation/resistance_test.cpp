#include "simulation/resistance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>

#include "tests/simulation/model_pairs.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::simulation;
namespace {

Case body(const ResistanceSettings& settings = LayeredSettings{}, const ForceParts& parts = {}) {
  return patient_for({"", settings, parts}, {"none", NoConstraint{}});
}

// The message of the tick's constructor.
std::string refusal(const Case& patient) {
  try {
    const HapticTick tick(patient);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

double push(const Case& patient, double depth, double turns = 0.0) {
  HapticTick tick(patient);
  TickOutput output;
  for (double d = -3.0; d <= depth; d += 0.02) output = tick.step(needle_at(d));
  for (double turn = 0.0; turn < turns; turn += 0.01) {
    TickInput input = needle_at(depth);
    input.needle.rotate(Eigen::AngleAxisd(turn * 2.0 * 3.14159265358979, Vec3::UnitZ()));
    output = tick.step(input);
  }
  for (double d = depth; turns > 0.0 && d > depth - 10.0; d -= 0.02) {
    TickInput input = needle_at(d);
    input.needle.rotate(Eigen::AngleAxisd(turns * 2.0 * 3.14159265358979, Vec3::UnitZ()));
    output = tick.step(input);
  }
  return output.resistance;
}

TEST(Resistance, a_spring_that_the_device_cannot_render_is_named_with_bound_and_remedy) {
  const std::string wall = refusal(body(SpringDamperWallSettings{.stiffness = 3.0, .damping = 0.0}));
  EXPECT_NE(wall.find("stiffness is 3 N/mm"), std::string::npos) << wall;
  EXPECT_NE(wall.find("at most 1 N/mm"), std::string::npos) << wall;
  EXPECT_NE(wall.find("lower it"), std::string::npos) << wall;
  // Colgate and Schenkel 1994: beside 0.5 N/mm at 1 kHz a device of 1 N/mm has 0.00025 N s/mm left.
  const std::string damping = refusal(body(SpringDamperWallSettings{.stiffness = 0.5, .damping = 0.002}));
  EXPECT_NE(damping.find("damping is 0.002 N s/mm"), std::string::npos) << damping;
  EXPECT_NE(damping.find("at most 0.00025 N s/mm"), std::string::npos) << damping;
  EXPECT_EQ(refusal(body(SpringDamperWallSettings{.stiffness = 0.5, .damping = 0.00025})), "");
  EXPECT_NE(refusal(body(DepthProfileSettings{.bone_stiffness = 2.0})).find("bone stiffness is 2"),
            std::string::npos);
  EXPECT_NE(refusal(body(VolumeProxySettings{.stiffness = 1.5})).find("stiffness is 1.5"), std::string::npos);
  EXPECT_NE(refusal(body(ThreeComponentSettings{.puncture_force = 40.0})).find("gives way"), std::string::npos);
  EXPECT_NE(refusal(body(FractureSettings{.toughness = 50.0})).find("tears"), std::string::npos);
  Case soft = body(TrackingWallSettings{});
  soft.description.device.stiffness = 0.4;
  EXPECT_NE(refusal(soft).find("tracking_wall: the spring of"), std::string::npos) << refusal(soft);
}

TEST(Resistance, a_part_that_does_not_go_with_the_model_is_refused) {
  ForceParts rubbing, relaxing, grasping;
  rubbing.shaft_friction.emplace();
  relaxing.relaxation = {{}};
  grasping.needle_grasp.emplace();
  EXPECT_NE(refusal(body(LayeredSettings{}, rubbing)).find("shaft_friction does not go with layered"),
            std::string::npos);
  EXPECT_NE(refusal(body(FractureSettings{}, relaxing)).find("relaxation does not go with fracture"),
            std::string::npos);
  EXPECT_NE(refusal(body(TrackingWallSettings{.leash = true}, relaxing)).find("or tracking_wall without leash"),
            std::string::npos);
  EXPECT_NE(refusal(body(FractureSettings{}, grasping)).find("add the part shaft_friction"), std::string::npos);
  EXPECT_EQ(refusal(body(LayeredSettings{}, grasping)), "");
  grasping.shaft_friction.emplace();
  EXPECT_EQ(refusal(body(FractureSettings{}, grasping)), "") << "it acts on the friction that the part adds";
}

TEST(Resistance, friction_of_the_shaft_adds_to_a_model_that_has_none) {
  ForceParts rubbing;
  rubbing.shaft_friction.emplace();
  const double alone = push(body(TrackingWallSettings{}), 30.0);
  const double both = push(body(TrackingWallSettings{}, rubbing), 30.0);
  const double friction = push(body(ShaftFrictionSettings{}), 30.0);
  // Beside a spring of its own the device has less left for the friction's, which then lags behind a little.
  EXPECT_NEAR(both, alone + friction, 0.05);
  // Skin 2 mm, fat 10, muscle 18: sums of Fc and the viscous part of the library at 20 mm/s.
  EXPECT_NEAR(friction, 2.0 * 0.03 + 10.0 * 0.004 + 18.0 * 0.015 + 20.0 * (2 * 0.0003 + 10 * 0.0004 + 18 * 0.0002),
              0.02);
}

TEST(Resistance, turning_the_needle_makes_it_hold_more_firmly_when_it_is_pulled_out) {
  ForceParts grasping;
  grasping.needle_grasp.emplace();
  for (const ResistanceSettings& settings :
       {ResistanceSettings(LayeredSettings{}), ResistanceSettings(ShaftFrictionSettings{})}) {
    const double plain = push(body(settings), 30.0, 4.0);
    const double wound = push(body(settings, grasping), 30.0, 4.0);
    ASSERT_LT(plain, 0.0) << name_of(settings);
    // Langevin et al. 2001: at most +167 %; the viscous part does not grow.
    EXPECT_GT(wound / plain, 1.5) << name_of(settings);
    EXPECT_LT(wound / plain, 2.67 + 1e-9) << name_of(settings);
  }
}

TEST(Resistance, relaxing_tissue_gives_way_to_the_share_that_remains) {
  ForceParts relaxing;
  relaxing.relaxation = {{0.5, 0.2}};
  const Case patient = body(SpringDamperWallSettings{.damping = 0.0}, relaxing);
  HapticTick tick(patient);
  TickOutput output;
  for (double d = -3.0; d <= 4.0; d += 0.02) output = tick.step(needle_at(d));
  for (int i = 0; i < 3000; ++i) output = tick.step(needle_at(4.0));
  EXPECT_NEAR(output.resistance, 0.5 * 0.5 * 4.0, 0.01);
  // The half that has decayed would pull the needle in: 0.25 N left of 0.5 N less half of the 1.5 N that were let go.
  double least = output.resistance;
  for (double d = 4.0; d >= 1.0; d -= 0.02) least = std::min(least, tick.step(needle_at(d)).resistance);
  EXPECT_EQ(least, 0.0);
}

// The diagnostic of that name in the last output.
double published(const HapticTick& tick, const TickOutput& output, std::string_view name) {
  const auto names = tick.diagnostic_names();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i].name == name) return output.diagnostics[i];
  ADD_FAILURE() << "no diagnostic " << name;
  return 0.0;
}

TEST(Resistance, the_grip_of_a_turned_needle_is_published) {
  ForceParts grasping;
  grasping.needle_grasp.emplace();
  const Case patient = body(ShaftFrictionSettings{}, grasping);
  HapticTick tick(patient);
  TickOutput output;
  for (double d = -3.0; d <= 20.0; d += 0.02) output = tick.step(needle_at(d));
  EXPECT_DOUBLE_EQ(published(tick, output, "grip"), 1.0);
  for (double turn = 0.0; turn < 4.0; turn += 0.01) {
    TickInput input = needle_at(20.0);
    input.needle.rotate(Eigen::AngleAxisd(turn * 2.0 * 3.14159265358979, Vec3::UnitZ()));
    output = tick.step(input);
  }
  EXPECT_NEAR(published(tick, output, "grip"), 1.0 + 1.67 * (1.0 - std::exp(-4.0 / 2.0)), 0.01);
}

TEST(Resistance, contact_is_told_once_though_models_notice_it_too) {
  const Case patient = body(FractureSettings{});
  HapticTick tick(patient);
  int contacts = 0;
  for (double d = -3.0; d <= 10.0; d += 0.02) {
    for (const forces::Event& event : tick.step(needle_at(d)).events)
      contacts += event.kind == forces::EventKind::contact ? 1 : 0;
  }
  EXPECT_EQ(contacts, 1);
}

}  // namespace
}  // namespace bodkin
