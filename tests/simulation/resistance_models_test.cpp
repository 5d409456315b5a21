#include "simulation/resistance_models.h"

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

#include "tests/simulation/model_pairs.h"
#include "tests/simulation/slab_patient.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::simulation;
namespace {

struct DragSettings {
  double force = 0.4;

  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"force_N", &DragSettings::force, Range{0.0, 5.0}, "N", "against every motion", Origin::choice}};
  }
};

// A model of somebody else: the same force against every motion.
class Drag : public ResistanceDefaults {
 public:
  using Settings = DragSettings;
  static constexpr ResistanceTraits traits = {.name = "test_drag", .diagnostics = {{{"ticks", "ticks in tissue"}}}};

  Drag(const Case&, const DragSettings& settings, double) : force_(settings.force) {}
  void begin(const Vec3&, const Vec3&) noexcept { ticks_ = 0.0; }
  ResistanceForce step(const NeedleInTissue& needle, TickEvents&) noexcept {
    ticks_ += 1.0;
    return {.along = needle.motion.direction * force_, .in_contact = needle.motion.depth > 0.0};
  }
  void reset() noexcept { ticks_ = 0.0; }
  ModelDiagnostics diagnostics() const noexcept { return {ticks_}; }

 private:
  double force_;
  double ticks_ = 0.0;
};

TEST(ResistanceModels, each_has_a_name_of_its_own_and_diagnostics_that_fit) {
  std::vector<std::string> names;
  for (const ResistanceEntry& entry : resistance_models()) {
    names.emplace_back(entry.traits.name);
    EXPECT_LE(count_of(entry.traits.diagnostics), most_model_diagnostics);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
  EXPECT_EQ(names.size(), resistance_names.size() - 1) << "all but `registered`";
}

TEST(ResistanceModels, the_suites_of_all_models_know_each) {
  std::set<std::string_view> tested;
  for (const NamedResistance& resistance : all_resistances()) tested.insert(name_of(resistance.settings));
  for (const ResistanceEntry& entry : resistance_models())
    EXPECT_TRUE(tested.contains(entry.traits.name)) << "add it to tests/simulation/model_pairs.h";
}

TEST(ResistanceModels, one_that_a_program_registers_runs_by_its_name_with_its_settings) {
  Case patient = slab_patient();
  patient.description.haptics.resistance =
      RegisteredSettings{.name = "test_drag", .values = {{"force_N", "0.7"}}, .children = {}};
  EXPECT_THROW(HapticTick{patient}, InputError) << "nobody has registered it yet";
  register_resistance<Drag>();
  EXPECT_THROW(register_resistance<Drag>(), InputError) << "the name is taken";
  HapticTick haptics(patient);
  ASSERT_EQ(haptics.diagnostic_names().size(), 1U);
  EXPECT_EQ(haptics.diagnostic_names()[0].name, "ticks");
  TickOutput output;
  for (double depth = -2.0; depth < 10.0; depth += 0.02) output = haptics.step(needle_at(depth));
  EXPECT_DOUBLE_EQ(output.resistance, 0.7);
  EXPECT_GT(output.diagnostics[0], 400.0);
  auto& chosen = std::get<RegisteredSettings>(patient.description.haptics.resistance);
  chosen.values[0].second = "9";
  EXPECT_THROW(HapticTick{patient}, InputError) << "out of its range";
  chosen.values[0].first = "weight_N";
  EXPECT_THROW(HapticTick{patient}, InputError) << "a setting that it does not have";
}

}  // namespace
}  // namespace bodkin
