#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "patient/meshing/mesh_record.h"
#include "tests/fem/calculix.h"

#include "fem/solid/patient_body.h"
#include "io/case_folder.h"

namespace bodkin_test {

// The mesh of a case as its resistance would use it, against CalculiX.
inline void expect_same_as_calculix(const std::filesystem::path& folder) {
  if (!::bodkin::checks::calculix_is_there()) {
    std::cout << "  not compared with CalculiX: ccx is not installed (Debian: calculix-ccx)\n";
    return;
  }
  setenv("BODKIN_IMAGES_WORKER", BODKIN_BUILD "/bin/bodkin-images", 1);  // it is not beside the tests
  const ::bodkin::anatomy::Case patient = ::bodkin::io::load_case(folder);
  unsetenv("BODKIN_IMAGES_WORKER");
  auto mesh = ::bodkin::patient::read_case_mesh(folder, patient.library);
  ASSERT_TRUE(mesh.has_value());
  const ::bodkin::anatomy::NeedlePath& path = *patient.description.procedure.path;
  ::bodkin::fem::BodyDescription body = ::bodkin::fem::describe_body(mesh->mesh, patient, {}, path);
  std::vector<std::string> notes;
  body.corridor = ::bodkin::fem::corridor_about(body, path, {.nodes = 300.0}, notes);
  ::bodkin::checks::expect_what_calculix_says(body, 60);
}

}  // namespace bodkin_test
