// Valid and invalid contents of case.xml, and the messages of refusal.
#include "io/case_xml.h"

#include "tests/io/case_documents.h"
#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Lt;
using ::testing::SizeIs;

// The sentence with which the largest case is refused when `from` in it becomes `to`.
std::string refused(const std::string& from, const std::string& to) {
  return refusal([&] { parse(replaced(largest, from, to)); });
}

TEST(CaseXml, every_value_arrives) {
  const CaseDescription d = parse(largest);
  EXPECT_EQ(d.name, "large");
  EXPECT_EQ(d.created_by, "a person");
  EXPECT_EQ(d.ct_digest, "0123456789abcdef0123456789abcdef");
  EXPECT_EQ(d.structures_file, "labels/s.nrrd");
  ASSERT_EQ(d.structures.size(), 2U);
  EXPECT_EQ(d.structures[1].label, 2);
  EXPECT_EQ(d.structures[1].tissue, "organ");
  EXPECT_TRUE(d.structures[1].critical);
  EXPECT_FALSE(d.structures[0].critical);
  EXPECT_EQ(d.needle.outer_diameter, 0.7);
  EXPECT_EQ(d.needle.tip, NeedleTip::whitacre);
  EXPECT_EQ(d.device.peak_force, 3.3);
  EXPECT_EQ(d.device.peak_torque, 0.0);
  EXPECT_EQ(d.haptics.rate, 2000.0);
  EXPECT_EQ(std::get<LayeredSettings>(d.haptics.resistance).law, LayeredLaw::sum);
  EXPECT_TRUE(std::get<LayeredSettings>(d.haptics.resistance).strict);
  EXPECT_EQ(std::get<LineSpringSettings>(d.haptics.constraint).limit, 2.0);
  EXPECT_EQ(d.haptics.compensation.weight, 0.45);
  EXPECT_EQ(d.haptics.compensation.up, Vec3::UnitZ());
  ASSERT_EQ(d.landmarks.size(), 2U);
  EXPECT_EQ(d.landmarks[1].position, Vec3(1.0, 2.0, -30.0));
  EXPECT_EQ(d.procedure.target_tissue, "dura");
  EXPECT_EQ(d.procedure.path->target, Vec3(3.0, -117.5, 294.0));
  EXPECT_EQ(d.notes, std::vector<std::string>{"one"});
  EXPECT_FALSE(d.breathing.has_value());
  const CaseDescription breathes = parse(replaced(
      largest, "  <notes>", "  <breathing x_mm='1' y_mm='-2' z_mm='300' rate_per_min='12' pause='3'/><notes>"));
  ASSERT_TRUE(breathes.breathing.has_value());
  EXPECT_EQ(breathes.breathing->centre, Vec3(1.0, -2.0, 300.0));
  EXPECT_EQ(breathes.breathing->rate, 12.0);
  EXPECT_EQ(breathes.breathing->pause, 3);
  EXPECT_EQ(breathes.breathing->motion, Breathing().motion);
}

TEST(CaseXml, a_gauge_alone_brings_its_nominal_diameters) {
  const Needle needle = parse(replaced(smallest, "gauge='22'", "gauge='18'")).needle;
  EXPECT_EQ(needle.outer_diameter, 1.27);
  EXPECT_EQ(needle.inner_diameter, 0.838);
}

TEST(CaseXml, elements_may_come_in_any_order) {
  const std::string needle = "  <needle gauge='22'/>\n";
  const std::string reordered = replaced(replaced(smallest, needle, ""), "  <volumes>\n", needle + "  <volumes>\n");
  EXPECT_EQ(parse(reordered).needle.gauge, 22);
}

struct Refusal {
  const char* name;
  const char* from;
  const char* to;
  const char* sentence;
};

class CaseXmlRefusal : public ::testing::TestWithParam<Refusal> {};

TEST_P(CaseXmlRefusal, names_line_field_what_was_found_and_what_was_expected) {
  const Refusal& r = GetParam();
  EXPECT_EQ(refused(r.from, r.to), std::string("case.xml, ") + r.sentence);
}

