#include "simulation/force_part.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>

#include "tests/simulation/slab_patient.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/tissue_library_file.h"
#include "simulation/haptic_tick.h"
#include "simulation/resistance_models.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::io;
using namespace bodkin::simulation;
namespace {

// The slabs with the tissues that come with Bodkin, and fluid behind the epidural space.
Case fluid_patient() {
  Case patient = slab_patient();
  patient.library = default_tissue_library();
  for (TissueId& one : patient.tissues.voxels) {
    if (one == tissue::cortical_bone) one = tissue::cerebrospinal_fluid;
  }
  patient.description.haptics.constraint = NoConstraint{};
  return patient;
}

struct PushResult {
  std::vector<Event> events;
  TickOutput last;
  std::vector<double> published;  // the diagnostic that was asked for, tick by tick

  const Event* first(EventKind kind) const {
    const auto found = std::find_if(events.begin(), events.end(), [&](const Event& e) { return e.kind == kind; });
    return found == events.end() ? nullptr : &*found;
  }
};

double named(const HapticTick& haptics, const TickOutput& output, std::string_view name) {
  const auto names = haptics.diagnostic_names();
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& one) { return one.name == name; });
  EXPECT_NE(found, names.end()) << name;
  return found == names.end() ? NAN : output.diagnostics[static_cast<std::size_t>(found - names.begin())];
}

PushResult push(HapticTick& haptics, double to, double speed, std::string_view name) {
  PushResult felt;
  for (double depth = -2.0; depth < to; depth += speed * haptics.dt()) {
    felt.last = haptics.step(needle_at(depth));
    felt.published.push_back(named(haptics, felt.last, name));
    felt.events.insert(felt.events.end(), felt.last.events.begin(), felt.last.events.end());
  }
  return felt;
}

TEST(ForcePart, a_bevel_pulls_the_tip_to_the_circle_that_it_cuts) {
  Case patient = fluid_patient();
  patient.description.haptics.parts.bevel_tip = BevelTipSettings{.curvature = 0.005, .stiffness = 0.05, .limit = 5.0};
  HapticTick haptics(patient);
  const double depth = 40.0;
  const PushResult felt = push(haptics, depth, 20.0, "bevel_aside_mm");
  // A circle of radius 200 mm: after 40 mm of path (1 - cos 0.2) 200 mm aside.
  const double aside = 200.0 * (1.0 - std::cos(0.005 * felt.last.depth));
  EXPECT_NEAR(felt.published.back(), aside, 0.02);
  EXPECT_NEAR(named(haptics, felt.last, "bevel_N"), 0.05 * aside, 0.002);
  EXPECT_NEAR(felt.last.requested.force.y(), -0.05 * aside, 0.002) << "towards the point, the side of -y";
  EXPECT_NEAR(felt.last.requested.force.x(), 0.0, 1e-9);
}

// A finger on the skin, then the needle into the fluid, turning, and out again: what each tick gives.
std::vector<double> felt_with(const Case& patient) {
  HapticTick haptics(patient);
  std::vector<double> given;
  const auto at = [&](double depth, bool finger) {
    TickInput input = needle_at(depth);
    input.other.finger = finger;
    input.needle.rotate(Eigen::AngleAxisd(finger ? 0.0 : depth, Vec3::UnitZ()));
    const TickOutput output = haptics.step(input);
    given.insert(given.end(), output.requested.force.begin(), output.requested.force.end());
    given.insert(given.end(), output.diagnostics.begin(), output.diagnostics.end());
  };
  for (const bool finger : {true, false}) {
    const double deepest = finger ? 5.0 : 50.0;
    for (double depth = -2.0; depth < deepest; depth += 0.05) at(depth, finger);
    for (double depth = deepest; depth > -2.0; depth -= 0.05) at(depth, finger);
  }
  return given;
}

