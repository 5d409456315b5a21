#include "study/straight_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::study {

namespace {

constexpr double lead = 10.0;            // mm of air before the skin
constexpr double step_of_search = 0.1;   // mm
constexpr double shortest_path = 1.0;    // mm
constexpr double entry_tolerance = 2.0;  // mm between entry and skin without a remark
constexpr anatomy::TissueId outside = 255;

std::string text_of(const Vec3& point) {
  return fmt::format("({:.1f}, {:.1f}, {:.1f})", point.x(), point.y(), point.z());
}

void check_inside(const Vec3& point, const char* what, const anatomy::Grid& grid) {
  const Vec3 index = grid.to_index(point);
  const Vec3 last = Vec3(grid.size[0], grid.size[1], grid.size[2]) - Vec3::Constant(0.5);
  if ((index.array() >= -0.5).all() && (index.array() <= last.array()).all()) return;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 place((corner & 1) != 0 ? last.x() : -0.5, (corner & 2) != 0 ? last.y() : -0.5,
                     (corner & 4) != 0 ? last.z() : -0.5);
    low = low.cwiseMin(grid.to_patient(place));
    high = high.cwiseMax(grid.to_patient(place));
  }
  throw InputError(fmt::format("the {} {} lies outside the volume, which reaches from {} to {} (LPS mm)", what,
                               text_of(point), text_of(low), text_of(high)));
}

anatomy::NeedlePath path_of(const anatomy::Case& patient, const std::optional<Vec3>& entry,
                            const std::optional<Vec3>& target) {
  const std::optional<anatomy::NeedlePath>& planned = patient.description.procedure.path;
  if (!planned && !(entry && target)) {
    throw InputError(fmt::format("the case '{}' has no planned path; give both --entry and --target in LPS mm",
                                 patient.description.name));
  }
  anatomy::NeedlePath path = planned.value_or(anatomy::NeedlePath{});
  if (entry) path.entry = *entry;
  if (target) path.target = *target;
  if (!path.entry.allFinite() || !path.target.allFinite()) {
    throw InputError("the entry and the target of a path must be finite numbers in LPS mm");
  }
  if (path.length() < shortest_path) {
    throw InputError(fmt::format("the entry {} and the target {} are {:.2f} mm apart, expected at least {} mm",
                                 text_of(path.entry), text_of(path.target), path.length(), shortest_path));
  }
  check_inside(path.entry, "entry", patient.tissues.grid);
  check_inside(path.target, "target", patient.tissues.grid);
  return path;
}

// mm from the path to the nearest voxel that is not air; infinite if there is none.
double distance_to_body(const anatomy::NeedlePath& path, const anatomy::TissueVolume& tissues) {
  const auto& size = tissues.grid.size;
  const Vec3 along = path.target - path.entry;
  double nearest_square = std::numeric_limits<double>::infinity();
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (tissues.at(i, j, k) == anatomy::tissue::air) continue;
        const Vec3 point = tissues.grid.to_patient(Vec3(i, j, k));
        const double share = std::clamp((point - path.entry).dot(along) / along.squaredNorm(), 0.0, 1.0);
        nearest_square = std::min(nearest_square, (path.entry + share * along - point).squaredNorm());
      }
    }
  }
  return std::sqrt(nearest_square);
}

// Finds the skin on the path, and thereby the needle's start.
void find_skin(StraightPath& line, const anatomy::TissueVolume& tissues) {
  const anatomy::NeedlePath& path = line.path;
  const Vec3 along = path.direction();
  const auto tissue_at = [&](double s) {
    return anatomy::nearest<anatomy::TissueId>(tissues, path.entry + s * along, outside);
  };
  const bool in_body = tissue_at(0.0) != anatomy::tissue::air;
  // The skin between a place in air and one in tissue, to the last relevant bit.
  const auto skin_between = [&](double in_air, double in_tissue) {
    for (int halving = 0; halving < 20; ++halving) {
      const double middle = 0.5 * (in_air + in_tissue);
      (tissue_at(middle) == anatomy::tissue::air ? in_air : in_tissue) = middle;
    }
    return in_tissue;
  };
  if (!in_body) {
    for (double s = step_of_search; s <= line.end; s += step_of_search) {
      const anatomy::TissueId here = tissue_at(s);
      if (here == outside) break;
      if (here == anatomy::tissue::air) continue;
      line.surface = skin_between(s - step_of_search, s);
      line.start = line.surface - lead;
      if (line.surface > entry_tolerance)
        line.notes.push_back(fmt::format("the entry lies {:.1f} mm in front of the skin", line.surface));
      return;
    }
    const double distance = distance_to_body(path, tissues);
    throw InputError(
        std::isfinite(distance)
            ? fmt::format("the path from {} to {} misses the body by {:.1f} mm; move its entry or its target",
                          text_of(path.entry), text_of(path.target), distance)
            : "the tissue volume holds nothing but air, so that no path can meet a body");
  }
  for (double s = -step_of_search;; s -= step_of_search) {
    const anatomy::TissueId here = tissue_at(s);
    if (here == outside) break;
    if (here != anatomy::tissue::air) continue;
    line.surface = skin_between(s, s + step_of_search);
    line.start = line.surface - lead;
    if (-line.surface > entry_tolerance) {
      line.notes.push_back(
          fmt::format("the entry lies {:.1f} mm below the skin; depth counts from the skin", -line.surface));
    }
    return;
  }
  line.notes.emplace_back("the volume has no skin before the entry, so the needle starts at the entry itself");
}

}  // namespace

Pose StraightPath::needle_at(double place) const {
  Pose needle = at_entry;
  needle.translation() = path.entry + place * path.direction();
  return needle;
}

StraightPath straight_path(const anatomy::Case& patient, const std::optional<Vec3>& entry,
                           const std::optional<Vec3>& target, double beyond) {
  StraightPath line;
  line.path = path_of(patient, entry, target);
  const Vec3 along = line.path.direction();
  line.at_entry = needle_pose(line.path.entry, along);
  line.end = line.path.length() + beyond;
  if (beyond > 0.0 &&
      anatomy::nearest<anatomy::TissueId>(patient.tissues, line.path.entry + line.end * along, outside) == outside) {
    throw InputError(fmt::format(
        "{:.1f} mm beyond the target lies outside the volume; go less deep with --beyond or --motion", beyond));
  }
  find_skin(line, patient.tissues);
  const double hub_on_skin = line.surface + patient.description.needle.length;
  if (line.end > hub_on_skin) {
    line.notes.push_back(
        fmt::format("the needle is {:g} mm long: its hub meets the skin {:.1f} mm before the end of the path",
                    patient.description.needle.length, line.end - hub_on_skin));
    line.end = hub_on_skin;
    line.ends_at_hub = true;
  }
  line.outside = std::min(line.start, -lead) - lead;
  return line;
}

std::vector<double> places_between(double from, double to, double step) {
  std::vector<double> places;
  const double towards = to < from ? -step : step;
  const auto whole = static_cast<std::size_t>(std::abs(to - from) / step);
  places.reserve(whole + 1);
  for (std::size_t n = 1; n <= whole; ++n) places.push_back(from + towards * static_cast<double>(n));
  if (places.empty() || places.back() != to) places.push_back(to);
  return places;
}

}  // namespace bodkin::study
