#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "patient/acupuncture/point_table.h"
#include "patient/whole_body/whole_body.h"

#include "anatomy/needle_path.h"
#include "core/geometry.h"

namespace bodkin::patient {

// The needling of a point on a body.
struct Needling {
  double shallowest = 0.0, deepest = 0.0;  // mm along the needle
  double angle = 90.0;                     // deg to the skin
  std::string direction;                   // in words; empty: straight in
  std::string caution;                     // empty: none is known
  std::string source;
  bool derived = false;       // from this body's anatomy, because nothing published is available
  Vec3 axis = Vec3::UnitY();  // unit, into the body
};

// A point on a body.
struct AtlasPoint {
  std::string code, pinyin, hanzi, meridian, region;
  bool bilateral = true;
  Vec3 place = Vec3::Zero();    // LPS mm, on the skin, of the left half
  Vec3 normal = Vec3::UnitY();  // unit, outwards
  // Straight below it, mm; empty: not within 80 mm.
  std::optional<double> bone_depth, danger_depth;
  std::string danger;  // the name of its tissue: "lung"

  Vec3 mirrored() const { return {-place.x(), place.y(), place.z()}; }
};

// A meridian, as lines on the skin of the left half (or the median plane).
struct Meridian {
  std::string code, name;  // "ST", "Stomach"
  bool bilateral = true;
  std::uint32_t colour = 0;              // 0xRRGGBB
  std::vector<std::vector<Vec3>> lines;  // LPS mm
};

// A body with the 361 standard points and the 14 meridians. Immutable.
class Atlas {
 public:
  // Throws InputError for parameters out of range, and for an unreadable table of points.
  explicit Atlas(const BodyParameters& parameters);

  const BodyShape& shape() const { return *shape_; }
  const BodyTissues& tissues() const { return *tissues_; }
  const std::vector<AtlasPoint>& points() const { return points_; }
  const std::vector<Meridian>& meridians() const { return meridians_; }
  // nullptr for an unknown code or name ("ST36", "st 36", "Zusanli").
  const AtlasPoint* find(std::string_view code_or_name) const;
  // By code, name or meridian, in any spelling; "luo": with the luo-connecting points; all of them for empty words.
  std::vector<const AtlasPoint*> search(std::string_view words) const;
  // The nearest point, also of the right half, and its distance in mm.
  struct Near {
    const AtlasPoint* point = nullptr;
    bool right = false;
    double distance = 0.0;
  };
  Near nearest(const Vec3& p) const;
  // The needling of a point, including published data.
  Needling needling(const AtlasPoint& point) const;
  // From the skin to the middle of the depth range, or to just before bone and danger if these come first in this
  // body; at least 3 mm long.
  anatomy::NeedlePath path(const AtlasPoint& point) const;

 private:
  void look_under(AtlasPoint& point) const;
  Vec3 needle_axis(const AtlasPoint& point, double angle, std::string_view direction) const;

  PointTable table_;
  std::unique_ptr<BodyShape> shape_;
  std::unique_ptr<BodyTissues> tissues_;
  std::vector<AtlasPoint> points_;
  std::vector<Meridian> meridians_;
};

}  // namespace bodkin::patient