// A part of the table of ForceParts that nobody takes would change nothing.
TEST(ForcePart, each_of_the_table_is_felt_or_published) {
  Case plain = fluid_patient();
  plain.description.haptics.resistance = SpringDamperWallSettings{.damping = 0.0};
  ASSERT_EQ(felt_with(plain), felt_with(plain));
  for (std::size_t part = 0; part < std::tuple_size_v<decltype(ForceParts::parameters())>; ++part) {
    Case with = plain;
    std::size_t at = 0;
    std::string_view name;
    for_each_inside(
        [&](const auto& entry, auto& value) {
          if (at++ != part) return;
          name = entry.name;
          if constexpr (parameter_detail::is_list<std::remove_cvref_t<decltype(entry)>>)
            value.emplace_back();
          else
            value.emplace();
        },
        with.description.haptics.parts);
    Case without = plain;
    if (name == "needle_grasp")  // acts on the friction of the shaft
      for (Case* patient : {&with, &without}) patient->description.haptics.parts.shaft_friction.emplace();
    EXPECT_NE(felt_with(with), felt_with(without)) << name;
  }
}

TEST(ForcePart, a_symmetric_tip_pulls_nowhere_and_changes_no_bit_along_the_line) {
  const Case plain = fluid_patient();
  Case with = plain;
  with.description.haptics.parts.bevel_tip = BevelTipSettings{.curvature = 0.0};
  HapticTick one(plain), other(with);
  for (double depth = -2.0; depth < 30.0; depth += 0.02) {
    const TickOutput a = one.step(needle_at(depth)), b = other.step(needle_at(depth));
    ASSERT_EQ(a.resistance, b.resistance);
    ASSERT_EQ(b.requested.force.x(), 0.0);
  }
}

TEST(ForcePart, the_pull_on_a_bevel_is_across_the_line_and_has_a_limit) {
  const Case plain = fluid_patient();
  Case with = plain;
  with.description.haptics.parts.bevel_tip = BevelTipSettings{.curvature = 0.01, .stiffness = 1.0, .limit = 0.6};
  HapticTick one(plain), other(with);
  TickOutput a, b;
  for (double depth = -2.0; depth < 30.0; depth += 0.02) {
    a = one.step(needle_at(depth));
    b = other.step(needle_at(depth));
    ASSERT_NEAR(b.requested.force.z(), a.requested.force.z(), 1e-9);
    ASSERT_LT(b.requested.force.head<2>().norm(), 0.6 + 1e-9);
  }
  EXPECT_NEAR(b.requested.force.head<2>().norm(), 0.6, 1e-9) << "4 mm aside would be 4 N";
  EXPECT_NEAR(named(other, b, "bevel_N"), 0.6, 1e-9);
}

// Half a turn half way: two arcs that bend to opposite sides, so that the path ends parallel to the line.
TEST(ForcePart, a_bevel_that_is_turned_cuts_to_the_other_side) {
  constexpr double pi = 3.14159265358979, curvature = 0.005, half_way = 20.0;
  Case patient = fluid_patient();
  patient.description.haptics.parts.bevel_tip = BevelTipSettings{.curvature = curvature, .stiffness = 0.05};
  HapticTick haptics(patient);
  TickOutput output;
  const auto move = [&](double depth, double roll) {
    TickInput input = needle_at(depth);
    input.needle.rotate(Eigen::AngleAxisd(roll, Vec3::UnitZ()));
    output = haptics.step(input);
  };
  for (double depth = -2.0; depth < half_way; depth += 0.02) move(depth, 0.0);
  for (int i = 1; i <= 100; ++i) move(half_way, pi * i / 100.0);
  for (double depth = half_way; depth < 2.0 * half_way; depth += 0.02) move(depth, pi);
  EXPECT_NEAR(named(haptics, output, "bevel_aside_mm"), 2.0 / curvature * (1.0 - std::cos(curvature * half_way)),
              0.1);
}

