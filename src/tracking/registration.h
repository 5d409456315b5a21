#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tracking/placement_errors.h"

#include "core/geometry.h"

namespace bodkin::tracking {

// A rigid placement with one scale for all directions: point -> scale * turn * point + shift.
struct Similarity {
  Mat3 turn = Mat3::Identity();
  Vec3 shift = Vec3::Zero();  // mm
  double scale = 1.0;

  Vec3 operator*(const Vec3& point) const { return scale * (turn * point) + shift; }
  Similarity inverse() const;
};

// The RMS length of an error over many registrations like this one, mm: estimated from this one, with the 90 %
// confidence interval of the true RMS. The error of a single registration may lie outside it.
struct ErrorInterval {
  double low = 0.0, estimate = 0.0, high = 0.0;
};

// The expected target registration error at a place.
struct TargetError {
  Vec3 target = Vec3::Zero();  // mm, moving frame
  ErrorInterval tre;
};

// Fiducials of two sets, paired by their order, and the quality of their registration.
struct Registration {
  Similarity fixed_from_moving;
  bool scaled = false;
  std::vector<double> residuals;  // mm, of each pair
  double fre_rms = 0.0;           // mm, fiducial registration error
  double fre_mean = 0.0;          // mm
  std::vector<double>
      leave_one_out;      // mm, error of each point when registered by the others; empty with too few points
  double flatness = 0.0;  // ratio of the least to the largest extent of the points but one: 0 is on a line
  std::optional<TargetError> at_target;   // if requested
  std::optional<PlacementErrors> errors;  // if requested
};

// Whether points are so nearly on a line that the rotation about it is undetermined: the second largest of their
// extents along the principal axes is below 0.5 mm, or below 1 % of the largest.
bool on_a_line(const std::vector<Vec3>& points);

// The least-squares placement of `moving` on `fixed`, closed form (Umeyama 1991; rigid: Arun, Huang and Blostein
// 1987). Throws InputError when there are fewer than three pairs (four with scale), when the sets differ in number,
// or when the points lie on a line.
Registration register_points(const std::vector<Vec3>& fixed, const std::vector<Vec3>& moving, bool with_scale);

// The scale with which rigidly registered points would fit far better, for example if a print is not to scale: one
// that noise would mimic once in a thousand registrations (F-test), and that is off by more than 0.2 %. Empty with
// fewer than four points.
std::optional<double> hidden_scale(const std::vector<Vec3>& fixed, const std::vector<Vec3>& moving);

// RMS target registration error at `target` (moving frame, mm) of fiducials whose localisation error has the RMS
// length `fle`, mm (Fitzpatrick, West and Maurer 1998; with scale the term of the scale is added: FLE^2/3 q^2 / sum
// p^2).
double predicted_tre(const std::vector<Vec3>& moving, const Vec3& target, double fle, bool with_scale);
// Target registration error as predicted by a single registration. The FRE of one registration says little about its
// TRE: hence an interval, from the distribution of FRE^2 (chi-squared with 3k - 6 degrees of freedom, 3k - 7 with
// scale).
ErrorInterval tre_interval(const Registration& registration, const std::vector<Vec3>& moving, const Vec3& target);

// The interval of an RMS error whose total variance, mm^2, was estimated with this many degrees of freedom.
ErrorInterval error_interval(double variance, double freedom);

// The uncertainty of the placement, when the localisation errors of the pairs have these covariances (mm^2, of fixed
// and moving together, in the fixed frame), up to a common factor, which the residuals determine: identities for
// equal errors. To first order, for the unweighted closed form.
PlacementErrors placement_errors(const Registration& registration, const std::vector<Vec3>& moving,
                                 const std::vector<Mat3>& covariances);

// The covariance of a target's place when each pair has its own localisation covariance (mm^2, of fixed and moving
// together, in the fixed frame), to first order, for the unweighted closed form.
Mat3 target_covariance(const Registration& registration, const std::vector<Vec3>& moving,
                       const std::vector<Mat3>& covariances, const Vec3& target);

// Target registration error when the localisation errors of the pairs are unequal: `covariances` as above, up to a
// common factor, which the residuals of this registration determine. The interval contains the RMS error in 90 % of
// registrations: the residuals' sum of squares has the first two moments of a chi-squared variable.
ErrorInterval tre_interval(const Registration& registration, const std::vector<Vec3>& moving,
                           const std::vector<Mat3>& covariances, const Vec3& target);

// The point of `moving` that belongs to each point of `fixed`.
struct PointMatch {
  std::vector<std::optional<std::size_t>> moving_of_fixed;
  double fre_rms = 0.0;    // mm
  bool ambiguous = false;  // another assignment fits nearly as well
};

// Pairs points without names: triples of equal distances (within `tolerance`, mm) propose a placement; the placement
// that matches most points wins. Some points of either set may have no partner. Throws InputError when a set has
// fewer than three points or lies on a line, and when no three points fit, or only some on a line.
PointMatch match_points(const std::vector<Vec3>& fixed, const std::vector<Vec3>& moving, double tolerance = 3.0);

// Pairs whose exchange reduces the FRE to less than a third, so that the names in one set were probably swapped: the
// best one, and those within a factor of 3 of it, as the other two points of a rectangle. Empty if there is none.
std::vector<std::pair<std::size_t, std::size_t>> swapped_pairs(const std::vector<Vec3>& fixed,
                                                               const std::vector<Vec3>& moving, bool with_scale);

}  // namespace bodkin::tracking
