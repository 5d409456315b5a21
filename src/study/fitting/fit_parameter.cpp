#include "study/fitting/fit_parameter.h"

namespace bodkin::study {

std::string name_without_unit(std::string_view name, std::string_view unit) {
  if (unit.empty()) return std::string(name);
  std::string ending = "_";
  for (const char letter : unit) {
    if (letter == '/') {
      ending += "_per_";
    } else if (letter == ' ') {
      ending += '_';
    } else if (letter != '^') {
      ending += letter;
    }
  }
  if (name.ends_with(ending)) name.remove_suffix(ending.size());
  return std::string(name);
}

}  // namespace bodkin::study
