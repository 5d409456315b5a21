#include "training/thresholds.h"

namespace bodkin::training {

std::vector<std::pair<std::string_view, double>> own_thresholds(const Thresholds& thresholds) {
  std::vector<std::pair<std::string_view, double>> own;
  for_each_parameter(
      [&](const auto& parameter, double value, double usual) {
        if (value != usual) own.emplace_back(parameter.name, value);
      },
      thresholds, Thresholds());
  return own;
}

}  // namespace bodkin::training
