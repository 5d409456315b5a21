// Force models as people type them.
#include "io/force_choice.h"

#include "tests/io/scratch_folder.h"
#include "tests/io/wild_haptics.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

ResistanceSettings resistance(const std::string& text) {
  return parse_resistance(text, "--resistance");
}

std::string refused_choice(const std::string& text) {
  return refusal([&] { resistance(text); });
}

std::string part_refused(const std::vector<std::string>& texts) {
  return refusal([&] { parse_parts(texts, "--part"); });
}

TEST(ForceChoice, a_name_alone_brings_the_defaults) {
  for (std::size_t model = 0; model < resistance_names.size(); ++model) {
    if (resistance_names[model] == "registered") continue;  // needs the name of a model
    EXPECT_EQ(resistance(std::string(resistance_names[model])).index(), model);
  }
  for (std::size_t model = 0; model < constraint_names.size(); ++model)
    EXPECT_EQ(parse_constraint(constraint_names[model], "--constraint").index(), model);
  EXPECT_TRUE(same_bits(resistance("tracking_wall"), ResistanceSettings(TrackingWallSettings{})));
}

TEST(ForceChoice, settings_are_those_of_case_files) {
  TrackingWallSettings expected;
  expected.catch_up = 0.3;
  expected.leash = true;
  EXPECT_TRUE(same_bits(resistance("tracking_wall catch_up_s=0.3 leash=true"), ResistanceSettings(expected)));
  EXPECT_TRUE(same_bits(resistance(" \ttracking_wall\n catch_up_s=0.3   leash=1 "), ResistanceSettings(expected)));
  expected = {};
  expected.layers = {{0.0, {0.5, 1.5}}, {4.0, {1.0, 0.4}}};
  EXPECT_TRUE(same_bits(resistance("tracking_wall; layer from_mm=0 force_N=1.5; layer from_mm=4 force_N=0.4 "
                                   "stiffness_N_per_mm=1"),
                        ResistanceSettings(expected)));
  EXPECT_TRUE(same_bits(resistance("surface_proxy stiffness_N_per_mm=0.5"),
                        ResistanceSettings(SurfaceProxySettings{.stiffness = 0.5})));
  EXPECT_TRUE(same_bits(resistance("registered name=constant_drag force_N=0.7"),
                        ResistanceSettings(RegisteredSettings{"constant_drag", {{"force_N", "0.7"}}, {}})));
  EXPECT_EQ(std::get<RailSettings>(parse_constraint("rail torsion_N_mm_per_rad=5e2", "--constraint")).torsion, 500.0);
}

TEST(ForceChoice, parts_add_up_and_none_is_none) {
  const ForceParts parts = parse_parts({"relaxation share=0.4 time_s=2", "needle_grasp", "relaxation"}, "--part");
  EXPECT_TRUE(same_bits(parts, {{{0.4, 2.0}, {}}, {}, NeedleGraspSettings{}, {}, {}, {}, {}}));
  const ForceParts more =
      parse_parts({"bevel_tip limit_N=2", "csf_flow stylet=true", "syringe filling=air thumb_force_N=7"}, "--part");
  EXPECT_EQ(more.bevel_tip->limit, 2.0);
  EXPECT_TRUE(more.csf_flow->stylet);
  EXPECT_EQ(more.syringe->filling, SyringeFilling::air);
  EXPECT_EQ(more.syringe->thumb_force, 7.0);
  EXPECT_TRUE(same_bits(parse_parts({" none "}, "--part"), {}));
}