TEST(ForcePart, fluid_rises_in_the_manometer_once_the_tip_is_in_fluid_and_not_with_the_stylet) {
  Case patient = fluid_patient();
  patient.description.haptics.parts.csf_flow.emplace();
  HapticTick haptics(patient);
  const PushResult felt = push(haptics, 50.0, 20.0, "csf_height_mm");
  const Event* returned = felt.first(EventKind::fluid_returned);
  ASSERT_NE(returned, nullptr);
  EXPECT_NEAR(returned->depth, 44.0, 0.1);
  EXPECT_EQ(returned->tissue, tissue::cerebrospinal_fluid);
  double height = felt.published.back();
  EXPECT_GT(height, 0.0);
  for (int tick = 0; tick < 120000; ++tick) haptics.step(needle_at(50.0));
  height = named(haptics, haptics.step(needle_at(50.0)), "csf_height_mm");
  EXPECT_NEAR(height, 145.0, 1.0) << "the opening pressure after five time constants";

  patient.description.haptics.parts.csf_flow->stylet = true;
  HapticTick closed(patient);
  EXPECT_EQ(push(closed, 50.0, 20.0, "csf_height_mm").first(EventKind::fluid_returned), nullptr);
}

TEST(ForcePart, fluid_returns_with_physical_mechanics_where_the_deformed_tissue_is_fluid) {
  Case patient = fluid_patient();
  patient.description.haptics.mechanics = Mechanics::physical;
  patient.description.haptics.parts.csf_flow.emplace();
  HapticTick haptics(patient);
  const PushResult felt = push(haptics, 55.0, 20.0, "csf_height_mm");
  const Event* returned = felt.first(EventKind::fluid_returned);
  ASSERT_NE(returned, nullptr);
  EXPECT_EQ(returned->tissue, tissue::cerebrospinal_fluid);
}

// Stylet out, drip, manometer on, off, on, stylet in: the handling of fluid in a whole lumbar puncture.
TEST(ForcePart, stylet_and_manometer_are_handled_while_the_needle_is_in_fluid) {
  Case patient = fluid_patient();
  patient.description.haptics.parts.csf_flow =
      CsfFlowSettings{.manometer = false, .stylet = true, .pressure_volume_index = 25.0, .times_faster = 20.0};
  HapticTick haptics(patient);
  EXPECT_EQ(push(haptics, 50.0, 20.0, "csf_height_mm").first(EventKind::fluid_returned), nullptr);
  std::vector<Event> events;
  const auto wait = [&](double seconds, OtherHand other) {
    TickInput input = needle_at(50.0);
    input.other = other;
    for (int tick = 0; tick < static_cast<int>(seconds * 1000.0); ++tick) {
      const TickOutput output = haptics.step(input);
      events.insert(events.end(), output.events.begin(), output.events.end());
    }
  };
  wait(0.1, {});
  EXPECT_TRUE(events.empty());
  wait(0.1, {.stylet_moved = true});
  wait(8.0, {.stylet_moved = true, .manometer_moved = true});
  wait(14.0, {.stylet_moved = true});
  wait(8.0, {.stylet_moved = true, .manometer_moved = true});
  wait(0.1, {.manometer_moved = true});
  std::vector<EventKind> kinds;
  double opening = 0.0, closing = 0.0, collected = 0.0;
  for (const Event& event : events) {
    if (event.kind == EventKind::pressure_read) (opening == 0.0 ? opening : closing) = event.value;
    if (event.kind == EventKind::fluid_collected) collected = event.value;
    if (kinds.empty() || kinds.back() != event.kind) kinds.push_back(event.kind);
  }
  EXPECT_EQ(kinds,
            (std::vector<EventKind>{EventKind::stylet_out, EventKind::fluid_returned, EventKind::manometer_on,
                                    EventKind::fluid_collected, EventKind::pressure_read, EventKind::manometer_off,
                                    EventKind::fluid_collected, EventKind::manometer_on, EventKind::fluid_collected,
                                    EventKind::pressure_read, EventKind::stylet_in}));
  EXPECT_NEAR(opening, 0.98 * 145.0, 1.0);
  EXPECT_GT(collected, 2000.0);
  EXPECT_NEAR(closing, 0.98 * 145.0 * std::pow(10.0, -collected / 25000.0), 1.0);
}

