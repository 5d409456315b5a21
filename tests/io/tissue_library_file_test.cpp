#include "io/tissue_library_file.h"

#include <array>
#include <set>

#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/label_scheme.h"
#include "io/resources.h"
#include "io/xml_document.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using ::testing::HasSubstr;

const std::string air =
    "<tissue id='0' name='air' title='air' colour='#101318' hounsfield_HU='-1000' hounsfield_noise_HU='0'>\n"  // 2
    "<layered><none/></layered><source>HU by definition.</source></tissue>\n";                                 // 3
const std::string gel =
    "<tissue id='32' name='gel' title='gelatine' colour='#A1b2C3' hounsfield_HU='20' hounsfield_noise_HU='5'>\n"  // 4
    "<layered>\n"                                                                                                 // 5
    "<viscoelastic stiffness_N_per_mm='0.05' viscosity_N_s_per_mm='0.001' element_spacing_mm='1' break_force_N='1' "
    "shaft_stiffness_N_per_mm2='0.02' shaft_spacing_mm='0.5' static_friction_N_per_mm='0.024' "
    "dynamic_friction_N_per_mm='0.02'/>\n"            // 6
    "</layered>\n"                                    // 7
    "<source>measured\n   here</source></tissue>\n";  // 8
// The other models' elements, one per line: lines 8 to 12 of a library with them.
const std::string others =
    "<tracking_wall stiffness_N_per_mm='0.6' force_N='1.1'/>\n"
    "<depth_profile kind='soft' stiffness_N_per_mm='0.7' slope_N_per_mm2='-0.01'/>\n"
    "<volume_proxy penetrability_N='1.2' friction_N='0.4' drag_N='0.3' viscosity_N_s_per_mm='0.02' "
    "field_value='-0.5'/>\n"
    "<shaft_friction coulomb_N_per_mm='0.013' static_N_per_mm='0.014' stiffness_N_per_mm2='0.06' "
    "viscous_N_s_per_mm2='0.0003'/>\n"
    "<syringe resistance_MPa_s_per_mm3='0.5' pressure_MPa='0.001'/>\n";
const std::string library = "<tissue_library version='1'>\n" + air + gel + "</tissue_library>\n";

TissueLibrary parse(const std::string& document) {
  return parse_tissue_library(document, "tissues.xml", XmlSchema("tissues.xsd"));
}

std::string refused_library(const std::string& from, const std::string& to) {
  return refusal([&] { parse(replaced(library, from, to)); });
}

std::string with_others() {
  return replaced(library, "<source>measured", others + "<source>measured");
}

std::string others_refused(const std::string& from, const std::string& to) {
  return refusal([&] { parse(replaced(with_others(), from, to)); });
}

TEST(TissueLibraryFile, every_value_arrives) {
  const TissueLibrary read = parse(library);
  ASSERT_EQ(read.tissues().size(), 2U);
  const TissueProperties& entry = *read.find(TissueId{32});
  EXPECT_EQ(entry.name, "gel");
  EXPECT_EQ(entry.title, "gelatine");
  EXPECT_EQ(entry.colour, 0xA1B2C3U);
  EXPECT_EQ(entry.hounsfield, 20.0);
  EXPECT_EQ(entry.hounsfield_noise, 5.0);
  EXPECT_EQ(entry.source, "measured here");
  EXPECT_EQ(entry.layered.kind, LayeredKind::viscoelastic);
  EXPECT_EQ(entry.layered.stiffness, 0.05);
  EXPECT_EQ(entry.layered.viscosity, 0.001);
  EXPECT_EQ(entry.layered.break_force, 1.0);
  EXPECT_EQ(entry.layered.break_force_rate, 0.0);
  EXPECT_EQ(entry.layered.shaft_stiffness, 0.02);
  EXPECT_EQ(entry.layered.shaft_spacing, 0.5);
  EXPECT_EQ(entry.layered.static_friction, 0.024);
  EXPECT_EQ(entry.layered.dynamic_friction, 0.02);
  EXPECT_EQ(entry.layered.roughness, 0.0);
  EXPECT_EQ(
      parse(replaced(library, "<none/>", "<viscous drag_N_s_per_mm2='0.0004'/>")).find(tissue::air)->layered.drag,
      0.0004);
  EXPECT_EQ(parse(replaced(library, "<none/>", "<rigid contact_stiffness_N_per_mm='3.16'/>"))
                .find(tissue::air)
                ->layered.contact_stiffness,
            3.16);
}

