#include "patient/acupuncture/placement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::patient {
namespace {

constexpr double deep = 20.0;      // mm: from further inside, the skin is searched on the named side
constexpr double walk_step = 1.0;  // mm

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

bool on_arm(const PointRow& row) {
  return is_one_of(row.region, {"upper_arm", "elbow", "forearm", "wrist", "hand"});
}

std::string_view first_side(const PointRow& row) {
  return std::string_view(row.surface).substr(0, row.surface.find('+'));
}

// The closest approach of two polylines, as a place on the first.
Vec3 crossing(const std::vector<Vec3>& line, const std::vector<Vec3>& other) {
  double least = std::numeric_limits<double>::infinity();
  Vec3 best = line.front();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    for (int n = 0; n <= 8; ++n) {
      const Vec3 p = line[i] + n / 8.0 * (line[i + 1] - line[i]);
      for (std::size_t j = 0; j + 1 < other.size(); ++j) {
        const Vec3 along = other[j + 1] - other[j];
        const double t = std::clamp((p - other[j]).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
        const double distance = (other[j] + t * along - p).norm();
        if (distance < least) {
          least = distance;
          best = p;
        }
      }
    }
  }
  return best;
}

// Height of a line across the body, at a distance from the median plane.
double height_at(const BodyLandmark& line, double x) {
  const auto& places = line.places;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double a = places[i].x(), b = places[i + 1].x();
    if (std::min(a, b) <= x && x <= std::max(a, b) && a != b)
      return places[i].z() + (x - a) / (b - a) * (places[i + 1].z() - places[i].z());
  }
  const auto nearest = std::min_element(places.begin(), places.end(), [x](const Vec3& p, const Vec3& q) {
    return std::abs(p.x() - x) < std::abs(q.x() - x);
  });
  return nearest->z();
}

}  // namespace

PointPlacer::PointPlacer(const PointTable& table, const BodyShape& shape, const BodyLandmarks& landmarks)
    : table_(table), shape_(shape), landmarks_(landmarks) {}

Vec3 PointPlacer::place(std::string_view code) {
  if (const auto at = found_.find(code); at != found_.end()) return at->second;
  const PointRow* row = table_.find(code);
  if (row == nullptr)
    throw InputError(fmt::format("there is no acupuncture point '{}', expected a code such as ST36", code));
  Vec3 point = find(*row);
  if (!row->bilateral) point.x() = 0.0;
  found_.emplace(code, point);
  return point;
}

const BodyLandmark& PointPlacer::landmark(std::string_view name) const {
  const auto at = landmarks_.find(name);
  if (at == landmarks_.end())
    throw InputError(fmt::format("acupuncture/points.csv: there is no landmark or point '{}'", name));
  return at->second;
}

double PointPlacer::unit(std::string_view measure) const {
  const auto at = table_.measures.find(measure);
  if (at == table_.measures.end())
    throw InputError(fmt::format("acupuncture/cun.csv: there is no measure '{}'", measure));
  const CunMeasure& m = at->second;
  const Vec3 a = landmark(m.from).place(), b = landmark(m.to).place();
  double length = 0.0;
  if (m.from == m.to) {
    length = 2.0 * a.x();  // from the left to the right
  } else if (measure == "hairline_front_to_back" || measure == "glabella_to_hairline") {
    // Along the skin of the median plane.
    Vec3 here = a;
    Vec3 way(0.0, 0.0, 1.0);
    while ((here - b).norm() > 1.5 * walk_step && length < 900.0) {
      const Vec3 normal = shape_.normal(here);
      way = (way - way.dot(normal) * normal).normalized();
      here = shape_.nearest_skin(here + walk_step * way);
      length += walk_step;
    }
    length += (here - b).norm();
  } else if (has(measure, "finger_cun")) {
    length = (a - b).norm();
  } else if (has(measure, "upper_arm") || has(measure, "forearm")) {
    const Mat3& axes = shape_.arm_axes();
    length = std::abs((a - b).dot(axes.col(2)));
  } else {
    length = std::abs(a.z() - b.z());
  }
  return length / m.cun;
}

