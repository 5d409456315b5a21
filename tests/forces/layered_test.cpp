#include "forces/layered.h"

#include "tests/forces/layered_rig.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

using namespace tissue;
using testing::HasSubstr;

LayeredTissue unbreakable_skin() {
  LayeredTissue skin = rig_skin();
  skin.break_force = 100.0;
  return skin;
}

TEST(Layered, skin_before_puncture_follows_equation_2_from_the_near_face) {
  LayeredRig rig({{skin, 60}}, rig_library(unbreakable_skin()));
  const double a[] = {0.5, 1, 1.5, 2, 3, 5, 10};
  const double force[] = {0.015625, 0.05, 0.109375, 0.2, 0.5, 1.75, 11};
  for (int i = 0; i < 7; ++i) EXPECT_NEAR(rig.to(a[i], 0.0).resistance, force[i], 1e-9 * force[i]);
  EXPECT_NEAR(rig.to(3.0, 10.0).resistance, 0.53, 1e-12);
  EXPECT_NEAR(rig.to(3.0, 0.0).stiffness, 0.391667, 5e-7);
}

TEST(Layered, the_sum_law_can_be_chosen) {
  LayeredRig rig({{skin, 60}}, rig_library(unbreakable_skin()), {.law = LayeredLaw::sum});
  EXPECT_NEAR(rig.to(1.5, 0.0).resistance, 0.1, 1e-12);
  EXPECT_NEAR(rig.to(10.0, 0.0).resistance, 2.75, 1e-12);
}

TEST(Layered, skin_breaks_at_its_limit_and_the_force_pops) {
  LayeredRig rig({{skin, 2}, {fat, 30}});
  double peak = 0.0;
  while (rig.seen(EventKind::puncture).empty()) {
    peak = std::max(peak, rig.to(rig.depth() + 0.005).resistance);
    ASSERT_LT(rig.depth(), 10.0);
  }
  const Event pop = rig.seen(EventKind::puncture).front();
  EXPECT_EQ(pop.tissue, skin);
  EXPECT_GE(pop.value, 1.0);
  EXPECT_NEAR(pop.value, 1.0, 0.01);
  EXPECT_NEAR(peak, 1.0, 0.01);
  EXPECT_LT(rig.last.resistance, 0.05);
}

// L = 2: the strict rule breaks at H + L/v.
TEST(Layered, the_strict_break_rule_has_the_tabulated_limits_and_depths) {
  LayeredTissue limited = rig_skin();
  limited.break_force_rate = 2.0;
  limited.viscosity = 0.0;
  const double speeds[] = {1, 2, 10, 50}, limits[] = {3, 2, 1.2, 1.04},
               depths[] = {6.15581, 5.25729, 4.24332, 3.74832};
  for (int i = 0; i < 4; ++i) {
    LayeredTissue viscous = limited;
    viscous.viscosity = 0.001;
    LayeredRig rig({{skin, 60}}, rig_library(viscous), {.strict = true});
    while (rig.seen(EventKind::puncture).empty() && rig.depth() < 10.0) rig.to(rig.depth() + 1e-4, speeds[i]);
    ASSERT_EQ(rig.seen(EventKind::puncture).size(), 1u);
    EXPECT_NEAR(rig.seen(EventKind::puncture)[0].value, limits[i], 2e-4);
    EXPECT_NEAR(rig.depth(), depths[i], 2e-4);
  }
}

TEST(Layered, withdrawing_never_punctures) {
  LayeredTissue limited = rig_skin();
  limited.break_force_rate = 2.0;
  for (const bool strict : {false, true}) {
    LayeredRig rig({{skin, 60}}, rig_library(limited), {.strict = strict});
    for (double depth = 0.0; depth < 30.0; depth += 0.1) rig.to(depth, -2.0);
    EXPECT_TRUE(rig.seen(EventKind::puncture).empty());
  }
}

