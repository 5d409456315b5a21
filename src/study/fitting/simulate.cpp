#include "study/fitting/simulate.h"

#include <algorithm>

#include <fmt/format.h>

#include "forces/voigt_law.h"

namespace bodkin::study {

io::XmlElement numbers_element(const std::string& name,
                               std::initializer_list<std::pair<const char*, double>> numbers) {
  io::XmlElement element;
  element.name = name;
  for (const auto& [attribute, value] : numbers) element.attributes.emplace_back(attribute, fmt::format("{}", value));
  return element;
}

double cubic_per_stiffness(double spacing, double depth) {
  return forces::VoigtLaw(forces::VoigtSum::cubic, 1.0, 0.0, spacing).elastic(std::max(depth, 0.01));
}

void add_for_layers(FitModel& model, std::size_t layers, const FitParameter& one) {
  for (std::size_t i = 0; i < layers; ++i) {
    model.parameters.push_back(one);
    model.parameters.back().name = fmt::format("{}_{}", one.name, i + 1);
  }
}

void add_tops(FitModel& model, std::span<const double> tops) {
  constexpr double deepest = 500.0;  // mm
  for (std::size_t i = 0; i < tops.size(); ++i)
    model.parameters.push_back({fmt::format("from_{}", i + 1), "mm", 0.0, deepest, tops[i], false});
}

}  // namespace bodkin::study