TEST(ForceChoice, errors_name_the_option_what_was_found_and_what_was_expected) {
  std::string names;
  for (const std::string_view name : resistance_names)
    names.append(names.empty() ? "" : name == "registered" ? " or " : ", ").append(name);
  EXPECT_TRUE(names.starts_with(
      "layered, spring_damper_wall, tracking_wall, depth_profile, volume_proxy, three_component, fracture, "
      "shaft_friction, embedded_needle, closest_node, surface_proxy"));
  EXPECT_EQ(refused_choice("tracking_wall catch_up_s=0"),
            "--resistance: tracking_wall catch_up_s is '0', expected a number of at least 0.001, or INF");
  EXPECT_EQ(refused_choice("tracking_wall catch_up=0"),
            "--resistance: <tracking_wall> has the unknown attribute 'catch_up'; it takes catch_up_s, "
            "channel_radius_mm, channel_tilt_deg, leash, limit_N, strict and surface_mm");
  EXPECT_EQ(refused_choice("tracking_wal"), "--resistance: there is no resistance 'tracking_wal', expected " + names);
  EXPECT_EQ(refused_choice(""), "--resistance: is empty, expected " + names);
  EXPECT_EQ(refused_choice(" ; "), "--resistance: is empty, expected " + names);
  EXPECT_EQ(refused_choice("<fracture/>"), "--resistance: there is no resistance '<fracture/>', expected " + names);
  EXPECT_EQ(refused_choice("fracture width_mm"),
            "--resistance: fracture has 'width_mm', expected SETTING=VALUE without blanks");
  EXPECT_EQ(refused_choice("fracture width_mm =1"),
            "--resistance: fracture has 'width_mm', expected SETTING=VALUE without blanks");
  EXPECT_EQ(refused_choice("fracture width_mm=1 width_mm=2"), "--resistance: fracture width_mm is given twice");
  EXPECT_EQ(refused_choice("fracture width_mm="),
            "--resistance: fracture width_mm is '', expected a number from 0.05 to 5");
  EXPECT_EQ(refused_choice("fracture width_mm='1'/><x"),
            "--resistance: fracture width_mm is ''1'/><x', expected a number from 0.05 to 5");
  EXPECT_EQ(refused_choice("fracture 1=2"),
            "--resistance: fracture has '1=2', expected SETTING=VALUE without blanks");
  EXPECT_EQ(refused_choice("tracking_wall; layer from_mm=1 force_N=1"),
            "--resistance: tracking_wall: from_mm of element 1 is 1, expected 0 for the first one");
  EXPECT_EQ(refused_choice("tracking_wall; <layer>"),
            "--resistance: ' <layer>' does not begin with a name, expected NAME SETTING=VALUE SETTING=VALUE ...");
  EXPECT_EQ(refused_choice("tracking_wall; membrane"),
            "--resistance: the element <membrane> is not allowed here, expected <layer>");
  EXPECT_EQ(refusal([] { parse_constraint("layered", "--constraint"); }),
            "--constraint: there is no constraint 'layered', expected line_spring, pivot, rail, beam or none");
  EXPECT_EQ(
      part_refused({"rail"}),
      "--part: there is no part 'rail', expected relaxation, shaft_friction, needle_grasp, bevel_tip, csf_flow, "
      "syringe or fingertip");
  EXPECT_EQ(
      part_refused({"none", "none"}),
      "--part: there is no part 'none', expected relaxation, shaft_friction, needle_grasp, bevel_tip, csf_flow, "
      "syringe or fingertip");
  EXPECT_EQ(part_refused({"needle_grasp", "needle_grasp"}),
            "--part: parts: the element needle_grasp is given 2 times, expected it once at most");
}

TEST(ForceChoice, texts_of_settings_read_back_to_the_same_bits) {
  Random random(9);
  for (int round = 0; round < 60; ++round) {
    const HapticSettings written = wild_haptics(random);
    const ForceTexts texts = force_texts(written);
    ASSERT_TRUE(same_bits(resistance(texts.resistance), written.resistance)) << texts.resistance;
    ASSERT_TRUE(same_bits(parse_constraint(texts.constraint, "c"), written.constraint)) << texts.constraint;
    ASSERT_TRUE(same_bits(parse_parts(texts.parts, "p"), written.parts));
  }
}

}  // namespace
}  // namespace bodkin
