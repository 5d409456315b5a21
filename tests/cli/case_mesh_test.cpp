#include <cmath>
#include <filesystem>
#include <functional>

#include "tests/cli/bodkin_command.h"
#include "tests/cli/calculix_case.h"
#include "tests/cli/mesher_rig.h"
#include "tests/io/foreign_meshes.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "imaging/png_file.h"
#include "io/mesh/foreign_mesh.h"

// `bodkin case mesh` as a user runs it.

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class CaseMesh : public PatientCommand {};

// A block of tetrahedra around the middle of the patient, as Gmsh writes it.
std::string block_in_patient(const json& shown, double scale,
                             const std::function<void(::bodkin::anatomy::TetrahedralMesh&)>& damage = {}) {
  ::bodkin::anatomy::TetrahedralMesh mesh = ::bodkin::block_mesh(4, 10.0);
  if (damage) damage(mesh);
  const auto target = shown.at("procedure").at("path").at("target_mm").get<std::array<double, 3>>();
  for (auto& node : mesh.nodes) {
    node = scale * (node + ::bodkin::Vec3(target[0] - 20.0, target[1] - 20.0, target[2] - 20.0));
  }
  return ::bodkin::gmsh_4_text(mesh);
}

TEST_F(CaseMesh, meshes_a_patient_once_and_tells_table_picture_and_json) {
  BODKIN_NEEDS_MESHER();
  const Outcome made = bodkin("--json case mesh patient --nodes 4000 --merge-layers");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const json result = json::parse(made.output);
  EXPECT_FALSE(result.at("up_to_date").get<bool>());
  EXPECT_NEAR(result.at("nodes").get<double>(), 4000.0, 600.0);
  EXPECT_GT(result.at("dihedral_angle_deg").at(0).get<double>(), 1.0);
  EXPECT_GT(result.at("element_volume_mm3").at(0).get<double>(), 0.0);
  // Near the path the mesh is finer than elsewhere, and has the stated size.
  const double fine = 2.0 * result.at("scale").get<double>();
  EXPECT_NEAR(result.at("corridor").at("mean_edge_mm").get<double>() / fine, 1.0, 0.25);
  EXPECT_LT(result.at("corridor").at("mean_edge_mm").get<double>(), result.at("edge_mm").at("mean").get<double>());
  const auto file = folder_ / "patient/mesh.vtu";
  const auto parsed = ::bodkin::io::parse_vtu(content_of(file), "mesh.vtu");
  EXPECT_EQ(parsed.nodes.size(), result.at("nodes").get<std::size_t>());
  EXPECT_EQ(parsed.elements.size(), result.at("elements").get<std::size_t>());
  const ::bodkin::imaging::ImageRgb picture =
      ::bodkin::imaging::decode_png(content_of(folder_ / "patient/mesh.png"), "mesh.png");
  EXPECT_GT(picture.width, 1000);

  const auto written = fs::last_write_time(file);
  const Outcome again = bodkin("-q case mesh patient --nodes 4000 --merge-layers -o mesh.svg");
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_EQ(fs::last_write_time(file), written);
  for (const char* text :
       {"is up to date", "tetrahedra", "muscle", "cancellous bone", "dihedral angles", "mesh.svg"}) {
    EXPECT_THAT(again.output, HasSubstr(text));
  }
  EXPECT_THAT(text_of("mesh.svg"), HasSubstr("planned path"));
  EXPECT_EQ(bodkin("-q case check patient").exit_code, 0);

  const std::string before = content_of(file);
  const Outcome other = bodkin("--json case mesh patient --nodes 2500 --merge-layers");
  ASSERT_EQ(other.exit_code, 0) << other.errors;
  EXPECT_NEAR(json::parse(other.output).at("nodes").get<double>(), 2500.0, 375.0);
  const Outcome back = bodkin("-q case mesh patient --nodes 4000 --merge-layers --force");
  EXPECT_EQ(back.exit_code, 0);
  EXPECT_EQ(content_of(file), before);  // the same bytes as the first time
}

