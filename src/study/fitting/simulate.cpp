#include "study/fitting/simulate.h"

#include <fmt/format.h>

namespace bodkin::study {

io::XmlElement numbers_element(const std::string& name,
                               std::initializer_list<std::pair<const char*, double>> numbers) {
  io::XmlElement element;
  element.name = name;
  for (const auto& [attribute, value] : numbers) element.attributes.emplace_back(attribute, fmt::format("{}", value));
  return element;
}

}  // namespace bodkin::study
