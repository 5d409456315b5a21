#include "io/case_soundness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include <fmt/format.h>

namespace bodkin::io {

namespace {

constexpr anatomy::TissueId outside = 255;  // never a tissue
constexpr double path_step = 0.25;          // mm
constexpr double longest_body = 600.0;      // mm that a line can be inside a person

std::string size_of(const anatomy::Grid& grid) {
  return fmt::format("{} x {} x {}", grid.size[0], grid.size[1], grid.size[2]);
}

std::string point(const Vec3& p) {
  return fmt::format("({:.1f}, {:.1f}, {:.1f})", p.x(), p.y(), p.z());
}

// The eight corners of the box that the voxels of a lattice fill.
std::array<Vec3, 8> box_corners(const anatomy::Grid& grid) {
  std::array<Vec3, 8> corners;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 index((corner & 1U) != 0 ? grid.size[0] - 0.5 : -0.5, (corner & 2U) != 0 ? grid.size[1] - 0.5 : -0.5,
                     (corner & 4U) != 0 ? grid.size[2] - 0.5 : -0.5);
    corners[corner] = grid.to_patient(index);
  }
  return corners;
}

// The greatest distance between corresponding corners of two boxes, mm.
double box_distance(const anatomy::Grid& a, const anatomy::Grid& b) {
  const auto corners_a = box_corners(a), corners_b = box_corners(b);
  double furthest = 0.0;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    furthest = std::max(furthest, (corners_a[corner] - corners_b[corner]).norm());
  }
  return furthest;
}

// The number of voxels of each value.
template <typename Voxel>
std::vector<std::size_t> histogram(const std::vector<Voxel>& voxels) {
  std::vector<std::size_t> counts(std::size_t{std::numeric_limits<Voxel>::max()} + 1, 0);
  for (const Voxel voxel : voxels) ++counts[voxel];
  return counts;
}

// "3", "3 and 7", "3, 7, 9 and 20 more" of values that nothing explains.
std::string values(const std::vector<std::size_t>& all) {
  constexpr std::size_t shown = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, all.size()); ++i) {
    text += (i == 0 ? "" : i + 1 == all.size() ? " and " : ", ") + fmt::format("{}", all[i]);
  }
  return all.size() > shown ? text + fmt::format(" and {} more", all.size() - shown) : text;
}

void check_structures(const anatomy::Case& patient, std::vector<std::string>& problems) {
  const auto counts = histogram(patient.structures.voxels);
  const auto& table = patient.description.structures;
  std::vector<std::size_t> unknown;
  for (std::size_t label = 1; label < counts.size(); ++label) {
    const bool known =
        counts[label] == 0 || std::any_of(table.begin(), table.end(),
                                          [label](const anatomy::Structure& entry) { return entry.label == label; });
    if (!known) unknown.push_back(label);
  }
  if (unknown.empty()) return;
  problems.push_back(fmt::format("{} has voxels with the label{} {}, which case.xml does not list as a structure",
                                 patient.description.structures_file, unknown.size() > 1 ? "s" : "",
                                 values(unknown)));
}

void check_tissue_ids(const anatomy::Case& patient, std::vector<std::string>& problems) {
  const auto counts = histogram(patient.tissues.voxels);
  std::vector<std::size_t> unknown;
  for (std::size_t id = 0; id < counts.size(); ++id) {
    if (counts[id] > 0 && patient.library.find(static_cast<anatomy::TissueId>(id)) == nullptr) unknown.push_back(id);
  }
  if (!unknown.empty()) {
    problems.push_back(fmt::format("{} has voxels with the tissue id{} {}, which the tissue library does not have",
                                   patient.description.tissues_file, unknown.size() > 1 ? "s" : "", values(unknown)));
  }
  if (counts[anatomy::tissue::air] == patient.tissues.voxels.size()) {
    problems.push_back(fmt::format("{} holds nothing but air", patient.description.tissues_file));
  }
}

// The tissues along a line, from `start` in steps of path_step.
class Line {
 public:
  Line(const anatomy::TissueVolume& tissues, const Vec3& start, const Vec3& direction)
      : tissues_(tissues), start_(start), direction_(direction) {}

  anatomy::TissueId at(double distance) const {
    return anatomy::nearest<anatomy::TissueId>(tissues_, start_ + distance * direction_, outside);
  }