TEST_F(CaseMesh, holds_the_layers_of_the_planned_path_or_says_how_many_nodes_that_takes) {
  BODKIN_NEEDS_MESHER();
  ASSERT_EQ(bodkin("-q case synthesize lumbar layers --spacing 3").exit_code, 0);
  const Outcome few = bodkin("-q case mesh layers --nodes 600");
  EXPECT_EQ(few.exit_code, 2);
  EXPECT_THAT(few.errors, HasSubstr("600 nodes are too few to hold the layers of the planned path"));
  EXPECT_EQ(lines_of(few.errors), 1);
  EXPECT_FALSE(fs::exists(folder_ / "layers/mesh.vtu"));
  const std::string give = "give --nodes ";
  const std::size_t at = few.errors.find(give);
  ASSERT_NE(at, std::string::npos);
  const int least = std::stoi(few.errors.substr(at + give.size()));
  EXPECT_GT(least, 600);
  const Outcome merged = bodkin("case mesh layers --nodes 600 --merge-layers");
  EXPECT_EQ(merged.exit_code, 0);
  EXPECT_THAT(merged.errors, HasSubstr("does not hold these layers"));
  const Outcome enough = bodkin("case mesh layers --nodes 8000");
  EXPECT_EQ(enough.exit_code, 0) << enough.errors;
  EXPECT_THAT(enough.errors, Not(HasSubstr("does not hold")));
}

TEST_F(CaseMesh, imports_a_mesh_with_regions_and_keeps_it) {
  ASSERT_EQ(bodkin("-q case synthesize lumbar imported --spacing 3").exit_code, 0);
  const json shown = json::parse(bodkin("--json case show imported -o shown.svg").output);
  write("body.msh", block_in_patient(shown, 1.0));
  write("regions.csv", "label,name,tissue,critical\n2,a,fat,no\n3,b,ligamentum_flavum,no\n");
  const std::string command = "--json case mesh imported --import body.msh --regions regions.csv -o imported.png";
  const Outcome made = bodkin(command);
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const json result = json::parse(made.output);
  EXPECT_EQ(result.at("elements"), 320);
  EXPECT_NEAR(result.at("volume_ml").get<double>(), 64.0, 1e-9);
  EXPECT_EQ(result.at("tissues").at(1).at("tissue"), "ligamentum_flavum");
  EXPECT_TRUE(json::parse(bodkin(command).output).at("up_to_date").get<bool>());
  const std::string kept = text_of("imported/mesh.vtu");
  // The file that was written is a mesh that can be imported too.
  fs::copy_file(folder_ / "imported/mesh.vtu", folder_ / "copy.vtu");
  EXPECT_EQ(bodkin("-q case mesh imported --import copy.vtu").exit_code, 0);
  EXPECT_EQ(text_of("imported/mesh.vtu"), kept);

  // Changed files are not replaced without request.
  write("imported/mesh.vtu", kept + "\n");
  const Outcome refused = bodkin("-q " + command);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("--force"));
  EXPECT_EQ(text_of("imported/mesh.vtu"), kept + "\n");
  EXPECT_EQ(bodkin("-q " + command + " --force").exit_code, 0);
  EXPECT_EQ(text_of("imported/mesh.vtu"), kept);
}

// The planned path does not meet it, so the image shows another cut.
TEST_F(CaseMesh, imports_a_mesh_beside_the_path) {
  ASSERT_EQ(bodkin("-q case synthesize lumbar beside --spacing 3").exit_code, 0);
  const json shown = json::parse(bodkin("--json case show beside -o shown.svg").output);
  ::bodkin::anatomy::TetrahedralMesh mesh = ::bodkin::block_mesh(2, 10.0);
  const auto target = shown.at("procedure").at("path").at("target_mm").get<std::array<double, 3>>();
  for (auto& node : mesh.nodes) node += ::bodkin::Vec3(target[0] + 30.0, target[1] - 10.0, target[2] - 10.0);
  write("aside.msh", ::bodkin::gmsh_4_text(mesh));
  write("aside.csv", "label,name,tissue,critical\n2,a,fat,no\n3,b,muscle,no\n");
  const Outcome made = bodkin("-q case mesh beside --import aside.msh --regions aside.csv -o aside.svg");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_THAT(text_of("aside.svg"), HasSubstr("the planned path does not meet it"));
  EXPECT_EQ(bodkin("-q case mesh beside --import aside.msh --regions aside.csv -o aside.png").exit_code, 0);
}

TEST_F(CaseMesh, case_check_finds_a_damaged_mesh) {
  ASSERT_EQ(bodkin("-q case synthesize lumbar damaged --spacing 3").exit_code, 0);
  const json shown = json::parse(bodkin("--json case show damaged -o shown.svg").output);
  write("sound.msh", block_in_patient(shown, 1.0));
  write("sound.csv", "label,name,tissue,critical\n2,a,fat,no\n3,b,ligamentum_flavum,no\n");
  ASSERT_EQ(bodkin("-q case mesh damaged --import sound.msh --regions sound.csv").exit_code, 0);
  EXPECT_EQ(bodkin("-q case check damaged").exit_code, 0);
  const std::string kept = text_of("damaged/mesh.vtu");
  const auto expect_said = [](const std::string& sentence) {
    const Outcome said = bodkin("-q case check damaged");
    EXPECT_EQ(said.exit_code, 2);
    EXPECT_THAT(said.output, HasSubstr(sentence));
    EXPECT_THAT(said.output, HasSubstr("is not valid: 1 problem"));
  };
  write("damaged/mesh.vtu", kept.substr(0, kept.size() / 2));
  expect_said("mesh.vtu");
  write("damaged/mesh.vtu", kept + "\n");
  expect_said("mesh.vtu is not the mesh that mesh.json was written with");
  fs::remove(folder_ / "damaged/mesh.json");
  EXPECT_EQ(bodkin("-q case check damaged").exit_code, 0);  // a mesh of the user's own
}