TEST(Layered, a_needle_that_rests_punctures_nothing_however_hard_it_presses) {
  LayeredRig rig({{skin, 60}});
  for (int tick = 0; tick < 100; ++tick) EXPECT_GT(rig.to(10.0, 0.0, true).resistance, 1.0);
  EXPECT_TRUE(rig.seen(EventKind::puncture).empty());
}

TEST(Layered, a_push_at_rest_has_a_finite_limit) {
  LayeredTissue limited = rig_skin();
  limited.break_force_rate = 2.0;
  limited.viscosity = 0.0;
  LayeredRig rig({{skin, 60}}, rig_library(limited));
  while (rig.seen(EventKind::puncture).empty() && rig.depth() < 10.0) rig.to(rig.depth() + 1e-4, 1e-9);
  ASSERT_EQ(rig.seen(EventKind::puncture).size(), 1u);
  EXPECT_NEAR(rig.seen(EventKind::puncture)[0].value, 3.0, 1e-3);  // H + L / v0, v0 = 1 mm/s
}

TEST(Layered, sliding_in_three_tissues_adds_up_to_the_tabulated_force) {
  LayeredRig rig({{skin, 2}, {fat, 10}, {muscle, 40}}, rig_library(), {}, 1e9, 0.001);
  rig.move(20.0, 5.0);
  ASSERT_EQ(rig.seen(EventKind::puncture).size(), 2u);
  EXPECT_NEAR(rig.last.resistance, 0.04 + 0.02 + 0.12, 1e-9);
}

TEST(Layered, friction_does_not_jump_when_sliding_stops_and_goes_on) {
  LayeredRig rig({{skin, 2}, {fat, 10}, {muscle, 60}});
  rig.move(40.0, 5.0);
  const double viscous = 0.0004 * 5.0 * 10.0;
  const double sliding = rig.last.resistance - viscous;
  EXPECT_NEAR(sliding, 0.04 + 0.015 * 28.0, 1e-9);
  EXPECT_NEAR(rig.rest(50).resistance, sliding, 1e-9);
  double before = rig.last.resistance;
  double peak = 0.0;
  while (rig.depth() < 42.0) {
    rig.to(rig.depth() + 0.005);
    const double now = rig.last.resistance - viscous;
    EXPECT_LT(now - before, 0.02);  // may fall from break-away to sliding, never jumps up
    before = now;
    peak = std::max(peak, now);
  }
  EXPECT_GT(peak, sliding);  // stick and slip: S > D
  EXPECT_LT(peak, 0.048 + 0.018 * 28.0 + 0.01);
}

TEST(Layered, jitter_around_rest_does_not_chatter) {
  LayeredRig rig({{skin, 2}, {muscle, 60}});
  rig.move(30.0, 5.0);
  const double sliding = rig.last.resistance;
  for (int tick = 0; tick < 10000; ++tick) {
    rig.to(30.0 + (tick % 2 == 0 ? 0.01 : 0.0));
    EXPECT_NEAR(rig.last.resistance, sliding, 0.05);
  }
}

// No force at rest can exceed the static friction, whatever the previous motion.
TEST(Layered, a_jump_and_back_leaves_no_more_than_static_friction) {
  for (const double jump : {0.5, 3.0, 10.0, -3.0, -10.0}) {
    LayeredRig rig({{skin, 2}, {muscle, 60}});
    rig.move(30.0, 5.0);
    rig.rest(50);
    const double limit = 0.024 * 2.0 + 0.018 * (28.0 + std::max(0.0, jump));  // of all the shaft that was gripped
    rig.to(30.0 + jump);
    EXPECT_LE(std::abs(rig.last.resistance), limit + 1e-9) << jump;
    rig.to(30.0);
    EXPECT_LE(std::abs(rig.rest(50).resistance), limit + 1e-9) << jump;
  }
}

TEST(Layered, withdrawal_pulls_the_needle_in_by_its_friction) {
  LayeredRig rig({{skin, 2}, {muscle, 60}});
  rig.move(22.0, 5.0);
  rig.move(12.0, 5.0);
  EXPECT_NEAR(rig.last.resistance, -(0.02 * 2.0 + 0.015 * 10.0), 1e-9);
}

