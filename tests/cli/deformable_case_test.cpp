// A patient with a mesh, as run by a user, and that mesh solved by CalculiX.
#include <cmath>
#include <filesystem>

#include "patient/prepared_body.h"
#include "tests/cli/bodkin_command.h"
#include "tests/cli/calculix_case.h"
#include "tests/cli/mesher_rig.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

class DeformableCase : public PatientCommand {};

double peak_in(const json& profile, const std::string& tissue) {
  double peak = 0.0;
  for (const json& crossing : profile.at("tissues")) {
    if (crossing.at("tissue").get<std::string>().find(tissue) != std::string::npos)
      peak = std::max(peak, crossing.at("peak_force_N").get<double>());
  }
  return peak;
}

std::vector<std::string> texts_in(const json& profile, const std::string& part) {
  std::vector<std::string> found;
  for (const json& event : profile.at("events")) {
    const auto text = event.at("text").get<std::string>();
    if (text.find(part) != std::string::npos) found.push_back(text);
  }
  return found;
}

TEST_F(DeformableCase, a_patient_is_felt_through_its_mesh) {
  BODKIN_NEEDS_MESHER();
  const Outcome without = bodkin("-q profile patient --resistance embedded_needle");
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_THAT(without.errors, HasSubstr("make one with: bodkin case mesh patient"));
  ASSERT_EQ(bodkin("-q case mesh patient --nodes 5000 --merge-layers").exit_code, 0);
  expect_same_as_calculix(folder_ / "patient");

  // Sutherland et al. 2013, III.A: 1.5 N at the skin, 0.5 to 1.5 N in soft tissue, 4.7 N at the ligamentum flavum.
  const std::string embedded = " --mechanics tables --resistance embedded_needle --constraint none ";
  const Outcome paper = bodkin("--json profile patient --beyond 10" + embedded + "-o paper");
  ASSERT_EQ(paper.exit_code, 0) << paper.errors;
  EXPECT_THAT(paper.errors, HasSubstr("the needle meets points of its line in a body of"));
  const json said = json::parse(paper.output);
  EXPECT_FALSE(texts_in(said, "skin gives way at 1.5").empty()) << paper.output;
  // Friction of the shaft adds to the ligament's own force.
  const std::vector<std::string> flavum = texts_in(said, "ligamentum flavum gives way at");
  ASSERT_EQ(flavum.size(), 1U) << paper.output;
  EXPECT_THAT(flavum.front(), ContainsRegex("N, of which 4\\.7[01] N are its own")) << "4.7 N, and what a tick adds";
  EXPECT_FALSE(texts_in(said, "loss of resistance").empty()) << paper.output;
  EXPECT_GT(peak_in(said, "interspinous ligament"), 0.2);
  EXPECT_LT(peak_in(said, "interspinous ligament"), 2.0);
  const Outcome again = bodkin("--json profile patient --beyond 10" + embedded + "-o again");
  EXPECT_EQ(text_of("paper.csv"), text_of("again.csv"));

  // A replay needs the original tissues and mesh.
  ASSERT_EQ(bodkin("-q run patient --max-time 2" + embedded + "-o felt.bodkin").exit_code, 0);
  ASSERT_EQ(bodkin("-q replay felt.bodkin").exit_code, 0);
  fs::copy(folder_ / "patient", folder_ / "remeshed", fs::copy_options::recursive);
  ASSERT_EQ(bodkin("-q case mesh remeshed --nodes 3000 --merge-layers --force").exit_code, 0);
  const Outcome other_mesh = bodkin("-q replay felt.bodkin --case remeshed");
  EXPECT_EQ(other_mesh.exit_code, 2) << other_mesh.output;
  EXPECT_THAT(other_mesh.errors, HasSubstr("its mesh is not the one of the session"));

  const Outcome seen = bodkin("-q profile patient --deformation" + embedded + "-o seen");
  ASSERT_EQ(seen.exit_code, 0) << seen.errors;
  EXPECT_THAT(text_of("seen-deformation.svg"), AllOf(HasSubstr("at rest"), HasSubstr("tissue moved ")));

  // Ultrasound of the same tissue: it has moved where the tip dents the skin.
  const std::string scan =
      "-q --json ultrasound patient --view needle --probe L14-5 --needle --needle-depth 3 --plain ";
  const Outcome straight = bodkin(scan + "--press 0 -o straight.png");
  ASSERT_EQ(straight.exit_code, 0) << straight.errors;
  const Outcome drawn = bodkin(scan + "--deformed -o drawn.png");
  ASSERT_EQ(drawn.exit_code, 0) << drawn.errors;
  const json tissue = json::parse(drawn.output);
  EXPECT_GT(tissue.at("tissue_moved_mm").get<double>(), 0.2);
  EXPECT_LT(tissue.at("tissue_moved_mm").get<double>(), 20.0);
  EXPECT_GT(tissue.at("needle_force_N").get<double>(), 0.05);
  EXPECT_NE(content_of(folder_ / "straight.png"), content_of(folder_ / "drawn.png"));

  // Beside the planned path.
  const auto moved = [&said](const char* end) {
    const json& at = said.at(end);
    return std::to_string(at[0].get<double>() + 35.0) + "," + std::to_string(at[1].get<double>()) + "," +
           std::to_string(at[2].get<double>());
  };
  const std::string beside = " --entry=" + moved("entry_mm") + " --target=" + moved("target_mm");
  const Outcome elsewhere = bodkin("--json profile patient" + beside + embedded + "-o elsewhere");
  ASSERT_EQ(elsewhere.exit_code, 0) << elsewhere.errors;
  EXPECT_FALSE(texts_in(json::parse(elsewhere.output), "skin gives way at 1.5").empty()) << elsewhere.output;

  ASSERT_EQ(bodkin("-q run patient --operator expert" + embedded + "-o session.bodkin").exit_code, 0);
  const Outcome replayed = bodkin("replay session.bodkin");
  EXPECT_EQ(replayed.exit_code, 0) << replayed.errors;
  EXPECT_THAT(replayed.output, HasSubstr("identical"));

  const Outcome compared = bodkin("--json compare patient --models layered,embedded_needle,closest_node -o compared");
  ASSERT_EQ(compared.exit_code, 0) << compared.errors;
  EXPECT_THAT(text_of("compared.csv"),
              HasSubstr("layered_shaft_N,layered_material_mm,embedded_needle_N,embedded_needle_tip_N,embedded_"
                        "needle_ahead_mm,embedded_needle_nodes,embedded_needle_material_mm,closest_node_N"));
}

