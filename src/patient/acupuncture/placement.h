#pragma once

#include <map>
#include <string>
#include <string_view>

#include "patient/acupuncture/point_table.h"
#include "patient/whole_body/body_landmarks.h"

namespace bodkin::patient {

// Finds the standard points on a body from its landmarks, by bone-proportional measure (docs/acupuncture.md has the
// rules). LPS mm, on the skin of the left half; points of the right half are mirror images. One thread.
class PointPlacer {
 public:
  // All three must outlive this object.
  PointPlacer(const PointTable& table, const BodyShape& shape, const BodyLandmarks& landmarks);

  // Throws InputError for an unknown code, and for a row with an unknown landmark.
  Vec3 place(std::string_view code);
  // mm of one cun by a measure of cun.csv.
  double unit(std::string_view measure) const;
  // mm that "just beside" a landmark means where the standard gives no distance: 0.3 finger cun, our choice.
  double beside() const { return 0.3 * unit("finger_cun_middle"); }

 private:
  Vec3 find(const PointRow& row);
  Vec3 base(const PointRow& row, bool& across_done);
  Vec3 step_along(const PointRow& row, const Vec3& from);
  Vec3 step_across(const PointRow& row, const Vec3& from);
  const BodyLandmark& landmark(std::string_view name) const;
  bool is_landmark(std::string_view name) const { return landmarks_.contains(name); }
  // Whether the line on which it starts is followed up or down from its level.
  bool follows_line(const PointRow& row) const;
  Vec3 target(const PointRow& row, const Vec3& from);
  // Height of a place, along the limb for limbs.
  double height(const PointRow& row, const Vec3& p) const;
  double level(const PointRow& row);
  Vec3 cut(const BodyLandmark& line, double at, const PointRow& row) const;
  Vec3 settle(const Vec3& p, const PointRow& row) const;
  Vec3 seen_from(const Vec3& p, std::string_view side) const;
  Vec3 direction(std::string_view name, const PointRow& row) const;
  Vec3 walk(const Vec3& from, const Vec3& direction, double length) const;
  Vec3 over_the_head(const Vec3& from, double length) const;
  std::string_view measure_along(const PointRow& row) const;
  std::string_view measure_across(const PointRow& row) const;

  const PointTable& table_;
  const BodyShape& shape_;
  const BodyLandmarks& landmarks_;
  std::map<std::string, Vec3, std::less<>> found_;
};

}  // namespace bodkin::patient
