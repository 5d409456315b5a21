#include "patient/from_ct/path_planner.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "patient/from_ct/hounsfield_classes.h"
#include "patient/from_ct/lumbar_construction.h"

namespace bodkin::patient {
namespace {

constexpr double enough = 2.5;  // mm of room to bone that a planned path should leave
constexpr double step = 0.5;    // mm between looks along a path
constexpr std::array<const char*, 3> preferred = {"L3_L4", "L4_L5", "L2_L3"};

// What a path crosses; nothing when it meets bone.
struct Crossing {
  double room = 1e3;      // mm, the least distance to bone
  double ligament = 0.0;  // mm in the supraspinous and interspinous ligaments: how well it keeps to the midline
};

std::optional<Crossing> crossing_along(const anatomy::TissueVolume& tissues, const anatomy::Volume<float>& distance,
                                       const anatomy::NeedlePath& path) {
  Crossing crossing;
  const Vec3 along = path.direction();
  for (double depth = 0.0; depth <= path.length(); depth += step) {
    const Vec3 p = path.entry + depth * along;
    const anatomy::TissueId here = anatomy::nearest(tissues, p, anatomy::tissue::air);
    if (is_bone(here)) return std::nullopt;
    if (here == anatomy::tissue::supraspinous_ligament || here == anatomy::tissue::interspinous_ligament)
      crossing.ligament += step;
    crossing.room = std::min(crossing.room, anatomy::linear(distance, p, 1e3));
  }
  return crossing;
}

}  // namespace

SkinPoint skin_along(const anatomy::TissueVolume& tissues, const Vec3& inside, const Vec3& direction) {
  constexpr double fine = 0.1;
  constexpr anatomy::TissueId outside = 255;
  Vec3 last = inside;
  for (double distance = fine; distance < 400.0; distance += fine) {
    const Vec3 p = inside + distance * direction;
    const anatomy::TissueId here = anatomy::nearest(tissues, p, outside);
    if (here == anatomy::tissue::air) return {last, true};
    if (here == outside) return {last, false};
    last = p;
  }
  return {last, false};
}

std::vector<PlannedPath> plan_paths(const anatomy::TissueVolume& tissues, const SpineView& view,
                                    const LumbarSpine& spine) {
  std::vector<PlannedPath> found;
  if (spine.interspaces.empty()) return found;
  const anatomy::Volume<float> distance = signed_distance(view.bone);
  for (const Interspace& gap : spine.interspaces) {
    std::optional<PlannedPath> best;
    double most = -1e9;
    for (double z = gap.middle() - 4.0; z <= gap.middle() + 10.0; z += 2.0) {
      if (!spine.canal.covers(z)) continue;
      const Vec3 target = sac_centre(spine, z);
      for (double up = 0.0; up <= 24.0; up += 2.0) {
        for (double aside = -4.0; aside <= 4.0; aside += 2.0) {
          const Vec3 outwards(std::sin(aside * degree), std::cos(aside * degree) * std::cos(up * degree),
                              -std::cos(aside * degree) * std::sin(up * degree));
          const SkinPoint skin = skin_along(tissues, target, outwards);
          const anatomy::NeedlePath path{skin.point, target};
          const auto crossing = crossing_along(tissues, distance, path);
          if (!crossing) continue;
          // Room up to 5 mm counts, 8 mm of ligament as much as 1 mm of room; then a slight cephalad tilt is usual.
          const double score = std::min(crossing->room, 5.0) + std::min(crossing->ligament, 30.0) / 8.0 -
                               0.03 * std::abs(up - 8.0) - 0.1 * std::abs(aside);
          if (score <= most) continue;
          most = score;
          best = PlannedPath{gap.name, path, crossing->room, up, skin.skin};
        }
      }
    }
    if (best) found.push_back(*best);
  }
  return found;
}

std::vector<PlannedPath> passed_over(const std::vector<PlannedPath>& paths, const PlannedPath& taken) {
  std::vector<PlannedPath> narrow;
  for (const char* name : preferred) {
    if (taken.interspace == name) break;
    const auto found =
        std::find_if(paths.begin(), paths.end(), [&](const PlannedPath& p) { return p.interspace == name; });
    if (found != paths.end()) narrow.push_back(*found);
  }
  return narrow;
}

std::optional<PlannedPath> best_path(const std::vector<PlannedPath>& paths) {
  for (const char* name : preferred) {
    const auto found =
        std::find_if(paths.begin(), paths.end(), [&](const PlannedPath& p) { return p.interspace == name; });
    if (found != paths.end() && found->clearance >= enough) return *found;
  }
  const auto roomiest = std::max_element(paths.begin(), paths.end(), [](const PlannedPath& a, const PlannedPath& b) {
    return a.clearance < b.clearance;
  });
  return roomiest == paths.end() ? std::nullopt : std::optional(*roomiest);
}

}  // namespace bodkin::patient
