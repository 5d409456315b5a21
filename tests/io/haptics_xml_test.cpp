// Valid contents of <haptics>: every model with its settings, and the agreement of schema and engine.
#include "io/haptics_xml.h"

#include <map>
#include <regex>

#include "tests/io/case_documents.h"
#include "tests/io/scratch_folder.h"
#include "tests/io/wild_haptics.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/resources.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

HapticSettings haptics_of(const std::string& inside) {
  static const XmlSchema schema("case.xsd");
  return parse_haptics_xml("<haptics>\n" + inside + "</haptics>\n", "h", schema);
}

template <typename Model>
Model resistance_of(const std::string& element) {
  return std::get<Model>(haptics_of("<resistance>" + element + "</resistance>").resistance);
}

template <typename Model>
Model constraint_of(const std::string& element) {
  return std::get<Model>(haptics_of("<constraint>" + element + "</constraint>").constraint);
}

std::string refused_haptics(const std::string& inside) {
  return refusal([&] { haptics_of(inside); });
}

TEST(HapticsXml, every_setting_of_every_resistance_arrives) {
  EXPECT_TRUE(same_bits(resistance_of<LayeredSettings>("<layered law='sum' strict='true' layer_mm='0.7'/>"),
                        {LayeredLaw::sum, true, 0.7}));
  EXPECT_TRUE(same_bits(resistance_of<SpringDamperWallSettings>(
                            "<spring_damper_wall stiffness_N_per_mm='0.6' damping_N_s_per_mm='0.001' wall_mm='-2' "
                            "limit_N='7'/>"),
                        {0.6, 0.001, -2.0, 7.0}));
  EXPECT_TRUE(same_bits(resistance_of<TrackingWallSettings>(
                            "<tracking_wall leash='true' surface_mm='1' catch_up_s='1e9' strict='true' limit_N='7' "
                            "channel_radius_mm='2' channel_tilt_deg='4'><layer from_mm='0' force_N='1.5'/>"
                            "<layer from_mm='5' stiffness_N_per_mm='0.8' force_N='0.4'/></tracking_wall>"),
                        {true, 1.0, 1e9, true, 7.0, 2.0, 4.0, {{0.0, {0.5, 1.5}}, {5.0, {0.8, 0.4}}}}));
  EXPECT_TRUE(same_bits(resistance_of<DepthProfileSettings>(
                            "<depth_profile skin_stiffness_N_per_mm='0.4' puncture_depth_mm='6' trailing_mm='3' "
                            "bone_stiffness_N_per_mm='0.9' limit_N='5' release_s='0.03' filter_Hz='40' "
                            "stiffening_N_per_mm_s='30' hysteresis_mm='2' channel_radius_mm='3' "
                            "channel_tilt_deg='5'/>"),
                        {0.4, 6.0, 3.0, 0.9, 5.0, 0.03, 40.0, 30.0, 2.0, 3.0, 5.0}));
  EXPECT_TRUE(same_bits(
      resistance_of<VolumeProxySettings>(
          "<volume_proxy stiffness_N_per_mm='0.6' gradient_reference_per_mm='0.2' gradient_least_per_mm='0.001' "
          "variant='viscous' two_sided='true' limit_N='7' field_ct_range='0.3' field_lowest_HU='-100' "
          "field_highest_HU='1400' field_smoothing_voxels='2'><transfer_point value='-1'/><transfer_point value='1' "
          "penetrability_N='1' friction_N='2' drag_N='3' viscosity_N_s_per_mm='4'/></volume_proxy>"),
      {0.6,
       0.2,
       0.001,
       ProxyVariant::viscous,
       true,
       7.0,
       {0.3, -100.0, 1400.0, 2.0},
       {{-1.0, {}}, {1.0, {1.0, 2.0, 3.0, 4.0}}}}));
  EXPECT_TRUE(same_bits(
      resistance_of<ThreeComponentSettings>(
          "<three_component linear_N_per_mm='0.03' quadratic_N_per_mm2='0.04' puncture_force_N='0.9' "
          "cutting_force_N='0.4' cutting_stiffness_N_per_mm='0.8' dead_band_mm_per_s='2' hold_N_per_mm2='0.2' "
          "limit_N='7'><outwards coulomb_N_per_mm='0.02' viscous_N_s_per_mm2='0.03' static_N_per_mm='0.04'/>"
          "</three_component>"),
      {0.03, 0.04, 0.9, 0.4, 0.8, ThreeComponentSettings{}.inwards, {0.02, 0.03, 0.04}, 2.0, 0.2, 7.0}));
  EXPECT_TRUE(
      same_bits(resistance_of<FractureSettings>(
                    "<fracture stiffness_N_per_mm='0.06' spacing_mm='2' toughness_N_per_mm='3' width_mm='0.9' "
                    "thickness_mm='4' cutting_stiffness_N_per_mm='0.7' cutting_toughness_N_per_mm='0.2' "
                    "limit_N='7'/>"),
                {0.06, 2.0, 3.0, 0.9, 4.0, 0.7, 0.2, 7.0}));
  EXPECT_EQ(
      resistance_of<ShaftFrictionSettings>("<shaft_friction stribeck_velocity_mm_per_s='6'/>").stribeck_velocity,
      6.0);
  EXPECT_TRUE(same_bits(
      resistance_of<EmbeddedNeedleSettings>(
          "<embedded_needle tip_radius_mm='0.5' point_spacing_mm='2' points_beyond_mm='10' capture_radius_mm='1' "
          "puncture_time_s='0.02' flexible='true' modulus_MPa='2e5' stylet='true' hold='pinned' "
          "cut_offset_mm='0.1' stiffness_scale='2' fix_bone='false' fix_cut='false' fix_beyond_mm='60'/>"),
      {0.5,
       2.0,
       10.0,
       1.0,
       0.02,
       EmbeddedNeedleSettings{}.most_nodes,
       {2.0, false, false, 60.0},
       {true, 2e5, true, NeedleHold::pinned, 0.1}}));
  EXPECT_TRUE(
      same_bits(resistance_of<ClosestNodeSettings>(
                    "<closest_node capture_radius_mm='3' presliding_N_per_mm='2' relaxation_s='0.1' layer_mm='1' "
                    "longest_mm='50' corridor_radius_mm='20' corridor_beyond_mm='10' corridor_nodes='500' "
                    "stiffness_scale='2' fix_bone='false' fix_cut='false' fix_beyond_mm='60'/>"),
                {3.0, 2.0, 0.1, 1.0, 50.0, {20.0, 10.0, 500.0}, {2.0, false, false, 60.0}}));
}