constexpr Refusal refusals[] = {
    // structure
    {"unknown_element", "  <landmarks>", "  <landmark_list/><landmarks>",
     "line 17: <case> has the unknown element <landmark_list>; it takes <description>, <volumes>, <tissue_library>, "
     "<needle>, <device>, <haptics>, <landmarks>, <procedure>, <breathing> and <notes>"},
    {"breathing_without_centre", "  <notes>", "  <breathing x_mm='1' y_mm='2'/><notes>",
     "line 25: <breathing> lacks the attribute z_mm, expected a number from -100000 to 100000"},
    {"breathing_too_far", "  <notes>", "  <breathing x_mm='1' y_mm='2' z_mm='3' feet_head_mm='-40'/><notes>",
     "line 25: breathing: motion is longer than a third of radius_mm, expected less, so that tissue does not fold; "
     "make "
     "radius_mm larger"},
    {"element_twice", "  <notes>", "  <needle gauge='22'/><notes>",
     "line 25: <case> has the element <needle> once more, expected it once at most"},
    {"missing_volumes", "<tissues file='tissues.nrrd'/>", "", "line 2: <volumes> lacks <tissues>"},
    {"unknown_attribute", "limit_N", "limit",
     "line 14: <line_spring> has the unknown attribute 'limit'; it takes damping_N_s_per_mm, limit_N and "
     "stiffness_N_per_mm"},
    {"missing_attribute", "label='28' ", "",
     "line 5: <structure> lacks the attribute label, expected a whole number from 1 to 65535"},
    {"text_where_none_may_be", "  <landmarks>", "  <landmarks>stray words",
     "line 17: <landmarks> has text inside ('stray words'), expected elements only"},
    {"text_in_an_empty_element", "<entry x_mm='4.5' y_mm='-45' z_mm='293'/>",
     "<entry x_mm='4.5' y_mm='-45' z_mm='293'>here</entry>",
     "line 22: <entry> must be empty, but has something inside"},
    {"entry_without_target", "<target x_mm='3' y_mm='-117.5' z_mm='294'/>", "",
     "line 21: <procedure> lacks <target>"},
    {"wrong_version", "version='1'", "version='2'", "line 1: case version is '2', expected '1'"},
    {"another_document", "<case ", "<patient ",
     "line 26: the XML is broken: Opening and ending tag mismatch: patient line 1 and case"},
    // values
    {"not_a_number", "length_mm='90'", "length_mm='long'",
     "line 10: needle length_mm is 'long', expected a number from 1 to 1000"},
    {"nan", "length_mm='90'", "length_mm='NaN'",
     "line 10: needle length_mm is 'NaN', expected a number from 1 to 1000"},
    {"infinite", "limit_N='2'", "limit_N='INF'",
     "line 14: line_spring limit_N is 'INF', expected a number above 0 and at most 100"},
    {"minus_infinite", "z_mm='293'", "z_mm='-INF'",
     "line 22: entry z_mm is '-INF', expected a number from -100000 to 100000"},
    {"too_large_for_a_double", "z_mm='293'", "z_mm='1e999'",
     "line 22: entry z_mm is '1e999', expected a number from -100000 to 100000"},
    {"decimal_comma", "x_mm='4.5'", "x_mm='4,5'",
     "line 22: entry x_mm is '4,5', expected a number from -100000 to 100000"},
    {"empty_number", "x_mm='4.5'", "x_mm=''", "line 22: entry x_mm is '', expected a number from -100000 to 100000"},
    {"hexadecimal", "x_mm='4.5'", "x_mm='0x10'",
     "line 22: entry x_mm is '0x10', expected a number from -100000 to 100000"},
    {"rate_too_low", "rate_Hz='2000'", "rate_Hz='199.9'",
     "line 12: haptics rate_Hz is '199.9', expected a number from 200 to 4000"},
    {"layer_too_thick", "layer_mm='1'", "layer_mm='3'",
     "line 13: layered layer_mm is '3', expected a number from 0.1 to 2"},
    {"negative_damping", "'0.001'", "'-0.001'",
     "line 14: line_spring damping_N_s_per_mm is '-0.001', expected a number from 0 to 1"},
    {"zero_force", "peak_force_N='3.3'", "peak_force_N='0'",
     "line 11: device peak_force_N is '0', expected a number above 0 and at most 100"},
    {"label_zero", "label='28'", "label='0'",
     "line 5: structure label is '0', expected a whole number from 1 to 65535"},
    {"label_too_large", "label='28'", "label='65536'",
     "line 5: structure label is '65536', expected a whole number from 1 to 65535"},
    {"label_not_whole", "label='28'", "label='28.5'",
     "line 5: structure label is '28.5', expected a whole number from 1 to 65535"},
    {"no_boolean", "critical='true'", "critical='yes'",
     "line 6: structure critical is 'yes', expected true or false"},
    {"unknown_tip", "whitacre", "sharp",
     "line 10: needle tip is 'sharp', expected quincke, whitacre, tuohy, chiba, trephine, filiform, sprotte, diamond "
     "or conical"},
    {"unknown_resistance", "<layered ", "<fem ",
     "line 13: the element <fem> is not allowed here, expected <layered>, <spring_damper_wall>, <tracking_wall>, "
     "<depth_profile>, <volume_proxy>, <three_component>, <fracture>, <shaft_friction>, <embedded_needle> or "
     "<closest_node>"},
    {"unknown_constraint", "<line_spring ", "<spring ",
     "line 14: the element <spring> is not allowed here, expected <line_spring>, <pivot>, <rail>, <beam> or <none>"},
    {"negative_torque", "peak_torque_N_mm='0'", "peak_torque_N_mm='-1'",
     "line 11: device peak_torque_N_mm is '-1', expected a number from 0 to 10000"},
    {"unknown_law", "law='sum'", "law='square'", "line 13: layered law is 'square', expected cubic or sum"},
    {"no_such_gauge", "gauge='22'", "gauge='9'",
     "line 10: needle gauge is '9', expected a gauge from 10 to 34, or 0 for a needle that has none"},
    {"bad_digest", "0123456789abcdef0123456789abcdef", "xyz",
     "line 3: ct digest is 'xyz', expected 32 hexadecimal digits"},
    {"empty_name", "name='large'", "name=''", "line 1: case name is '', expected a text of 1 to 200 characters"},
    // what one value means for another
    {"inner_over_outer", "inner_diameter_mm='0.4'", "inner_diameter_mm='0.7'",
     "line 10: needle: inner_diameter_mm is not less than outer_diameter_mm, expected a tube or a solid needle"},
    {"one_diameter", " inner_diameter_mm='0.4'", "",
     "line 10: needle has one of outer_diameter_mm and inner_diameter_mm, expected both or neither (a solid needle "
     "has an inner_diameter_mm of 0)"},
    {"no_size_at_all", "gauge='22' outer_diameter_mm='0.7' inner_diameter_mm='0.4'", "gauge='0'",
     "line 10: needle gauge is 0, expected 10 to 34, or outer_diameter_mm and inner_diameter_mm beside it"},
    {"continuous_over_peak", "'0.9'", "'3.4'",
     "line 11: device: continuous_force_N is 3.4 N, expected at most the peak_force_N of 3.3 N"},
    {"target_is_entry", "x_mm='3' y_mm='-117.5' z_mm='294'", "x_mm='4.5' y_mm='-45' z_mm='293'",
     "line 23: target is 0 mm from the entry on line 22, expected at least 0.1 mm"},
    {"label_twice", "label='2'", "label='28'", "line 6: structure label is 28, which line 5 uses already"},
    {"landmark_twice", "'L4_L5'", "'L3_L4'", "line 19: landmark name is 'L3_L4', which line 18 uses already"},
    {"unknown_tissue", "tissue='organ'", "tissue='liver'",
     "line 6: structure tissue is 'liver', which the tissue library does not have"},
    {"unknown_aim", "'dura'", "'duramater'",
     "line 21: procedure target_tissue is 'duramater', which the tissue library does not have"},
    // file names that lead out
    {"parent_folder", "ct.nrrd", "../ct.nrrd",
     "line 3: ct file is '../ct.nrrd', expected a file name inside the case folder, without '..' or a leading '/'"},
    {"parent_inside", "labels/s.nrrd", "labels/../../s",
     "line 4: structures file is 'labels/../../s', expected a file name inside the case folder, without '..' or a "
     "leading '/'"},
    {"absolute", "tissues.nrrd", "/etc/passwd",
     "line 8: tissues file is '/etc/passwd', expected a file name inside the case folder, without '..' or a leading "
     "'/'"},
    {"backslash", "tissues.nrrd", "..\\secret",
     "line 8: tissues file is '..\\secret', expected a file name inside the case folder, without '..' or a leading "
     "'/'"},
    {"library_outside", "  <landmarks>", "  <tissue_library file='../t.xml'/><landmarks>",
     "line 17: tissue_library file is '../t.xml', expected a file name inside the case folder, without '..' or a "
     "leading '/'"},
    // XML that is none, or that wants more than a case may
    {"namespace", "<case ", "<case xmlns='http://example.org' ",
     "line 1: <case> uses an XML namespace; these files have none, so remove every xmlns and prefix"},
    {"schema_of_its_own", "<case ",
     "<case xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' xsi:noNamespaceSchemaLocation='/etc/passwd' ",
     "line 1: <case> uses an XML namespace; these files have none, so remove every xmlns and prefix"},
    {"attribute_with_prefix", "<haptics ", "<haptics xml:base='/' ",
     "line 12: <haptics> has the attribute xml:base, but attributes with a prefix are not allowed"},
    {"unknown_entity", "<note>one", "<note>&one;", "line 25: the XML is broken: Entity 'one' not defined"},
    {"attribute_twice", "gauge='22'", "gauge='22' gauge='23'",
     "line 10: the XML is broken: Attribute gauge redefined"},
    {"not_utf8", "one</note>", "\xff\xfe</note>",
     "line 25: there is a character that is not UTF-8 or not allowed in XML"},
    {"cut_short", "  <notes><note>one</note></notes>\n</case>\n", "",
     "line 25: the file ends before its elements are closed; is it cut short?"},
};

