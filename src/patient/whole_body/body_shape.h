#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "patient/synthetic/curve.h"

#include "core/geometry.h"
#include "core/parameter.h"

namespace bodkin::patient {

enum class Sex : std::uint8_t { male, female };

// Parameters of a whole synthetic body.
struct BodyParameters {
  double height = 1.72;  // m, 1.40 to 2.05
  double weight = 70.0;  // kg, 40 to 160: with height, the girth of trunk and limbs and the fat under the skin
  Sex sex = Sex::male;   // width of shoulders and pelvis, breasts
};

// Throws InputError naming the parameter, its value and its range.
void check_body(const BodyParameters& parameters);

// A limb or the trunk: ellipses stacked along an axis. Coordinates across (a, b) and along it (w).
struct Tube {
  Curve centre_a, centre_b, half_a, half_b;
  double from = 0.0, to = 0.0;  // of w
  double rounding = 12.0;       // of its ends
  bool squarish = false;        // superellipses, as trunks are

  void add(double w, double at_a, double at_b, double radius_a, double radius_b);
  double distance(double a, double b, double w) const;
};

// The outside of a standing body as a signed distance, negative inside: anatomical position, arms straight and raised
// sideways by 33 degrees, palms to the front. Patient frame (LPS mm): the soles at z = 0, the middle of the body at x
// = 0. The body is symmetric. Immutable and thread-safe.
//
// Everything is designed for a man of 1.72 m in "drawn" millimetres, and scaled to the height. Distances are accurate
// to some percent near the skin, which suffices for a search for the skin.
class BodyShape {
 public:
  // Parameters accepted by check_body().
  explicit BodyShape(const BodyParameters& parameters);

  const BodyParameters& parameters() const { return parameters_; }
  double scale() const { return scale_; }  // real mm per drawn mm
  double girth() const { return girth_; }  // of the trunk, 1: body mass index 23
  double distance(const Vec3& p) const { return scale_ * drawn_distance(p / scale_); }
  // Of the body without ears, which hide the skin behind them.
  double drawn_distance(const Vec3& q, bool with_ears = true) const;
  // Unit, outwards; of the body without ears.
  Vec3 normal(const Vec3& p) const;
  // The nearest point on the skin, without ears, to a point less than some cm from it.
  Vec3 nearest_skin(const Vec3& p) const;

  // Single parts, drawn mm, of the left half (x >= 0).
  double trunk_distance(const Vec3& q) const;
  const Tube& leg() const { return leg_; }

  // The arm's own frame: x across it to the thumb's side, y to the palm, z towards the hand; the shoulder's joint is
  // its origin. Drawn mm, left arm.
  Vec3 in_arm(const Vec3& q) const { return arm_axes_.transpose() * (q - shoulder_); }
  Vec3 from_arm(const Vec3& local) const { return shoulder_ + arm_axes_ * local; }
  const Mat3& arm_axes() const { return arm_axes_; }

  // Along the arm from the shoulder's joint, drawn mm.
  static constexpr double elbow = 292.0, wrist = 555.0, knuckles = 648.0, fingertip = 738.0;

 private:
  double head_distance(const Vec3& q, bool with_ears) const;
  double arm_distance(const Vec3& q) const;
  double leg_distance(const Vec3& q) const;
  double foot_distance(const Vec3& q) const;

  BodyParameters parameters_;
  double scale_, girth_, limb_girth_, shoulder_width_;
  Tube trunk_, neck_, arm_, leg_;
  Vec3 shoulder_;
  Mat3 arm_axes_;
};

}  // namespace bodkin::patient