// The shaft met nodes of the mesh then, and the file said which.
TEST(HapticsXml, a_needle_of_an_earlier_version_arrives) {
  EmbeddedNeedleSettings expected;
  expected.tip_radius = 0.5;
  expected.points_beyond = 10.0;
  EXPECT_TRUE(
      same_bits(resistance_of<EmbeddedNeedleSettings>(
                    "<embedded_needle contact='nodes' tip_radius_mm='0.5' spacing_mm='0.8' corridor_radius_mm='20' "
                    "corridor_beyond_mm='10' corridor_nodes='500'/>"),
                expected));
  expected.points_beyond = 12.0;
  EXPECT_TRUE(same_bits(resistance_of<EmbeddedNeedleSettings>(
                            "<embedded_needle tip_radius_mm='0.5' corridor_beyond_mm='10' points_beyond_mm='12'/>"),
                        expected));
  EXPECT_THAT(refused_haptics("<resistance><embedded_needle contact='edges'/></resistance>"),
              HasSubstr("contact is 'edges', expected "));
  EXPECT_THAT(haptics_xml({.resistance = expected}), Not(AnyOf(HasSubstr("contact="), HasSubstr("corridor"))));
}

TEST(HapticsXml, a_surface_and_a_model_of_the_program_arrive) {
  EXPECT_TRUE(same_bits(resistance_of<SurfaceProxySettings>(
                            "<surface_proxy stiffness_N_per_mm='0.6' static_friction='0.5' dynamic_friction='0.4' "
                            "stick_after_s='0.1' viscosity_N_s_per_mm='0.01' limit_N='7'/>"),
                        {0.6, 0.5, 0.4, 0.1, 0.01, 7.0}));
  EXPECT_TRUE(same_bits(resistance_of<RegisteredSettings>("<registered name='constant_drag' force_N='0.7'/>"),
                        {"constant_drag", {{"force_N", "0.7"}}, {}}));
}

