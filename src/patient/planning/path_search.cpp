#include "patient/planning/path_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stop_token>

#include <fmt/format.h>

#include "anatomy/label_distance.h"
#include "core/error.h"
#include "core/parallel_for.h"

namespace bodkin::patient {
namespace {

constexpr double hub_room = 5.0;     // mm of the needle that stay outside
constexpr double enough_room = 8.0;  // mm beyond the margins; more is not better
constexpr double cost_of_length = 0.05, cost_of_oblique = 0.02, cost_of_lateral = 0.03;  // mm of room per mm, degree
constexpr std::size_t coarse = 1500, fine = 6000;  // directions over the whole sphere, 5 and 2.5 degrees apart
constexpr std::size_t refined = 12;                // good directions around which the search is refined
constexpr std::size_t most_why = 3;                // reasons that are reported

struct Candidate {
  anatomy::NeedlePath path;
  Room room;
  double score = 0.0;
};

enum class Refusal : std::uint8_t { none, no_skin, too_long, flat, blocked, close };

struct Look {
  Candidate candidate;
  Refusal refusal = Refusal::none;
};

// Directions spread evenly over the sphere, those in the cone.
std::vector<Vec3> directions(std::size_t count, const PathCriteria& criteria) {
  std::vector<Vec3> found;
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  const double least = criteria.outwards.isZero() ? -2.0 : std::cos(criteria.cone * degree);
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
    const double radius = std::sqrt(1.0 - z * z), turn = golden * static_cast<double>(i);
    const Vec3 direction(radius * std::cos(turn), radius * std::sin(turn), z);
    if (criteria.outwards.isZero() || direction.dot(criteria.outwards) >= least) found.push_back(direction);
  }
  return found;
}

// Around one direction, 1 degree apart, 3 degrees to each side.
void add_about(const Vec3& direction, std::vector<Vec3>& found) {
  const Vec3 u = direction.unitOrthogonal(), v = direction.cross(u);
  for (int a = -3; a <= 3; ++a) {
    for (int b = -3; b <= 3; ++b) {
      if (a == 0 && b == 0) continue;
      found.push_back((direction + std::tan(a * degree) * u + std::tan(b * degree) * v).normalized());
    }
  }
}

class Searcher {
 public:
  Searcher(const PatientView& patient, const Obstacles& obstacles, const Vec3& target, const PathCriteria& criteria,
           std::stop_token stop)
      : patient_(patient), obstacles_(obstacles), target_(target), criteria_(criteria), stop_(std::move(stop)) {}

  std::vector<Look> look_along(const std::vector<Vec3>& ways) const {
    std::vector<Look> looks(ways.size());
    parallel_for(ways.size(), [&](std::size_t i) {
      if (!stop_.stop_requested()) looks[i] = look(ways[i]);
    });
    if (stop_.stop_requested()) std::erase_if(looks, [](const Look& one) { return one.candidate.score == 0.0; });
    return looks;
  }

 private:
  Look look(const Vec3& outwards) const {
    Look found;
    const std::optional<Vec3> skin = find_skin_exit(patient_.tissues, target_, outwards, criteria_.longest + 0.5);
    found.candidate.path = {skin.value_or(target_), target_};
    if (!skin) {
      const Vec3 end = target_ + (criteria_.longest + 0.5) * outwards;
      constexpr anatomy::TissueId outside = 255;
      found.refusal =
          anatomy::nearest(patient_.tissues, end, outside) == outside ? Refusal::no_skin : Refusal::too_long;
      return found;
    }
    const std::optional<Vec3> normal = skin_normal(patient_.tissues, *skin);
    const double oblique =
        normal ? std::acos(std::clamp(normal->dot(outwards), -1.0, 1.0)) / degree : criteria_.flattest + 1.0;
    if (oblique > criteria_.flattest) {
      found.refusal = Refusal::flat;
      return found;
    }
    Candidate& candidate = found.candidate;
    candidate.room = clearance_along(obstacles_, candidate.path, enough_room);
    if (candidate.room.blocked || candidate.room.spare < 0.0) {
      found.refusal = candidate.room.blocked ? Refusal::blocked : Refusal::close;
      return found;
    }
    const double lateral = std::asin(std::min(1.0, std::abs(outwards.x()))) / degree;
    candidate.score = std::min(candidate.room.spare, enough_room) - cost_of_length * candidate.path.length() -
                      cost_of_oblique * std::max(0.0, oblique - 15.0) -
                      (criteria_.outwards.isZero() ? 0.0 : cost_of_lateral * lateral);
    return found;
  }

