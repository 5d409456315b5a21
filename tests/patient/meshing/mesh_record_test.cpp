#include "patient/meshing/mesh_record.h"

#include "patient/meshing/mesh_regions.h"
#include "tests/io/foreign_meshes.h"
#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/label_scheme.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

using ::testing::HasSubstr;

ForeignMesh foreign_block() {
  return parse_gmsh(gmsh_2_text(block_mesh(2, 3.0)), "body.msh");
}

std::string region_refusal(const ForeignMesh& foreign, const std::string& scheme) {
  const TissueLibrary library = default_tissue_library();
  std::vector<std::string> notes;
  try {
    const auto structures = scheme.empty() ? std::vector<Structure>()
                                           : parse_label_scheme("label,name,tissue,critical\n" + scheme, "r.csv");
    with_tissues(foreign, library, structures, scheme.empty() ? "body.msh" : "r.csv", notes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(MeshRegions, are_tissue_ids_or_rows_of_a_scheme) {
  const TissueLibrary library = default_tissue_library();
  std::vector<std::string> notes;
  const TetrahedralMesh plain = with_tissues(foreign_block(), library, {}, "body.msh", notes);
  EXPECT_EQ(plain.tissues, block_mesh(2, 3.0).tissues);
  const auto scheme =
      parse_label_scheme("label,name,tissue,critical\n2,soft,organ,no\n3,hard,cortical_bone,no\n", "r");
  const TetrahedralMesh mapped = with_tissues(foreign_block(), library, scheme, "r", notes);
  for (std::size_t e = 0; e < mapped.tissues.size(); ++e) {
    EXPECT_EQ(mapped.tissues[e], plain.tissues[e] == tissue::fat ? tissue::organ : tissue::cortical_bone);
  }
  EXPECT_TRUE(notes.empty());
}

TEST(MeshRegions, without_a_tissue_are_refused_by_name) {
  ForeignMesh foreign = foreign_block();
  EXPECT_THAT(region_refusal(foreign, "3,hard,cortical_bone,no\n"),
              HasSubstr("r.csv: there is no row for region 2 ('fat tissue')"));
  EXPECT_THAT(region_refusal(foreign, "2,a,bone,no\n3,b,fat,no\n"), HasSubstr("is 'bone', expected the name of one"));
  foreign.regions[5] = 200;
  EXPECT_THAT(region_refusal(foreign, ""), HasSubstr("body.msh: region 200 is not the id of a tissue"));
  foreign.regions[5] = 0;
  EXPECT_THAT(region_refusal(foreign, ""), HasSubstr("region 0 is not the id of a tissue"));
}

TEST(MeshRegions, inside_out_elements_are_turned_and_flat_ones_refused_with_their_place) {
  ForeignMesh foreign = foreign_block();
  std::swap(foreign.elements[3][1], foreign.elements[3][2]);
  std::vector<std::string> notes;
  with_tissues(foreign, default_tissue_library(), {}, "body.msh", notes);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes.front(), HasSubstr("1 tetrahedra were inside out"));
  foreign.nodes[foreign.elements[7][0]] = foreign.nodes[foreign.elements[7][1]];
  EXPECT_THAT(region_refusal(foreign, ""), HasSubstr("has no volume"));
}

TEST(MeshRecord, a_mesh_is_found_again_with_what_it_was_made_from) {
  const ScratchFolder folder;
  const TissueLibrary library = default_tissue_library();
  EXPECT_FALSE(read_case_mesh(folder.path(), library));
  EXPECT_TRUE(case_mesh_is_ours(folder.path()));
  const TetrahedralMesh mesh = block_mesh(2, 1.0 / 3.0);
  write_case_mesh(mesh, {"from", {}, 1.25, "body.msh", {"A note."}}, folder.path());
  const auto found = read_case_mesh(folder.path(), library);
  ASSERT_TRUE(found && found->record);
  EXPECT_EQ(found->mesh.nodes, mesh.nodes);
  EXPECT_EQ(found->mesh.elements, mesh.elements);
  EXPECT_EQ(found->mesh.tissues, mesh.tissues);
  EXPECT_EQ(found->record->made_from, "from");
  EXPECT_EQ(found->record->scale, 1.25);
  EXPECT_EQ(found->record->source, "body.msh");
  EXPECT_EQ(found->record->notes, std::vector<std::string>{"A note."});
}

TEST(MeshRecord, a_mesh_changed_by_somebody_else_is_not_ours) {
  const ScratchFolder folder;
  write_case_mesh(block_mesh(2, 1.0), {"from", {}, 1.0, {}, {}}, folder.path());
  EXPECT_TRUE(case_mesh_is_ours(folder.path()));
  folder.write("mesh.vtu", vtu_text(block_mesh(2, 1.5)));
  EXPECT_FALSE(case_mesh_is_ours(folder.path()));
  const auto found = read_case_mesh(folder.path(), default_tissue_library());
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->record);
  for (const char* damaged : {"", "{", "[]", "{\"made_from\": 3}"}) {
    folder.write("mesh.json", damaged);
    EXPECT_FALSE(read_mesh_record(folder.path())) << damaged;
  }
}

TEST(MeshRecord, the_fingerprint_follows_from_everything_that_the_mesh_does) {
  TissueVolume tissues(Grid{{4, 4, 4}, Vec3::Ones(), Mat3::Identity(), Vec3::Zero()}, tissue::fat);
  const NeedlePath path{Vec3::Zero(), Vec3(0, 3, 0)};
  const std::string first = mesh_made_from(tissues, path, {});
  EXPECT_EQ(mesh_made_from(tissues, path, {}), first);
  std::vector<std::string> others = {mesh_made_from(tissues, std::nullopt, {}),
                                     mesh_made_from(tissues, NeedlePath{Vec3::Zero(), Vec3(0, 3.1, 0)}, {})};
  for (int change = 0; change < 5; ++change) {
    MeshSettings settings;
    if (change == 0) settings.nodes += 1;
    if (change == 1) settings.fine += 0.1;
    if (change == 2) settings.coarse += 0.1;
    if (change == 3) settings.corridor_radius += 0.1;
    if (change == 4) settings.preserve_layers = false;
    others.push_back(mesh_made_from(tissues, path, settings));
  }
  tissues.at(1, 2, 3) = tissue::muscle;
  others.push_back(mesh_made_from(tissues, path, {}));
  others.push_back(mesh_made_from("bytes", "scheme"));
  others.push_back(mesh_made_from("bytesscheme", ""));
  others.push_back(first);
  std::sort(others.begin(), others.end());
  EXPECT_EQ(std::unique(others.begin(), others.end()), others.end());
}

}  // namespace
}  // namespace bodkin
