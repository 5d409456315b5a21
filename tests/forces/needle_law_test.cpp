#include "forces/needle_law.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

Needle gauge_needle(int gauge, NeedleTip tip) {
  const GaugeSize size = *gauge_size(gauge);
  return {.gauge = gauge, .outer_diameter = size.outer_diameter, .inner_diameter = size.inner_diameter, .tip = tip};
}

Case patient_with_needle(const Needle& needle) {
  Case patient;
  patient.library = io::default_tissue_library();
  patient.description.needle = needle;
  patient.description.haptics.mechanics = Mechanics::physical;
  patient.description.device.stiffness = 2.0;
  return patient;
}

const PhysicalTissue& described(const TissueLibrary& library, TissueId id) {
  return library.find(id)->physical;
}

TEST(NeedleLaw, ligamentum_flavum_gives_way_as_published_at_16_and_18_gauge) {
  const TissueLibrary library = io::default_tissue_library();
  const PhysicalTissue& flavum = described(library, tissue::ligamentum_flavum);
  EXPECT_NEAR(puncture_force(flavum, gauge_needle(18, NeedleTip::tuohy)), 5.0, 1.0) << "Naemura et al., 18 G";
  EXPECT_NEAR(puncture_force(flavum, gauge_needle(16, NeedleTip::tuohy)), 9.0, 0.9) << "Brett et al. 1997, 16 G";
}

TEST(NeedleLaw, is_one_at_the_reference_needle_of_every_tissue) {
  const TissueLibrary library = io::default_tissue_library();
  for (const TissueProperties& tissue : library.tissues()) {
    const PhysicalTissue& is = tissue.physical;
    const Needle reference = {.outer_diameter = is.reference_diameter, .tip = is.reference_tip};
    EXPECT_DOUBLE_EQ(puncture_force(is, reference), is.puncture_force) << tissue.name;
    if (is.puncture_force > 0.0) {
      EXPECT_NEAR(puncture_force(is, reference) / boundary_stiffness(is, reference), is.dimpling, 1e-12)
          << tissue.name;
    }
  }
}

TEST(NeedleLaw, a_thicker_needle_of_the_same_tip_meets_more_everywhere) {
  const TissueLibrary library = io::default_tissue_library();
  for (const TissueProperties& tissue : library.tissues()) {
    if (!is_described(tissue.physical)) continue;
    for (int gauge = 10; gauge < 34; ++gauge) {
      const Needle thick = gauge_needle(gauge, NeedleTip::quincke),
                   thin = gauge_needle(gauge + 1, NeedleTip::quincke);
      EXPECT_GE(puncture_force(tissue.physical, thick), puncture_force(tissue.physical, thin)) << tissue.name;
      EXPECT_GT(friction_per_length(tissue.physical, thick), friction_per_length(tissue.physical, thin));
    }
  }
}

TEST(NeedleLaw, a_tip_without_an_edge_needs_eight_percent_more_than_a_cutting_one_in_skin) {
  // Maloney et al., human skin, taper against reverse cutting: 1.0/0.95, 0.74/0.60 and 0.48/0.51 N.
  const double measured = (1.0 / 0.95 + 0.74 / 0.60 + 0.48 / 0.51) / 3.0;
  EXPECT_NEAR(tip_factor({.tip = NeedleTip::conical}) / tip_factor({.tip = NeedleTip::quincke}), measured, 0.05);
  EXPECT_DOUBLE_EQ(tip_factor({.tip = NeedleTip::quincke}), 1.0);
  EXPECT_GT(tip_factor({.bevel_angle = 40.0}), tip_factor({.bevel_angle = 20.0})) << "a blunter bevel spreads more";
}

TEST(NeedleLaw, friction_is_that_of_the_measured_needle_in_liver) {
  const TissueLibrary library = io::default_tissue_library();  // Okamura et al. 2004: 11.96 and 18.45 N/m at 1.27 mm
  const PhysicalTissue& liver = described(library, tissue::organ);
  EXPECT_NEAR(friction_per_length(liver, {.outer_diameter = 1.27}), 0.01196, 0.0003);
  EXPECT_NEAR(friction_per_length(liver, {.outer_diameter = 1.27}) * liver.static_ratio, 0.01845, 0.0005);
}