TEST(TissueLibraryFile, every_value_of_the_other_models_arrives) {
  const TissueLibrary read = parse(with_others());
  const TissueProperties& entry = *read.find(TissueId{32});
  EXPECT_EQ(entry.tracking_wall.stiffness, 0.6);
  EXPECT_EQ(entry.tracking_wall.force, 1.1);
  EXPECT_EQ(entry.depth_profile.kind, DepthProfileKind::soft);
  EXPECT_EQ(entry.depth_profile.stiffness, 0.7);
  EXPECT_EQ(entry.depth_profile.slope, -0.01);
  EXPECT_EQ(entry.volume_proxy.properties.penetrability, 1.2);
  EXPECT_EQ(entry.volume_proxy.properties.friction, 0.4);
  EXPECT_EQ(entry.volume_proxy.properties.drag, 0.3);
  EXPECT_EQ(entry.volume_proxy.properties.viscosity, 0.02);
  EXPECT_EQ(entry.volume_proxy.field_value, -0.5);
  EXPECT_EQ(entry.shaft_friction.coulomb, 0.013);
  EXPECT_EQ(entry.shaft_friction.static_force, 0.014);
  EXPECT_EQ(entry.shaft_friction.stiffness, 0.06);
  EXPECT_EQ(entry.shaft_friction.viscous, 0.0003);
  EXPECT_EQ(entry.syringe.resistance, 0.5);
  EXPECT_EQ(entry.syringe.pressure, 0.001);
  const std::pair<const char*, DepthProfileKind> kinds[] = {
      {"nothing", DepthProfileKind::nothing}, {"bone", DepthProfileKind::bone}, {"organ", DepthProfileKind::organ}};
  for (const auto& [name, kind] : kinds) {
    const std::string other = "kind='" + std::string(name) + "'";
    EXPECT_EQ(parse(replaced(with_others(), "kind='soft'", other)).find(TissueId{32})->depth_profile.kind, kind);
  }
}

TEST(TissueLibraryFile, a_tissue_that_says_nothing_to_a_model_resists_with_nothing_there) {
  const TissueProperties neutral;
  const TissueLibrary silent = parse(library);
  // The same with optional attributes omitted.
  const TissueLibrary brief = parse(
      replaced(library, "<source>measured",
               "<syringe resistance_MPa_s_per_mm3='0.05'/><depth_profile kind='nothing'/><tracking_wall "
               "stiffness_N_per_mm='0.5' force_N='0'/><shaft_friction coulomb_N_per_mm='0' static_N_per_mm='0'/>"
               "<volume_proxy penetrability_N='0' friction_N='0' field_value='0'/><source>measured"));
  for (const TissueLibrary* read : {&silent, &brief}) {
    const TissueProperties& entry = *read->find(TissueId{32});
    EXPECT_EQ(entry.tracking_wall.stiffness, neutral.tracking_wall.stiffness);
    EXPECT_EQ(entry.tracking_wall.force, 0.0);
    EXPECT_EQ(entry.depth_profile.kind, DepthProfileKind::nothing);
    EXPECT_EQ(entry.depth_profile.stiffness, neutral.depth_profile.stiffness);
    EXPECT_EQ(entry.depth_profile.slope, 0.0);
    EXPECT_EQ(entry.volume_proxy.properties.penetrability, 0.0);
    EXPECT_EQ(entry.volume_proxy.properties.friction, 0.0);
    EXPECT_EQ(entry.volume_proxy.properties.drag, 0.0);
    EXPECT_EQ(entry.volume_proxy.properties.viscosity, 0.0);
    EXPECT_EQ(entry.volume_proxy.field_value, 0.0);
    EXPECT_EQ(entry.shaft_friction.coulomb, 0.0);
    EXPECT_EQ(entry.shaft_friction.static_force, 0.0);
    EXPECT_EQ(entry.shaft_friction.stiffness, neutral.shaft_friction.stiffness);
    EXPECT_EQ(entry.shaft_friction.viscous, 0.0);
    EXPECT_EQ(entry.syringe.resistance, neutral.syringe.resistance);
    EXPECT_EQ(entry.syringe.pressure, 0.0);
  }
}

