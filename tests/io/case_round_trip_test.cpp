// case.xml and the description agree to the bit, in both directions.
#include <array>
#include <bit>
#include <cmath>

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

using ::testing::HasSubstr;

void expect_same(const CaseDescription& a, const CaseDescription& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  const auto same_vector = [&same](const Vec3& x, const Vec3& y) {
    return same(x.x(), y.x()) && same(x.y(), y.y()) && same(x.z(), y.z());
  };
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.created_by, b.created_by);
  EXPECT_EQ(a.ct_file, b.ct_file);
  EXPECT_EQ(a.ct_digest, b.ct_digest);
  EXPECT_EQ(a.structures_file, b.structures_file);
  EXPECT_EQ(a.structures_digest, b.structures_digest);
  EXPECT_EQ(a.tissues_file, b.tissues_file);
  EXPECT_EQ(a.tissues_digest, b.tissues_digest);
  EXPECT_EQ(a.tissue_library_file, b.tissue_library_file);
  EXPECT_EQ(a.notes, b.notes);
  ASSERT_EQ(a.structures.size(), b.structures.size());
  for (std::size_t i = 0; i < a.structures.size(); ++i) {
    EXPECT_EQ(a.structures[i].label, b.structures[i].label);
    EXPECT_EQ(a.structures[i].name, b.structures[i].name);
    EXPECT_EQ(a.structures[i].tissue, b.structures[i].tissue);
    EXPECT_EQ(a.structures[i].critical, b.structures[i].critical);
  }
  EXPECT_EQ(a.needle.gauge, b.needle.gauge);
  EXPECT_TRUE(same(a.needle.outer_diameter, b.needle.outer_diameter));
  EXPECT_TRUE(same(a.needle.inner_diameter, b.needle.inner_diameter));
  EXPECT_TRUE(same(a.needle.length, b.needle.length));
  EXPECT_EQ(a.needle.tip, b.needle.tip);
  EXPECT_EQ(a.device.profile, b.device.profile);
  EXPECT_TRUE(same(a.device.peak_force, b.device.peak_force));
  EXPECT_TRUE(same(a.device.continuous_force, b.device.continuous_force));
  EXPECT_TRUE(same(a.device.peak_torque, b.device.peak_torque));
  EXPECT_TRUE(same(a.device.stiffness, b.device.stiffness));
  EXPECT_TRUE(same(a.device.position_resolution, b.device.position_resolution));
  EXPECT_TRUE(same_bits(a.haptics, b.haptics));
  ASSERT_EQ(a.breathing.has_value(), b.breathing.has_value());
  if (a.breathing) {
    EXPECT_TRUE(same_parameters(*a.breathing, *b.breathing));
  }
  ASSERT_EQ(a.landmarks.size(), b.landmarks.size());
  for (std::size_t i = 0; i < a.landmarks.size(); ++i) {
    EXPECT_EQ(a.landmarks[i].name, b.landmarks[i].name);
    EXPECT_TRUE(same_vector(a.landmarks[i].position, b.landmarks[i].position));
  }
  EXPECT_EQ(a.procedure.name, b.procedure.name);
  EXPECT_EQ(a.procedure.target_tissue, b.procedure.target_tissue);
  EXPECT_TRUE(same(a.procedure.target_tolerance, b.procedure.target_tolerance));
  ASSERT_EQ(a.procedure.path.has_value(), b.procedure.path.has_value());
  if (a.procedure.path) {
    EXPECT_TRUE(same_vector(a.procedure.path->entry, b.procedure.path->entry));
    EXPECT_TRUE(same_vector(a.procedure.path->target, b.procedure.path->target));
  }
}

std::string wild_text(Random& random) {
  static const std::vector<std::string> pieces = {"a",     "Z", " ",  "  ", "\n",  "\t", "\r",
                                                  "\r\n",  "<", ">",  "&",  "\"",  "'",  "]]>",
                                                  "&amp;", "ü", "脊", "😀",  "-->", "0",  "<!--"};
  std::string text = "x";
  const int count = static_cast<int>(random.uniform(0.0, 12.0));
  for (int i = 0; i < count; ++i) text += pieces[random.next() % pieces.size()];
  return text;
}

std::string wild_digest(Random& random) {
  std::string digest;
  for (int i = 0; i < 32; ++i) digest += "0123456789abcdef"[random.next() % 16];
  return digest;
}