TEST(ForcePart, a_finger_feels_the_skin_and_the_needle_comes_after_it) {
  Case patient = fluid_patient();
  patient.description.haptics.parts.fingertip.emplace();
  HapticTick haptics(patient);
  std::vector<Event> events;
  double felt = 0.0;
  const auto go = [&](double from, double to, bool finger) {
    for (double depth = from; std::abs(depth - to) > 0.005; depth += from < to ? 0.01 : -0.01) {
      TickInput input = needle_at(depth);
      input.other.finger = finger;
      const TickOutput output = haptics.step(input);
      EXPECT_FALSE(finger && output.in_contact) << "nothing is inserted";
      felt = std::max(felt, finger ? output.resistance : 0.0);
      events.insert(events.end(), output.events.begin(), output.events.end());
    }
  };
  go(-3.0, 7.0, true);
  EXPECT_GT(felt, 0.3);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::palpated);
  go(7.0, 3.0, false);  // the finger is taken for the needle only above the skin
  EXPECT_EQ(events.size(), 1U);
  go(3.0, -3.0, false);
  go(-3.0, 5.0, false);
  const auto touched =
      std::find_if(events.begin(), events.end(), [](const Event& event) { return event.kind == EventKind::contact; });
  ASSERT_NE(touched, events.end());
  EXPECT_NEAR(haptics.step(needle_at(5.0)).depth, 5.0, 0.6);
  TickInput input = needle_at(5.0);
  input.other.finger = true;
  EXPECT_TRUE(haptics.step(input).in_contact) << "no finger while the needle is in";
}

TEST(ForcePart, the_syringe_holds_pressure_in_the_ligament_and_loses_it_in_the_epidural_space) {
  Case patient = fluid_patient();
  patient.description.haptics.parts.syringe.emplace();
  patient.description.needle.outer_diameter = 1.651;  // 16G: a thin needle holds the pressure up by itself
  patient.description.needle.inner_diameter = 1.194;
  HapticTick haptics(patient);
  const PushResult felt = push(haptics, 42.0, 5.0, "syringe_pressure_MPa");
  const Event* lost = felt.first(EventKind::pressure_lost);
  ASSERT_NE(lost, nullptr);
  EXPECT_GT(lost->depth, 35.9);
  EXPECT_LT(lost->depth, 37.0);
  EXPECT_GT(lost->value, 0.01);
  const double highest = *std::max_element(felt.published.begin(), felt.published.end());
  // 5 N of the thumb less the plunger's friction on 177 mm^2.
  EXPECT_LE(highest, 5.0 / 176.7 + 1e-4);
  EXPECT_GT(highest, 0.9 * (5.0 - 0.3) / 176.7);
}

TEST(ForcePart, the_hand_says_when_the_thumb_presses_the_plunger) {
  Case patient = fluid_patient();
  patient.description.haptics.parts.syringe.emplace();
  HapticTick haptics(patient);
  // Down into the ligament with the thumb off the plunger, then the thumb presses with 3 N, then with the case's 5 N.
  TickInput input = needle_at(-2.0);
  input.thumb = Thumb::of_force(0.0);
  for (double depth = -2.0; depth < 33.0; depth += 0.05) {
    input.needle = needle_at(depth).needle;
    EXPECT_EQ(named(haptics, haptics.step(input), "plunger_mm"), 0.0);
  }
  const auto pressure_after_a_second = [&](Thumb thumb) {
    input.thumb = thumb;
    for (int tick = 0; tick < 999; ++tick) haptics.step(input);
    return named(haptics, haptics.step(input), "syringe_pressure_MPa");
  };
  const double area = 176.7;  // mm^2, of 15 mm
  EXPECT_NEAR(pressure_after_a_second(Thumb::of_force(3.0)), 3.0 / area, 0.1 * 3.0 / area);
  EXPECT_NEAR(pressure_after_a_second(Thumb()), 5.0 / area, 0.1 * 5.0 / area);
  const double travel = named(haptics, haptics.step(input), "plunger_mm");
  EXPECT_LE(pressure_after_a_second(Thumb::of_force(0.0)), 5.0 / area) << "who lets go presses no further";
  EXPECT_GE(named(haptics, haptics.step(input), "plunger_mm"), travel) << "and the plunger does not come back";
}

