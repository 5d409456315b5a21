#include "app/models/model_draft.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files.h"
#include "io/tissue_library_file.h"
#include "io/xml_document.h"

namespace bodkin::app {

namespace {

constexpr const char* draft_name = "models.draft.json";

// Calls visit(step's index) for each number of the model: of the wizard's eleven steps one is not a model number, the
// weight of the stylus.
template <typename Visit>
void for_each_number(ParameterModel& model, const Visit& visit) {
  const bool showed_all = model.shows_all();
  for (const bool all : {false, true}) {
    model.show_all(all);
    for (std::size_t step = 0; step < model.steps().size(); ++step) visit(step);
  }
  model.show_all(showed_all);
}

nlohmann::json key_of(const SettingStep& step) {
  return {static_cast<int>(step.place), step.tissue, step.name};
}

}  // namespace

void keep_model_draft(ParameterModel& model, const std::filesystem::path& folder) {
  if (!model.is_changed()) {
    std::error_code ignored;
    std::filesystem::remove(folder / draft_name, ignored);
    return;
  }
  // A model other than the patient's original one has no previous values.
  const bool is_own = model.model() == anatomy::name_of(model.reference().haptics.resistance);
  nlohmann::json numbers = nlohmann::json::array();
  for_each_number(model, [&](std::size_t step) {
    const bool may_be_default = is_own || model.steps()[step].place == forces::ModelPart::tissue;
    if (may_be_default && model.value(step) == model.before(step)) return;
    nlohmann::json number = {{"of", key_of(model.steps()[step])}, {"value", model.value(step)}};
    if (std::find(numbers.begin(), numbers.end(), number) == numbers.end()) numbers.push_back(std::move(number));
  });
  nlohmann::json draft = {{"model", model.model()}, {"numbers", std::move(numbers)}};
  // Tissues of a loaded file may lie off the planned path, where no step sets their numbers.
  if (const anatomy::TissueLibrary changed = model.changed_tissues(); !changed.tissues().empty())
    draft["tissues"] = io::tissue_library_xml(changed);
  write_file(folder / draft_name, draft.dump(1) + "\n");
}

bool take_model_draft(ParameterModel& model, const std::filesystem::path& folder) {
  std::ifstream stream(folder / draft_name);
  if (!stream) return false;
  nlohmann::json numbers;
  try {
    const nlohmann::json draft = nlohmann::json::parse(stream);
    numbers = draft.at("numbers");
    for (const nlohmann::json& number : numbers) {  // throws if one is invalid
      number.at("of");
      number.at("value").get<double>();
    }
    std::optional<anatomy::TissueLibrary> tissues;
    if (draft.contains("tissues"))
      tissues =
          io::parse_tissue_library(draft["tissues"].get<std::string>(), draft_name, io::XmlSchema("tissues.xsd"));
    model.choose_model(draft.at("model").get<std::string>());
    if (tissues) model.take(*tissues, true);
  } catch (const nlohmann::json::exception&) {
    return false;
  } catch (const InputError&) {  // a model of another version
    return false;
  }
  const auto take = [&](std::size_t step) {
    const nlohmann::json key = key_of(model.steps()[step]);
    for (const nlohmann::json& number : numbers)
      if (number["of"] == key) model.set(step, number["value"].get<double>(), true);
  };
  for_each_number(model, take);
  for_each_number(model, take);  // value permitted only with a certain value of another number
  return model.is_changed();
}

}  // namespace bodkin::app
