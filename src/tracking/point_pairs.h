#pragma once

#include <string>
#include <vector>

#include "tracking/registration_file.h"

namespace bodkin::tracking {

// Points of two sets with their partners; all members but the last three have equal length.
struct PointPairs {
  std::vector<std::string> names;
  std::vector<Vec3> fixed, moving;                          // mm
  std::vector<Mat3> fixed_covariances, moving_covariances;  // mm^2, each in its own frame; 0 if a set states none
  bool unequal = false;                                     // a set states standard deviations
  std::vector<std::string> fixed_alone, moving_alone;       // names, or numbers from 1, of points without a partner
};

enum class PairedBy { name_or_order, distance };

// `name_or_order`: points of equal names, if both sets have names; else in order, for sets of equal size. `distance`:
// as paired by match_points(), ignoring names. Throws InputError when the sets differ in number and have no names,
// and when several pairings fit.
PointPairs pair_points(const NamedPoints& fixed, const NamedPoints& moving, PairedBy paired_by);

// The covariance of each pair in the fixed frame, mm^2, of fixed and moving together, for target_covariance().
std::vector<Mat3> covariances_of(const PointPairs& pairs, const Similarity& fixed_from_moving);

}  // namespace bodkin::tracking