TEST(TissueLibraryFile, faults_of_the_other_models_are_refused_with_line_field_found_and_expected) {
  const std::array<std::array<const char*, 3>, 17> faults = {{
      {"stiffness_N_per_mm='0.6'", "stiffness_N_per_mm='0.009'",
       "8: tracking_wall stiffness_N_per_mm is '0.009', expected a number from 0.01 to 100"},
      {"force_N='1.1'", "force_N='51'", "8: tracking_wall force_N is '51', expected a number from 0 to 50"},
      {" force_N='1.1'", "", "8: <tracking_wall> lacks the attribute force_N, expected a number from 0 to 50"},
      {"kind='soft'", "kind='fluid'", "9: depth_profile kind is 'fluid', expected nothing, soft, bone or organ"},
      {"stiffness_N_per_mm='0.7'", "stiffness_N_per_mm='10.1'",
       "9: depth_profile stiffness_N_per_mm is '10.1', expected a number from 0 to 10"},
      {"'-0.01'", "'-1.01'", "9: depth_profile slope_N_per_mm2 is '-1.01', expected a number from -1 to 1"},
      {"penetrability_N='1.2'", "penetrability_N='-1'",
       "10: volume_proxy penetrability_N is '-1', expected a number from 0 to 50"},
      {"friction_N='0.4'", "friction_N='NaN'",
       "10: volume_proxy friction_N is 'NaN', expected a number from 0 to 50"},
      {"drag_N='0.3'", "drag_N='51'", "10: volume_proxy drag_N is '51', expected a number from 0 to 50"},
      {"viscosity_N_s_per_mm='0.02'", "viscosity_N_s_per_mm='11'",
       "10: volume_proxy viscosity_N_s_per_mm is '11', expected a number from 0 to 10"},
      {"field_value='-0.5'", "field_value='-11'",
       "10: volume_proxy field_value is '-11', expected a number from -10 to 10"},
      {"static_N_per_mm='0.014'", "static_N_per_mm='0.012'",
       "11: shaft_friction: coulomb_N_per_mm is 0.013 N/mm, expected at most the static_N_per_mm of 0.012 N/mm"},
      {"coulomb_N_per_mm='0.013'", "coulomb_N_per_mm='11'",
       "11: shaft_friction coulomb_N_per_mm is '11', expected a number from 0 to 10"},
      {"stiffness_N_per_mm2='0.06'", "stiffness_N_per_mm2='0'",
       "11: shaft_friction stiffness_N_per_mm2 is '0', expected a number from 0.000001 to 100"},
      {"viscous_N_s_per_mm2='0.0003'", "viscous_N_s_per_mm2='1.1'",
       "11: shaft_friction viscous_N_s_per_mm2 is '1.1', expected a number from 0 to 1"},
      {"resistance_MPa_s_per_mm3='0.5'", "resistance_MPa_s_per_mm3='1e7'",
       "12: syringe resistance_MPa_s_per_mm3 is '1e7', expected a number from 0 to 1000000"},
      {"pressure_MPa='0.001'", "pressure_MPa='0.06'",
       "12: syringe pressure_MPa is '0.06', expected a number from -0.01 to 0.05"},
  }};
  for (const auto& [from, to, sentence] : faults)
    EXPECT_EQ(others_refused(from, to), std::string("tissues.xml, line ") + sentence);
  EXPECT_EQ(others_refused("<syringe", "<tracking_wall stiffness_N_per_mm='1' force_N='1'/><syringe"),
            "tissues.xml, line 12: the element <tracking_wall> is not allowed here, expected <syringe>, "
            "<deformable>, <acoustic>, <physical> or <source>");
}

