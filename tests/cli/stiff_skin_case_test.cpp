// A patient whose skin is much stiffer than fat: the mesh preserves it around the needle's path, and it bends.
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "patient/meshing/mesh_record.h"
#include "tests/cli/bodkin_command.h"
#include "tests/cli/mesher_rig.h"
#include <gtest/gtest.h>

#include "fem/solid/contact_body.h"
#include "fem/solid/patient_body.h"
#include "io/case_folder.h"

namespace bodkin_test {
namespace {

using namespace ::bodkin::anatomy;
using namespace ::bodkin::fem;

class StiffSkinCase : public BodkinCommand {
 protected:
  // The text of a file with `from`, its first after `behind`, replaced.
  static std::string with(std::string text, const std::string& behind, const std::string& from,
                          const std::string& to) {
    const std::size_t at = text.find(from, text.find(behind));
    EXPECT_NE(at, std::string::npos) << behind;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
  }
};

TEST_F(StiffSkinCase, has_its_skin_in_the_mesh_about_the_path_and_bends_it) {
  BODKIN_NEEDS_MESHER();
  ASSERT_EQ(bodkin("-q case synthesize lumbar patient").exit_code, 0);
  const std::string library = content_of(BODKIN_REPOSITORY "/share/bodkin/tissues.xml");
  write("patient/tissues.xml",
        with(library, "name=\"skin\"", "<deformable young_MPa=\"0.02\"", "<deformable young_MPa=\"0.5\""));
  write("patient/case.xml", with(content_of(folder_ / "patient/case.xml"), "</volumes>", "</volumes>",
                                 "</volumes>\n  <tissue_library file=\"tissues.xml\"/>"));
  const Outcome meshed = bodkin("-q case mesh patient");
  ASSERT_EQ(meshed.exit_code, 0) << meshed.errors;

  setenv("BODKIN_IMAGES_WORKER", BODKIN_BUILD "/bin/bodkin-images", 1);  // it is not beside the tests
  const Case patient = ::bodkin::io::load_case(folder_ / "patient");
  unsetenv("BODKIN_IMAGES_WORKER");
  auto mesh = ::bodkin::patient::read_case_mesh(folder_ / "patient", patient.library);
  ASSERT_TRUE(mesh.has_value());
  const NeedlePath path = *patient.description.procedure.path;
  const auto body = std::make_shared<const BodyDescription>(describe_body(mesh->mesh, patient, {}, path));
  std::vector<bool> fixed(body->mesh.nodes.size(), false);
  for (const std::uint32_t node : body->fixed) fixed[node] = true;
  const std::vector<bool> chosen = elements_of_stiff_skin(body->mesh, body->materials, fixed);
  std::set<TissueId> tissues;
  double farthest = 0.0;
  for (std::size_t element = 0; element < chosen.size(); ++element) {
    if (!chosen[element]) continue;
    tissues.insert(body->mesh.tissues[element]);
    const ::bodkin::Vec3 from_entry = body->mesh.nodes[body->mesh.elements[element][0]] - path.entry;
    farthest = std::max(farthest, from_entry.cross(path.direction()).norm());
  }
  EXPECT_EQ(tissues, std::set<TissueId>{tissue::skin});
  EXPECT_GT(farthest, 10.0);
  EXPECT_LT(farthest, 25.0);
  EXPECT_GT(QuadraticEdges(body->mesh, chosen, fixed).size(), 1000U);

  const Outcome profile = bodkin("profile patient --resistance embedded_needle");
  EXPECT_EQ(profile.exit_code, 0) << profile.errors;
  EXPECT_NE(profile.errors.find("note: the skin is stiffer than fat"), std::string::npos) << profile.errors;
}

}  // namespace
}  // namespace bodkin_test
