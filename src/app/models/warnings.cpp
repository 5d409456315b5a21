#include "app/models/warnings.h"

#include "views/open_case.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr double beside_bone = 2.0;  // mm around the tip, searched for the bone that it touches

// The labelled structure at a point; null: none.
const anatomy::Structure* structure_at(const anatomy::Case& patient, const Vec3& point) {
  if (patient.structures.empty()) return nullptr;
  const std::uint16_t label = anatomy::nearest(patient.structures, point, std::uint16_t{0});
  if (label == 0) return nullptr;
  for (const anatomy::Structure& structure : patient.description.structures) {
    if (structure.label == label) return &structure;
  }
  return nullptr;
}

bool is_bone(anatomy::TissueId tissue) {
  return tissue == anatomy::tissue::cortical_bone || tissue == anatomy::tissue::cancellous_bone;
}

// The name of the bone at or next to the tip; empty: it has none.
std::string bone_near(const anatomy::Case& patient, const Vec3& tip) {
  for (const double reach : {0.0, 0.5 * beside_bone, beside_bone}) {
    for (int side = 0; side < 6; ++side) {
      Vec3 way = Vec3::Zero();
      way[side / 2] = side % 2 == 0 ? reach : -reach;
      const Vec3 point = tip + way;
      if (!is_bone(anatomy::nearest(patient.tissues, point, anatomy::tissue::air))) continue;
      if (const anatomy::Structure* structure = structure_at(patient, point))
        return readable_structure(structure->name);
    }
  }
  return "";
}

std::string with_name(const char* what, const anatomy::Structure* structure, const std::string& otherwise) {
  const std::string name = structure == nullptr ? otherwise : readable_structure(structure->name);
  return name.empty() || name == what ? std::string(what) : std::string(what) + ": " + name;
}

}  // namespace

std::optional<Warning> warning_at(const anatomy::Case& patient, const Vec3& tip, anatomy::TissueId tissue,
                                  bool is_on_bone) {
  const anatomy::TissueProperties* const target = patient.library.find(patient.description.procedure.target_tissue);
  const anatomy::Structure* const structure = structure_at(patient, tip);
  const std::string title = patient.library.title(tissue);
  if (target != nullptr && target->id == tissue && !is_on_bone) return std::nullopt;
  if (tissue == anatomy::tissue::spinal_cord) {
    return Warning{Warning::Kind::nerve, "Spinal cord", "Stop and draw back at once, and go in two levels lower."};
  }
  if (tissue == anatomy::tissue::nerve) {
    return Warning{Warning::Kind::nerve, with_name("Nerve", nullptr, title),
                   "Stop and draw back at once: the patient feels a shock along the nerve."};
  }
  if (tissue == anatomy::tissue::vessel) {
    return Warning{Warning::Kind::vessel, with_name("Vessel", structure, title),
                   "Draw back to the skin and press on the place before you go in again."};
  }
  const bool in_critical = structure != nullptr && structure->critical && !is_bone(tissue);
  if (tissue == anatomy::tissue::organ || tissue == anatomy::tissue::lung || in_critical) {
    return Warning{Warning::Kind::organ, with_name("Organ", structure, title),
                   "Draw back to the skin and choose another way in."};
  }
  if (is_on_bone || is_bone(tissue)) {
    const std::string name = bone_near(patient, tip);
    return Warning{Warning::Kind::bone, name.empty() ? "Bone" : "Bone: " + name,
                   "Draw back to just under the skin, change the angle, go in again."};
  }
  return std::nullopt;
}

}  // namespace bodkin::app