TEST(TissueLibraryFile, fibres_of_a_deformable_body_arrive) {
  const auto deformable = [](const std::string& more) {
    const std::string element =
        "<deformable young_MPa='0.17' friction_N_per_mm='0.2' puncture_force_N='4.7'" + more + "/>";
    return parse(replaced(library, "<source>measured", element + "<source>measured")).find(TissueId{32})->deformable;
  };
  const DeformableTissue whole = deformable(" fibres='superior' young_along_MPa='15' shear_along_MPa='0.4'");
  EXPECT_EQ(whole.fibres, FibreAxis::superior);
  EXPECT_EQ(whole.young_along, 15.0);
  EXPECT_EQ(whole.shear_along, 0.4);
  EXPECT_EQ(deformable("").fibres, FibreAxis::none);
  EXPECT_THAT(refusal([&] { deformable(" fibres='upwards'"); }), HasSubstr("upwards"));
}

TEST(TissueLibraryFile, what_a_tissue_is_to_sound_arrives) {
  const auto acoustic = [](const std::string& element) {
    return parse(replaced(library, "<source>measured", element + "<source>measured")).find(TissueId{32})->acoustic;
  };
  const AcousticTissue whole = acoustic(
      "<acoustic impedance_MRayl='1.7' attenuation_dB_per_cm_MHz='0.9' attenuation_power='1.1' echo_dB='-40' "
      "scatterer_density='0.25' fibre_variation_dB='6'/>");
  EXPECT_EQ(whole.impedance, 1.7);
  EXPECT_EQ(whole.attenuation, 0.9);
  EXPECT_EQ(whole.power, 1.1);
  EXPECT_EQ(whole.echo, -40.0);
  EXPECT_EQ(whole.density, 0.25);
  EXPECT_EQ(whole.variation, 6.0);
  const AcousticTissue neutral;
  const AcousticTissue brief =
      acoustic("<acoustic impedance_MRayl='0' attenuation_dB_per_cm_MHz='0' echo_dB='-200'/>");
  EXPECT_EQ(brief.impedance, 0.0);
  EXPECT_EQ(brief.power, neutral.power);
  EXPECT_EQ(brief.density, neutral.density);
  EXPECT_EQ(brief.variation, neutral.variation);
  const AcousticTissue silent = acoustic("");
  EXPECT_EQ(silent.impedance, 0.0) << "that of its HU";
  EXPECT_EQ(silent.attenuation, neutral.attenuation);
  EXPECT_EQ(silent.echo, neutral.echo);
}

TEST(TissueLibraryFile, faults_of_sound_are_refused_with_line_field_found_and_expected) {
  const std::string whole =
      "<acoustic impedance_MRayl='1.7' attenuation_dB_per_cm_MHz='0.9' attenuation_power='1.1' echo_dB='-40' "
      "scatterer_density='0.25' fibre_variation_dB='6'/>\n";
  const std::string sounding = replaced(library, "<source>measured", whole + "<source>measured");
  const std::array<std::array<const char*, 3>, 6> faults = {{
      {"'1.7'", "'101'", "impedance_MRayl is '101', expected a number from 0 to 100"},
      {"'0.9'", "'-1'", "attenuation_dB_per_cm_MHz is '-1', expected a number from 0 to 100"},
      {"'1.1'", "'2.1'", "attenuation_power is '2.1', expected a number from 0.5 to 2"},
      {"'-40'", "'1'", "echo_dB is '1', expected a number from -200 to 0"},
      {"'0.25'", "'NaN'", "scatterer_density is 'NaN', expected a number from 0 to 1"},
      {"'6'", "'21'", "fibre_variation_dB is '21', expected a number from 0 to 20"},
  }};
  for (const auto& [from, to, sentence] : faults) {
    EXPECT_EQ(refusal([&, from = from, to = to] { parse(replaced(sounding, from, to)); }),
              std::string("tissues.xml, line 8: acoustic ") + sentence);
  }
  EXPECT_EQ(
      refusal([&] { parse(replaced(sounding, "'1.7'", "'0.00005'")); }),
      "tissues.xml, line 8: acoustic: impedance_MRayl is above 0 and below 0.0001, expected 0.0001 to 100 MRayl, or "
      "0 to take it from the HU");
}