TEST(HapticsXml, every_setting_of_every_constraint_arrives) {
  EXPECT_TRUE(same_bits(constraint_of<LineSpringSettings>(
                            "<line_spring stiffness_N_per_mm='0.4' damping_N_s_per_mm='0.001' limit_N='2'/>"),
                        {0.4, 0.001, 2.0}));
  EXPECT_TRUE(same_bits(constraint_of<PivotSettings>("<pivot stiffness_N_per_mm='0.3' gain='2' limit_N='3' "
                                                     "shortest_outside_mm='30' largest_angle_rad='0.2'/>"),
                        {0.3, 2.0, 3.0, 30.0, 0.2}));
  EXPECT_TRUE(same_bits(constraint_of<RailSettings>("<rail stiffness_N_per_mm='0.6' limit_N='4' "
                                                    "torsion_N_mm_per_rad='900' full_depth_mm='50' "
                                                    "torque_limit_N_mm='100'/>"),
                        {0.6, 4.0, 900.0, 50.0, 100.0}));
  EXPECT_TRUE(same_bits(constraint_of<BeamSettings>("<beam modulus_MPa='2e5' stylet='true' "
                                                    "largest_stiffness_N_per_mm='0.8' limit_N='3' "
                                                    "smoothing_Hz='30'/>"),
                        {2e5, true, 0.8, 3.0, 30.0}));
  EXPECT_NO_THROW(constraint_of<NoConstraint>("<none/>"));
}

TEST(HapticsXml, every_part_arrives_in_any_order) {
  const ForceParts parts = haptics_of(
                               "<parts><needle_grasp one_way='2' two_way='1' point='1.18' turns_to_wind='3'/>"
                               "<relaxation share='0.3' time_s='0.1'/><shaft_friction "
                               "stribeck_velocity_mm_per_s='4'/><relaxation share='0.2' time_s='5'/></parts>")
                               .parts;
  EXPECT_TRUE(
      same_bits(parts, {{{0.3, 0.1}, {0.2, 5.0}}, ShaftFrictionSettings{4.0}, {{2.0, 1.0, 1.18, 3.0}}, {}, {}, {}}));
  EXPECT_TRUE(same_bits(haptics_of("<parts/>").parts, {}));
  const ForceParts more =
      haptics_of(
          "<parts><syringe filling='air' bore_mm='12' air_volume_mm3='3000' saline_compliance_mm3_per_MPa='50' "
          "viscosity_MPa_s='2e-11' friction_N='0.4' thumb_force_N='7'/><bevel_tip curvature_per_mm='0.003' "
          "stiffness_N_per_mm='0.2' limit_N='2'/><csf_flow opening_pressure_mm='200' viscosity_MPa_s='8e-10' "
          "manometer_bore_mm='2' manometer='false' stylet='true'/></parts>")
          .parts;
  EXPECT_TRUE(same_bits(*more.bevel_tip, {0.003, 0.2, 2.0}));
  const CsfFlowSettings flow;
  EXPECT_TRUE(same_bits(*more.csf_flow, {200.0, flow.needle_bore, flow.needle_length, 8e-10, 2.0, false, true}));
  const SyringeSettings syringe;
  EXPECT_TRUE(same_bits(*more.syringe, {SyringeFilling::air, 12.0, 3000.0, 50.0, syringe.needle_bore,
                                        syringe.needle_length, 2e-11, 0.4, 7.0}));
}

TEST(HapticsXml, compensation_takes_any_direction_and_keeps_a_unit_vector_as_it_is) {
  const GravitySettings given =
      haptics_of(
          "<compensation weight_N='0.45' up_x='0' up_y='-3' up_z='4' slope_x_N_per_mm='0.01' slope_y_N_per_mm='0.02' "
          "slope_z_N_per_mm='0.03' centre_x_mm='1' centre_y_mm='2' centre_z_mm='3' limit_N='4'/>")
          .compensation;
  EXPECT_TRUE(same_bits(given, {{0.0, -3.0 / 5.0, 4.0 / 5.0}, 0.45, {0.01, 0.02, 0.03}, {1.0, 2.0, 3.0}, 4.0}));
  EXPECT_TRUE(same_bits(haptics_of("<compensation/>").compensation, {}));
  // Dividing by a length that is 1 up to rounding would change the last bits repeatedly.
  const auto up = [](const std::string& y) {
    return haptics_of("<compensation up_x='0' up_y='" + y + "' up_z='0'/>").compensation.up.y();
  };
  EXPECT_EQ(up("0.9999999999999"), 0.9999999999999);
  EXPECT_EQ(up("0.99999999999"), 1.0);
  EXPECT_EQ(up("0.00001"), 1.0);
}

TEST(HapticsXml, any_settings_read_back_as_they_were_written_to_the_bit) {
  Random random(4);
  const XmlSchema schema("case.xsd");
  std::map<std::string_view, int> seen;
  for (int round = 0; round < 400; ++round) {
    const HapticSettings written = wild_haptics(random);
    ++seen[name_of(written.resistance)];
    ++seen[name_of(written.constraint)];
    const std::string document = haptics_xml(written);
    ASSERT_TRUE(same_bits(parse_haptics_xml(document, "h", schema), written)) << document;
  }
  EXPECT_EQ(seen.size(), resistance_names.size() + constraint_names.size());
}

