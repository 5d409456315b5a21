#include "patient/from_ct/level_landmarks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace bodkin::patient {
namespace {

constexpr double wide_half_breadth = 100.0;              // mm of the view beside the midline
constexpr double bone_before = 36.0, bone_behind = 7.0;  // mm of bone examined in front of the canal and behind it

// Bone beside the spine, by slice of the view: mm^2 of each side, -1 where the image does not show the side.
struct Flanks {
  std::vector<double> wing;   // between 28 and 40 mm beside the midline, the
                              // larger of the two sides' mean
  std::vector<double> ilium;  // between 48 and 75 mm, the larger side
};

// mm^2 above `least` HU between `from` and `to` mm beside the midline on one side (-1 right, 1 left), or -1.
double bone_beside(const SpineView& view, const CanalSection& section, int k, int side, double from, double to,
                   int least) {
  const auto& size = view.grid().size;
  const int near = view.i_of(section.x + side * from), far = view.i_of(section.x + side * to);
  if (far < 0 || far >= size[0]) return -1.0;
  int count = 0;
  for (int j = std::max(0, view.j_of(section.front - bone_before));
       j <= std::min(size[1] - 1, view.j_of(section.back + bone_behind)); ++j) {
    for (int i = std::min(near, far); i <= std::max(near, far); ++i) count += view.hounsfield.at(i, j, k) > least;
  }
  return count * view.grid().spacing.x() * view.grid().spacing.y();
}

Flanks flanks_of(const SpineView& view, const SpinalCanal& canal) {
  Flanks flanks;
  for (int k = 0; k < view.grid().size[2]; ++k) {
    const CanalSection section = canal.at(view.z_of(k));
    double wings = 0.0, ilium = -1.0;
    int sides = 0;
    for (const int side : {-1, 1}) {
      if (const double wing = bone_beside(view, section, k, side, 28.0, 40.0, 120); wing >= 0.0)
        wings += wing, ++sides;
      ilium = std::max(ilium, bone_beside(view, section, k, side, 48.0, 75.0, 200));
    }
    flanks.wing.push_back(sides > 0 ? wings / sides : -1.0);
    flanks.ilium.push_back(ilium);
  }
  return flanks;
}

// The uppermost slice from which the wings of the sacrum continue downwards, or -1.
int sacrum_slice(const Flanks& flanks, double step) {
  constexpr double least = 120.0, mean = 150.0, beside = 100.0;  // mm^2
  const int height = static_cast<int>(20.0 / step);
  for (int k = static_cast<int>(flanks.wing.size()) - 1; k >= height; --k) {
    const auto at = flanks.wing.begin() + k;
    if (flanks.ilium[static_cast<std::size_t>(k)] < beside || *std::min_element(at - height, at + 1) < least)
      continue;
    if (std::accumulate(at - height, at + 1, 0.0) / (height + 1) >= mean) return k;
  }
  return -1;
}

// The highest slice of the ilium present at slice `from`.
int crest_slice(const Flanks& flanks, int from) {
  int k = from;
  while (k + 1 < static_cast<int>(flanks.ilium.size()) && flanks.ilium[static_cast<std::size_t>(k) + 1] > 25.0) ++k;
  return k;
}

struct RibSearch {
  double nearest = 1e9, furthest = 0.0;  // mm beside the midline
  double medial_z = 0.0, medial_y = 0.0, medial = 0.0;
  double lateral_z = 0.0, lateral = 0.0;
  double volume = 0.0;  // mm^3
  int side = 0;
};

// LPS z at which the lowest rib of a side (-1 right, 1 left) leaves the spine.
std::optional<double> lowest_rib(const SpineView& view, const SpinalCanal& canal, int side) {
  constexpr double spine = 28.0, reach = 34.0, least_length = 58.0,
                   end = 6.0;                         // mm beside the midline
  constexpr double smallest = 400.0, largest = 40e3;  // mm^3
  MaskVolume mask = view.bone;
  const auto& size = view.grid().size;
  const auto beside = [&](int i, int k) { return side * (view.x_of(i) - canal.at(view.z_of(k)).x); };
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (beside(i, k) < spine) mask.at(i, j, k) = 0;
      }
    }
  }
  const auto pieces = number_pieces(mask);
  const std::uint32_t count = *std::max_element(pieces.voxels.begin(), pieces.voxels.end());
  std::vector<RibSearch> ribs(count + 1);
  const double voxel = view.grid().spacing.prod();
  const auto each = [&](const auto& work) {
    for (int k = 0; k < size[2]; ++k) {
      const CanalSection section = canal.at(view.z_of(k));
      for (int j = 0; j < size[1]; ++j) {
        for (int i = 0; i < size[0]; ++i) {
          if (pieces.at(i, j, k) != 0)
            work(ribs[pieces.at(i, j, k)], side * (view.x_of(i) - section.x), view.y_of(j) - section.back,
                 view.z_of(k));
        }
      }
    }
  };
  each([&](RibSearch& rib, double x, double, double) {
    rib.nearest = std::min(rib.nearest, x), rib.furthest = std::max(rib.furthest, x);
    rib.volume += voxel;
  });
  each([&](RibSearch& rib, double x, double y, double z) {
    if (x < rib.nearest + end) rib.medial_z += z, rib.medial_y += y, rib.medial += 1.0;
    if (x > rib.furthest - end) rib.lateral_z += z, rib.lateral += 1.0;
  });
  std::optional<double> lowest;
  for (const RibSearch& rib : ribs) {
    if (rib.volume < smallest || rib.volume > largest || rib.nearest > reach || rib.furthest < least_length) continue;
    const double z = rib.medial_z / rib.medial, y = rib.medial_y / rib.medial;
    if (y < -35.0 || y > 25.0 || rib.lateral_z / rib.lateral > z + 4.0) continue;
    if (!lowest || z < *lowest) lowest = z;
  }
  return lowest;
}

