#include "tracking/point_pairs.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::tracking {

namespace {

// The moving point for each fixed one.
std::vector<std::optional<std::size_t>> partners_of(const NamedPoints& fixed, const NamedPoints& moving,
                                                    PairedBy paired_by) {
  if (paired_by == PairedBy::distance) {
    PointMatch match = match_points(fixed.points, moving.points);
    if (match.ambiguous) {
      throw InputError(
          "the points can be paired in more than one way that fits; move one of them so that their distances differ, "
          "or "
          "give them names");
    }
    return std::move(match.moving_of_fixed);
  }
  std::vector<std::optional<std::size_t>> partners(fixed.points.size());
  if (!fixed.names.empty() && !moving.names.empty()) {
    for (std::size_t i = 0; i < fixed.names.size(); ++i) {
      const auto partner = std::find(moving.names.begin(), moving.names.end(), fixed.names[i]);
      if (partner != moving.names.end()) partners[i] = static_cast<std::size_t>(partner - moving.names.begin());
    }
    return partners;
  }
  if (fixed.points.size() != moving.points.size()) {
    throw InputError(fmt::format(
        "registration: {} fixed and {} moving points, which are paired by their order; give both names, or "
        "--match to pair them by their distances",
        fixed.points.size(), moving.points.size()));
  }
  for (std::size_t i = 0; i < partners.size(); ++i) partners[i] = i;
  return partners;
}

std::string name_in(const NamedPoints& points, std::size_t i) {
  return points.names.empty() ? std::to_string(i + 1) : points.names[i];
}

Mat3 covariance_in(const NamedPoints& points, std::size_t i) {
  return points.deviations.empty() ? Mat3(Mat3::Zero()) : Mat3(points.deviations[i].cwiseAbs2().asDiagonal());
}

}  // namespace

PointPairs pair_points(const NamedPoints& fixed, const NamedPoints& moving, PairedBy paired_by) {
  const std::vector<std::optional<std::size_t>> partners = partners_of(fixed, moving, paired_by);
  PointPairs pairs;
  pairs.unequal = !fixed.deviations.empty() || !moving.deviations.empty();
  std::vector<bool> taken(moving.points.size(), false);
  for (std::size_t i = 0; i < partners.size(); ++i) {
    const std::string name = name_in(fixed, i);
    if (!partners[i]) {
      pairs.fixed_alone.push_back(name);
      continue;
    }
    const std::size_t partner = *partners[i];
    taken[partner] = true;
    const std::string other = name_in(moving, partner);
    pairs.names.push_back(name == other && paired_by != PairedBy::distance ? name
                                                                           : fmt::format("{} - {}", name, other));
    pairs.fixed.push_back(fixed.points[i]);
    pairs.moving.push_back(moving.points[partner]);
    pairs.fixed_covariances.push_back(covariance_in(fixed, i));
    pairs.moving_covariances.push_back(covariance_in(moving, partner));
  }
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (!taken[i]) pairs.moving_alone.push_back(name_in(moving, i));
  return pairs;
}

std::vector<Mat3> covariances_of(const PointPairs& pairs, const Similarity& fixed_from_moving) {
  const Mat3 turn = fixed_from_moving.scale * fixed_from_moving.turn;
  std::vector<Mat3> covariances;
  for (std::size_t i = 0; i < pairs.names.size(); ++i)
    covariances.push_back(pairs.fixed_covariances[i] + turn * pairs.moving_covariances[i] * turn.transpose());
  return covariances;
}

}  // namespace bodkin::tracking