// --- the schema and the settings ---------------------------------------------------------------------------------

struct Attribute {
  std::string name, fallback, type;
};

std::string given(const std::string& attribute, const std::string& value) {
  std::string text(1, ' ');
  return text.append(attribute).append("='").append(value).append("'");
}

// The optional attributes of a named type of the schema.
std::vector<Attribute> attributes_of(const std::string& schema, const std::string& type) {
  const auto begin = schema.find("<xs:complexType name=\"" + type + "\">");
  EXPECT_NE(begin, std::string::npos) << type;
  // Behind the children, whose attributes are not the model's own.
  const auto end = schema.find("\n  </xs:complexType>", begin);
  const std::string text = schema.substr(begin, end - begin);
  static const std::regex pattern("\n    <xs:attribute name=\"(\\w+)\" default=\"([^\"]*)\" type=\"([\\w:]+)\"/>");
  std::vector<Attribute> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), last; match != last; ++match)
    found.push_back({(*match)[1], (*match)[2], (*match)[3]});
  return found;
}

struct Role {
  std::string before, after;  // around the element in <haptics>
};

const std::map<std::string, Role>& roles() {
  static const std::map<std::string, Role> all = [] {
    std::map<std::string, Role> by_name;
    for (const std::string_view name : resistance_names)
      by_name[std::string(name)] = {"<resistance>", "</resistance>"};
    for (const std::string_view name : constraint_names)
      by_name[std::string(name)] = {"<constraint>", "</constraint>"};
    for (const char* name : {"relaxation", "needle_grasp", "bevel_tip", "csf_flow", "syringe", "fingertip"})
      by_name[name] = {"<parts>", "</parts>"};
    by_name["compensation"] = {"", ""};
    by_name.erase("none");
    by_name.erase("registered");  // the settings of its models are theirs
    return by_name;
  }();
  return all;
}

TEST(HapticsXml, the_defaults_that_the_schema_states_are_those_of_the_settings) {
  const std::string schema = read_text_file(shared_file("case.xsd"), 1 << 20);
  int checked = 0;
  for (const auto& [name, role] : roles()) {
    std::string all;
    for (const Attribute& attribute : attributes_of(schema, name)) {
      all += given(attribute.name, attribute.fallback);
      ++checked;
    }
    EXPECT_TRUE(same_bits(haptics_of(role.before + "<" + name + all + "/>" + role.after),
                          haptics_of(role.before + "<" + name + "/>" + role.after)))
        << name << all;
  }
  EXPECT_EQ(checked, 137);
}

TEST(HapticsXml, the_defaults_that_the_schema_states_for_friction_are_those_of_the_settings) {
  const std::string schema = read_text_file(shared_file("case.xsd"), 1 << 20);
  for (const char* direction : {"inwards", "outwards"}) {
    const auto begin = schema.find("<xs:element name=\"" + std::string(direction) + "\"");
    const std::string text = schema.substr(begin, schema.find("</xs:complexType>", begin) - begin);
    static const std::regex pattern("name=\"(\\w+)\" default=\"([^\"]*)\"");
    std::string all;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), last; match != last; ++match)
      all += given((*match)[1], (*match)[2]);
    EXPECT_THAT(all, HasSubstr("static_N_per_mm"));
    EXPECT_TRUE(same_bits(resistance_of<ThreeComponentSettings>("<three_component><" + std::string(direction) + all +
                                                                "/></three_component>"),
                          {}))
        << all;
  }
}

TEST(HapticsXml, every_setting_has_a_range_that_the_schema_guards) {
  const std::string schema = read_text_file(shared_file("case.xsd"), 1 << 20);
  for (const auto& [name, role] : roles()) {
    for (const Attribute& attribute : attributes_of(schema, name)) {
      for (const std::string wrong : {"NaN", "-INF", "INF", "1e300", "-1e300", "", "soft"}) {
        if (attribute.name == "catch_up_s" && (wrong == "INF" || wrong == "1e300")) continue;  // the wall holds
        const std::string sentence =
            refused_haptics(role.before + "<" + name + given(attribute.name, wrong) + "/>" + role.after);
        EXPECT_THAT(sentence,
                    HasSubstr("h, line 2: " + name + " " + attribute.name + " is '" + wrong + "', expected "));
      }
    }
  }
}

// --- what one value means for another, and what belongs where ----------------------------------------------------