// The height of the lowest ribs if all visible sides have them there.
std::optional<double> lowest_ribs(const SpineView& view, const SpinalCanal& canal) {
  constexpr double least_below = 45.0, most_apart = 20.0;  // mm
  const double x = canal.at(view.z_of(view.grid().size[2] / 2)).x;
  std::vector<double> found;
  for (const int side : {-1, 1}) {
    const double shown = side < 0 ? x - view.x_of(0) : view.x_of(view.grid().size[0] - 1) - x;
    if (shown < 65.0) continue;
    const auto rib = lowest_rib(view, canal, side);
    if (!rib) return std::nullopt;
    found.push_back(*rib);
  }
  if (found.empty()) return std::nullopt;
  const auto [low, high] = std::minmax_element(found.begin(), found.end());
  if (*high - *low > most_apart || *low - view.z_of(0) < least_below) return std::nullopt;
  return 0.5 * (*low + *high);
}

}  // namespace

PatientBox wide_box(const SpinalCanal& canal, const PatientBox& image) {
  PatientBox box = image;
  double front = 1e9, back = -1e9;
  for (const CanalSection& section : canal.sections) {
    front = std::min(front, section.front), back = std::max(back, section.back);
  }
  const double x = canal.sections[canal.sections.size() / 2].x;
  box.low.x() = x - wide_half_breadth, box.high.x() = x + wide_half_breadth;
  box.low.y() = front - bone_before - 5.0, box.high.y() = back + 45.0;
  return box;
}

LevelLandmarks find_level_landmarks(const SpineView& wide, const SpinalCanal& canal) {
  LevelLandmarks found;
  const Flanks flanks = flanks_of(wide, canal);
  if (const int k = sacrum_slice(flanks, wide.grid().spacing.z()); k >= 0) {
    found.sacrum = wide.z_of(k);
    const int crest = crest_slice(flanks, k);
    if (crest + 1 < wide.grid().size[2]) found.iliac_crest = wide.z_of(crest);
  }
  found.lowest_rib = lowest_ribs(wide, canal);
  return found;
}

}  // namespace bodkin::patient
