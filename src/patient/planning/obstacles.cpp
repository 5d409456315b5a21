#include "patient/planning/obstacles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "patient/planning/clearance.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::patient {
namespace {

constexpr double wall = 10.0;            // mm about a lesion, searched for the organ around it
constexpr double level_reach = 25.0;     // mm along the spine from the middle of an interspace
constexpr double usual_vertebra = 34.0;  // mm with its disc, if only one interspace is known
constexpr std::array<const char*, 4> safe_levels = {"L2_L3", "L3_L4", "L4_L5", "L5_S1"};

// The structure around a point, from 26 rays, each ending at the first structure of `guarded`: the most frequent one,
// if met by at least half of the rays.
template <typename Voxel>
std::optional<Voxel> holder(const anatomy::Volume<Voxel>& volume, const Vec3& point, const std::set<Voxel>& guarded) {
  std::map<Voxel, int> met;
  for (int way = 0; way < 27; ++way) {
    const int across = way % 3, along = way / 3 % 3, up = way / 9;
    const Vec3 direction(across - 1, along - 1, up - 1);
    if (direction.isZero()) continue;
    for (double far = 0.5; far <= 6.0 * wall; far += 0.5) {
      const Voxel here = anatomy::nearest(volume, Vec3(point + far * direction.normalized()), Voxel{0});
      if (!guarded.contains(here)) continue;
      ++met[here];
      break;
    }
  }
  const auto most = std::max_element(met.begin(), met.end(), [](auto& a, auto& b) { return a.second < b.second; });
  if (most == met.end() || most->second < 13) return std::nullopt;
  return most->first;
}

bool is_interspace(const anatomy::Landmark& landmark) {
  const std::string& name = landmark.name;
  const auto is_vertebra = [](const std::string& part) {
    return part.size() >= 2 && part.size() <= 3 && (part[0] == 'T' || part[0] == 'L' || part[0] == 'S') &&
           std::all_of(part.begin() + 1, part.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  const std::size_t between = name.find('_');
  return between != std::string::npos && is_vertebra(name.substr(0, between)) &&
         is_vertebra(name.substr(between + 1));
}

const anatomy::Landmark* nearest_level(const PatientView& patient, const Vec3& target) {
  const anatomy::Landmark* nearest = nullptr;
  for (const anatomy::Landmark& each : patient.landmarks) {
    if (!is_interspace(each)) continue;
    if (nearest == nullptr || std::abs(each.position.z() - target.z()) < std::abs(nearest->position.z() - target.z()))
      nearest = &each;
  }
  return nearest;
}

// mm from one interspace to the next.
double vertebra_of(const PatientView& patient) {
  std::vector<double> heights;
  for (const anatomy::Landmark& each : patient.landmarks)
    if (is_interspace(each)) heights.push_back(each.position.z());
  std::sort(heights.begin(), heights.end());
  double least = usual_vertebra;
  for (std::size_t i = 1; i < heights.size(); ++i) least = std::min(least, heights[i] - heights[i - 1]);
  return least;
}

// Marks the voxels: the kind (1 + position, 0 none) of each tissue and each label.
struct Marking {
  std::array<std::uint8_t, 256> of_tissue{};
  std::vector<std::uint8_t> of_label = std::vector<std::uint8_t>(65536, 0);
  std::vector<bool> is_host = std::vector<bool>(65536, false);
};

void mark(const PatientView& patient, const Marking& marking, anatomy::Volume<std::uint8_t>& at) {
  const anatomy::Grid& grid = at.grid;
  const bool labelled = !patient.structures.empty();
  Vec3 start = Vec3::Zero(), step = Vec3::Zero();
  std::size_t voxel = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      if (labelled) {
        start = patient.structures.grid.to_index(grid.to_patient(Vec3(0, j, k)));
        step = patient.structures.grid.to_index(grid.to_patient(Vec3(1, j, k))) - start;
      }
      for (int i = 0; i < grid.size[0]; ++i, ++voxel) {
        const anatomy::TissueId tissue = patient.tissues.voxels[voxel];
        if (tissue == anatomy::tissue::air) continue;
        std::uint8_t kind = marking.of_tissue[tissue];
        const bool is_bone = kind == 1, is_cord = tissue == anatomy::tissue::spinal_cord;
        if (labelled && !is_bone && !is_cord) {
          const std::uint16_t label =
              anatomy::nearest_at_index(patient.structures, Vec3(start + i * step), std::uint16_t{0});
          if (marking.is_host[label]) kind = 0;
          if (marking.of_label[label] != 0) kind = marking.of_label[label];
        }
        at.voxels[voxel] = kind;
      }
    }
  }
}

}  // namespace

PatientView view_of(const anatomy::Case& patient) {
  return {patient.tissues, patient.structures, patient.description.structures, patient.description.landmarks,
          patient.library};
}

std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

