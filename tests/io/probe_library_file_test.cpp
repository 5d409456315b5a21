#include "io/probe_library_file.h"

#include <set>

#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/resources.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using ::testing::HasSubstr;

const std::string probe_document =
    "<probe_library version='1'>\n"
    "<probe name='A1' title='one' kind='linear' frequency_MHz='7.2' lowest_MHz='5' highest_MHz='14' elements='96' "
    "pitch_mm='0.31' height_mm='4' lens_mm='16' cycles='1.5' depth_mm='60'><source>a\n  sheet</source></probe>\n"
    "<probe name='B2' title='two' kind='curvilinear' frequency_MHz='3.5' lowest_MHz='2' highest_MHz='5' "
    "elements='128' pitch_mm='0.46' radius_mm='60' height_mm='14' lens_mm='60'><source>x</source></probe>\n"
    "<probe name='C3' title='three' kind='phased' frequency_MHz='2.7' lowest_MHz='2' highest_MHz='4' elements='64' "
    "pitch_mm='0.3' sector_deg='90' height_mm='14' lens_mm='60'><source>x</source></probe>\n"
    "</probe_library>\n";

std::string probes_refused(const std::string& from, const std::string& to) {
  return refusal([&] { parse_probes(replaced(probe_document, from, to), "probes.xml"); });
}

TEST(ProbeLibraryFile, every_value_arrives) {
  const std::vector<UltrasoundProbe> probes = parse_probes(probe_document, "probes.xml");
  ASSERT_EQ(probes.size(), 3U);
  const UltrasoundProbe& first = probes[0];
  EXPECT_EQ(first.name, "A1");
  EXPECT_EQ(first.title, "one");
  EXPECT_EQ(first.kind, ProbeKind::linear);
  EXPECT_EQ(first.frequency, 7.2);
  EXPECT_EQ(first.lowest, 5.0);
  EXPECT_EQ(first.highest, 14.0);
  EXPECT_EQ(first.elements, 96);
  EXPECT_EQ(first.pitch, 0.31);
  EXPECT_EQ(first.radius, 0.0);
  EXPECT_EQ(first.sector, 0.0);
  EXPECT_EQ(first.height, 4.0);
  EXPECT_EQ(first.lens, 16.0);
  EXPECT_EQ(first.cycles, 1.5);
  EXPECT_EQ(first.depth, 60.0);
  EXPECT_EQ(first.source, "a sheet");
  EXPECT_EQ(probes[1].kind, ProbeKind::curvilinear);
  EXPECT_EQ(probes[1].radius, 60.0);
  EXPECT_EQ(probes[1].cycles, UltrasoundProbe{}.cycles);
  EXPECT_EQ(probes[1].depth, UltrasoundProbe{}.depth);
  EXPECT_EQ(probes[2].kind, ProbeKind::phased);
  EXPECT_EQ(probes[2].sector, 90.0);
}

TEST(ProbeLibraryFile, faults_are_refused_with_line_field_found_and_expected) {
  EXPECT_EQ(probes_refused("kind='linear'", "kind='round'"),
            "probes.xml, line 2: probe kind is 'round', expected linear, curvilinear or phased");
  EXPECT_EQ(probes_refused("elements='96'", "elements='8'"),
            "probes.xml, line 2: probe elements is '8', expected a whole number from 16 to 1024");
  EXPECT_EQ(probes_refused("frequency_MHz='7.2'", "frequency_MHz='NaN'"),
            "probes.xml, line 2: probe frequency_MHz is 'NaN', expected a number from 1 to 30");
  EXPECT_EQ(probes_refused(" pitch_mm='0.31'", ""),
            "probes.xml, line 2: <probe> lacks the attribute pitch_mm, expected a number from 0.02 to 2");
  EXPECT_EQ(
      probes_refused("name='A1'", "name='A 1'"),
      "probes.xml, line 2: probe name is 'A 1', expected a name such as C5-2: letters, digits, '.', '_', '-' and "
      "'/', at most 64, the first a letter or a digit");
  EXPECT_EQ(probes_refused("name='B2'", "name='a1'"),
            "probes.xml, line 4: probe name is 'a1', which line 2 uses already; names that differ only in capitals "
            "are the same name");
  EXPECT_EQ(probes_refused("lowest_MHz='5'", "lowest_MHz='8'"),
            "probes.xml, line 2: probe 'A1': lowest_MHz is 8 MHz, expected at most the frequency_MHz of 7.2 MHz");
  EXPECT_EQ(probes_refused("radius_mm='60' ", ""),
            "probes.xml, line 4: probe 'B2': radius_mm is 0 mm, expected 5 to 200 mm");
  EXPECT_EQ(
      probes_refused("sector_deg='90'", "radius_mm='60'"),
      "probes.xml, line 5: probe 'C3': radius_mm is 60 mm, expected 0 of a phased probe; leave it out, it belongs to "
      "curvilinear probes");
  EXPECT_THAT(refusal([] { parse_probes("<probe_library version='1'/>", "p.xml"); }), HasSubstr("lacks <probe>"));
  EXPECT_THAT(refusal([] { read_probes("/nowhere/probes.xml"); }), HasSubstr("there is no such file"));
}

TEST(ProbeLibraryFile, a_probe_is_found_by_its_name_in_capitals_or_not) {
  EXPECT_EQ(find_probe("c5-2").name, "C5-2");
  const std::vector<UltrasoundProbe> probes = parse_probes(probe_document, "probes.xml");
  EXPECT_EQ(&find_probe(probes, "B2"), &probes[1]);
  EXPECT_EQ(refusal([&] { find_probe(probes, "D4"); }),
            "there is no ultrasound probe 'D4', expected one of: A1, B2, C3");
}

TEST(ProbeLibraryFile, the_probes_that_come_with_bodkin_are_of_every_kind_and_say_where_they_come_from) {
  const std::vector<UltrasoundProbe> probes = default_probes();
  EXPECT_GE(probes.size(), 8U);
  std::set<ProbeKind> kinds;
  for (const UltrasoundProbe& probe : probes) {
    kinds.insert(probe.kind);
    EXPECT_GT(probe.source.size(), 20U) << probe.name;
    EXPECT_GE(probe.depth, 20.0) << probe.name;
  }
  EXPECT_EQ(kinds.size(), 3U);
  const UltrasoundProbe shallow = find_probe("L14-5"), curved = find_probe("C5-2"), raysim = find_probe("raysim");
  EXPECT_NEAR(shallow.aperture(), 38.0, 1.1) << "PLUS's example";
  EXPECT_EQ(shallow.depth, 60.0) << "PLUS's example";
  constexpr double degrees = 57.29577951308232;  // in a radian
  EXPECT_EQ(curved.radius, 60.0) << "PLUS's example";
  EXPECT_NEAR(curved.aperture() / curved.radius * degrees, 56.0, 0.05) << "PLUS's example";
  EXPECT_NEAR(raysim.aperture() / raysim.radius * degrees, 73.0, 0.05) << "raysim";
  EXPECT_EQ(raysim.elements, 256) << "raysim";
}

TEST(ProbeLibraryFile, the_document_validates_for_xmllint_too) {
  if (std::system("command -v xmllint >/dev/null") != 0)
    GTEST_SKIP() << "xmllint is not installed (Debian package libxml2-utils)";
  const std::string command = "xmllint --noout --schema '" + shared_file("probes.xsd").string() + "' '" +
                              shared_file("probes.xml").string() + "' 2>/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace bodkin