TEST(TissueLibraryFile, the_library_sounds_as_a_sonographer_knows_it) {
  const TissueLibrary read = default_tissue_library();
  const auto of = [&read](TissueId id) -> const AcousticTissue& { return read.find(id)->acoustic; };
  for (const TissueProperties& entry : read.tissues()) EXPECT_GT(entry.acoustic.impedance, 0.0) << entry.name;
  EXPECT_EQ(of(tissue::cortical_bone).impedance, 7.8) << "segmented bone has an impedance of its own";
  EXPECT_EQ(of(tissue::fat).impedance, 1.38);
  for (const TissueId airy : {tissue::air, tissue::lung, tissue::gas}) EXPECT_EQ(of(airy).impedance, 0.0004);
  for (const TissueId solid :
       {tissue::cortical_bone, tissue::cancellous_bone, tissue::metal, tissue::lung, tissue::gas})
    EXPECT_LE(of(solid).echo, -150.0) << read.title(solid) << ": a clean shadow";
  for (const TissueId clear : {tissue::cerebrospinal_fluid, tissue::vessel})
    EXPECT_LE(of(clear).echo, -90.0) << read.title(clear) << ": black";
  for (const TissueId grey :
       {tissue::skin, tissue::fat, tissue::muscle, tissue::soft, tissue::disc, tissue::interspinous_ligament,
        tissue::ligamentum_flavum, tissue::dura, tissue::organ}) {
    EXPECT_GE(of(grey).echo, -46.0) << read.title(grey);
    EXPECT_LE(of(grey).echo, -30.0) << read.title(grey);
  }
  EXPECT_LT(of(tissue::fat).echo, of(tissue::muscle).echo) << "fat under the skin is dark";
  EXPECT_GT(of(tissue::epidural_fat).echo, of(tissue::muscle).echo) << "epidural fat is bright";
  EXPECT_GT(of(tissue::dura).echo, of(tissue::epidural_fat).echo);
  EXPECT_LT(of(tissue::mass).echo, of(tissue::organ).echo) << "a lesion shows";
  EXPECT_GT(of(tissue::muscle).variation, 3.0) << "fibres";
  EXPECT_EQ(of(tissue::cerebrospinal_fluid).power, 2.0) << "as water";
}

TEST(TissueLibraryFile, faults_are_refused_with_line_field_found_and_expected) {
  EXPECT_EQ(refused_library("id='32'", "id='255'"),
            "tissues.xml, line 4: tissue id is '255', expected a whole number from 0 to 254");
  EXPECT_EQ(refused_library("id='32'", "id='0'"), "tissues.xml, line 4: tissue id is 0, which line 2 uses already");
  EXPECT_EQ(refused_library("name='gel'", "name='air'"),
            "tissues.xml, line 4: tissue name is 'air', which line 2 uses already");
  EXPECT_EQ(refused_library("id='0'", "id='1'"),
            "tissues.xml, line 1: there is no tissue with id 0, expected one for air");
  EXPECT_EQ(refused_library("#A1b2C3", "red"),
            "tissues.xml, line 4: tissue colour is 'red', expected a colour such as #F4EBD0");
  EXPECT_EQ(refused_library("hounsfield_HU='20'", "hounsfield_HU='NaN'"),
            "tissues.xml, line 4: tissue hounsfield_HU is 'NaN', expected a number from -1024 to 30000");
  EXPECT_EQ(refused_library("stiffness_N_per_mm='0.05'", "stiffness_N_per_mm='0'"),
            "tissues.xml, line 6: viscoelastic stiffness_N_per_mm is '0', expected a number above 0 and at most 100");
  EXPECT_EQ(refused_library("break_force_N='1' ", ""),
            "tissues.xml, line 6: <viscoelastic> lacks the attribute break_force_N, expected a number above 0 and at "
            "most 100");
  EXPECT_EQ(refused_library("'0.024'", "'0.019'"),
            "tissues.xml, line 6: viscoelastic: dynamic_friction_N_per_mm is 0.02 N/mm, expected at most the "
            "static_friction_N_per_mm of 0.019 N/mm");
  EXPECT_EQ(refused_library("'0.02'/>", "'0.02' roughness='1'/>"),
            "tissues.xml, line 6: viscoelastic roughness is '1', expected a number of at least 0 and below 1");
  EXPECT_EQ(refused_library("<none/>", "<elastic/>"),
            "tissues.xml, line 3: the element <elastic> is not allowed here, expected <none>, <viscoelastic>, "
            "<viscous> or <rigid>");
  EXPECT_EQ(refused_library("<source>measured\n   here</source>", ""),
            "tissues.xml, line 4: <tissue> lacks <source>");
}