TEST_F(DeformableCase, a_damaged_body_file_is_made_anew_and_a_damaged_mesh_is_refused) {
  BODKIN_NEEDS_MESHER();
  ASSERT_EQ(bodkin("-q case mesh patient --nodes 1500 --merge-layers").exit_code, 0);
  const std::string command = "profile patient --resistance 'closest_node corridor_nodes=100' -o damaged";
  ASSERT_EQ(bodkin(command).exit_code, 0);
  fs::resize_file(folder_ / "patient" / ::bodkin::patient::body_file_name, 1000);
  const Outcome anew = bodkin(command);
  EXPECT_EQ(anew.exit_code, 0);
  EXPECT_THAT(anew.errors, HasSubstr("the body is prepared again"));

  const std::string points = "--json profile patient --resistance embedded_needle -o points";
  const Outcome first = bodkin(points);
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  const std::string curve = text_of("points.csv");
  const fs::path factor = folder_ / "patient" / ::bodkin::patient::factor_file_name;
  const auto made = fs::last_write_time(factor);
  ASSERT_EQ(bodkin(points).exit_code, 0);
  EXPECT_EQ(fs::last_write_time(factor), made) << "it is read";
  EXPECT_EQ(text_of("points.csv"), curve);
  fs::resize_file(factor, 1000);
  const Outcome again = bodkin(points);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.errors, HasSubstr("the body is prepared again"));
  EXPECT_EQ(text_of("points.csv"), curve);
  EXPECT_GT(fs::file_size(factor), 1000U);
  fs::resize_file(folder_ / "patient/mesh.vtu", 1000);
  const Outcome refused = bodkin("-q " + command);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(lines_of(refused.errors), 1) << refused.errors;
}

}  // namespace
}  // namespace bodkin_test
