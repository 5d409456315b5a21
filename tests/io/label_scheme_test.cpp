#include "io/label_scheme.h"

#include <cstdlib>
#include <map>
#include <set>

#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using ::testing::HasSubstr;

const std::string scheme_header = "label,name,tissue,critical\n";

std::string refused_scheme(const std::string& text) {
  return refusal([&] { parse_label_scheme(text, "s.csv"); });
}

std::map<int, Structure> by_label(const std::vector<Structure>& structures) {
  std::map<int, Structure> map;
  for (const Structure& entry : structures) map.emplace(entry.label, entry);
  return map;
}

TEST(LabelScheme, a_line_becomes_a_structure) {
  const auto structures = parse_label_scheme(
      scheme_header + "28,vertebrae_L4,bone,no\n2,\"kidney, right\",organ,yes\n7,thing,,\n", "s.csv");
  ASSERT_EQ(structures.size(), 3U);
  EXPECT_EQ(structures[0].label, 28);
  EXPECT_EQ(structures[0].name, "vertebrae_L4");
  EXPECT_EQ(structures[0].tissue, "bone");
  EXPECT_FALSE(structures[0].critical);
  EXPECT_EQ(structures[1].name, "kidney, right");
  EXPECT_TRUE(structures[1].critical);
  EXPECT_EQ(structures[2].tissue, "");
  EXPECT_FALSE(structures[2].critical);
}

TEST(LabelScheme, what_spreadsheets_write_is_read) {
  const std::string text =
      "\xEF\xBB\xBFlabel,name,tissue,critical\r\n\"1\", spaced ,bone,no\r\n\r\n2,\"a \"\"b\"\"\",organ,1";
  const auto structures = parse_label_scheme(text, "s.csv");
  ASSERT_EQ(structures.size(), 2U);
  EXPECT_EQ(structures[0].label, 1);
  EXPECT_EQ(structures[0].name, "spaced");
  EXPECT_EQ(structures[1].name, "a \"b\"");
  EXPECT_TRUE(structures[1].critical);
}

struct SchemeRefusal {
  const char* name;
  std::string text;
  const char* sentence;
};

class LabelSchemeRefusal : public ::testing::TestWithParam<SchemeRefusal> {};

TEST_P(LabelSchemeRefusal, names_line_and_column) {
  EXPECT_EQ(refused_scheme(GetParam().text), std::string("s.csv, ") + GetParam().sentence);
}