TEST(TissueLibraryFile, the_library_that_comes_with_bodkin_has_every_tissue_of_the_engine_under_its_name) {
  const TissueLibrary read = default_tissue_library();
  ASSERT_EQ(read.tissues().size(), static_cast<std::size_t>(tissue::count));
  const std::pair<TissueId, const char*> names[] = {{tissue::air, "air"},
                                                    {tissue::skin, "skin"},
                                                    {tissue::fat, "fat"},
                                                    {tissue::muscle, "muscle"},
                                                    {tissue::soft, "soft"},
                                                    {tissue::cortical_bone, "cortical_bone"},
                                                    {tissue::cancellous_bone, "cancellous_bone"},
                                                    {tissue::disc, "disc"},
                                                    {tissue::supraspinous_ligament, "supraspinous_ligament"},
                                                    {tissue::interspinous_ligament, "interspinous_ligament"},
                                                    {tissue::ligamentum_flavum, "ligamentum_flavum"},
                                                    {tissue::epidural_fat, "epidural_fat"},
                                                    {tissue::dura, "dura"},
                                                    {tissue::cerebrospinal_fluid, "cerebrospinal_fluid"},
                                                    {tissue::nerve, "nerve"},
                                                    {tissue::vessel, "vessel"},
                                                    {tissue::organ, "organ"},
                                                    {tissue::lung, "lung"},
                                                    {tissue::gas, "gas"},
                                                    {tissue::metal, "metal"},
                                                    {tissue::mass, "mass"},
                                                    {tissue::cartilage, "cartilage"},
                                                    {tissue::spinal_cord, "spinal_cord"}};
  std::set<std::uint32_t> colours;
  for (const auto& [id, name] : names) {
    const TissueProperties* entry = read.find(name);
    ASSERT_NE(entry, nullptr) << name;
    EXPECT_EQ(entry->id, id) << name;
    EXPECT_GT(entry->source.size(), 10U) << name << " says where its numbers come from";
    colours.insert(entry->colour);
  }
  EXPECT_EQ(colours.size(), static_cast<std::size_t>(tissue::count)) << "no two tissues share a colour";
  for (const TissueId soundless : {tissue::air, tissue::gas, tissue::cerebrospinal_fluid}) {
    EXPECT_EQ(read.find(soundless)->layered.kind, LayeredKind::none);
  }
  for (const TissueId hard : {tissue::cortical_bone, tissue::cancellous_bone})
    EXPECT_EQ(read.find(hard)->layered.kind, LayeredKind::rigid);
  for (const TissueId oily : {tissue::fat, tissue::epidural_fat})
    EXPECT_EQ(read.find(oily)->layered.kind, LayeredKind::viscous);
}

TEST(TissueLibraryFile, the_other_models_of_the_library_hold_their_published_values) {
  const TissueLibrary read = default_tissue_library();
  const auto& of = [&read](TissueId id) -> const TissueProperties& { return *read.find(id); };
  EXPECT_EQ(of(tissue::muscle).tracking_wall.force, 1.0) << "Alamilla 2018";
  EXPECT_EQ(of(tissue::muscle).tracking_wall.stiffness, 0.5) << "Alamilla 2018";
  EXPECT_EQ(of(tissue::ligamentum_flavum).tracking_wall.force, 4.7) << "Sutherland 2013";
  EXPECT_EQ(of(tissue::ligamentum_flavum).volume_proxy.properties.penetrability, 4.7) << "Sutherland 2013";
  EXPECT_GE(of(tissue::organ).shaft_friction.coulomb, 0.0106) << "Okamura 2004";
  EXPECT_LE(of(tissue::organ).shaft_friction.coulomb, 0.0120) << "Okamura 2004";
  EXPECT_NEAR(of(tissue::organ).shaft_friction.viscous, 0.00021, 2e-5) << "Okamura 2004";
  const double mmHg = 133.322e-6;  // MPa
  EXPECT_GE(of(tissue::epidural_fat).syringe.pressure, -0.3 * mmHg);
  EXPECT_LE(of(tissue::epidural_fat).syringe.pressure, 10.0 * mmHg);
  EXPECT_NEAR(of(tissue::cerebrospinal_fluid).syringe.pressure, 0.145 * 1004.6 * 9.80665e-6, 5e-5) << "Gilland 1974";
}

