#include "study/fitting/fit_model.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::study {

const std::vector<FitModel>& fit_models() {
  static const std::vector<FitModel> models = {
      spring_damper_wall_fit(), tracking_wall_fit(), depth_profile_fit(), layered_fit(),
      three_component_fit(),    fracture_fit(),      shaft_friction_fit()};
  return models;
}

const FitModel& fit_model(std::string_view name) {
  const auto& models = fit_models();
  const auto found = std::find_if(models.begin(), models.end(), [&](const FitModel& m) { return m.name == name; });
  if (found != models.end()) return *found;
  std::string names;
  for (const FitModel& model : models) names += fmt::format("{}{}", names.empty() ? "" : ", ", model.name);
  throw InputError(fmt::format("the model is {}, expected one of {}", io::in_quotes(name), names));
}

}  // namespace bodkin::study