std::string_view PointPlacer::measure_along(const PointRow& row) const {
  const std::string_view region = row.region, surface = row.surface;
  if (region == "head" && !has(row.from, "eyebrow") && !has(row.from, "canthus")) return "hairline_front_to_back";
  if (is_one_of(region, {"head", "face", "neck"})) return "glabella_to_hairline";
  if (region == "chest") return row.toward == "anterior" ? "nipple_width" : "sternum_length";
  if (region == "abdomen")
    return has(row.toward, "xiphi") || has(row.from, "xiphi") ? "upper_abdomen" : "lower_abdomen";
  if (is_one_of(region, {"upper_arm", "elbow", "shoulder"}))
    return has(surface, "posterior") ? "upper_arm_posterior" : "upper_arm_anterior";
  if (is_one_of(region, {"forearm", "wrist", "hand"}))
    return has(surface, "posterior") ? "forearm_dorsal" : "forearm_palmar";
  if (region == "thigh" || region == "knee") {
    if (has(surface, "posterior")) return "thigh_posterior";
    return surface == "lateral" ? "thigh_lateral" : "thigh_anterior";
  }
  if (region == "leg") return has(surface, "medial") ? "leg_medial" : "leg_lateral";
  if (region == "ankle" || region == "foot") return "ankle_height";
  return "scapula_width";
}

std::string_view PointPlacer::measure_across(const PointRow& row) const {
  if (row.region == "chest" || row.region == "abdomen") return "nipple_width";
  if (has(row.from, "occipital")) return "mastoid_width";
  if (row.region == "head" || row.region == "face") return "forehead_width";
  return "scapula_width";
}

double PointPlacer::height(const PointRow& row, const Vec3& p) const {
  if (on_arm(row)) return -shape_.in_arm(p / shape_.scale()).z() * shape_.scale();
  return row.region == "foot" ? p.y() : p.z();
}

double PointPlacer::level(const PointRow& row) {
  if (!is_landmark(row.level_of)) return height(row, place(row.level_of));
  const BodyLandmark& found = landmark(row.level_of);
  double sum = 0.0;
  for (const Vec3& p : found.places) sum += height(row, p);
  return sum / static_cast<double>(found.places.size());
}

Vec3 PointPlacer::cut(const BodyLandmark& line, double at, const PointRow& row) const {
  const auto& places = line.places;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double a = height(row, places[i]), b = height(row, places[i + 1]);
    if ((a - at) * (b - at) > 0.0 || a == b) continue;
    return shape_.nearest_skin(places[i] + (at - a) / (b - a) * (places[i + 1] - places[i]));
  }
  return *std::min_element(places.begin(), places.end(), [&](const Vec3& p, const Vec3& q) {
    return std::abs(height(row, p) - at) < std::abs(height(row, q) - at);
  });
}

Vec3 PointPlacer::direction(std::string_view name, const PointRow& row) const {
  const Mat3& arm = shape_.arm_axes();
  const bool foot = row.region == "foot";
  if (name == "cranial") return Vec3::UnitZ();
  if (name == "caudal") return -Vec3::UnitZ();
  if (name == "anterior") return -Vec3::UnitY();
  if (name == "posterior") return Vec3::UnitY();
  if (name == "radial") return arm.col(0);
  if (name == "ulnar") return -arm.col(0);
  if (name == "lateral") return on_arm(row) ? Vec3(arm.col(0)) : Vec3(Vec3::UnitX());
  if (name == "medial") return on_arm(row) ? Vec3(-arm.col(0)) : Vec3(-Vec3::UnitX());
  if (name == "proximal" || name == "distal") {
    const double sign = name == "proximal" ? 1.0 : -1.0;
    if (on_arm(row)) return -sign * arm.col(2);
    return foot ? Vec3(sign * Vec3::UnitY()) : Vec3(sign * Vec3::UnitZ());
  }
  throw InputError(fmt::format(
      "acupuncture/points.csv: {} goes toward '{}', expected a landmark, a point or a direction", row.code, name));
}