TEST_F(CaseMesh, refuses_what_it_cannot_use_and_writes_nothing) {
  const json shown = json::parse(bodkin("--json case show patient -o shown.svg").output);
  write("good.msh", block_in_patient(shown, 1.0));
  write("metres.msh", block_in_patient(shown, 0.001));
  write("damaged.msh", "$MeshFormat\n4.1 0 8\n");
  using ::bodkin::anatomy::TetrahedralMesh;
  write("twice.msh", block_in_patient(shown, 1.0, [](TetrahedralMesh& mesh) {
          mesh.elements.push_back(mesh.elements[7]);
          mesh.tissues.push_back(mesh.tissues[7]);
        }));
  write(
      "flat.msh", block_in_patient(shown, 1.0, [](TetrahedralMesh& mesh) {
        const auto& corners = mesh.elements[7];
        const ::bodkin::Vec3 across =
            (mesh.nodes[corners[1]] - mesh.nodes[corners[0]]).cross(mesh.nodes[corners[2]] - mesh.nodes[corners[0]]);
        ::bodkin::Vec3& top = mesh.nodes[corners[3]];
        top -= across * (across.dot(top - mesh.nodes[corners[0]]) * (1.0 - 1e-7) / across.squaredNorm());
      }));
  write("unknown.obj", "v 0 0 0\n");
  write("short.csv", "label,name,tissue,critical\n2,a,fat,no\n");
  const auto refused = [](const std::string& options, const std::string& sentence) {
    const auto before = listing();
    const Outcome said = bodkin("-q case mesh " + options);
    EXPECT_EQ(said.exit_code, 2) << options;
    EXPECT_THAT(said.errors, HasSubstr(sentence));
    EXPECT_EQ(lines_of(said.errors), 1) << said.errors;
    EXPECT_EQ(listing(), before) << options;
  };
  refused("nowhere", "no such case folder");
  refused("patient -o mesh.jpg", "expected .png or .svg");
  refused("patient --fine 5 --coarse 4", "--coarse is 4; expected at least --fine, 5");
  refused("patient --regions short.csv", "expected --import FILE with it");
  refused("patient --import absent.msh", "no such file");
  refused("patient --import unknown.obj", "expected .msh (Gmsh) or .vtu (VTK)");
  refused("patient --import damaged.msh", "damaged.msh, line 3");
  refused("patient --import twice.msh", "have the same four corners");
  refused("patient --import flat.msh", "flat.msh: ");
  refused("patient --import metres.msh", "expected patient coordinates, LPS in mm");
  refused("patient --import good.msh --regions short.csv", "no row for region 3");
}

TEST_F(CaseMesh, meshes_a_real_abdomen) {
  BODKIN_NEEDS_MESHER();
  const char* named = std::getenv("BODKIN_DATA");
  const fs::path data = named != nullptr ? fs::path(named) : fs::path(BODKIN_REPOSITORY) / "../shared/data";
  if (!fs::exists(data / "abdomen")) GTEST_SKIP() << "no real CT data: set BODKIN_DATA to its folder";
  const Outcome imported = bodkin("-q case new abdomen --ct '" + (data / "abdomen/abdomen_ct.nii.gz").string() +
                                  "' --labels '" + (data / "abdomen/abdomen_labels.nii.gz").string() + "'");
  ASSERT_EQ(imported.exit_code, 0) << imported.errors;
  const Outcome made = bodkin("--json case mesh abdomen --nodes 5000 --merge-layers");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const json result = json::parse(made.output);
  EXPECT_NEAR(result.at("nodes").get<double>(), 5000.0, 750.0);
  EXPECT_GT(result.at("dihedral_angle_deg").at(0).get<double>(), 1.0);
  EXPECT_GE(result.at("tissues").size(), 5U);
  expect_same_as_calculix(folder_ / "abdomen");
}

}  // namespace
}  // namespace bodkin_test
