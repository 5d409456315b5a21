#include "views/open_case.h"

#include <algorithm>
#include <cctype>

namespace bodkin::views {

std::string readable_structure(const std::string& name) {
  std::string text = name;
  if (text.starts_with("vertebrae_")) text.replace(0, 10, "vertebra ");
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string readable_procedure(const std::string& name) {
  std::string text = name;
  std::replace(text.begin(), text.end(), '_', ' ');
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::string place_name(const anatomy::Case& patient, const Vec3& point) {
  const anatomy::TissueId tissue = anatomy::nearest(patient.tissues, point, anatomy::tissue::air);
  const std::string title = patient.library.title(tissue);
  // A label covers the whole contents of the canal; the tissue tells cord and roots apart.
  const bool is_nervous = tissue == anatomy::tissue::nerve || tissue == anatomy::tissue::spinal_cord;
  if (patient.structures.empty() || is_nervous) return title;
  const std::uint16_t label = anatomy::nearest(patient.structures, point, std::uint16_t{0});
  for (const anatomy::Structure& structure : patient.description.structures) {
    if (structure.label == label && label != 0) return readable_structure(structure.name);
  }
  return title;
}

}  // namespace bodkin::views