const SchemeRefusal scheme_refusals[] = {
    {"empty", "", "line 1: the file is empty, expected the header label,name,tissue,critical"},
    {"blank", "\n\n", "line 1: the file is empty, expected the header label,name,tissue,critical"},
    {"no_header", "1,spleen,organ,yes\n",
     "line 1: the header is '1,spleen,organ,yes', expected label,name,tissue,critical"},
    {"other_header", "id,tissue\n1,organ\n",
     "line 1: the header is 'id,tissue', expected label,name,tissue,critical"},
    {"only_a_header", scheme_header, "line 1: there are no labels under the header"},
    {"too_many_columns", scheme_header + "1,a,bone,no\n2,b,bone,no,maybe\n",
     "line 3: there are 5 columns, expected 4 (label,name,tissue,critical)"},
    {"too_few_columns", scheme_header + "\n\n1,a\n",
     "line 4: there are 2 columns, expected 4 (label,name,tissue,critical)"},
    {"label_is_a_word", scheme_header + "one,a,bone,no\n",
     "line 2: column 1: label is 'one', expected a whole number from 1 to 65535"},
    {"label_zero", scheme_header + "0,a,bone,no\n",
     "line 2: column 1: label is '0', expected a whole number from 1 to 65535"},
    {"label_negative", scheme_header + "-1,a,bone,no\n",
     "line 2: column 1: label is '-1', expected a whole number from 1 to 65535"},
    {"label_too_large", scheme_header + "65536,a,bone,no\n",
     "line 2: column 1: label is '65536', expected a whole number from 1 to 65535"},
    {"label_fraction", scheme_header + "1.5,a,bone,no\n",
     "line 2: column 1: label is '1.5', expected a whole number from 1 to 65535"},
    {"label_empty", scheme_header + ",a,bone,no\n",
     "line 2: column 1: label is '', expected a whole number from 1 to 65535"},
    {"label_twice", scheme_header + "1,a,bone,no\r\n2,b,bone,no\r\n1,c,bone,no\r\n",
     "line 4: column 1: label is 1, which line 2 uses already"},
    {"no_name", scheme_header + "1,,bone,no\n",
     "line 2: column 2: name is '', expected a name on one line, at most 200 bytes long"},
    {"name_on_two_lines", scheme_header + "1,\"a\nb\",bone,no\n",
     "line 2: column 2: name is 'a b', expected a name on one line, at most 200 bytes long"},
    {"unknown_tissue", scheme_header + "1,a,liver,no\n",
     "line 2: column 3: tissue is 'liver', expected the name of a tissue of the library, bone, spinal_canal or "
     "nothing"},
    {"unknown_critical", scheme_header + "1,a,bone,maybe\n",
     "line 2: column 4: critical is 'maybe', expected yes or no"},
    {"quote_inside", scheme_header + "1,a\"b,bone,no\n",
     "line 2: column 2: a quote (\") is not allowed here; put the whole field in quotes and double the quotes in it"},
    {"quote_left_open", scheme_header + "1,a,bone,no\n2,\"b,bone,no\n3,c,bone,no\n",
     "line 3: a field that begins with a quote (\") never ends with one"},
    {"nul", scheme_header + std::string("1,a\0b,bone,no\n", 14),
     "line 2: column 2: the byte 0x00 is not text, expected UTF-8 without control characters"},
    {"latin1",
     scheme_header + "1,r\xFC"
                     "ckgrat,bone,no\n",
     "line 2: column 2: the byte 0xFC is not text, expected UTF-8 without control characters"},
    {"utf16", std::string("\xFF\xFEl\0a\0", 6),
     "line 1: column 1: the byte 0xFF is not text, expected UTF-8 without control characters"},
};

INSTANTIATE_TEST_SUITE_P(All, LabelSchemeRefusal, ::testing::ValuesIn(scheme_refusals),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(LabelScheme, lines_are_counted_whatever_ends_them) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string text = "label,name,tissue,critical" + end + "1,a,bone,no" + end + end + "x,b,bone,no" + end;
    EXPECT_THAT(refused_scheme(text), ::testing::StartsWith("s.csv, line 4: column 1: label is 'x'"));
  }
}

TEST(LabelScheme, a_name_that_is_neither_a_scheme_nor_a_file_is_refused) {
  EXPECT_EQ(refusal([] { read_label_scheme("nosuch"); }),
            "label scheme is 'nosuch', expected totalsegmentator, totalsegmentator_v1, tptbox or the path of a CSV "
            "file with the columns "
            "label,name,tissue,critical");
  const ScratchFolder folder;
  EXPECT_THAT(refusal([&] { read_label_scheme(folder.path()); }), HasSubstr("this is not a file"));
  const auto large = folder.write("large.csv", scheme_header + std::string(9 << 20, ' '));
  EXPECT_THAT(refusal([&] { read_label_scheme(large); }), HasSubstr("larger than the 8192 kB"));
  const auto good = folder.write("good.csv", scheme_header + "1,a,bone,no\n");
  EXPECT_EQ(read_label_scheme(good).size(), 1U);
}

TEST(LabelScheme, a_table_of_ids_and_names_takes_the_tissues_from_the_names) {
  const auto scheme = by_label(parse_label_scheme("id,name\n5,vertebrae_L3\n6,aorta\n7,my_thing\n", "mine.csv"));
  EXPECT_EQ(scheme.at(5).tissue, "bone");
  EXPECT_EQ(scheme.at(6).tissue, "vessel");
  EXPECT_TRUE(scheme.at(6).critical);
  EXPECT_EQ(scheme.at(7).tissue, "") << "decided by HU";
  EXPECT_THROW(parse_label_scheme("id,name\n5\n", "mine.csv"), InputError);
}

