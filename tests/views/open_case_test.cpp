#include "views/open_case.h"

#include <gtest/gtest.h>

#include "io/tissue_library_file.h"

namespace bodkin::views {
namespace {

// A row of voxels, 1 mm apart: fluid, a root and the cord in the canal, then bone of L3, then muscle without a label.
anatomy::Case row() {
  using namespace anatomy::tissue;
  anatomy::Case patient;
  patient.library = io::default_tissue_library();
  anatomy::Grid grid;
  grid.size = {5, 1, 1};
  patient.tissues = anatomy::TissueVolume(grid);
  patient.tissues.voxels = {cerebrospinal_fluid, nerve, spinal_cord, cortical_bone, muscle};
  patient.structures = anatomy::LabelVolume(grid);
  patient.structures.voxels = {1, 1, 1, 2, 0};
  patient.description.structures = {{.label = 1, .name = "spinal_cord", .tissue = "spinal_canal"},
                                    {.label = 2, .name = "vertebrae_L3", .tissue = "cortical_bone"}};
  return patient;
}

TEST(PlaceName, in_the_canal_it_is_the_tissue_and_elsewhere_the_structure) {
  const anatomy::Case patient = row();
  const char* const names[] = {"cerebrospinal fluid", "nerve roots", "spinal cord", "vertebra L3", "muscle"};
  for (int i = 0; i < 5; ++i) EXPECT_EQ(place_name(patient, Vec3(i, 0.0, 0.0)), names[i]) << i;
}

// A tip that pushes a boundary ahead is still in the tissue in front of that boundary.
TEST(PlaceName, of_a_tip_in_the_deformed_material_is_what_it_is_in) {
  using namespace anatomy::tissue;
  const anatomy::Case patient = row();
  const Vec3 inwards = Vec3::UnitX();
  EXPECT_EQ(place_name(patient, Vec3(3.0, 0.0, 0.0), inwards, spinal_cord), "spinal cord") << "bone is pushed";
  EXPECT_EQ(place_name(patient, Vec3(4.4, 0.0, 0.0), inwards, cortical_bone), "vertebra L3");
  EXPECT_EQ(place_name(patient, Vec3(3.0, 0.0, 0.0), inwards, cortical_bone), "vertebra L3");
  EXPECT_EQ(place_name(patient, Vec3(0.0, 0.0, 0.0), inwards, muscle), "muscle") << "it is nowhere before";
}

TEST(PlaceName, without_labels_it_is_the_tissue) {
  anatomy::Case patient = row();
  patient.structures = {};
  EXPECT_EQ(place_name(patient, Vec3(3.0, 0.0, 0.0)), "cortical bone");
}

}  // namespace
}  // namespace bodkin::views
