#include "patient/acupuncture/atlas.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

#include "patient/acupuncture/collaterals.h"
#include "patient/acupuncture/meridian_line.h"
#include "patient/acupuncture/placement.h"
#include <fmt/format.h>

namespace bodkin::patient {
namespace {

namespace tissue = anatomy::tissue;

constexpr double looked_under = 80.0;  // mm
constexpr double skull_base = 1570.0;  // drawn mm

// Usual colours of the five phases, varied so that neighbours differ.
struct MeridianColour {
  std::string_view code;
  std::uint32_t colour;
};
constexpr std::array<MeridianColour, 14> meridian_colours = {{{"LU", 0xE8E8F0},
                                                              {"LI", 0xB8C4D8},
                                                              {"ST", 0xF2B632},
                                                              {"SP", 0xD98C2B},
                                                              {"HT", 0xF0503C},
                                                              {"SI", 0xF58A6B},
                                                              {"BL", 0x3C7DF0},
                                                              {"KI", 0x6A5CE0},
                                                              {"PC", 0xE84A8C},
                                                              {"TE", 0xF08CB4},
                                                              {"GB", 0x4CC25A},
                                                              {"LR", 0x1E9E78},
                                                              {"GV", 0x2ED0D0},
                                                              {"CV", 0xC8E05A}}};

std::string plain(std::string_view text) {
  std::string result;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      result.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
  return result;
}

std::string danger_name(anatomy::TissueId id) {
  switch (id) {
    case tissue::lung:
      return "lung";
    case tissue::vessel:
      return "vessel";
    case tissue::nerve:
      return "nerve";
    case tissue::organ:
      return "organ";
    case tissue::dura:
    case tissue::spinal_cord:
    case tissue::cerebrospinal_fluid:
      return "spinal canal";
    default:
      return "";
  }
}

}  // namespace

Atlas::Atlas(const BodyParameters& parameters) : table_(read_point_table()) {
  check_body(parameters);
  shape_ = std::make_unique<BodyShape>(parameters);
  tissues_ = std::make_unique<BodyTissues>(*shape_);
  const BodyLandmarks landmarks = body_landmarks(*shape_);
  PointPlacer placer(table_, *shape_, landmarks);
  for (const PointRow& row : table_.points) {
    AtlasPoint point;
    point.code = row.code;
    point.pinyin = row.pinyin;
    point.hanzi = row.hanzi;
    point.meridian = row.meridian;
    point.region = row.region;
    point.bilateral = row.bilateral;
    point.place = placer.place(row.code);
    point.normal = shape_->normal(point.place);
    look_under(point);
    points_.push_back(std::move(point));
  }
  for (const MeridianColour& one : meridian_colours) {
    Meridian meridian;
    meridian.code = one.code;
    meridian.colour = one.colour;
    std::vector<Vec3> line;
    for (const AtlasPoint& point : points_) {
      if (meridian_code(point.code) != one.code) continue;
      meridian.name = point.meridian;
      meridian.bilateral = point.bilateral;
      // Points where the standard numbering continues from another point than the previous one.
      const std::string_view jump = point.code == "ST9"    ? "ST5"
                                    : point.code == "BL41" ? "BL10"
                                    : point.code == "BL55" ? "BL40"
                                                           : "";
      if (!jump.empty()) {
        meridian.lines.push_back(std::move(line));
        line = {placer.place(jump)};
      }
      if (line.empty()) {
        line.push_back(point.place);
      } else {
        append_skin_line(*shape_, point.place, line);
      }
    }
    meridian.lines.push_back(std::move(line));
    meridians_.push_back(std::move(meridian));
  }
}

void Atlas::look_under(AtlasPoint& point) const {
  constexpr double step = 0.5;
  for (double depth = step; depth <= looked_under; depth += step) {
    const Vec3 p = point.place - depth * point.normal;
    const double distance = shape_->distance(p);
    const anatomy::TissueId id = tissues_->at(p, distance, 1.0);
    if (id == tissue::air && depth > 5.0) break;  // through
    if (!point.bone_depth && (id == tissue::cortical_bone || id == tissue::cancellous_bone)) point.bone_depth = depth;
    if (!point.danger_depth) {
      point.danger = danger_name(id);
      if (point.danger == "spinal canal" && p.z() > skull_base * shape_->scale()) point.danger = "brain";
      if (!point.danger.empty()) point.danger_depth = depth;
    }
  }
}

const AtlasPoint* Atlas::find(std::string_view code_or_name) const {
  const std::string wanted = plain(code_or_name);
  for (const AtlasPoint& point : points_)
    if (plain(point.code) == wanted) return &point;
  for (const AtlasPoint& point : points_)
    if (plain(point.pinyin) == wanted) return &point;
  return nullptr;
}

std::vector<const AtlasPoint*> Atlas::search(std::string_view words) const {
  const std::string wanted = plain(words);
  std::vector<const AtlasPoint*> found;
  if (const AtlasPoint* exact = wanted.empty() ? nullptr : find(words)) found.push_back(exact);
  for (const AtlasPoint& point : points_) {
    const bool fits = wanted.empty() || plain(point.code).rfind(wanted, 0) == 0 ||
                      plain(point.pinyin).find(wanted) != std::string::npos ||
                      plain(point.meridian).find(wanted) != std::string::npos ||
                      (!words.empty() && point.hanzi == words) ||
                      (wanted == "luo" && collateral_at(point.code) != nullptr);
    if (fits && (found.empty() || found.front() != &point)) found.push_back(&point);
  }
  return found;
}

Atlas::Near Atlas::nearest(const Vec3& p) const {
  Near best;
  best.distance = std::numeric_limits<double>::infinity();
  for (const AtlasPoint& point : points_) {
    for (const bool right : {false, true}) {
      if (right && !point.bilateral) continue;
      const double distance = (p - (right ? point.mirrored() : point.place)).norm();
      if (distance < best.distance) best = {&point, right, distance};
    }
  }
  return best;
}

Vec3 Atlas::needle_axis(const AtlasPoint& point, double angle, std::string_view direction) const {
  Vec3 way = -Vec3::UnitZ();
  const auto says = [direction](std::string_view word) { return direction.find(word) != std::string_view::npos; };
  if (says("spine") || says("medial")) way = -Vec3::UnitX();
  if (says("upwards")) way = Vec3::UnitZ();
  way = (way - way.dot(point.normal) * point.normal).normalized();
  const double radians = angle * degree;
  return (-std::sin(radians) * point.normal + std::cos(radians) * way).normalized();
}

Needling Atlas::needling(const AtlasPoint& point) const {
  Needling result;
  if (const auto at = table_.needling.find(point.code); at != table_.needling.end()) {
    const NeedlingRow& row = at->second;
    result = {row.shallowest, row.deepest, row.angle, row.direction, row.caution, row.source, false, {}};
  } else {
    // Half a cun to one, short of bone, and well short of forbidden structures; oblique if that leaves little.
    constexpr double least = 5.0, usual_cun = 1.0, before_bone = 1.0, before_danger = 6.0;
    const double cun = shape_->parameters().height * 1000.0 / 75.0;
    double deepest = usual_cun * cun;
    if (point.bone_depth) deepest = std::min(deepest, *point.bone_depth - before_bone);
    if (point.danger_depth) deepest = std::min(deepest, *point.danger_depth - before_danger);
    result.derived = true;
    if (deepest < least) {
      result.angle = 15.0;
      deepest = 0.5 * cun;
      result.direction = "transverse";
    } else if (deepest < 10.0 && point.danger_depth && *point.danger_depth < 25.0) {
      result.angle = 45.0;
      result.direction = "oblique, towards the spine";
    }
    result.deepest = deepest;
    result.shallowest = 0.5 * deepest;
    if (point.danger_depth) result.caution = fmt::format("{} at {:.0f} mm", point.danger, *point.danger_depth);
    result.source = "derived from the anatomy of this body under the point";
  }
  result.axis = needle_axis(point, result.angle, result.direction);
  return result;
}

anatomy::NeedlePath Atlas::path(const AtlasPoint& point) const {
  const Needling how = needling(point);
  double depth = 0.5 * (how.shallowest + how.deepest);
  // A published depth does not account for this body.
  const double straight_in = -how.axis.dot(point.normal);
  if (point.bone_depth) depth = std::min(depth, (*point.bone_depth - 2.0) / straight_in);
  if (point.danger_depth) depth = std::min(depth, (*point.danger_depth - 4.0) / straight_in);
  return {point.place, point.place + std::max(depth, 3.0) * how.axis};
}

}  // namespace bodkin::patient