Vec3 PointPlacer::seen_from(const Vec3& p, std::string_view side) const {
  Vec3 out = Vec3::UnitX();
  if (side == "anterior" || side == "palmar") out = -Vec3::UnitY();
  if (side == "posterior") out = Vec3::UnitY();
  if (side == "medial") out = -Vec3::UnitX();
  if (side == "dorsal") out = Vec3::UnitZ();
  if (side == "plantar") out = -Vec3::UnitZ();
  BodyLandmarks unused;
  const double scale = shape_.scale();
  return scale * SkinFinder(shape_, unused).along(p / scale, out);
}

Vec3 PointPlacer::settle(const Vec3& p, const PointRow& row) const {
  return shape_.distance(p) < -deep ? seen_from(p, first_side(row)) : shape_.nearest_skin(p);
}

Vec3 PointPlacer::walk(const Vec3& from, const Vec3& direction, double length) const {
  Vec3 here = from;
  while (length > 0.0) {
    const Vec3 normal = shape_.normal(here);
    const Vec3 way = (direction - direction.dot(normal) * normal).normalized();
    here = shape_.nearest_skin(here + std::min(length, walk_step) * way);
    length -= walk_step;
  }
  return here;
}

Vec3 PointPlacer::over_the_head(const Vec3& from, double length) const {
  Vec3 here = from;
  Vec3 way = Vec3::UnitZ();
  while (length > 0.0) {
    Vec3 normal = shape_.normal(here);
    normal.x() = 0.0;
    normal.normalize();
    way.x() = 0.0;
    way = (way - way.dot(normal) * normal).normalized();
    Vec3 next = shape_.nearest_skin(here + std::min(length, walk_step) * way);
    next.x() = from.x();
    here = next;
    length -= walk_step;
  }
  return shape_.nearest_skin(here);
}

bool PointPlacer::follows_line(const PointRow& row) const {
  return is_landmark(row.from) && landmark(row.from).kind == BodyLandmark::Kind::line &&
         row.along.kind == Cun::Kind::body && row.along.amount > 0.0 &&
         (row.toward == "proximal" || row.toward == "distal");
}

Vec3 PointPlacer::target(const PointRow& row, const Vec3& from) {
  if (!is_landmark(row.toward)) return place(row.toward);
  const BodyLandmark& found = landmark(row.toward);
  if (found.kind != BodyLandmark::Kind::line) return found.place();
  return cut(found, row.level_of.empty() ? height(row, from) : level(row), row);
}

Vec3 PointPlacer::base(const PointRow& row, bool& across_done) {
  if (!is_landmark(row.from)) return place(row.from);
  const BodyLandmark& found = landmark(row.from);
  BodyLandmarks unused;
  const SkinFinder skin(shape_, unused);
  const double scale = shape_.scale();
  if (row.from == "anterior_median_line") {
    const double x = row.across ? *row.across * unit("nipple_width") : 0.0;
    const BodyLandmark& level_line = landmark(row.level_of);
    const double z = level_line.kind == BodyLandmark::Kind::line ? height_at(level_line, x) : level_line.place().z();
    across_done = true;
    return scale * skin.front(x / scale, z / scale);
  }
  if (found.kind == BodyLandmark::Kind::line) {
    if (follows_line(row)) {
      const double sign = row.toward == "distal" ? -1.0 : 1.0;
      return cut(found, level(row) + sign * row.along.amount * unit(measure_along(row)), row);
    }
    if (is_landmark(row.level_of) && landmark(row.level_of).kind == BodyLandmark::Kind::line)
      return shape_.nearest_skin(crossing(found.places, landmark(row.level_of).places));
    return cut(found, level(row), row);
  }
  Vec3 place = found.place();
  const bool line_target = is_landmark(row.toward) && landmark(row.toward).kind == BodyLandmark::Kind::line;
  const bool continues = row.along.kind == Cun::Kind::none && !row.toward.empty();
  if (!row.level_of.empty() && !on_arm(row) && row.region != "foot" && !line_target && !continues) {
    place.z() = level(row);
    const std::string_view side = first_side(row);
    if (side == "anterior") place = scale * skin.front(place.x() / scale, place.z() / scale);
    if (side == "posterior") place = scale * skin.back(place.x() / scale, place.z() / scale);
    if (side == "lateral") place = scale * skin.side(place.y() / scale, place.z() / scale);
  }
  return place;
}