TEST(TissueLibraryFile, the_models_agree_about_which_tissue_is_hard_and_which_is_not_there) {
  const TissueLibrary read = default_tissue_library();
  for (const TissueProperties& entry : read.tissues()) {
    const bool empty = entry.layered.kind == LayeredKind::none, hard = entry.layered.kind == LayeredKind::rigid;
    EXPECT_EQ(entry.depth_profile.kind == DepthProfileKind::nothing, empty) << entry.name;
    EXPECT_EQ(entry.tracking_wall.force == 0.0, empty) << entry.name;
    EXPECT_EQ(entry.volume_proxy.properties.penetrability == 0.0, empty) << entry.name;
    EXPECT_EQ(entry.shaft_friction.coulomb == 0.0, empty) << entry.name;
    EXPECT_EQ(entry.syringe.resistance == 0.0, empty) << entry.name;
    EXPECT_EQ(entry.depth_profile.kind == DepthProfileKind::bone, hard) << entry.name;
    EXPECT_EQ(entry.tracking_wall.force >= 6.0, hard) << entry.name;
    EXPECT_EQ(entry.volume_proxy.properties.penetrability >= 8.0, hard) << entry.name;
    EXPECT_EQ(entry.volume_proxy.field_value >= 0.9, hard) << entry.name;
  }
}

TEST(TissueLibraryFile, hounsfield_values_of_the_library_lie_in_the_published_ranges) {
  const TissueLibrary read = default_tissue_library();
  const auto expect_between = [&read](TissueId id, double low, double high) {
    EXPECT_GE(read.find(id)->hounsfield, low) << read.title(id);
    EXPECT_LE(read.find(id)->hounsfield, high) << read.title(id);
  };
  expect_between(tissue::air, -1000, -1000);
  expect_between(tissue::lung, -910, -850);
  expect_between(tissue::fat, -120, -50);
  expect_between(tissue::muscle, 10, 80);
  expect_between(tissue::cerebrospinal_fluid, 0, 15);
  expect_between(tissue::organ, 20, 65);
  expect_between(tissue::vessel, 45, 65);
  expect_between(tissue::cortical_bone, 400, 1000);
}

TEST(TissueLibraryFile, the_words_of_label_schemes_are_not_tissues) {
  for (const char* word : {"", "bone", "spinal_canal"}) {
    EXPECT_TRUE(is_resolved_by_construction(word));
    EXPECT_EQ(default_tissue_library().find(word), nullptr);
  }
}

TEST(TissueLibraryFile, the_documents_validate_for_xmllint_too) {
  if (std::system("command -v xmllint >/dev/null") != 0)
    GTEST_SKIP() << "xmllint is not installed (Debian package libxml2-utils)";
  const std::string command = "xmllint --noout --schema '" + shared_file("tissues.xsd").string() + "' '" +
                              shared_file("tissues.xml").string() + "' 2>/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(TissueLibraryFile, a_library_that_is_written_reads_back_to_the_same_bits) {
  const anatomy::TissueLibrary original = default_tissue_library();
  const std::string xml = tissue_library_xml(original);
  const anatomy::TissueLibrary read = parse_tissue_library(xml, "written.xml", XmlSchema("tissues.xsd"));
  ASSERT_EQ(read.tissues().size(), original.tissues().size());
  for (std::size_t i = 0; i < read.tissues().size(); ++i)
    EXPECT_TRUE(same_parameters(read.tissues()[i], original.tissues()[i])) << original.tissues()[i].name;
  EXPECT_EQ(tissue_library_xml(read), xml);
}

}  // namespace
}  // namespace bodkin
