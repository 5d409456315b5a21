#pragma once

#include <string>
#include <vector>

#include "tracking/registration_file.h"

namespace bodkin::tracking {

// Points of two sets, each with its partner; all but the last three are equally long.
struct PointPairs {
  std::vector<std::string> names;
  std::vector<Vec3> fixed, moving;                          // mm
  std::vector<Mat3> fixed_covariances, moving_covariances;  // mm^2, each in its own frame; 0 where a set tells none
  bool unequal = false;                                     // a set tells standard deviations
  std::vector<std::string> fixed_alone, moving_alone;       // names, or numbers from 1, of points without a partner
};

enum class PairedBy { name_or_order, distance };

// By `name_or_order`: points of one name, where both sets have names; else the first with the first and so on, which
// needs as many of the one as of the other. By `distance`: as match_points() pairs them, whatever they are called.
// Throws InputError when the sets differ in number and have no names, and when more than one way of pairing fits.
PointPairs pair_points(const NamedPoints& fixed, const NamedPoints& moving, PairedBy paired_by);

// The covariance of each pair in the fixed frame, mm^2, of fixed and moving together, for target_covariance().
std::vector<Mat3> covariances_of(const PointPairs& pairs, const Similarity& fixed_from_moving);

}  // namespace bodkin::tracking
