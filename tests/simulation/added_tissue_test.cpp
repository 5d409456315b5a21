// The example of CONTRIBUTING.md: a tissue added to a copy of Bodkin's library is felt by the needle.
#include <string>
#include <vector>

#include "tests/simulation/slab_patient.h"
#include <gtest/gtest.h>

#include "io/resources.h"
#include "io/tissue_library_file.h"
#include "io/xml_document.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::io;
using namespace bodkin::simulation;
namespace {

// A contributor writes only the numbers for a model. In a model without numbers the tissue does not resist.
constexpr const char* gelatine = R"(
  <tissue id="32" name="gelatine" title="gelatine" colour="#A1B2C3" hounsfield_HU="20" hounsfield_noise_HU="5">
    <layered>
      <viscoelastic stiffness_N_per_mm="0.05" viscosity_N_s_per_mm="0.001" element_spacing_mm="1" break_force_N="2"
                    shaft_stiffness_N_per_mm2="0.02" shaft_spacing_mm="0.5" static_friction_N_per_mm="0.024"
                    dynamic_friction_N_per_mm="0.02"/>
    </layered>
    <source>Bodkin default.</source>
  </tissue>
)";

TissueLibrary library_with_gelatine() {
  std::string document = read_text_file(shared_file("tissues.xml"), 1'000'000);
  document.insert(document.rfind("</tissue_library>"), gelatine);
  return parse_tissue_library(document, "tissues.xml", XmlSchema("tissues.xsd"));
}

TEST(AddedTissue, is_punctured_at_its_own_force) {
  Case patient = slab_patient(std::vector<TissueId>(80, TissueId{32}));
  patient.library = library_with_gelatine();
  HapticTick tick(patient);

  std::vector<Event> punctures;
  for (double depth = -5.0; depth < 30.0; depth += 0.01) {  // 10 mm/s
    const TickOutput output = tick.step(needle_at(depth));
    for (const Event& event : output.events) {
      if (event.kind == EventKind::puncture) punctures.push_back(event);
    }
  }

  ASSERT_EQ(punctures.size(), 1U);
  EXPECT_EQ(punctures[0].tissue, TissueId{32});
  EXPECT_NEAR(punctures[0].value, 2.0, 0.05);  // N, break_force_N; the force may exceed it within one tick
}

}  // namespace
}  // namespace bodkin