TEST(ForcePart, a_thumb_is_kept_in_steps_of_a_fifth_of_a_newton) {
  EXPECT_EQ(Thumb().force(), std::nullopt);
  EXPECT_EQ(Thumb().byte(), 0) << "as recordings from before there was a thumb have it";
  EXPECT_EQ(*Thumb::of_force(0.0).force(), 0.0);
  EXPECT_NEAR(*Thumb::of_force(3.09).force(), 3.0, 1e-12);
  EXPECT_NEAR(*Thumb::of_force(3.11).force(), 3.2, 1e-12);
  EXPECT_NEAR(*Thumb::of_force(1000.0).force(), 50.8, 1e-12);
  EXPECT_EQ(*Thumb::of_force(-1.0).force(), 0.0);
  EXPECT_EQ(*Thumb::of_force(NAN).force(), 0.0);
  for (int byte = 1; byte < 256; ++byte) {
    const Thumb thumb = Thumb::from_byte(static_cast<std::uint8_t>(byte));
    EXPECT_EQ(Thumb::of_force(*thumb.force()).byte(), byte);
  }
}

TEST(ForcePart, an_empty_barrel_presses_nothing_out_any_more) {
  Case patient = fluid_patient();
  patient.description.haptics.parts.syringe.emplace();
  HapticTick haptics(patient);
  push(haptics, 40.0, 20.0, "syringe_pressure_MPa");  // in the epidural space
  const auto pressure_after = [&haptics](int seconds) {
    TickOutput output;
    for (int tick = 0; tick < 1000 * seconds; ++tick) output = haptics.step(needle_at(40.0));
    return named(haptics, output, "syringe_pressure_MPa");
  };
  const double flowing = pressure_after(2);
  EXPECT_LT(pressure_after(600), 0.5 * flowing) << "60 mm of barrel are empty";
}

TEST(ForcePart, settings_out_of_range_are_refused_with_their_range) {
  Case patient = fluid_patient();
  patient.description.haptics.parts.bevel_tip = BevelTipSettings{.stiffness = 11.0};
  EXPECT_THROW(HapticTick{patient}, InputError);
  patient.description.haptics.parts.bevel_tip.reset();
  patient.description.haptics.parts.csf_flow.emplace();
  patient.description.needle.inner_diameter = 0.0;  // solid
  EXPECT_THROW(HapticTick{patient}, InputError);
}

TEST(SurfaceProxyResistance, the_skin_pushes_back_with_the_spring_and_lets_go) {
  Case patient = fluid_patient();
  patient.description.haptics.resistance = SurfaceProxySettings{.stiffness = 0.5};
  HapticTick haptics(patient);
  double pressed = 0.0;
  for (double depth = -8.0; depth < 4.0; depth += 0.01) pressed = haptics.step(needle_at(depth)).resistance;
  EXPECT_NEAR(pressed, 0.5 * 4.0, 0.5 * 0.7) << "the skin is at z = 0 to within a voxel";
  bool withdrawn = false;
  double last = 1.0;
  for (double depth = 4.0; depth > -8.0; depth -= 0.01) {
    const TickOutput output = haptics.step(needle_at(depth));
    last = output.resistance;
    for (const Event& event : output.events) withdrawn = withdrawn || event.kind == EventKind::withdrawn;
  }
  EXPECT_TRUE(withdrawn);
  EXPECT_EQ(last, 0.0);
}

}  // namespace
}  // namespace bodkin
