#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "patient/whole_body/body_shape.h"

namespace bodkin::patient {

// A landmark by which points are located, on the skin of the left half of a body (LPS mm). A point and a level have
// one place; a line has two or more, from one end to the other.
struct BodyLandmark {
  enum class Kind : std::uint8_t { point, line, level };
  Kind kind = Kind::point;
  std::vector<Vec3> places;

  const Vec3& place() const { return places.front(); }
};

using BodyLandmarks = std::map<std::string, BodyLandmark, std::less<>>;

// The direction in which heights are measured: up the body, or along the limb.
enum class BodyPart : std::uint8_t { trunk, arm, leg, foot };

// The 231 landmarks used by acupuncture's standard (WHO Standard Acupuncture Point Locations, 2008), placed by this
// body's own bones, folds and outlines.
BodyLandmarks body_landmarks(const BodyShape& shape);

// Searches from a body's inside or outside for the skin, in drawn mm; for the files of the landmarks.
class SkinFinder {
 public:
  SkinFinder(const BodyShape& shape, BodyLandmarks& landmarks) : shape_(shape), landmarks_(landmarks) {}

  const BodyShape& shape() const { return shape_; }
  // The first skin from `from` (inside or outside) along a direction.
  Vec3 along(const Vec3& from, const Vec3& direction, bool with_ears = false) const;
  Vec3 front(double x, double z) const { return along(Vec3(x, -330.0, z), Vec3::UnitY()); }
  Vec3 back(double x, double z) const { return along(Vec3(x, 330.0, z), -Vec3::UnitY()); }
  // From the median plane outwards at this depth and height.
  Vec3 side(double y, double z) const { return along(Vec3(0.0, y, z), Vec3::UnitX()); }
  // About a limb's axis: 0 deg towards the thumb or the little toe, 90 to the front, 180 towards the body, 270 to the
  // back.
  Vec3 arm(double w, double angle) const;
  Vec3 leg(double z, double angle) const;
  Vec3 neck(double z, double angle) const;
  Vec3 hand(double across, double w, double to_palm) const;  // to_palm: 1 palm, -1 back
  Vec3 foot(double x, double y) const { return along(Vec3(x, y, 190.0), -Vec3::UnitZ()); }

  void point(std::string_view name, const Vec3& at) { add(name, BodyLandmark::Kind::point, {at}); }
  void level(std::string_view name, const Vec3& at) { add(name, BodyLandmark::Kind::level, {at}); }
  void line(std::string_view name, std::vector<Vec3> places) {
    add(name, BodyLandmark::Kind::line, std::move(places));
  }

 private:
  void add(std::string_view name, BodyLandmark::Kind kind, std::vector<Vec3> places);

  const BodyShape& shape_;
  BodyLandmarks& landmarks_;
};

void add_head_landmarks(SkinFinder& skin);
void add_trunk_landmarks(SkinFinder& skin);
void add_arm_landmarks(SkinFinder& skin);
void add_leg_landmarks(SkinFinder& skin);
void add_foot_landmarks(SkinFinder& skin);

// Heights of the spine, drawn mm: of the lower border of a spinous process, 0 C7, 1 T1, ... 12 T12, 13 L1, ... 17 L5.
double spinous_height(int vertebra);
// Height of rib 1 to 12 on its way from the spine (0) round to the breastbone or its free end (1).
double rib_height(int rib, double position);
// The position along the ribs of a place on the trunk: 0 behind, 1 in front.
double position_along_ribs(const Vec3& q);

}  // namespace bodkin::patient