TEST(Layered, roughness_belongs_to_the_depth_and_not_to_the_tick) {
  LayeredTissue rough = rig_skin();
  rough.roughness = 0.5;
  LayeredRig slow({{skin, 60}}, rig_library(rough)), fast({{skin, 60}}, rig_library(rough));
  slow.move(10.0, 5.0);
  fast.move(10.0, 20.0);
  double least = 1e9, most = 0.0;
  for (int step = 1; step <= 40; ++step) {
    const double depth = 10.0 + 0.5 * step;
    const double a = slow.move(depth, 5.0).resistance, b = fast.move(depth, 20.0).resistance;
    EXPECT_NEAR(a, b, 1e-9);
    least = std::min(least, a / depth);
    most = std::max(most, a / depth);
  }
  EXPECT_GE(least, 0.02 * 0.5);
  EXPECT_LE(most, 0.02 * 1.5);
  EXPECT_GT(most - least, 0.002);
}

TEST(Layered, bone_is_a_spring_without_any_viscous_term) {
  for (const double v : {0.0, -40.0, 40.0}) {
    LayeredRig rig({{fat, 10}, {cortical_bone, 20}});
    rig.to(10.5);
    EXPECT_NEAR(rig.to(11.0, v).resistance, 3.16, 1e-12);
  }
}

TEST(Layered, tissue_that_is_pressed_onto_bone_has_no_viscous_term_either) {
  double forces[3];
  for (int i = 0; i < 3; ++i) {
    LayeredRig rig({{skin, 10}, {cortical_bone, 20}}, rig_library(unbreakable_skin()));
    rig.to(10.5, 0.0);
    forces[i] = rig.to(11.0, 40.0 * (i - 1)).resistance;
  }
  EXPECT_DOUBLE_EQ(forces[0], forces[1]);
  EXPECT_DOUBLE_EQ(forces[2], forces[1]);
}

TEST(Layered, the_device_bounds_the_stiffness_of_bone) {
  LayeredRig rig({{fat, 10}, {cortical_bone, 20}}, rig_library(), {}, 1.0);
  EXPECT_NEAR(rig.to(11.0, 0.0).resistance, 1.0, 1e-12);
}

TEST(Layered, bone_is_never_punctured_and_nothing_behind_it_is_felt) {
  LayeredRig rig({{fat, 10}, {cortical_bone, 3}, {muscle, 60}});
  rig.move(40.0, 10.0);
  EXPECT_NEAR(rig.last.resistance, 3.16 * 30.0, 1e-9);
  EXPECT_TRUE(rig.seen(EventKind::puncture).empty());
  EXPECT_EQ(rig.seen(EventKind::bone_contact).size(), 1u);
}

TEST(Layered, drag_fades_in_over_20_ms_after_bone) {
  LayeredRig rig({{fat, 10}, {cortical_bone, 20}});
  rig.move(10.5, 5.0);
  rig.to(9.0, 100.0);
  const double full = 0.0004 * 100.0 * 9.0;
  EXPECT_NEAR(rig.last.resistance, full / 20.0, 1e-9);
  for (int tick = 0; tick < 9; ++tick) rig.to(9.0, 100.0);
  EXPECT_NEAR(rig.last.resistance, full / 2.0, 1e-9);
  for (int tick = 0; tick < 10; ++tick) rig.to(9.0, 100.0);
  EXPECT_NEAR(rig.last.resistance, full, 1e-9);
  EXPECT_EQ(rig.seen(EventKind::bone_left).size(), 1u);
}

TEST(Layered, a_needle_that_trembles_on_bone_leaves_it_once) {
  LayeredRig rig({{fat, 10}, {cortical_bone, 20}});
  rig.move(10.5, 5.0);
  for (int turn = 0; turn < 3; ++turn) {
    rig.move(9.85, 5.0);
    rig.move(10.1, 5.0);
  }
  EXPECT_EQ(rig.seen(EventKind::bone_contact).size(), 1u);
  EXPECT_TRUE(rig.seen(EventKind::bone_left).empty());
  rig.move(9.79, 5.0);  // more than 0.2 mm off
  ASSERT_EQ(rig.seen(EventKind::bone_left).size(), 1u);
  EXPECT_NEAR(rig.seen(EventKind::bone_left)[0].depth, 9.8, 0.011);
  rig.move(10.1, 5.0);
  EXPECT_EQ(rig.seen(EventKind::bone_contact).size(), 2u);
}

