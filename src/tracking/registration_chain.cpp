#include "tracking/registration_chain.h"

namespace bodkin::tracking {

namespace {

// The same errors about another centre, and in the target frame of `onwards`.
PlacementErrors carried(const PlacementErrors& errors, const Similarity& onwards, const Vec3& middle) {
  const Vec3 away = middle - onwards * errors.middle;
  Matrix7 change = Matrix7::Zero();
  change.topLeftCorner<3, 3>() = onwards.scale * onwards.turn;
  change.block<3, 3>(3, 3) = onwards.turn;
  change(6, 6) = 1.0;
  Matrix7 moved = Matrix7::Identity();
  moved.topRows<3>() = displacement(away);
  const Matrix7 whole = moved * change;
  return {middle, whole * errors.covariance * whole.transpose(), errors.freedom};
}

// Degrees of freedom of a sum of two variances, each with its own.
double freedom_of_sum(double one, double freedom_of_one, double other, double freedom_of_other) {
  const double sum = one + other;
  if (sum <= 0.0) return freedom_of_one + freedom_of_other;
  return sum * sum / (one * one / freedom_of_one + other * other / freedom_of_other);
}

}  // namespace

Registration followed_by(const Registration& first, const Registration& second) {
  const Similarity& inner = first.fixed_from_moving;
  const Similarity& outer = second.fixed_from_moving;
  Registration whole = first;
  whole.scaled = first.scaled || second.scaled;
  whole.fixed_from_moving = {
      .turn = outer.turn * inner.turn, .shift = outer * inner.shift, .scale = outer.scale * inner.scale};
  whole.errors.reset();
  whole.at_target.reset();
  if (!first.errors || !second.errors) return whole;
  const PlacementErrors carried_on = carried(*first.errors, outer, second.errors->middle);
  // At the place of interest, or else in the middle.
  const Vec3 place =
      first.at_target ? whole.fixed_from_moving * first.at_target->target : Vec3(second.errors->middle);
  const double of_first = covariance_at(carried_on, place).trace(),
               of_second = covariance_at(*second.errors, place).trace();
  const double freedom = freedom_of_sum(of_first, carried_on.freedom, of_second, second.errors->freedom);
  whole.errors = PlacementErrors{second.errors->middle, carried_on.covariance + second.errors->covariance, freedom};
  if (first.at_target) {
    whole.at_target = TargetError{first.at_target->target, error_interval(of_first + of_second, freedom)};
  }
  return whole;
}

}  // namespace bodkin::tracking
