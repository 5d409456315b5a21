#include "patient/from_ct/midline_search.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "patient/from_ct/spinal_canal.h"

#include "core/parallel_for.h"

namespace bodkin::patient {
namespace {

constexpr double search_spacing = 2.0;    // mm of the view that are searched
constexpr double least_laminae = 30.0;    // mm of height
constexpr double longest_process = 45.0;  // mm from the canal to the tip of a spinous process
constexpr double most_lung = 0.03;        // of a slice's voxels

std::vector<bool> slices_without_lung(const SpineView& view, const BodySurface& body) {
  const auto& size = view.grid().size;
  std::vector<bool> free(static_cast<std::size_t>(size[2]));
  for (int k = 0; k < size[2]; ++k) {
    int lung = 0, count = 0;
    for (int j = 0; j < size[1]; j += 3) {
      for (int i = 0; i < size[0]; i += 3, ++count) {
        lung += anatomy::nearest(body.lung, view.grid().to_patient(Vec3(i, j, k)), std::uint8_t{0});
      }
    }
    free[static_cast<std::size_t>(k)] = lung < most_lung * count;
  }
  return free;
}

}  // namespace

std::optional<SpineMidline> find_midline(const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                                         const BodySurface& body) {
  const SpineView view = view_spine(ct, {}, {}, tissues, box_of_image(ct.grid), search_spacing);
  const auto& size = view.grid().size;
  const auto free = slices_without_lung(view, body);
  // Bone behind the canal, mm, for each sagittal plane and height; 0 where there is no canal.
  const auto planes = static_cast<std::size_t>(size[0]), heights = static_cast<std::size_t>(size[2]);
  std::vector<float> laminae(planes * heights, 0.0F), backs(planes * heights, 0.0F);
  parallel_for(size[2], [&](int k) {
    if (!free[static_cast<std::size_t>(k)]) return;
    for (int i = 0; i < size[0]; ++i) {
      const auto gap = canal_gap(view, i, k);
      if (!gap || gap->lamina > 2 * longest_process) continue;
      const std::size_t at = static_cast<std::size_t>(k) * planes + static_cast<std::size_t>(i);
      laminae[at] = static_cast<float>(std::min(gap->lamina, longest_process));
      backs[at] = static_cast<float>(gap->back);
    }
  });
  // The score of plane i between heights a and b: bone in it and, less, in its neighbours.
  const auto score = [&](int i, int a, int b) {
    double sum = 0.0;
    for (int k = std::max(0, a); k <= std::min(size[2] - 1, b); ++k) {
      for (int n = std::max(0, i - 2); n <= std::min(size[0] - 1, i + 2); ++n) {
        sum += laminae[static_cast<std::size_t>(k) * planes + static_cast<std::size_t>(n)] / (1 + std::abs(n - i));
      }
    }
    return sum;
  };
  const auto best_of = [&](int from, int to, int a, int b) {
    int best = std::clamp((from + to) / 2, 0, size[0] - 1);
    double most = 0.0;
    for (int i = std::max(0, from); i <= std::min(size[0] - 1, to); ++i) {
      if (const double s = score(i, a, b); s > most) most = s, best = i;
    }
    return best;
  };
  const int middle = best_of(0, size[0] - 1, 0, size[2] - 1);
  double low = 1e9, high = -1e9, front = 1e9, back = -1e9;
  int rows = 0;
  for (int k = 0; k < size[2]; ++k) {
    const std::size_t at = static_cast<std::size_t>(k) * planes + static_cast<std::size_t>(middle);
    if (laminae[at] <= 0.0F) continue;
    ++rows;
    low = std::min(low, view.z_of(k)), high = std::max(high, view.z_of(k));
    front = std::min<double>(front, backs[at]), back = std::max<double>(back, backs[at]);
  }
  if (rows * search_spacing < least_laminae) return std::nullopt;

  const int reach = static_cast<int>(40.0 / search_spacing);
  std::vector<double> x(heights);
  for (int k = 0; k < size[2]; ++k) {
    x[static_cast<std::size_t>(k)] = view.x_of(best_of(middle - 4, middle + 4, k - reach, k + reach));
  }
  const auto line = std::make_shared<const std::vector<double>>(moving_average(x, reach));
  SpineMidline found;
  found.box = {Vec3(view.x_of(middle) - 32.0, front - 45.0, low - 25.0),
               Vec3(view.x_of(middle) + 32.0, back + 70.0, high + 25.0)};
  const double first = view.z_of(0);
  found.x_at = [line, first](double z) {
    const double n = std::clamp((z - first) / search_spacing, 0.0, static_cast<double>(line->size()) - 1.0);
    const auto at = static_cast<std::size_t>(n);
    const auto next = std::min(at + 1, line->size() - 1);
    return (*line)[at] + (n - static_cast<double>(at)) * ((*line)[next] - (*line)[at]);
  };
  return found;
}

}  // namespace bodkin::patient