TEST(NeedleLaw, every_model_gives_way_at_the_same_force) {
  for (const Needle& needle : {gauge_needle(16, NeedleTip::tuohy), gauge_needle(22, NeedleTip::quincke)}) {
    const Case patient = patient_with_needle(needle);
    const TissueLibrary felt = effective_tissues(patient);
    for (const TissueProperties& tissue : felt.tissues()) {
      const double force = puncture_force(tissue.physical, needle);
      if (!(force > 0.0)) continue;
      EXPECT_DOUBLE_EQ(tissue.layered.break_force, force) << tissue.name;
      EXPECT_DOUBLE_EQ(tissue.tracking_wall.force, force) << tissue.name;
      EXPECT_DOUBLE_EQ(tissue.volume_proxy.properties.penetrability, force) << tissue.name;
      EXPECT_DOUBLE_EQ(tissue.deformable.puncture_force, force) << tissue.name;
      EXPECT_DOUBLE_EQ(tissue.layered.dynamic_friction, tissue.shaft_friction.coulomb) << tissue.name;
      EXPECT_DOUBLE_EQ(tissue.deformable.friction, tissue.shaft_friction.coulomb) << tissue.name;
    }
  }
}

// Barnett et al. 2015: 61 % of the force tears, 18 % spreads; a Tuohy needle's blunter bevel spreads more.
TEST(NeedleLaw, the_ligamentum_flavum_alone_is_cut_on_with_what_tears) {
  const double tears = 0.61, spreads = 0.18;
  const double bevel = std::tan(30.0 * std::numbers::pi / 180.0) / std::tan(20.0 * std::numbers::pi / 180.0);
  const std::vector<std::pair<Needle, double>> expected = {
      {gauge_needle(22, NeedleTip::quincke), tears / (tears + spreads)},
      {gauge_needle(27, NeedleTip::quincke), tears / (tears + spreads)},
      {gauge_needle(18, NeedleTip::tuohy), tears / (tears + bevel * spreads)}};
  for (const auto& [needle, share] : expected) {
    const TissueLibrary felt = effective_tissues(patient_with_needle(needle));
    for (const TissueProperties& tissue : felt.tissues()) {
      const double force = cutting_force(tissue.physical, needle);
      const bool is_flavum = tissue.id == tissue::ligamentum_flavum;
      EXPECT_NEAR(force, is_flavum ? share * puncture_force(tissue.physical, needle) : 0.0, 0.02) << tissue.name;
      if (is_described(tissue.physical)) {
        EXPECT_DOUBLE_EQ(tissue.deformable.cutting_force, force) << tissue.name;
      }
    }
  }
}

TEST(NeedleLaw, the_layered_law_passes_through_the_puncture_force_at_the_dimpling) {
  const Needle needle = gauge_needle(22, NeedleTip::quincke);
  const TissueLibrary felt = effective_tissues(patient_with_needle(needle));
  const TissueProperties& dura = *felt.find(tissue::dura);
  const double dx = dura.layered.element_spacing, a = dura.physical.dimpling / dx;
  EXPECT_NEAR(dura.layered.stiffness * dx * a * (a + 1.0) * (a + 2.0) / 6.0, dura.layered.break_force, 1e-9);
}

TEST(NeedleLaw, tables_and_tissues_without_a_description_are_left_as_they_are) {
  Case patient = patient_with_needle(gauge_needle(14, NeedleTip::tuohy));
  const TissueLibrary felt = effective_tissues(patient);
  EXPECT_TRUE(same_parameters(felt.find(tissue::cortical_bone)->layered,
                              patient.library.find(tissue::cortical_bone)->layered));
  patient.description.haptics.mechanics = Mechanics::tables;
  const TissueLibrary same = effective_tissues(patient);
  for (const TissueProperties& tissue : same.tissues())
    EXPECT_TRUE(same_parameters(tissue, *patient.library.find(tissue.id))) << tissue.name;
  EXPECT_DOUBLE_EQ(felt_settings(FractureSettings{}, patient).width, FractureSettings{}.width);
}

TEST(NeedleLaw, models_of_one_membrane_take_the_skin) {
  const Case patient = patient_with_needle(gauge_needle(18, NeedleTip::tuohy));
  const double skin = puncture_force(described(patient.library, tissue::skin), patient.description.needle);
  EXPECT_DOUBLE_EQ(felt_settings(ThreeComponentSettings{}, patient).puncture_force, skin);
  const DepthProfileSettings profile = felt_settings(DepthProfileSettings{}, patient);
  EXPECT_NEAR(profile.skin_stiffness * profile.puncture_depth, skin, 1e-9);
  EXPECT_DOUBLE_EQ(felt_settings(FractureSettings{}, patient).width, 1.27);
}

}  // namespace
}  // namespace bodkin
