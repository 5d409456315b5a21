#include "study/fitting/fit_parameter.h"

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "study/fitting/fit_model.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "anatomy/resistance_settings.h"
#include "anatomy/tissue_forces.h"
#include "io/settings_xml.h"

namespace bodkin::study {
namespace {

using namespace bodkin::anatomy;
using ::testing::UnorderedElementsAre;

struct Declared {
  Range range;
  std::string unit;
  double usual = 0.0;
};

// The parameters declared in a model's tables, by the name used in a fit.
using Tables = std::multimap<std::string, Declared>;

template <typename Settings>
Tables rows_of(const Settings& settings, const std::string& suffix = "") {
  Tables rows;
  for_each_parameter(
      [&](const auto& parameter, const auto& value) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) {
          rows.emplace(std::string(name_without_unit(parameter.name, parameter.unit)) + suffix,
                       Declared{parameter.range, std::string(parameter.unit), value});
        }
      },
      settings);
  return rows;
}

Tables together(std::initializer_list<Tables> tables) {
  Tables all;
  for (const Tables& one : tables) all.insert(one.begin(), one.end());
  return all;
}

Tables tables_of(std::string_view model) {
  if (model == "spring_damper_wall") return rows_of(SpringDamperWallSettings());
  if (model == "tracking_wall") return together({rows_of(TrackingWallSettings()), rows_of(TrackingWallTissue())});
  if (model == "depth_profile") return together({rows_of(DepthProfileSettings()), rows_of(DepthProfileTissue())});
  if (model == "layered") return rows_of(LayeredTissue());
  if (model == "fracture") return rows_of(FractureSettings());
  if (model == "shaft_friction") return together({rows_of(ShaftFrictionSettings()), rows_of(ShaftFrictionTissue())});
  const ThreeComponentSettings three;
  return together({rows_of(three), rows_of(three.inwards, "_inwards"), rows_of(three.outwards, "_outwards")});
}

std::vector<FitModel> stacks() {
  std::vector<FitModel> found;
  const std::vector<double> tops = {0.0, 2.0, 5.0};
  for (const FitModel& model : fit_models())
    if (model.stack != nullptr) found.push_back(fit_stack(model.name, tops));
  return found;
}

TEST(FitParameter, its_unit_is_the_declared_one_and_its_range_lies_in_the_declared_one) {
  for (const FitModel& model : fit_models()) {
    const Tables tables = tables_of(model.name);
    for (const FitParameter& one : model.parameters) {
      SCOPED_TRACE(std::string(model.name) + " " + one.name);
      if (one.name == "contact" || one.name == "static_ratio") continue;  // in no table
      ASSERT_EQ(tables.count(one.name), 1U);
      const Declared& declared = tables.find(one.name)->second;
      EXPECT_EQ(one.unit, declared.unit);
      EXPECT_TRUE(declared.range.contains(one.low));
      EXPECT_TRUE(declared.range.contains(one.high));
      EXPECT_TRUE(one.low <= one.usual && one.usual <= one.high);
    }
  }
}

// Each exception has a comment at its parameter that states why a fit searches less than the model allows.
TEST(FitParameter, its_range_and_its_usual_value_are_the_declared_ones_but_for_these) {
  std::set<std::string> ranges, values;
  for (const FitModel& model : fit_models()) {
    const Tables tables = tables_of(model.name);
    for (const FitParameter& one : model.parameters) {
      const auto found = tables.find(one.name);
      if (found == tables.end()) continue;
      const Declared& declared = found->second;
      if (one.low != declared.range.low || one.high != declared.range.high)
        ranges.insert(std::string(model.name) + " " + one.name);
      if (one.usual != declared.usual) values.insert(std::string(model.name) + " " + one.name);
    }
  }
  EXPECT_THAT(ranges, UnorderedElementsAre("tracking_wall catch_up", "layered stiffness", "layered break_force",
                                           "layered shaft_stiffness", "layered dynamic_friction"));
  EXPECT_THAT(values,
              UnorderedElementsAre("tracking_wall force", "layered stiffness", "layered break_force",
                                   "layered shaft_stiffness", "layered dynamic_friction", "layered viscosity",
                                   "shaft_friction coulomb", "shaft_friction static", "shaft_friction viscous"));
}

TEST(FitParameter, a_layer_of_a_stack_has_the_range_of_one_tissue) {
  for (const FitModel& model : stacks()) {
    const FitModel& one_tissue = fit_model(model.name);
    for (const FitParameter& one : model.parameters) {
      SCOPED_TRACE(std::string(model.name) + " " + one.name);
      const std::string name = one.name.substr(0, one.name.find_last_not_of("_0123456789") + 1);
      for (const FitParameter& other : one_tissue.parameters) {
        if (other.name != name) continue;
        EXPECT_EQ(one.unit, other.unit);
        EXPECT_EQ(one.low, other.low);
        EXPECT_EQ(one.high, other.high);
        EXPECT_EQ(one.usual, other.usual);
      }
    }
  }
}

// Throws InputError unless the table of the element accepts it.
void read(const io::XmlElement& element, bool is_of_a_tissue) {
  const SettingsTree tree = io::tree_of(element);
  if (element.name == "layered") {
    settings_from<LayeredTissue>(tree, "fit");
  } else if (element.name == "spring_damper_wall") {
    settings_from<SpringDamperWallSettings>(tree, "fit");
  } else if (element.name == "three_component") {
    settings_from<ThreeComponentSettings>(tree, "fit");
  } else if (element.name == "fracture") {
    settings_from<FractureSettings>(tree, "fit");
  } else if (element.name == "tracking_wall") {
    is_of_a_tissue ? void(settings_from<TrackingWallTissue>(tree, "fit"))
                   : void(settings_from<TrackingWallSettings>(tree, "fit"));
  } else if (element.name == "depth_profile") {
    is_of_a_tissue ? void(settings_from<DepthProfileTissue>(tree, "fit"))
                   : void(settings_from<DepthProfileSettings>(tree, "fit"));
  } else {
    ASSERT_EQ(element.name, "shaft_friction");
    is_of_a_tissue ? void(settings_from<ShaftFrictionTissue>(tree, "fit"))
                   : void(settings_from<ShaftFrictionSettings>(tree, "fit"));
  }
}

TEST(FitParameter, whatever_a_fit_finds_a_tissue_library_and_a_case_take) {
  std::vector<FitModel> models = fit_models();
  for (FitModel& model : stacks()) models.push_back(std::move(model));
  const std::vector<std::function<double(const FitParameter&)>> corners = {
      [](const FitParameter& one) { return one.low; }, [](const FitParameter& one) { return one.high; },
      [](const FitParameter& one) { return one.usual; }};
  for (const FitModel& model : models) {
    for (const auto& value : corners) {
      std::vector<double> values;
      for (const FitParameter& one : model.parameters)
        values.push_back(one.name.starts_with("from_") ? one.usual : value(one));
      const FittedElements elements = model.elements(values);
      for (const io::XmlElement& tissue : elements.tissues) EXPECT_NO_THROW(read(tissue, true)) << model.name;
      if (elements.resistance) {
        EXPECT_NO_THROW(read(*elements.resistance, false)) << model.name;
      }
    }
  }
}

}  // namespace
}  // namespace bodkin::study