TEST(LabelScheme, totalsegmentator_v1_holds_its_104_structures) {
  const auto scheme = by_label(read_label_scheme("totalsegmentator_v1"));
  EXPECT_EQ(scheme.size(), 104U);
  EXPECT_EQ(scheme.at(18).name, "vertebrae_L5");
  EXPECT_EQ(scheme.at(92).name, "sacrum");
  EXPECT_EQ(scheme.at(103).tissue, "muscle");
}

TEST(LabelScheme, totalsegmentator_holds_all_117_structures_with_the_tissues_they_are_made_of) {
  const auto scheme = by_label(read_label_scheme("totalsegmentator"));
  ASSERT_EQ(scheme.size(), 117U);
  EXPECT_EQ(scheme.begin()->first, 1);
  EXPECT_EQ(scheme.rbegin()->first, 117);
  EXPECT_EQ(scheme.at(29).name, "vertebrae_L3");
  EXPECT_EQ(scheme.at(29).tissue, "bone");
  EXPECT_EQ(scheme.at(79).tissue, "spinal_canal");
  EXPECT_FALSE(scheme.at(79).critical);
  EXPECT_EQ(scheme.at(52).tissue, "vessel");
  EXPECT_EQ(scheme.at(86).tissue, "muscle");
  std::map<std::string, int> counts;
  for (const auto& [label, entry] : scheme) {
    ++counts[entry.tissue];
    const bool soft_and_vital = entry.tissue == "organ" || entry.tissue == "vessel" || entry.tissue == "lung";
    EXPECT_TRUE(entry.critical || !soft_and_vital) << entry.name;
    EXPECT_FALSE(entry.critical && (entry.tissue == "bone" || entry.tissue == "muscle")) << entry.name;
  }
  // 26 vertebrae and sacrum, 24 ribs, sternum, skull, and ten bones of the limbs and girdles
  EXPECT_EQ(counts["bone"], 26 + 24 + 2 + 10);
  EXPECT_EQ(counts["lung"], 5);
}

TEST(LabelScheme, totalsegmentator_names_are_those_of_the_segmentation_s_own_table) {
  const char* data = std::getenv("BODKIN_DATA");
  const std::filesystem::path file =
      std::filesystem::path(data != nullptr ? data : BODKIN_REPOSITORY "/../shared/data") / "abdomen" /
      "abdomen_labels.csv";
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << file << " is not here; BODKIN_DATA names the folder of test data";
  const auto scheme = by_label(read_label_scheme("totalsegmentator"));
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  int rows = 0;
  while (std::getline(stream, line)) {
    const auto comma = line.find(',');
    ++rows;
    EXPECT_EQ(scheme.at(std::stoi(line.substr(0, comma))).name, line.substr(comma + 1));
  }
  EXPECT_EQ(rows, 117);
}

TEST(LabelScheme, tptbox_numbers_vertebrae_their_parts_and_discs) {
  const auto scheme = by_label(read_label_scheme("tptbox"));
  EXPECT_EQ(scheme.at(1).name, "vertebrae_C1");
  EXPECT_EQ(scheme.at(19).name, "vertebrae_T12");
  EXPECT_EQ(scheme.at(20).name, "vertebrae_L1");
  EXPECT_EQ(scheme.at(24).name, "vertebrae_L5");
  EXPECT_EQ(scheme.at(26).name, "vertebrae_S1");
  EXPECT_EQ(scheme.at(42).name, "Spinosus_Process");
  EXPECT_EQ(scheme.at(50).tissue, "bone");
  EXPECT_EQ(scheme.at(61).tissue, "spinal_canal");
  EXPECT_EQ(scheme.at(122).tissue, "disc");
  EXPECT_EQ(scheme.at(122).name, "disc_L3");
}

}  // namespace
}  // namespace bodkin
