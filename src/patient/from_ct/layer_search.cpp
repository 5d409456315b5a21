#include "patient/from_ct/layer_search.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bodkin::patient {
namespace {

constexpr double look_step = 0.5;                       // mm between samples
constexpr double first_look = -10.0, last_look = 14.0;  // mm about CanalSection::back
constexpr double furthest_edge = 7.0;                   // mm behind it
constexpr double row_half_breadth = 3.0;                // mm of the midline

// Mean HU along the canal's depth, about CanalSection::back.
struct DepthRow {
  std::vector<double> hounsfield;
  int rows = 0;  // heights that contributed
  int index(double offset) const { return static_cast<int>(std::lround((offset - first_look) / look_step)); }
  double offset(double index) const { return first_look + look_step * index; }
  double least(int from, int to) const {
    return *std::min_element(hounsfield.begin() + std::max(0, from), hounsfield.begin() + clip(to) + 1);
  }
  double most(int from, int to) const {
    return *std::max_element(hounsfield.begin() + std::max(0, from), hounsfield.begin() + clip(to) + 1);
  }
  // Standard deviation of changes within 2 mm, in front of the layers: noise and roots, but no slow slope.
  double noise() const {
    constexpr int apart = static_cast<int>(2.0 / look_step);
    double sum = 0.0;
    int count = 0;
    for (int n = apart; n + apart <= index(-2.0); ++n, ++count) {
      const auto at = hounsfield.begin() + n;
      const double change = *at - 0.5 * (*(at - apart) + *(at + apart));
      sum += change * change / 1.5;
    }
    return std::sqrt(sum / count);
  }
  int clip(int n) const { return std::min(n, static_cast<int>(hounsfield.size()) - 1); }
};

bool shows_lamina(const SpineView& view, const CanalSection& s, double z) {
  const int middle = view.i_of(s.x), k = view.k_of(z);
  int bone = 0, count = 0;
  for (int j = view.j_of(s.back - 1.0); j <= view.j_of(s.back + 3.0); ++j) {
    for (int i = middle - 2; i <= middle + 2; ++i, ++count) bone += view.bone_at(i, j, k) ? 1 : 0;
  }
  return bone > 0.3 * count;
}

DepthRow depth_row(const SpineView& view, const SpinalCanal& canal, double low, double high) {
  DepthRow row;
  row.hounsfield.assign(static_cast<std::size_t>((last_look - first_look) / look_step) + 1, 0.0);
  for (double z = low; z <= high; z += 1.0) {
    const CanalSection s = canal.at(z);
    if (shows_lamina(view, s, z)) continue;
    ++row.rows;
    for (std::size_t n = 0; n < row.hounsfield.size(); ++n) {
      const double y = s.back + row.offset(static_cast<double>(n));
      double sum = 0.0;
      int count = 0;
      for (double x = s.x - row_half_breadth; x <= s.x + row_half_breadth; x += 1.0, ++count)
        sum += anatomy::linear(view.hounsfield, Vec3(x, y, z), 0.0);
      row.hounsfield[n] += sum / count;
    }
  }
  for (double& value : row.hounsfield) value /= std::max(1, row.rows);
  return row;
}

// The offset at which the row passes `level` between index n and the next one in direction `way`.
double passing(const DepthRow& row, int n, int way, double level) {
  const double here = row.hounsfield[static_cast<std::size_t>(n)];
  const int beyond = n + way;
  const double next = row.hounsfield[static_cast<std::size_t>(beyond)];
  const double part = std::abs(next - here) < 1e-9 ? 0.0 : std::clamp((level - here) / (next - here), 0.0, 1.0);
  return row.offset(n + way * part);
}

// The first offset from index n on in direction `way` at which the rising row reaches `level`.
std::optional<double> reaches(const DepthRow& row, int n, int way, double level) {
  const int count = static_cast<int>(row.hounsfield.size());
  for (int next = n + way; next >= 0 && next < count; next += way) {
    if (row.hounsfield[static_cast<std::size_t>(next)] >= level) return passing(row, next - way, way, level);
  }
  return std::nullopt;
}

}  // namespace

LayersSeen see_layers(const SpineView& view, const SpinalCanal& canal, double low, double high, double voxel) {
  constexpr double least_step = 35.0, least_ligament = 20.0, most_ligament = 95.0;  // HU
  constexpr double fat_below_sac = 25.0;                                            // HU
  constexpr double least_fat = 1.5, most_fat = 9.0;                                 // mm
  const DepthRow row = depth_row(view, canal, low, high);
  if (row.rows < 2) return {};
  LayersSeen seen;
  const double step_needed = std::max(least_step, 4.0 * row.noise());
  const int before = static_cast<int>(5.0 / look_step), behind = static_cast<int>(4.5 / look_step);
  for (int n = before; n <= row.index(furthest_edge); ++n) {
    const auto here = row.hounsfield[static_cast<std::size_t>(n)];
    const double floor = row.least(n - before, n), top = std::min(row.most(n, n + behind), most_ligament);
    if (top - floor < step_needed || top < least_ligament || here > 0.5 * (floor + top)) continue;
    // The lowest HU before the ligament may lie slightly further back: in fat, if there is any.
    int lowest = n;
    while (row.offset(lowest + 1) <= furthest_edge &&
           row.hounsfield[static_cast<std::size_t>(lowest) + 1] < row.hounsfield[static_cast<std::size_t>(lowest)])
      ++lowest;
    const double fat = row.least(lowest - before, lowest);
    const double ligament = std::min(row.most(lowest, lowest + static_cast<int>(5.0 / look_step)), most_ligament);
    const auto edge = reaches(row, lowest, 1, 0.5 * (fat + ligament));
    const auto quarter = reaches(row, lowest, 1, 0.75 * fat + 0.25 * ligament);
    const auto three = reaches(row, lowest, 1, 0.25 * fat + 0.75 * ligament);
    if (!edge || !quarter || !three || *edge > furthest_edge) break;
    seen.wall = Measured{*edge, std::max(0.5 * voxel, 0.5 * (*three - *quarter))};
    // The sac, 4 to 9 mm in front of the fat.
    std::vector<double> sac;
    for (int m = lowest - static_cast<int>(9.0 / look_step); m <= lowest - static_cast<int>(4.0 / look_step); ++m) {
      if (m >= 0) sac.push_back(row.hounsfield[static_cast<std::size_t>(m)]);
    }
    if (sac.size() < 4) break;
    std::nth_element(sac.begin(), sac.begin() + static_cast<std::ptrdiff_t>(sac.size() / 2), sac.end());
    const double fluid = sac[sac.size() / 2];
    if (fluid - fat < fat_below_sac) break;
    const auto deepest =
        std::min_element(row.hounsfield.begin() + std::max(0, lowest - before), row.hounsfield.begin() + lowest + 1);
    const auto dura = reaches(row, static_cast<int>(deepest - row.hounsfield.begin()), -1, 0.5 * (fat + fluid));
    if (dura && *edge - *dura >= least_fat && *edge - *dura <= most_fat)
      seen.epidural = Measured{*edge - *dura, std::max(0.7 * voxel, seen.wall->uncertainty)};
    break;
  }
  return seen;
}

}  // namespace bodkin::patient
