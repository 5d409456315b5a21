#include "views/open_case.h"

#include <algorithm>

namespace bodkin::views {

std::string readable_structure(const std::string& name) {
  std::string text = name;
  if (text.starts_with("vertebrae_")) text.replace(0, 10, "vertebra ");
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string place_name(const anatomy::Case& patient, const Vec3& point) {
  const anatomy::TissueId tissue = anatomy::nearest(patient.tissues, point, anatomy::tissue::air);
  std::string title = patient.library.title(tissue);
  if (patient.structures.empty()) return title;
  const std::uint16_t label = anatomy::nearest(patient.structures, point, std::uint16_t{0});
  for (const anatomy::Structure& structure : patient.description.structures) {
    if (structure.label != label || label == 0) continue;
    // A label named spinal_cord covers the whole canal; the tissue distinguishes fluid, roots and cord.
    const bool is_canal = structure.name == "spinal_cord" || structure.tissue == "spinal_canal";
    const bool is_nervous = tissue == anatomy::tissue::nerve || tissue == anatomy::tissue::spinal_cord;
    return is_canal || is_nervous ? title : readable_structure(structure.name);
  }
  return title;
}

std::string place_name(const anatomy::Case& patient, const Vec3& point, const Vec3& inwards,
                       anatomy::TissueId tissue) {
  constexpr double step = 0.5, farthest = 3.0;  // mm
  for (double back = 0.0; back <= farthest; back += step) {
    const Vec3 place = point - back * inwards;
    if (anatomy::nearest(patient.tissues, place, anatomy::tissue::air) == tissue) return place_name(patient, place);
  }
  return patient.library.title(tissue);
}

}  // namespace bodkin::views
