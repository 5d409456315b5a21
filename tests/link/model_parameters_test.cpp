// Parameters of force models by name, as read and set by clients.
#include "link/model_parameters.h"

#include "tests/session/slab_case.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/settings_tree.h"

namespace bodkin::link {
namespace {

using ::testing::HasSubstr;

forces::ModelSettings lumbar() {
  return forces::model_settings(slab_case(lumbar_slabs()));
}

std::string refusal(const std::string& part, const std::string& name, const std::string& text) {
  forces::ModelSettings settings = lumbar();
  const std::string before = parameters_json(settings, "skin");
  try {
    set_parameter(settings, part, name, text);
  } catch (const InputError& error) {
    EXPECT_EQ(parameters_json(settings, "skin"), before) << "what is refused changes nothing";
    return error.what();
  }
  return "set";
}

TEST(ModelParameters, of_a_part_are_those_that_its_file_has) {
  const forces::ModelSettings settings = lumbar();
  const anatomy::TissueLibrary library(settings.tissues);
  const anatomy::TissueProperties& skin = *library.find("skin");
  ASSERT_EQ(anatomy::name_of(settings.haptics.resistance), "layered");
  const SettingsTree file = settings_tree("layered", skin.layered);
  const auto& stated = file.children.empty() ? file.values : file.children.front().values;
  const auto json = nlohmann::json::parse(parameters_json(settings, "skin"));
  EXPECT_THAT(json.at("parts"), ::testing::Contains("compensation"));
  ASSERT_EQ(json.at("parameters").size(), stated.size());
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const auto& one = json.at("parameters").at(i);
    EXPECT_EQ(one.at("name"), stated[i].first);
    if (!one.at("value").is_number()) continue;
    double value = 0.0;
    ASSERT_TRUE(parse_number(stated[i].second, value));
    EXPECT_EQ(one.at("value").get<double>(), value);
    EXPECT_TRUE(one.contains("unit"));
    EXPECT_FALSE(one.at("description").get<std::string>().empty());
  }
}

TEST(ModelParameters, one_is_set_and_nothing_else) {
  forces::ModelSettings settings = lumbar(), expected = settings;
  for (anatomy::TissueProperties& tissue : expected.tissues) {
    if (tissue.name == "skin") tissue.layered.break_force *= 0.5;
  }
  double wanted = 0.0;
  for (const anatomy::TissueProperties& tissue : expected.tissues) {
    if (tissue.name == "skin") wanted = tissue.layered.break_force;
  }
  Command command{.name = "SetModelParameter",
                  .values = {{"Part", "skin"}, {"Parameter", "break_force_N"}, {"Value", number_text(wanted)}}};
  EXPECT_THAT(set_parameter(settings, command), HasSubstr("break_force_N of skin is"));
  for (std::size_t i = 0; i < settings.tissues.size(); ++i)
    EXPECT_TRUE(same_parameters(settings.tissues[i], expected.tissues[i])) << settings.tissues[i].name;
  command.values.erase("Value");
  EXPECT_THROW(set_parameter(settings, command), InputError);
}

TEST(ModelParameters, that_cannot_be_are_refused_with_what_is_expected) {
  EXPECT_THAT(refusal("skin", "break_force_N", "-1"), HasSubstr("break_force_N is -1 N, expected"));
  EXPECT_THAT(refusal("skin", "break_force_N", "NAN"), HasSubstr("'NAN', expected a number"));
  EXPECT_THAT(refusal("skin", "break_force_N", "much"), HasSubstr("'much', expected a number"));
  EXPECT_THAT(refusal("skin", "colour", "1"), HasSubstr("skin has no parameter 'colour' for layered"));
  EXPECT_THAT(refusal("soul", "break_force_N", "1"), HasSubstr("Part is 'soul', expected one of resistance"));
  EXPECT_THAT(refusal("compensation", "up_x", "1"), HasSubstr("no parameter 'up_x'"));
}

}  // namespace
}  // namespace bodkin::link
