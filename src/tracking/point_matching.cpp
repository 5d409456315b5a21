#include <algorithm>
#include <cmath>

#include "tracking/registration.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::tracking {

namespace {

using Assignment = std::vector<std::optional<std::size_t>>;

struct Proposal {
  Assignment pairs;
  std::size_t count = 0;
  double fre = 1e9;
};

// Mutual nearest neighbours of fixed and moving points within reach.
Assignment nearest_pairs(const Similarity& placed, const std::vector<Vec3>& fixed, const std::vector<Vec3>& moving,
                         double within) {
  const auto nearest = [&](const Vec3& to, const auto& distance_to, std::size_t count) {
    std::optional<std::size_t> best;
    double least = within;
    for (std::size_t i = 0; i < count; ++i) {
      const double distance = distance_to(i, to);
      if (distance < least) {
        least = distance;
        best = i;
      }
    }
    return best;
  };
  const auto of_moving = [&](std::size_t i, const Vec3& to) { return (placed * moving[i] - to).norm(); };
  const auto of_fixed = [&](std::size_t i, const Vec3& to) { return (fixed[i] - to).norm(); };
  Assignment pairs(fixed.size());
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    const std::optional<std::size_t> partner = nearest(fixed[i], of_moving, moving.size());
    if (partner && nearest(placed * moving[*partner], of_fixed, fixed.size()) == i) pairs[i] = partner;
  }
  return pairs;
}

// Refuses a set that cannot be matched, before comparing its points with others.
void require_a_triangle(const std::vector<Vec3>& points, const char* set) {
  if (points.size() < 3) {
    throw InputError(fmt::format(
        "registration: the number of {} points is {}, expected at least 3 to pair them by their distances", set,
        points.size()));
  }
  if (on_a_line(points)) {
    throw InputError(
        fmt::format("registration: the {} points lie on a line, so the rotation about it is undetermined; add a "
                    "point off that line",
                    set));
  }
}

// The placement by all of these pairs; false if they lie on a line or are too few.
bool place_pairs(const Assignment& pairs, const std::vector<Vec3>& fixed, const std::vector<Vec3>& moving,
                 Proposal& made, Similarity& placed) {
  std::vector<Vec3> from, to;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!pairs[i]) continue;
    to.push_back(fixed[i]);
    from.push_back(moving[*pairs[i]]);
  }
  if (to.size() < 3 || on_a_line(to) || on_a_line(from)) return false;
  const Registration registration = register_points(to, from, false);
  placed = registration.fixed_from_moving;
  made = {pairs, to.size(), registration.fre_rms};
  return true;
}

}  // namespace

PointMatch match_points(const std::vector<Vec3>& fixed, const std::vector<Vec3>& moving, double tolerance) {
  require_a_triangle(fixed, "fixed");
  require_a_triangle(moving, "moving");
  std::vector<Proposal> proposals;
  bool alike_on_a_line = false;
  const std::size_t k = fixed.size(), m = moving.size();
  for (std::size_t a = 0; a < k; ++a) {
    for (std::size_t b = a + 1; b < k; ++b) {
      for (std::size_t c = b + 1; c < k; ++c) {
        const double ab = (fixed[a] - fixed[b]).norm(), bc = (fixed[b] - fixed[c]).norm(),
                     ca = (fixed[c] - fixed[a]).norm();
        for (std::size_t i = 0; i < m; ++i) {
          for (std::size_t j = 0; j < m; ++j) {
            if (j == i || std::abs((moving[i] - moving[j]).norm() - ab) > tolerance) continue;
            for (std::size_t l = 0; l < m; ++l) {
              if (l == i || l == j || std::abs((moving[j] - moving[l]).norm() - bc) > tolerance ||
                  std::abs((moving[l] - moving[i]).norm() - ca) > tolerance) {
                continue;
              }
              // A placement that already contains this triple would be found again.
              const bool held = std::any_of(proposals.begin(), proposals.end(), [&](const Proposal& other) {
                return other.pairs[a] == i && other.pairs[b] == j && other.pairs[c] == l;
              });
              if (held) continue;
              Assignment pairs(k);
              pairs[a] = i;
              pairs[b] = j;
              pairs[c] = l;
              Proposal made;
              Similarity placed;
              // From a triple, then twice from all nearby points.
              if (!place_pairs(pairs, fixed, moving, made, placed)) {
                alike_on_a_line = true;
                continue;
              }
              for (int turn = 0; turn < 2; ++turn) {
                const Assignment wider = nearest_pairs(placed, fixed, moving, 2.0 * tolerance);
                if (!place_pairs(wider, fixed, moving, made, placed)) break;
              }
              if (made.fre > tolerance) continue;
              const bool known = std::any_of(proposals.begin(), proposals.end(),
                                             [&](const Proposal& other) { return other.pairs == made.pairs; });
              if (!known) proposals.push_back(made);
            }
          }
        }
      }
    }
  }
  if (proposals.empty() && alike_on_a_line) {
    throw InputError(
        "registration: the points that match in both sets are on a line, so the rotation about it is undetermined; "
        "check that a point off that line is in both sets");
  }
  if (proposals.empty()) {
    throw InputError(
        "registration: no three points of one set have the same distances as three of the other; check that both "
        "show the same fiducials, in mm");
  }
  // An additional point counts more than a better fit.
  const auto better = [](const Proposal& one, const Proposal& other) {
    return one.count != other.count ? one.count > other.count : one.fre < other.fre;
  };
  std::sort(proposals.begin(), proposals.end(), better);
  PointMatch match;
  match.moving_of_fixed = proposals.front().pairs;
  match.fre_rms = proposals.front().fre;
  // An equally large assignment that contradicts this one and fits within the localisation errors.
  for (std::size_t i = 1; i < proposals.size(); ++i) {
    const Proposal& other = proposals[i];
    if (other.count < proposals.front().count) break;
    if (other.fre < 3.0 * std::max(match.fre_rms, tolerance / 6.0)) match.ambiguous = true;
  }
  if (proposals.front().count == 3 && proposals.size() > 1) {
    match.ambiguous = match.ambiguous || proposals[1].fre < tolerance;
  }
  return match;
}

}  // namespace bodkin::tracking
