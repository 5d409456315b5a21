#include <regex>

#include "tests/io/foreign_meshes.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "anatomy/mesh_parts.h"
#include "anatomy/mesh_quality.h"
#include "core/error.h"
#include "io/mesh/foreign_mesh.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string gmsh_refusal(const std::string& text) {
  try {
    parse_gmsh(text, "body.msh");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string gmsh_changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(GmshFile, both_versions_give_the_mesh_that_was_written) {
  const TetrahedralMesh mesh = block_mesh(3, 2.5);
  for (const std::string& text : {gmsh_2_text(mesh), gmsh_4_text(mesh)}) {
    const ForeignMesh read = parse_gmsh(text, "body.msh");
    ASSERT_EQ(read.nodes.size(), mesh.nodes.size());
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) EXPECT_EQ(read.nodes[n], mesh.nodes[n]);
    ASSERT_EQ(read.elements.size(), mesh.elements.size());
    TetrahedralMesh again{read.nodes, read.elements, {}};
    for (const std::int64_t region : read.regions) again.tissues.push_back(static_cast<TissueId>(region));
    const MeshQuality before = measure_quality(mesh), after = measure_quality(again);
    EXPECT_DOUBLE_EQ(before.volume, after.volume);
    EXPECT_EQ(after.not_positive, 0U);
    ASSERT_EQ(before.tissues.size(), after.tissues.size());
    for (std::size_t t = 0; t < before.tissues.size(); ++t) {
      EXPECT_EQ(before.tissues[t].elements, after.tissues[t].elements);
      EXPECT_NEAR(before.tissues[t].volume, after.tissues[t].volume, 1e-9);
    }
    ASSERT_FALSE(read.notes.empty());
    EXPECT_THAT(read.notes.front(), HasSubstr("1 elements that are no tetrahedra"));
  }
  EXPECT_EQ(parse_gmsh(gmsh_2_text(mesh), "body.msh").names.at(2), "fat tissue");
}

TEST(GmshFile, tetrahedra_without_a_group_have_the_number_of_their_volume) {
  const std::string text = gmsh_changed(gmsh_4_text(block_mesh(2, 1.0)), "1 1 1 1 2 1 9\n103", "1 1 1 0 1 9\n103");
  const ForeignMesh read = parse_gmsh(text, "body.msh");
  EXPECT_EQ(std::count(read.regions.begin(), read.regions.end(), 102), 20);
  EXPECT_THAT(read.notes.back(), HasSubstr("20 tetrahedra belong to no physical group"));
}

TEST(GmshFile, other_sections_and_windows_line_ends_do_not_matter) {
  std::string text = gmsh_2_text(block_mesh(2, 1.0));
  text = gmsh_changed(text, "$Nodes", "$Comments\nanything 1 2 3 $Nodes of it\n$EndComments\n$Nodes");
  text = std::regex_replace(text, std::regex("\n"), "\r\n");
  EXPECT_EQ(parse_gmsh(text, "body.msh").elements.size(), 40U);
}

TEST(GmshFile, every_damage_gets_a_sentence_with_its_line) {
  const std::string two = gmsh_2_text(block_mesh(2, 1.0)), four = gmsh_4_text(block_mesh(2, 1.0));
  const auto expect = [](const std::string& text, const std::string& line, const std::string& sentence) {
    EXPECT_THAT(gmsh_refusal(text), AllOf(HasSubstr("body.msh, line " + line), HasSubstr(sentence)));
  };
  expect("", "1", "not a mesh of Gmsh");
  expect("solid cube\n", "1", "not a mesh of Gmsh");
  expect(gmsh_changed(two, "2.2 0 8", "1.0 0 8"), "2", "expected 2.2 or 4.1");
  expect(gmsh_changed(two, "2.2 0 8", "2.2 1 8"), "2", "binary");
  expect(gmsh_changed(two, "$Nodes\n27", "$Nodes\n28"), "39", "'$EndNodes', expected a whole number");
  expect(gmsh_changed(two, "$Nodes\n27", "$Nodes\n4000001"), "11", "expected 0 to 4000000");
  expect(gmsh_changed(two, "$Nodes\n27", "$Nodes\n3999999"), "11", "too short for so many");
  expect(gmsh_changed(two, "$Nodes\n27", "$Nodes\n-1"), "11", "expected 0 to");
  expect(gmsh_changed(two, "11 0.1", "11 nan"), "12", "node 1 has the coordinate nan");
  expect(gmsh_changed(two, "11 0.1", "11 1e6"), "12", "expected numbers within 100000 mm");
  expect(gmsh_changed(two, "11 0.1", "11 x"), "12", "'x', expected a number");
  expect(gmsh_changed(two, "\n14 ", "\n11 "), "13", "node 11 is given twice");
  expect(gmsh_changed(two, "2 4 2 3 1 11", "2 4 2 3 1 12"), "43", "element 2 has the node 12, which $Nodes does not");
  expect(gmsh_changed(two, "2 4 2 3 1 11 14", "2 4 2 3 1 14 14"), "43", "element 2 has one node twice");
  expect(gmsh_changed(two, "2 4 2 3 1", "2 11 2 3 1"), "43", "element 2 is a tetrahedron of second order");
  expect(gmsh_changed(two, "2 4 2 3 1", "2 5 2 3 1"), "43", "element 2 is a solid of type 5");
  expect(gmsh_changed(two, "2 4 2 3 1", "2 99 2 3 1"), "43", "the type 99, which is not known");
  expect(two.substr(0, two.rfind(' ', two.find("$EndNodes")) + 1), "38", "the file ends where");
  expect(two.substr(0, two.find("$EndNodes") + 2), "", "'$E'");
  expect(gmsh_changed(two, "$EndElements\n", ""), "", "the end of the file, expected $EndElements");
  expect(gmsh_changed(four, "$Nodes\n2 27", "$Nodes\n2 26"), "", "there are 27 nodes, but 26 were announced");
  expect(gmsh_changed(four, "$EndNodes\n", "$EndNodes\n$Nodes\n0 0 0 0\n$EndNodes\n"), "", "a second section $Nodes");
  expect(gmsh_changed(two, "3 2 \"fat tissue\"", "3 2 fat"), "7", "in double quotes");
  const std::size_t nodes = two.find("$Nodes"), elements = two.find("$Elements");
  expect(two.substr(0, nodes) + two.substr(elements), "", "before $Nodes");
  expect(two.substr(0, nodes), "", "there are no nodes");
  EXPECT_THAT(gmsh_refusal(two.substr(0, elements)), HasSubstr("there are no tetrahedra"));
}

TEST(GmshFile, no_truncated_file_is_taken_for_whole) {
  for (const std::string& text : {gmsh_2_text(block_mesh(1, 1.0)), gmsh_4_text(block_mesh(1, 1.0))}) {
    for (std::size_t length = 0; length + 2 < text.size(); length += 3) {
      EXPECT_NE(gmsh_refusal(text.substr(0, length)), "accepted") << length;
    }
  }
}

}  // namespace
}  // namespace bodkin