Vec3 PointPlacer::step_along(const PointRow& row, const Vec3& from) {
  if (row.toward.empty()) return from;
  const bool is_direction = !is_landmark(row.toward) && table_.find(row.toward) == nullptr;
  const double amount = row.along.amount;
  if (is_direction) {
    const Vec3 way = direction(row.toward, row);
    if (row.along.kind == Cun::Kind::none) {
      // Continues to the height of the level, seen from the point's side.
      BodyLandmarks unused;
      const SkinFinder skin(shape_, unused);
      const double scale = shape_.scale(), z = level(row) / scale;
      const std::string_view side = first_side(row);
      if (side == "lateral") return scale * skin.side(from.y() / scale, z);
      const double x = from.x() / scale;
      return scale * (side == "posterior" ? skin.back(x, z) : skin.front(x, z));
    }
    if (follows_line(row)) return from;
    double length = amount == 0.0 ? beside() : amount * unit("finger_cun_middle");
    if (row.along.kind == Cun::Kind::body && amount > 0.0) length = amount * unit(measure_along(row));
    return walk(from, way, length);
  }
  const Vec3 to = target(row, from);
  if (row.along.kind == Cun::Kind::fraction) {
    Vec3 p = from + amount * (to - from);
    p.y() += 4.0 * amount * (1.0 - amount) * row.bow * unit("glabella_to_hairline");
    return amount >= 1.0 ? to : settle(p, row);
  }
  if (row.along.kind == Cun::Kind::none) {
    const double a = height(row, from), b = height(row, to);
    return settle(from + std::clamp((level(row) - a) / (b - a), 0.0, 1.0) * (to - from), row);
  }
  if (row.along.kind == Cun::Kind::finger)
    return settle(from + amount * unit("finger_cun_middle") * (to - from).normalized(), row);
  const double length = amount * unit(measure_along(row));
  if (row.region == "head") return over_the_head(from, length);
  const double rise = std::abs(height(row, to) - height(row, from)), way = (to - from).norm();
  return settle(from + length / (rise < 0.6 * way ? way : rise) * (to - from), row);
}

Vec3 PointPlacer::step_across(const PointRow& row, const Vec3& from) {
  const double sign = row.across_direction == "medial" ? -1.0 : 1.0;
  const double x = from.x() + sign * *row.across * unit(measure_across(row));
  if (row.region == "head" && !has(row.from, "occipital")) {
    // Across the arch of the head: in the plane of the median line's normal.
    const Vec3 normal = shape_.normal(from);
    BodyLandmarks unused;
    const double scale = shape_.scale();
    const Vec3 outside(x, from.y() + 60.0 * normal.y(), from.z() + 60.0 * normal.z());
    return scale * SkinFinder(shape_, unused).along(outside / scale, -Vec3(0.0, normal.y(), normal.z()).normalized());
  }
  BodyLandmarks unused;
  const SkinFinder skin(shape_, unused);
  const double scale = shape_.scale();
  const bool behind = first_side(row) == "posterior";
  return scale * (behind ? skin.back(x / scale, from.z() / scale) : skin.front(x / scale, from.z() / scale));
}

Vec3 PointPlacer::find(const PointRow& row) {
  bool across_done = false;
  const Vec3 from = base(row, across_done);
  const Vec3 along = step_along(row, from);
  return row.across && !across_done ? step_across(row, along) : along;
}

}  // namespace bodkin::patient