CaseDescription wild_case(Random& random) {
  CaseDescription d;
  const auto vector = [&random](double bound) {
    return Vec3(wild_number(random, -bound, bound), wild_number(random, -bound, bound),
                wild_number(random, -bound, bound));
  };
  d.name = wild_text(random);
  d.description = wild_text(random);
  d.created_by = wild_text(random);
  d.ct_file = "ct & <co>.nrrd";
  d.ct_digest = wild_digest(random);
  d.tissues_file = "tissues/tissues.nrrd";
  if (random.uniform() < 0.5) {
    d.structures_file = "structures.nrrd";
    d.structures_digest = wild_digest(random);
    for (int label = 1; label < 40; label += 1 + static_cast<int>(random.uniform(0.0, 9.0))) {
      const char* tissues[] = {"", "bone", "spinal_canal", "organ", "ligamentum_flavum"};
      d.structures.push_back({static_cast<std::uint16_t>(label * 1600), wild_text(random), tissues[random.next() % 5],
                              random.uniform() < 0.5});
    }
  }
  d.needle = {static_cast<int>(10 + random.next() % 25), wild_number(random, 1.0, 20.0),
              wild_number(random, 0.0, 0.99), wild_number(random, 1.0, 1000.0),
              static_cast<NeedleTip>(random.next() % 6)};
  d.device = {wild_text(random),
              wild_number(random, 50.0, 100.0),
              wild_number(random, 1e-6, 50.0),
              wild_number(random, 0.0, 1e4),
              wild_number(random, 1e-6, 100.0),
              wild_number(random, 0.0, 1.0)};
  d.haptics = wild_haptics(random);
  for (int i = 0; random.uniform() < 0.7; ++i)
    d.landmarks.push_back({wild_text(random) + std::to_string(i), vector(1e5)});
  if (random.uniform() < 0.5) {
    d.breathing.emplace();
    d.breathing->rate = wild_number(random, 2.0, 60.0);
    d.breathing->motion = Vec3(wild_number(random, -30.0, 30.0), wild_number(random, -30.0, 30.0), 0.25);
    d.breathing->centre = vector(1e5);
    d.breathing->radius = wild_number(random, 200.0, 500.0);
    d.breathing->pause = 1 + static_cast<int>(random.next() % 6);
    d.breathing->longest_hold = wild_number(random, 1.0, 120.0);
  }
  d.procedure.name = "biopsy_2";
  d.procedure.target_tissue = random.uniform() < 0.5 ? "" : "mass";
  d.procedure.target_tolerance = wild_number(random, 1e-3, 100.0);
  if (random.uniform() < 0.7) d.procedure.path = NeedlePath{vector(1e5), vector(1e5) + Vec3(0.0, 0.0, 1e-3)};
  if (d.procedure.path && d.procedure.path->length() < 1.0) d.procedure.path.reset();
  while (random.uniform() < 0.6) d.notes.push_back(wild_text(random));
  return d;
}

TEST(CaseXml, any_case_reads_back_as_it_was_written_to_the_bit) {
  Random random(20);
  const XmlSchema schema("case.xsd");
  const TissueLibrary library = default_tissue_library();
  for (int round = 0; round < 300; ++round) {
    const CaseDescription written = wild_case(random);
    const CaseDescription read =
        parse_case_xml(case_xml(written), "case.xml", schema, [&](const std::string&) { return library; });
    expect_same(read, written);
    if (HasFailure()) FAIL() << "round " << round << "\n" << case_xml(written);
  }
}

TEST(CaseXml, what_is_left_out_takes_the_default_of_the_description) {
  CaseDescription expected;
  expected.name = "small";
  expected.ct_file = "ct.nrrd";
  expected.tissues_file = "tissues.nrrd";
  expect_same(parse(smallest), expected);
}

TEST(CaseXml, the_defaults_that_the_schema_states_are_those_of_the_description) {
  // Elements without their optional attributes, against the same elements left out.
  const std::string bare = replaced(smallest, "  <needle gauge='22'/>\n",
                                    "<needle gauge='22'/><device/><haptics><resistance><layered/></resistance>"
                                    "<constraint><line_spring/></constraint><parts/><compensation/></haptics>"
                                    "<procedure/>");
  expect_same(parse(bare), parse(smallest));
  // And against the schema's defaults for a validating reader.
  const std::string schema = read_text_file(shared_file("case.xsd"), 1 << 20);
  std::string filled = bare;
  for (const auto& [element, attribute, value] :
       std::vector<std::array<std::string, 3>>{{"needle", "length_mm", "90"},
                                               {"needle", "tip", "quincke"},
                                               {"device", "profile", "generic"},
                                               {"device", "peak_force_N", "6"},
                                               {"device", "continuous_force_N", "2"},
                                               {"device", "peak_torque_N_mm", "188"},
                                               {"device", "stiffness_N_per_mm", "1"},
                                               {"device", "position_resolution_mm", "0"},
                                               {"haptics", "rate_Hz", "1000"},
                                               {"haptics", "mechanics", "tables"},
                                               {"haptics", "force_in_organs", "felt"},
                                               {"procedure", "name", "lumbar_puncture"},
                                               {"procedure", "target_tolerance_mm", "3"}}) {
    EXPECT_THAT(schema, HasSubstr("name=\"" + attribute + "\" default=\"" + value + "\"")) << element;
    filled = replaced(filled, "<" + element, "<" + element + " " + attribute + "='" + value + "'");
  }
  expect_same(parse(filled), parse(smallest));
}

TEST(CaseXml, characters_that_xml_cannot_hold_become_replacement_characters) {
  CaseDescription description = parse(smallest);
  description.notes = {
      "bell \x07, half a character \xE2\x82, lone surrogate \xED\xA0\x80, overlong \xC0\x80, good \xC3\xBC"};
  const std::string mark = "\xEF\xBF\xBD";
  EXPECT_EQ(parse(case_xml(description)).notes.front(), "bell " + mark + ", half a character " + mark + mark +
                                                            ", lone surrogate " + mark + mark + mark + ", overlong " +
                                                            mark + mark + ", good \xC3\xBC");
}

}  // namespace
}  // namespace bodkin