Obstacles find_obstacles(const PatientView& patient, const PlanningRules& rules, const Vec3& target) {
  Obstacles found;
  Marking marking;
  const anatomy::TissueId at_target = anatomy::nearest(patient.tissues, target, anatomy::tissue::air);
  const std::uint16_t label_at_target =
      patient.structures.empty() ? std::uint16_t{0} : anatomy::nearest(patient.structures, target, std::uint16_t{0});
  const auto add = [&found](Obstacle kind) {
    if (found.kinds.size() >= 254) throw InputError("a plan can keep away from at most 254 tissues and structures");
    found.kinds.push_back(std::move(kind));
    return static_cast<std::uint8_t>(found.kinds.size());
  };
  const std::uint8_t bone = add({"bone", "bone", rules.bone_margin});
  for (const anatomy::TissueId id :
       {anatomy::tissue::cortical_bone, anatomy::tissue::cancellous_bone, anatomy::tissue::metal})
    marking.of_tissue[id] = bone;

  // Structures: by rule, or because the case says so. One kind each.
  std::set<std::uint16_t> guarded;
  const auto rule_about = [&rules](const std::string& name) {
    return std::find_if(rules.avoid.begin(), rules.avoid.end(),
                        [&](const AvoidRule& rule) { return !rule.structure.empty() && rule.structure == name; });
  };
  for (const anatomy::Structure& each : patient.table)
    if (each.critical || rule_about(each.name) != rules.avoid.end()) guarded.insert(each.label);
  std::optional<std::uint16_t> host;
  const bool in_lesion =
      at_target == anatomy::tissue::mass || (label_at_target != 0 && !guarded.contains(label_at_target));
  if (guarded.contains(label_at_target)) host = label_at_target;
  if (!host && in_lesion && !patient.structures.empty()) host = holder(patient.structures, target, guarded);
  if (host) marking.is_host[*host] = true;
  for (const anatomy::Structure& each : patient.table) {
    if (!guarded.contains(each.label) || each.label == host) continue;
    const auto rule = rule_about(each.name);
    const double margin = rule != rules.avoid.end() && rule->margin > 0.0 ? rule->margin : rules.margin;
    marking.of_label[each.label] = add({each.name, spoken(each.name), margin});
  }

  // Tissues.
  std::set<anatomy::TissueId> forbidden;
  for (const AvoidRule& rule : rules.avoid) {
    if (rule.tissue.empty()) continue;
    const anatomy::TissueProperties* tissue = patient.library.find(rule.tissue);
    if (tissue == nullptr) {
      throw InputError(fmt::format(
          "the procedure forbids the tissue '{}', which the tissue library of the case does not have", rule.tissue));
    }
    forbidden.insert(tissue->id);
  }
  std::optional<anatomy::TissueId> around;
  if (at_target == anatomy::tissue::mass) around = holder(patient.tissues, target, forbidden);
  bool has_cord = false;
  for (const AvoidRule& rule : rules.avoid) {
    if (rule.tissue.empty()) continue;
    const anatomy::TissueProperties& tissue = *patient.library.find(rule.tissue);
    const bool is_cord = tissue.id == anatomy::tissue::spinal_cord;
    has_cord = has_cord || is_cord;
    if (!is_cord && (tissue.id == at_target || around == tissue.id)) continue;
    double margin = rule.margin > 0.0 ? rule.margin : rules.margin;
    if (is_cord) margin = std::max(margin, rules.cord_margin);
    marking.of_tissue[tissue.id] = add({tissue.name, tissue.title, margin});
  }
  if (!has_cord) {
    marking.of_tissue[anatomy::tissue::spinal_cord] =
        add({"spinal_cord", patient.library.title(anatomy::tissue::spinal_cord), rules.cord_margin});
  }

  found.at = anatomy::Volume<std::uint8_t>(patient.tissues.grid);
  mark(patient, marking, found.at);
  // A margin is limited to the target's own distance from the obstacle, except the cord's.
  double widest = 0.0;
  for (const Obstacle& kind : found.kinds) widest = std::max(widest, kind.margin);
  for (const Clearance& each : clearances(found, {target, target}, widest)) {
    Obstacle& kind = found.kinds[each.kind];
    if (kind.name != "spinal_cord") kind.margin = std::min(kind.margin, std::max(0.0, each.distance - 0.1));
  }
  return found;
}

std::string level_at(const PatientView& patient, const Vec3& target) {
  const anatomy::Landmark* nearest = nearest_level(patient, target);
  if (nearest == nullptr || std::abs(nearest->position.z() - target.z()) > level_reach) return "";
  return nearest->name;
}

std::optional<std::string> level_problem(const PatientView& patient, const PlanningRules& rules, const Vec3& target) {
  if (rules.levels.empty()) return std::nullopt;
  const std::string level = level_at(patient, target);
  if (level.empty()) return "the interspace there has no known name";
  std::string level_name = level;
  std::replace(level_name.begin(), level_name.end(), '_', '/');
  const auto is = [&level](const std::string& name) { return name == level; };
  if (std::none_of(rules.levels.begin(), rules.levels.end(), is))
    return fmt::format("{} is not a level of this procedure", level_name);
  if (std::none_of(safe_levels.begin(), safe_levels.end(), is))
    return fmt::format("{} lies above L2/L3, where the cord may be met", level_name);
  const double vertebra = vertebra_of(patient);
  for (const anatomy::Landmark& each : patient.landmarks) {
    if (each.name != "conus") continue;
    const double below = each.position.z() - nearest_level(patient, target)->position.z();
    if (below < vertebra - 1.0)
      return fmt::format("the cord ends {:.0f} mm above {}, which is less than a vertebra", below, level_name);
  }
  return std::nullopt;
}

std::vector<anatomy::Landmark> allowed_levels(const PatientView& patient, const PlanningRules& rules) {
  std::vector<anatomy::Landmark> found;
  if (rules.levels.empty()) return found;
  for (const anatomy::Landmark& each : patient.landmarks)
    if (is_interspace(each) && !level_problem(patient, rules, each.position)) found.push_back(each);
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.position.z() > b.position.z(); });
  return found;
}

}  // namespace bodkin::patient
