#include "patient/from_ct/path_planner.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "patient/from_ct/hounsfield_classes.h"
#include "patient/from_ct/lumbar_construction.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::patient {
namespace {

constexpr double enough = 2.5;         // mm of distance to bone that a planned path should keep
constexpr double path_step = 0.5;      // mm between samples of a path
constexpr double clear_of_cord = 5.0;  // mm beyond the target that must also be free of cord
constexpr std::array<const char*, 3> preferred = {"L3_L4", "L4_L5", "L2_L3"};

// The tissues on a path; empty if it meets bone.
struct Crossing {
  double room = 1e3;      // mm, the least distance to bone
  double ligament = 0.0;  // mm in the supraspinous and interspinous ligaments: measure of keeping to the midline
};

std::optional<Crossing> crossing_along(const anatomy::TissueVolume& tissues, const anatomy::Volume<float>& distance,
                                       const anatomy::NeedlePath& path) {
  Crossing crossing;
  const Vec3 along = path.direction();
  for (double depth = 0.0; depth <= path.length(); depth += path_step) {
    const Vec3 p = path.entry + depth * along;
    const anatomy::TissueId here = anatomy::nearest(tissues, p, anatomy::tissue::air);
    if (is_bone(here)) return std::nullopt;
    if (here == anatomy::tissue::supraspinous_ligament || here == anatomy::tissue::interspinous_ligament)
      crossing.ligament += path_step;
    crossing.room = std::min(crossing.room, anatomy::linear(distance, p, 1e3));
  }
  if (depth_of_cord(tissues, path, clear_of_cord)) return std::nullopt;
  return crossing;
}

const PlannedPath* path_at(const std::vector<PlannedPath>& paths, std::string_view name) {
  const auto found =
      std::find_if(paths.begin(), paths.end(), [&](const PlannedPath& path) { return path.interspace == name; });
  return found == paths.end() ? nullptr : &*found;
}

std::string names_of(const LumbarSpine& spine) {
  std::string text;
  for (const Interspace& gap : spine.interspaces) text += (text.empty() ? "" : ", ") + gap.name;
  return text;
}

// How the user can state the levels, as the end of a sentence.
std::string level_advice(const LumbarSpine& spine) {
  return fmt::format("say with --lowest-vertebra which vertebra lies above the lowest interspace, at z = {:.0f}",
                     spine.interspaces.back().middle());
}

// The path at an interspace that the user named.
PlannedPath path_at_level(const std::vector<PlannedPath>& paths, const LumbarSpine& spine, const std::string& level) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("--level is {}, where no path can be planned: {}", level, why));
  };
  if (!spine.levels.known()) refuse(fmt::format("{}; {}", spine.levels.evidence, level_advice(spine)));
  const auto gap = std::find_if(spine.interspaces.begin(), spine.interspaces.end(),
                                [&](const Interspace& one) { return one.name == level; });
  if (gap == spine.interspaces.end()) refuse(fmt::format("the interspaces found are {}", names_of(spine)));
  if (gap->cut) refuse("the image border cuts one of its vertebrae");
  const PlannedPath* path = path_at(paths, level);
  if (path == nullptr) {
    refuse(fmt::format("no straight path there stays clear of bone and of the spinal cord, which ends at the {}",
                       describe_place(spine.conus_place)));
  }
  return *path;
}

}  // namespace

std::optional<double> depth_of_cord(const anatomy::TissueVolume& tissues, const anatomy::NeedlePath& path,
                                    double beyond) {
  constexpr double fine = 0.25;
  const Vec3 along = path.direction();
  for (double depth = 0.0; depth <= path.length() + beyond; depth += fine) {
    if (anatomy::nearest(tissues, Vec3(path.entry + depth * along), anatomy::tissue::air) ==
        anatomy::tissue::spinal_cord)
      return depth;
  }
  return std::nullopt;
}

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

PathChoice choose_path(const std::vector<PlannedPath>& paths, const LumbarSpine& spine, const std::string& level,
                       std::span<const std::string> allowed_levels) {
  if (!level.empty()) return {path_at_level(paths, spine, level), {}, ""};
  if (!spine.levels.known()) {
    return {std::nullopt,
            {},
            fmt::format("the levels are not known: {}; {}", spine.levels.evidence, level_advice(spine))};
  }
  std::vector<PlannedPath> allowed;
  bool low_enough = false, permitted = false, whole = false;
  for (const Interspace& gap : spine.interspaces) {
    if (!gap.place || !may_plan_at(*gap.place, spine.conus_place)) continue;
    low_enough = true;
    if (!allowed_levels.empty() &&
        std::find(allowed_levels.begin(), allowed_levels.end(), gap.name) == allowed_levels.end())
      continue;
    permitted = true;
    if (gap.cut) continue;
    whole = true;
    if (const PlannedPath* path = path_at(paths, gap.name)) allowed.push_back(*path);
  }
  PathChoice choice;
  for (const char* name : preferred) {
    const PlannedPath* path = path_at(allowed, name);
    if (path == nullptr) continue;
    if (path->clearance >= enough) {
      choice.path = *path;
      return choice;
    }
    choice.passed_over.push_back(*path);
  }
  const auto widest_path =
      std::max_element(allowed.begin(), allowed.end(),
                       [](const PlannedPath& a, const PlannedPath& b) { return a.clearance < b.clearance; });
  if (widest_path != allowed.end()) {
    choice.path = *widest_path;
    std::erase_if(choice.passed_over, [&](const PlannedPath& p) { return p.interspace == widest_path->interspace; });
    return choice;
  }
  choice.passed_over.clear();
  choice.why_not =
      !low_enough ? fmt::format(
                        "no interspace here lies at L2/L3 or below and a whole vertebra below the cord, "
                        "which ends at the {}; name one with --level to plan there anyway",
                        describe_place(spine.conus_place))
      : !permitted ? "the procedure allows none of the interspaces from L2/L3 down that were found; name one with "
                     "--level to plan there anyway"
      : !whole     ? "the image border cuts a vertebra of every interspace that comes into question"
                   : "no straight path through an interspace that comes into question stays clear of bone";
  return choice;
}

}  // namespace bodkin::patient