  // The first distance in [0, limit] at which `wanted` holds, or nothing; the search ends where the image does.
  template <typename Wanted>
  std::optional<double> find(double limit, Wanted wanted) const {
    for (int step = 0; step * path_step <= limit; ++step) {
      const anatomy::TissueId found = at(step * path_step);
      if (wanted(found)) return step * path_step;
      if (found == outside) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  const anatomy::TissueVolume& tissues_;
  Vec3 start_, direction_;
};

// The entry must be where air meets the body. A crop may have no skin on the line: then any entry is valid.
void check_entry(const anatomy::Case& patient, const anatomy::NeedlePath& path, std::vector<std::string>& problems) {
  const double tolerance = std::max(3.0, 1.5 * patient.ct.grid.spacing.maxCoeff());
  const auto is_air = [](anatomy::TissueId id) { return id == anatomy::tissue::air; };
  const auto is_body = [](anatomy::TissueId id) { return id != anatomy::tissue::air && id != outside; };
  const Line inwards(patient.tissues, path.entry, path.direction());
  if (is_air(inwards.at(0.0))) {
    const auto skin = inwards.find(path.length(), is_body);
    if (!skin)
      problems.push_back("the planned path lies in air from its entry to its target; it misses the body");
    else if (*skin > tolerance) {
      problems.push_back(
          fmt::format("the entry {} of the planned path lies {:.1f} mm in front of the skin, expected on it",
                      point(path.entry), *skin));
    }
    return;
  }
  const Line outwards(patient.tissues, path.entry, -path.direction());
  if (const auto skin = outwards.find(longest_body, is_air); skin && *skin > tolerance) {
    problems.push_back(fmt::format("the entry {} of the planned path lies {:.1f} mm under the skin, expected on it",
                                   point(path.entry), *skin));
  }
}

// No needle may be planned into the spinal cord.
void check_cord(const anatomy::Case& patient, const anatomy::NeedlePath& path, std::vector<std::string>& problems) {
  const Line inwards(patient.tissues, path.entry, path.direction());
  const auto cord =
      inwards.find(path.length(), [](anatomy::TissueId id) { return id == anatomy::tissue::spinal_cord; });
  if (!cord) return;
  problems.push_back(
      fmt::format("the planned path goes into the spinal cord {:.1f} mm from its entry; plan it below the conus, at "
                  "L2/L3 or lower",
                  *cord));
}

}  // namespace

std::vector<std::string> lattice_problems(const anatomy::Case& patient) {
  constexpr double tolerance = 0.01;  // mm
  std::vector<std::string> problems;
  const anatomy::CaseDescription& description = patient.description;
  if (patient.ct.empty()) return problems;
  const anatomy::Grid& ct = patient.ct.grid;
  if (!patient.structures.empty() && !anatomy::same_lattice(ct, patient.structures.grid, tolerance)) {
    const anatomy::Grid& grid = patient.structures.grid;
    problems.push_back(fmt::format(
        "{} ({} voxels, axes {}, from {}) does not lie on the lattice of {} ({} voxels, axes {}, from {})",
        description.structures_file, size_of(grid), grid.axes(), point(grid.origin), description.ct_file, size_of(ct),
        ct.axes(), point(ct.origin)));
  }
  if (!patient.tissues.empty()) {
    if (const double apart = box_distance(ct, patient.tissues.grid); !(apart <= tolerance)) {
      problems.push_back(fmt::format("{} does not cover the same box as {}: a corner lies {:.2f} mm off",
                                     description.tissues_file, description.ct_file, apart));
    }
  }
  return problems;
}

std::vector<std::string> path_problems(const anatomy::Case& patient, const anatomy::NeedlePath& path) {
  std::vector<std::string> problems;
  const anatomy::CaseDescription& description = patient.description;
  if (path.length() > description.needle.length) {
    problems.push_back(fmt::format(
        "the planned path is {:.1f} mm long, but the needle length_mm is {}; take a longer needle or a nearer target",
        path.length(), description.needle.length));
  }
  bool inside = true;
  for (const auto& [name, position] : {std::pair("entry", path.entry), std::pair("target", path.target)}) {
    if (anatomy::nearest<anatomy::TissueId>(patient.tissues, position, outside) != outside) continue;
    problems.push_back(fmt::format("the {} {} of the planned path lies outside the image", name, point(position)));
    inside = false;
  }
  if (!inside) return problems;
  check_entry(patient, path, problems);
  check_cord(patient, path, problems);
  const anatomy::TissueProperties* aim = patient.library.find(description.procedure.target_tissue);
  if (aim == nullptr) return problems;
  const Line inwards(patient.tissues, path.entry, path.direction());
  const double reach = path.length() + description.procedure.target_tolerance;
  if (!inwards.find(reach, [aim](anatomy::TissueId id) { return id == aim->id; })) {
    problems.push_back(fmt::format(
        "the planned path does not meet the target_tissue '{}' within the target_tolerance_mm of {} after its target",
        aim->name, description.procedure.target_tolerance));
  }
  return problems;
}

std::vector<std::string> content_problems(const anatomy::Case& patient) {
  std::vector<std::string> problems;
  if (!patient.structures.empty()) check_structures(patient, problems);
  if (!patient.tissues.empty()) {
    check_tissue_ids(patient, problems);
    if (const auto& path = patient.description.procedure.path; path && !patient.ct.empty()) {
      for (std::string& problem : path_problems(patient, *path)) problems.push_back(std::move(problem));
    }
  }
  return problems;
}

}  // namespace bodkin::io