TEST(Layered, held_shaft_keeps_a_tenth_of_the_device_beside_bone) {
  LayeredRig rig({{muscle, 40}, {cortical_bone, 20}}, rig_library(), {}, 1.0);
  rig.move(41.0, 5.0);
  rig.rest(5);
  EXPECT_GT(rig.last.stiffness, 1.05);  // bone takes the whole 1 N/mm
  EXPECT_LE(rig.last.stiffness, 1.1 + 1e-9);
}

TEST(Layered, fat_behind_an_unbroken_face_does_not_drag) {
  LayeredTissue hard = unbreakable_skin();
  hard.viscosity = 0.0;
  LayeredRig rig({{skin, 2}, {fat, 20}}, rig_library(hard));
  rig.move(3.0, 5.0);
  EXPECT_NEAR(rig.to(3.0, 1000.0).resistance, 0.5, 1e-12);
}

TEST(Layered, a_punctured_block_grips_at_once_when_met_again) {
  LayeredRig rig({{skin, 2}, {fat, 20}, {muscle, 40}});
  rig.move(40.0, 20.0);
  ASSERT_EQ(rig.seen(EventKind::puncture).size(), 2u);
  rig.move(10.0, 20.0);
  rig.move(35.0, 20.0);
  EXPECT_EQ(rig.seen(EventKind::puncture).size(), 2u);
  EXPECT_NEAR(rig.last.resistance, 0.04 + 0.0004 * 20.0 * 20.0 + 0.015 * 13.0, 1e-6);
}

TEST(Layered, several_faces_press_at_once_and_break_in_their_own_time) {
  LayeredRig rig({{skin, 2}, {muscle, 40}}, rig_library(unbreakable_skin()));
  rig.move(5.0, 5.0);
  EXPECT_NEAR(rig.to(5.0, 0.0).resistance, 1.75 + 0.3, 1e-9);
  rig.move(8.0, 5.0);
  const auto punctures = rig.seen(EventKind::puncture);
  ASSERT_EQ(punctures.size(), 1u);
  EXPECT_EQ(punctures[0].tissue, muscle);
}

TEST(Layered, contact_ends_at_the_surface_unless_the_skin_holds_the_shaft) {
  LayeredRig touched({{skin, 2}, {fat, 20}});
  touched.move(1.0, 5.0);
  EXPECT_TRUE(touched.last.in_contact);
  EXPECT_FALSE(touched.to(0.0).in_contact);

  LayeredRig pierced({{skin, 2}, {fat, 20}});
  pierced.move(10.0, 5.0);
  pierced.move(0.0, 5.0);
  double furthest = 0.0;
  while (pierced.last.in_contact && pierced.depth() > -20.0)
    furthest = pierced.to(pierced.depth() - 0.005).in_contact ? pierced.depth() : furthest;
  EXPECT_GE(furthest, -10.0);
  EXPECT_EQ(pierced.last.resistance, 0.0);
}

TEST(Layered, skin_pulled_outwards_tents_before_it_lets_go) {
  LayeredTissue sticky = rig_skin();
  sticky.static_friction = 10.0;  // never slides: 6 N/mm are the most at 16 mm
  sticky.shaft_stiffness = 0.002;
  LayeredRig rig({{skin, 2}, {fat, 20}}, rig_library(sticky));
  rig.move(6.0, 5.0);
  rig.move(-5.0, 5.0);
  EXPECT_TRUE(rig.last.in_contact);
  EXPECT_LT(rig.last.resistance, 0.0);
  EXPECT_FALSE(rig.move(-10.1, 5.0).in_contact);
}

