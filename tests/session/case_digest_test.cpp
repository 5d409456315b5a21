#include "session/case_digest.h"

#include <fstream>
#include <set>

#include "tests/change_parameter.h"
#include "tests/session/session_samples.h"
#include "tests/session/slab_case.h"
#include "tests/simulation/slab_patient.h"
#include <gtest/gtest.h>

#include "anatomy/case.h"
#include "io/case_xml.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::session;
namespace {

Case patient_of_two_tissues() {
  Case patient = slab_case({{tissue::skin, 2.0}, {tissue::muscle, 20.0}});
  patient.description.ct_file = "ct.nrrd";
  patient.description.tissues_file = "tissues.nrrd";
  return patient;
}

std::string digest_of(const Case& patient) {
  return case_digest(patient, case_xml(patient.description), "mesh");
}

TEST(CaseDigest, every_parameter_of_every_tissue_changes_it) {
  const Case patient = patient_of_two_tissues();
  const std::size_t tissues = patient.library.tissues().size();
  std::set<std::string> digests = {digest_of(patient)};
  std::size_t expected = 1;
  std::set<std::string> names;
  for (std::size_t i = 0; i < tissues; ++i) {
    for (int parameter = 0;; ++parameter) {
      std::vector<TissueProperties> changed = patient.library.tissues();
      int which = parameter;
      const std::string name = change_parameter(changed[i], which);
      if (name.empty()) break;
      if (name == "id") continue;  // the ids of the other tissues
      Case other;
      other.description = patient.description;
      other.tissues = patient.tissues;
      other.library = TissueLibrary(changed);
      digests.insert(digest_of(other));
      names.insert(name);
      ++expected;
      EXPECT_EQ(digests.size(), expected) << changed[i].name << ": " << name;
    }
  }
  for (const char* name :
       {"title", "layered kind", "layered roughness", "tracking_wall force_N", "depth_profile kind",
        "volume_proxy drag_N", "volume_proxy field_value", "shaft_friction viscous_N_s_per_mm2",
        "syringe pressure_MPa", "deformable young_MPa", "deformable puncture_force_N", "acoustic impedance_MRayl",
        "acoustic fibre_variation_dB", "source"})
    EXPECT_TRUE(names.contains(name)) << name;
  EXPECT_GE(names.size(), 44U);
}

template <typename Settings>
void expect_each_changes(const Case& patient, Settings& of_patient, std::set<std::string>& digests) {
  const Settings settings = of_patient;
  for (int parameter = 0;; ++parameter) {
    of_patient = settings;
    int which = parameter;
    const std::string name = change_parameter(of_patient, which);
    if (name.empty()) break;
    EXPECT_TRUE(digests.insert(digest_of(patient)).second) << name;
  }
  of_patient = settings;
}

TEST(CaseDigest, every_setting_of_a_case_changes_it) {
  Case patient = patient_of_two_tissues();
  HapticSettings& haptics = patient.description.haptics;
  std::set<std::string> digests = {digest_of(patient)};
  expect_each_changes(patient, patient.description.needle, digests);
  expect_each_changes(patient, patient.description.device, digests);
  patient.description.breathing.emplace();
  digests.insert(digest_of(patient));
  expect_each_changes(patient, *patient.description.breathing, digests);
  patient.description.breathing.reset();
  expect_each_changes(patient, haptics, digests);
  expect_each_changes(patient, haptics.parts, digests);
  expect_each_changes(patient, haptics.compensation, digests);
  haptics.parts = {.relaxation = {{}},
                   .shaft_friction = ShaftFrictionSettings{},
                   .needle_grasp = NeedleGraspSettings{},
                   .bevel_tip = BevelTipSettings{},
                   .csf_flow = CsfFlowSettings{},
                   .syringe = SyringeSettings{},
                   .fingertip = FingertipSettings{}};
  expect_each_changes(patient, haptics.parts.relaxation.front(), digests);
  expect_each_changes(patient, *haptics.parts.shaft_friction, digests);
  expect_each_changes(patient, *haptics.parts.needle_grasp, digests);
  expect_each_changes(patient, *haptics.parts.bevel_tip, digests);
  expect_each_changes(patient, *haptics.parts.csf_flow, digests);
  expect_each_changes(patient, *haptics.parts.syringe, digests);
  expect_each_changes(patient, *haptics.parts.fingertip, digests);
  haptics.parts = {};
  const auto each_model = [&]<typename Models, std::size_t... Index>(Models& chosen, std::index_sequence<Index...>) {
    const auto one = [&](auto settings) {
      using Settings = decltype(settings);
      chosen = settings;
      if constexpr (requires { settings.layers; }) std::get<Settings>(chosen).layers.emplace_back();
      if constexpr (requires { settings.transfer; }) std::get<Settings>(chosen).transfer.emplace_back();
      digests.insert(digest_of(patient));
      expect_each_changes(patient, std::get<Settings>(chosen), digests);
      if constexpr (requires { settings.layers; })
        expect_each_changes(patient, std::get<Settings>(chosen).layers.front(), digests);
      if constexpr (requires { settings.transfer; })
        expect_each_changes(patient, std::get<Settings>(chosen).transfer.front(), digests);
    };
    (one(std::variant_alternative_t<Index, Models>{}), ...);
  };
  each_model(haptics.resistance, std::make_index_sequence<std::variant_size_v<ResistanceSettings>>());
  for (const char* force : {"0.5", "0.7"}) {
    haptics.resistance = RegisteredSettings{"constant_drag", {{"force_N", force}}, {}};
    EXPECT_TRUE(digests.insert(digest_of(patient)).second) << "settings of a model of the program";
  }
  haptics.resistance = LayeredSettings{};
  each_model(haptics.constraint, std::make_index_sequence<std::variant_size_v<ConstraintSettings>>());
  EXPECT_GT(digests.size(), 100U);
}

TEST(CaseDigest, names_the_part_of_a_case_that_has_changed) {
  const Case patient = patient_of_two_tissues();
  const std::string recorded = case_parts(patient, "mesh");
  EXPECT_EQ(changed_parts(recorded, patient, "mesh"), "");
  EXPECT_EQ(changed_parts(recorded, patient, "another mesh"), "mesh");
  EXPECT_EQ(changed_parts(recorded, patient, ""), "mesh");
  EXPECT_EQ(changed_parts(case_parts(patient, ""), patient, ""), "");
  Case other = patient;
  other.tissues.voxels.front() = other.tissues.voxels.front() == tissue::skin ? tissue::muscle : tissue::skin;
  EXPECT_EQ(changed_parts(recorded, other, "mesh"), "voxels");
  std::vector<TissueProperties> tissues = patient.library.tissues();
  tissues.back().deformable.young *= 1.0 + 1e-12;
  other.library = TissueLibrary(tissues);
  EXPECT_EQ(changed_parts(recorded, other, "mesh"), "voxels and tissues");
}

TEST(CaseDigest, the_mesh_counts_where_a_resistance_meets_it) {
  const Case patient = patient_of_two_tissues();
  EXPECT_NE(case_digest(patient, "<case/>", "one mesh"), case_digest(patient, "<case/>", "another mesh"));
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "case_digest_test";
  std::filesystem::create_directories(folder);
  EXPECT_EQ(mesh_digest(folder, EmbeddedNeedleSettings{}), "") << "there is none";
  std::ofstream(folder / "mesh.vtu") << "one";
  const std::string one = mesh_digest(folder, EmbeddedNeedleSettings{});
  EXPECT_FALSE(one.empty());
  EXPECT_EQ(mesh_digest(folder, ClosestNodeSettings{}), one);
  EXPECT_EQ(mesh_digest(folder, LayeredSettings{}), "") << "does not feel it";
  std::ofstream(folder / "mesh.vtu") << "two";
  EXPECT_NE(mesh_digest(folder, EmbeddedNeedleSettings{}), one);
  std::filesystem::remove_all(folder);
}

// Computed by the program version before tissues had fibres.
TEST(CaseDigest, of_a_case_without_fibres_is_that_from_before_there_were_fibres) {
  Case patient = slab_patient();
  EXPECT_EQ(case_digest(patient, "case", "mesh"), "3:f5151b7e4df23e81");
  EXPECT_EQ(second_case_digest(patient, "case", "mesh"), "2:474c0c442ea35d43");
  std::vector<TissueProperties> tissues = patient.library.tissues();
  tissues.back().deformable.fibres = FibreAxis::superior;
  patient.library = TissueLibrary(tissues);
  EXPECT_NE(case_digest(patient, "case", "mesh"), "3:f5151b7e4df23e81");
}

TEST(CaseDigest, a_session_from_before_the_physical_description_is_compared_without_it) {
  const Case patient = patient_of_two_tissues();
  const std::string recorded = second_case_digest(patient, "<case/>", "mesh");
  EXPECT_TRUE(recorded.starts_with("2:"));
  Case other = patient;
  std::vector<TissueProperties> tissues = patient.library.tissues();
  tissues.back().physical.friction += 0.001;
  other.library = TissueLibrary(tissues);
  EXPECT_TRUE(is_digest_of_case(recorded, other, "<case/>", "mesh"));
  EXPECT_FALSE(is_digest_of_case(case_digest(patient, "<case/>", "mesh"), other, "<case/>", "mesh"));
  tissues.back().tracking_wall.force += 0.1;
  other.library = TissueLibrary(tissues);
  EXPECT_FALSE(is_digest_of_case(recorded, other, "<case/>", "mesh"));
}

TEST(CaseDigest, a_session_of_bodkin_0_1_is_compared_with_what_its_digest_covered) {
  const Case patient = patient_of_two_tissues();
  const std::string recorded = first_case_digest(patient, "<case/>");
  EXPECT_EQ(recorded.size(), 16U);
  EXPECT_TRUE(is_digest_of_case(recorded, patient, "<case/>", "any mesh"));
  EXPECT_FALSE(is_digest_of_case(recorded, patient, "<case />", "any mesh"));
  Case other = patient;
  std::vector<TissueProperties> tissues = patient.library.tissues();
  tissues.back().tracking_wall.force += 0.1;
  other.library = TissueLibrary(tissues);
  EXPECT_FALSE(is_digest_of_case(recorded, other, "<case/>", "any mesh"));
  const std::string digest = case_digest(patient, "<case/>", "mesh");
  EXPECT_TRUE(is_digest_of_case(digest, patient, "<case/>", "mesh"));
  EXPECT_FALSE(is_digest_of_case(digest, patient, "<case/>", "another mesh"));
}

}  // namespace
}  // namespace bodkin