TEST(HapticsXml, settings_that_do_not_go_together_are_refused) {
  const std::pair<const char*, const char*> faults[] = {
      // libxml2 names ten elements at most.
      {"<resistance/>",
       "<resistance> lacks <layered>, <spring_damper_wall>, <tracking_wall>, <depth_profile>, <volume_proxy>, "
       "<three_component>, <fracture>, <shaft_friction>, <embedded_needle> or "
       "<closest_node>"},
      {"<resistance><layered/><layered/></resistance>",
       "<resistance> has the element <layered> once more, expected it once at most"},
      {"<constraint><none stiffness_N_per_mm='1'/></constraint>",
       "<none> has the unknown attribute 'stiffness_N_per_mm'; it takes none"},
      {"<resistance><tracking_wall catch_up_s='0'/></resistance>",
       "tracking_wall catch_up_s is '0', expected a number of at least 0.001, or INF"},
      {"<resistance><tracking_wall><layer from_mm='1' force_N='1'/></tracking_wall></resistance>",
       "tracking_wall: from_mm of element 1 is 1, expected 0 for the first one"},
      {"<resistance><tracking_wall><layer from_mm='0' force_N='1'/><layer from_mm='0' force_N='1'/></tracking_wall>"
       "</resistance>",
       "tracking_wall: from_mm of element 2 is 0, expected more than the 0 of the one before"},
      {"<resistance><tracking_wall><layer from_mm='0'/></tracking_wall></resistance>",
       "<layer> lacks the attribute force_N, expected a number from 0 to 50"},
      {"<resistance><depth_profile trailing_mm='6'/></resistance>",
       "depth_profile: trailing_mm is 6 mm, expected at most the puncture_depth_mm of 5 mm"},
      {"<resistance><volume_proxy gradient_least_per_mm='0.2'/></resistance>",
       "volume_proxy: gradient_least_per_mm is 0.2 1/mm, expected at most the gradient_reference_per_mm of 0.1 1/mm"},
      {"<resistance><volume_proxy field_lowest_HU='1500'/></resistance>",
       "volume_proxy: field_lowest_HU is 1500 HU, expected at most the field_highest_HU of 1500 HU, less 1 HU"},
      {"<resistance><volume_proxy><transfer_point value='2'/><transfer_point value='1'/></volume_proxy></resistance>",
       "volume_proxy: value of element 2 is 1, expected more than the 2 of the one before"},
      {"<resistance><three_component cutting_force_N='0.9'/></resistance>",
       "three_component: cutting_force_N is 0.9 N, expected at most the puncture_force_N of 0.85 N"},
      {"<resistance><three_component linear_N_per_mm='0' quadratic_N_per_mm2='0'/></resistance>",
       "three_component: linear_N_per_mm and quadratic_N_per_mm2 are both 0, expected one of them above 0"},
      {"<resistance><surface_proxy static_friction='0.1'/></resistance>",
       "surface_proxy: dynamic_friction is 0.2, expected at most the static_friction of 0.1"},
      {"<resistance><registered force_N='1'/></resistance>",
       "<registered> lacks the attribute name, expected a name of lower-case letters, digits and "
       "underscores that begins with a letter, at most 64 long"},
      {"<parts><needle_grasp two_way='1.7'/></parts>",
       "parts, needle_grasp: two_way is 1.7, expected at most the one_way of 1.67"},
      {"<parts><shaft_friction/><shaft_friction/></parts>",
       "parts: the element shaft_friction is given 2 times, expected it once at most"},
      {"<parts><relaxation/><relaxation/><relaxation share='0.1'/></parts>",
       "parts: the shares of the elements relaxation add up to more than 1, expected at most 1"},
      {"<parts><relaxation share='0'/><relaxation share='0'/><relaxation share='0'/><relaxation share='0'/>"
       "<relaxation share='0'/></parts>",
       "parts: there are 5 elements relaxation, expected at most 4"},
      {"<parts><layered/></parts>",
       "the element <layered> is not allowed here, expected <relaxation>, <shaft_friction>, <needle_grasp>, "
       "<bevel_tip>, <csf_flow>, <syringe> or <fingertip>"},
      {"<compensation up_y='1'/>", "compensation: 1 of the 3 components of a vector are given, expected all or none"},
      {"<compensation up_x='0' up_y='0' up_z='-0'/>",
       "compensation up_x, up_y and up_z are 0, 0 and -0, expected a direction, which is longer than 1e-06"},
  };
  for (const auto& [inside, sentence] : faults)
    EXPECT_EQ(refused_haptics(inside), std::string("h, line 2: ") + sentence);
}

}  // namespace
}  // namespace bodkin
