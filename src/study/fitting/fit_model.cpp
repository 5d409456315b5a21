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

FitModel fit_stack(std::string_view name, std::span<const double> tops) {
  constexpr std::size_t most = 30;
  const FitModel& one_tissue = fit_model(name);
  if (one_tissue.stack == nullptr) {
    std::string names;
    for (const FitModel& model : fit_models())
      if (model.stack != nullptr) names += fmt::format("{}{}", names.empty() ? "" : ", ", model.name);
    throw InputError(
        fmt::format("--layers is for one of {}, not {}, which has one tissue and no layers", names, name));
  }
  if (tops.front() != 0.0)
    throw InputError(fmt::format("--layers begins at {:g} mm, expected 0, the skin, first", tops.front()));
  for (std::size_t i = 1; i < tops.size(); ++i) {
    if (!(tops[i] > tops[i - 1] && tops[i] <= deepest_layer))
      throw InputError(fmt::format("--layers has {:g} mm after {:g}, expected depths that rise, at most {:g}",
                                   tops[i], tops[i - 1], deepest_layer));
  }
  if (tops.size() > most)
    throw InputError(fmt::format("--layers has {} depths, expected at most {}", tops.size(), most));
  return one_tissue.stack(tops);
}

}  // namespace bodkin::study