TEST(Layered, a_thin_flicker_of_the_labels_is_no_tissue_of_its_own) {
  LayeredRig rig({{muscle, 10}, {fat, 0.5}, {muscle, 10}, {fat, 0.5}, {muscle, 20}});
  rig.move(40.0, 5.0);
  EXPECT_EQ(rig.seen(EventKind::puncture).size(), 1u);
  EXPECT_NEAR(rig.last.resistance, 0.015 * 40.0, 1e-9);

  LayeredRig thick({{muscle, 10}, {fat, 1.0}, {muscle, 20}});
  thick.move(30.0, 5.0);
  EXPECT_EQ(thick.seen(EventKind::puncture).size(), 2u);

  LayeredRig bone({{muscle, 10}, {cortical_bone, 0.5}, {muscle, 20}});
  bone.move(15.0, 5.0);
  EXPECT_EQ(bone.seen(EventKind::bone_contact).size(), 1u);
}

TEST(Layered, a_long_held_shaft_stays_within_the_stiffness_of_the_device) {
  LayeredRig free({{muscle, 200}}), bounded({{muscle, 200}}, rig_library(), {}, 1.0);
  for (LayeredRig* rig : {&free, &bounded}) {
    rig->move(120.0, 20.0);
    rig->rest(40);
  }
  EXPECT_NEAR(free.last.resistance, bounded.last.resistance, 1e-9);  // the same force at rest, another way to it
  double stiffest = 0.0, steepest = 0.0;  // N/mm, as the model states it, and of the force itself
  while (bounded.depth() > 110.0) {
    const double before = bounded.last.resistance;
    stiffest = std::max(stiffest, bounded.to(bounded.depth() - 0.005).stiffness);
    steepest = std::max(steepest, (before - bounded.last.resistance) / 0.005);
  }
  EXPECT_LE(stiffest, 1.0 + 1e-3);  // break-away is noticed a tick late
  EXPECT_LE(steepest, 1.0 + 0.02);
  const double before = free.last.resistance;
  free.to(free.depth() - 0.005);
  EXPECT_GT(free.last.stiffness, 3.0);
  EXPECT_GT((before - free.last.resistance) / 0.005, 3.0);
}

TEST(Layered, a_tissue_too_stiff_for_the_device_is_softened_and_that_is_reported) {
  LayeredTissue hard = rig_skin();
  hard.stiffness = 5.0;
  hard.break_force = 4.0;
  LayeredRig rig({{skin, 40}}, rig_library(hard), {}, 1.0);
  EXPECT_LT(rig.model.stiffness_scale(), 1.0);
  double stiffest = 0.0;
  while (rig.seen(EventKind::puncture).empty() && rig.depth() < 30.0) {
    stiffest = std::max(stiffest, rig.to(rig.depth() + 0.002).stiffness);
  }
  EXPECT_LE(stiffest, 1.0 + 1e-9);
  EXPECT_NEAR(rig.seen(EventKind::puncture)[0].value, 4.0, 0.02);
  EXPECT_EQ(LayeredRig({{skin, 40}}, rig_library(), {}, 10.0).model.stiffness_scale(), 1.0);
}

TEST(Layered, refuses_parameters_that_no_tissue_can_have_and_names_them) {
  const auto message = [](const LayeredTissue& skin_properties) -> std::string {
    try {
      Layered(rig_library(skin_properties), {}, 1.0, 0.001, 100.0);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  LayeredTissue wrong = rig_skin();
  wrong.static_friction = 0.01;
  EXPECT_THAT(message(wrong), testing::AllOf(HasSubstr("skin"), HasSubstr("static_friction")));
  wrong = rig_skin();
  wrong.stiffness = 0.0;
  EXPECT_THAT(message(wrong), HasSubstr("stiffness"));
  wrong = rig_skin();
  wrong.roughness = 1.0;
  EXPECT_THAT(message(wrong), HasSubstr("roughness"));
  wrong = rig_skin();
  wrong.break_force = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message(wrong), HasSubstr("break_force"));
  EXPECT_EQ(message(rig_skin()), "");
}

}  // namespace
}  // namespace bodkin