INSTANTIATE_TEST_SUITE_P(All, CaseXmlRefusal, ::testing::ValuesIn(refusals),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(CaseXml, an_empty_file_and_a_foreign_file_are_refused) {
  EXPECT_EQ(refusal([] { parse(""); }), "case.xml: the file is empty");
  EXPECT_EQ(refusal([] { parse("label,name\n"); }),
            "case.xml, line 1: the file is not XML; expected it to begin with '<'");
  EXPECT_EQ(refusal([] { parse("<patient/>"); }),
            "case.xml, line 1: the outermost element is <patient>, which does not belong there");
  EXPECT_EQ(refusal([] { parse("<haptics/>"); }),
            "case.xml, line 1: the outermost element is <haptics>, which does not belong there");
}

TEST(CaseXml, document_types_are_refused_before_their_entities_expand) {
  std::string laughs = "<?xml version='1.0'?>\n<!DOCTYPE case [<!ENTITY a0 'ha'>";
  for (int i = 1; i < 40; ++i)
    laughs +=
        "<!ENTITY a" + std::to_string(i) + " '&a" + std::to_string(i - 1) + ";&a" + std::to_string(i - 1) + ";'>";
  laughs += "]>\n" + replaced(largest, "<note>one", "<note>&a39;");
  EXPECT_EQ(
      refusal([&] { parse(laughs); }),
      "case.xml, line 2: a document type (<!DOCTYPE ...>) is not allowed; remove it and any entities it declares");
  EXPECT_THAT(refusal([] { parse("<!DOCTYPE case SYSTEM 'file:///etc/passwd'>\n" + largest); }),
              HasSubstr("is not allowed"));
  EXPECT_THAT(
      refusal([] {
        parse("<!DOCTYPE case [<!ENTITY x SYSTEM 'file:///etc/passwd'>]>\n" + replaced(largest, "one", "&x;"));
      }),
      HasSubstr("is not allowed"));
}

TEST(CaseXml, deep_nesting_is_refused) {
  const auto nested = [](int levels) {
    std::string text;
    for (int i = 0; i < levels; ++i) text += "<a>";
    for (int i = 0; i < levels; ++i) text += "</a>";
    return text;
  };
  EXPECT_EQ(refusal([&] { parse(nested(20)); }), "case.xml, line 1: <a> is nested deeper than 16 levels");
  EXPECT_EQ(refusal([&] { parse(nested(100000)); }), "case.xml, line 1: the elements are nested too deeply");
}

TEST(CaseXml, a_long_value_is_shown_short_and_whole_characters_only) {
  std::string digest;
  for (int i = 0; i < 5000; ++i) digest += "ü";
  const std::string sentence = refused("0123456789abcdef0123456789abcdef", digest);
  EXPECT_THAT(sentence, SizeIs(Lt(200U)));
  EXPECT_THAT(sentence, AllOf(HasSubstr("ü...'"), HasSubstr("expected 32 hexadecimal digits")));
}

}  // namespace
}  // namespace bodkin