  const PatientView& patient_;
  const Obstacles& obstacles_;
  const Vec3& target_;
  const PathCriteria& criteria_;
  std::stop_token stop_;
};

std::vector<Candidate> open_ones(const std::vector<Look>& looks) {
  std::vector<Candidate> open;
  for (const Look& one : looks)
    if (one.refusal == Refusal::none) open.push_back(one.candidate);
  std::stable_sort(open.begin(), open.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  return open;
}

// The best ones at least so many degrees apart.
std::vector<Candidate> thinned(const std::vector<Candidate>& ranked, double apart, std::size_t count) {
  std::vector<Candidate> kept;
  const double most = std::cos(apart * degree);
  for (const Candidate& one : ranked) {
    if (kept.size() == count) break;
    const auto is_near = [&](const Candidate& other) {
      return one.path.direction().dot(other.path.direction()) > most;
    };
    if (std::none_of(kept.begin(), kept.end(), is_near)) kept.push_back(one);
  }
  return kept;
}

std::string reasons(const std::vector<Look>& looks, const Obstacles& obstacles, const PathCriteria& criteria) {
  std::vector<std::size_t> into(obstacles.kinds.size(), 0), close(obstacles.kinds.size(), 0);
  std::size_t cut = 0, far = 0, flat = 0;
  for (const Look& one : looks) {
    const std::size_t kind = one.candidate.room.kind;
    cut += one.refusal == Refusal::no_skin ? 1U : 0U;
    far += one.refusal == Refusal::too_long ? 1U : 0U;
    flat += one.refusal == Refusal::flat ? 1U : 0U;
    into[kind] += one.refusal == Refusal::blocked ? 1U : 0U;
    close[kind] += one.refusal == Refusal::close ? 1U : 0U;
  }
  std::vector<std::pair<std::size_t, std::string>> counted;
  counted.emplace_back(cut, "leave the image before the skin");
  counted.emplace_back(far, fmt::format("are longer than the {:.0f} mm that the needle reaches", criteria.longest));
  counted.emplace_back(flat, fmt::format("are flatter than {:.0f} degrees to the skin", 90.0 - criteria.flattest));
  for (std::size_t kind = 0; kind < obstacles.kinds.size(); ++kind) {
    const Obstacle& obstacle = obstacles.kinds[kind];
    counted.emplace_back(into[kind], fmt::format("go into {}", obstacle.title));
    counted.emplace_back(close[kind],
                         fmt::format("come closer than {:.1f} mm to {}", obstacle.margin, obstacle.title));
  }
  std::stable_sort(counted.begin(), counted.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text;
  for (std::size_t i = 0; i < most_why && counted[i].first > 0; ++i)
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", counted[i].first, counted[i].second);
  return text;
}

}  // namespace

PathCriteria criteria_for(const anatomy::Needle& needle, const PlanningRules& rules) {
  PathCriteria criteria;
  criteria.longest = std::max(1.0, needle.length - hub_room);
  if (!rules.levels.empty()) {
    criteria.outwards = Vec3::UnitY();
    criteria.cone = 40.0;
  }
  return criteria;
}

std::optional<Vec3> find_skin_exit(const anatomy::TissueVolume& tissues, const Vec3& inside, const Vec3& direction,
                                   double reach) {
  constexpr double step = 0.5, small = 0.1;  // mm
  constexpr anatomy::TissueId outside = 255;
  for (double far = 0.0; far <= reach; far += step) {
    const anatomy::TissueId here = anatomy::nearest(tissues, Vec3(inside + far * direction), outside);
    if (here == outside) return std::nullopt;
    if (here != anatomy::tissue::air) continue;
    if (far == 0.0) return std::nullopt;
    double last = far - step;
    while (anatomy::nearest(tissues, Vec3(inside + (last + small) * direction), outside) != anatomy::tissue::air)
      last += small;
    return inside + last * direction;
  }
  return std::nullopt;
}

std::optional<Vec3> skin_normal(const anatomy::TissueVolume& tissues, const Vec3& point) {
  constexpr double reach = 4.0;  // mm
  Vec3 sum = Vec3::Zero();
  for (const Vec3& way : directions(60, {})) {
    const anatomy::TissueId there = anatomy::nearest(tissues, Vec3(point + reach * way), anatomy::tissue::air);
    if (there == anatomy::tissue::air) sum += way;
  }
  if (sum.norm() < 1.0) return std::nullopt;
  return sum.normalized();
}

PathSearch search_paths(const PatientView& patient, const Obstacles& obstacles, const Vec3& target,
                        const PathCriteria& criteria, const std::stop_token& stop) {
  PathSearch search;
  const anatomy::TissueId at_target = anatomy::nearest(patient.tissues, target, anatomy::tissue::air);
  if (at_target == anatomy::tissue::air) {
    search.why_not = "The target does not lie in the body.";
    return search;
  }
  if (const std::uint8_t mark = anatomy::nearest(obstacles.at, target, std::uint8_t{0}); mark != 0) {
    search.why_not = fmt::format("The target lies in {}, which the needle must not enter.",
                                 obstacles.kinds[static_cast<std::size_t>(mark - 1)].title);
    return search;
  }
  const Searcher searcher(patient, obstacles, target, criteria, stop);
  std::vector<Look> looks = searcher.look_along(directions(coarse, criteria));
  std::vector<Candidate> open = open_ones(looks);
  if (open.empty() && !stop.stop_requested()) {
    looks = searcher.look_along(directions(fine, criteria));
    open = open_ones(looks);
  }
  search.looked_at = looks.size();
  if (open.empty()) {
    search.why_not = fmt::format("No straight path leads there: of {} directions tried, {}.", looks.size(),
                                 reasons(looks, obstacles, criteria));
    return search;
  }
  std::vector<Vec3> closer;
  for (const Candidate& one : thinned(open, 0.5 * criteria.apart, refined)) add_about(-one.path.direction(), closer);
  const double least = criteria.outwards.isZero() ? -2.0 : std::cos(criteria.cone * degree);
  std::erase_if(closer,
                [&](const Vec3& way) { return !criteria.outwards.isZero() && way.dot(criteria.outwards) < least; });
  std::vector<Look> more = searcher.look_along(closer);
  search.looked_at += more.size();
  for (Candidate& one : open_ones(more)) open.push_back(one);
  std::stable_sort(open.begin(), open.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  for (const Candidate& one : thinned(open, criteria.apart, criteria.count))
    search.proposals.push_back(report_on(patient, obstacles, one.path));
  return search;
}

Vec3 target_in_structure(const PatientView& patient, const std::string& name) {
  std::string names;
  std::optional<std::uint16_t> label;
  for (const anatomy::Structure& each : patient.table) {
    if (each.name == name) label = each.label;
    names += (names.empty() ? "" : ", ") + each.name;
  }
  if (!label) {
    throw InputError(fmt::format("the target is the structure '{}', which this patient does not have; expected {}",
                                 name, names.empty() ? "a point x,y,z: there is no segmentation" : names));
  }
  const anatomy::LabelVolume& labels = patient.structures;
  const anatomy::Grid& grid = labels.grid;
  Vec3 sum = Vec3::Zero();
  double count = 0.0;
  std::array<int, 3> low = grid.size, high = {0, 0, 0};
  std::size_t voxel = 0;
  for (int k = 0; k < (labels.empty() ? 0 : grid.size[2]); ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i, ++voxel) {
        if (labels.voxels[voxel] != *label) continue;
        sum += Vec3(i, j, k);
        count += 1.0;
        low = {std::min(low[0], i), std::min(low[1], j), std::min(low[2], k)};
        high = {std::max(high[0], i), std::max(high[1], j), std::max(high[2], k)};
      }
    }
  }
  if (count == 0.0) {
    throw InputError(
        fmt::format("the target is the structure '{}', which has no voxel here; expected one of {}", name, names));
  }
  Vec3 centre = grid.to_patient(sum / count);
  if (anatomy::nearest(labels, centre, std::uint16_t{0}) == *label) return centre;
  // The deepest voxel; the box has a border of one foreign voxel.
  anatomy::Grid box = grid;
  for (std::size_t axis = 0; axis < 3; ++axis) box.size[axis] = high[axis] - low[axis] + 3;
  anatomy::Volume<std::uint8_t> inside(box, 0);
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int i = low[0]; i <= high[0]; ++i)
        inside.at(i - low[0] + 1, j - low[1] + 1, k - low[2] + 1) = labels.at(i, j, k) == *label ? 1 : 0;
    }
  }
  std::vector<float> depth = anatomy::distance_to_other_label(inside);
  for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = inside.voxels[i] == 0 ? 0.0F : depth[i];
  const auto deepest = static_cast<int>(std::max_element(depth.begin(), depth.end()) - depth.begin());
  const int i = deepest % box.size[0], j = deepest / box.size[0] % box.size[1],
            k = deepest / (box.size[0] * box.size[1]);
  return grid.to_patient(Vec3(i + low[0] - 1, j + low[1] - 1, k + low[2] - 1));
}

}  // namespace bodkin::patient
