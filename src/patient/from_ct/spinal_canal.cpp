#include "patient/from_ct/spinal_canal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bodkin::patient {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double usual_half_width = 11.0;  // mm, of a lumbar canal between the pedicles

// Linear interpolation across missing values; the ends keep the nearest known one. At least one must be known.
void fill_missing(std::vector<double>& values) {
  int last = -1;
  const int count = static_cast<int>(values.size());
  for (int n = 0; n < count; ++n) {
    const auto at = static_cast<std::size_t>(n);
    if (std::isnan(values[at])) continue;
    for (int m = last + 1; m < n; ++m) {
      const double f = last < 0 ? 1.0 : static_cast<double>(m - last) / (n - last);
      values[static_cast<std::size_t>(m)] =
          last < 0 ? values[at] : (1 - f) * values[static_cast<std::size_t>(last)] + f * values[at];
    }
    last = n;
  }
  for (int m = last + 1; m < count && last >= 0; ++m)
    values[static_cast<std::size_t>(m)] = values[static_cast<std::size_t>(last)];
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Drops values that differ by more than `most` from the median of the known ones within +-reach.
void drop_outliers(std::vector<double>& front, std::vector<double>& back, int reach, double most) {
  const auto clean = [&](const std::vector<double>& values, int n) {
    std::vector<double> near;
    for (int m = std::max(0, n - reach); m <= std::min(static_cast<int>(values.size()) - 1, n + reach); ++m) {
      if (!std::isnan(values[static_cast<std::size_t>(m)])) near.push_back(values[static_cast<std::size_t>(m)]);
    }
    return std::abs(values[static_cast<std::size_t>(n)] - median(near)) <= most;
  };
  std::vector<int> odd;
  for (int n = 0; n < static_cast<int>(front.size()); ++n) {
    if (!std::isnan(front[static_cast<std::size_t>(n)]) && !(clean(front, n) && clean(back, n))) odd.push_back(n);
  }
  for (const int n : odd) front[static_cast<std::size_t>(n)] = back[static_cast<std::size_t>(n)] = missing;
}

// Distance from the middle of the canal to bone on each side at the height of slice k, or missing.
std::pair<double, double> sides(const SpineView& view, const CanalSection& section, int k) {
  const int i = view.i_of(section.x);
  const double step = view.grid().spacing.x();
  std::array<double, 2> found = {missing, missing};
  for (const int side : {0, 1}) {
    for (int n = 1; n * step <= 16.0 && std::isnan(found[static_cast<std::size_t>(side)]); ++n) {
      int bone = 0;
      for (const double f : {0.3, 0.5, 0.7}) {
        const int j = view.j_of(section.front + f * (section.back - section.front));
        if (view.bone_at(i + (side == 0 ? -n : n), j, k)) ++bone;
      }
      if (bone >= 2) found[static_cast<std::size_t>(side)] = (n - 0.5) * step;
    }
  }
  return {found[0], found[1]};
}

// Moves the sections to the middle between the pedicles and facets, where both sides are visible.
void centre_sections(const SpineView& view, SpinalCanal& canal) {
  std::vector<double> shift(canal.sections.size(), missing);
  for (std::size_t n = 0; n < shift.size(); ++n) {
    const auto [right, left] = sides(view, canal.sections[n], view.k_of(canal.lowest + static_cast<double>(n)));
    if (right + left > 12.0) shift[n] = std::clamp(0.5 * (left - right), -4.0, 4.0);
  }
  if (std::all_of(shift.begin(), shift.end(), [](double v) { return std::isnan(v); })) return;
  fill_missing(shift);
  shift = moving_average(shift, 12);
  for (std::size_t n = 0; n < shift.size(); ++n) canal.sections[n].x += shift[n];
}

void find_widths(const SpineView& view, SpinalCanal& canal) {
  std::vector<double> widths(canal.sections.size(), missing);
  for (std::size_t n = 0; n < widths.size(); ++n) {
    const auto [right, left] = sides(view, canal.sections[n], view.k_of(canal.lowest + static_cast<double>(n)));
    const double width = std::isnan(right) ? left : std::isnan(left) ? right : 0.5 * (left + right);
    if (width >= 7.0) widths[n] = std::min(width, 15.0);
  }
  if (std::all_of(widths.begin(), widths.end(), [](double w) { return std::isnan(w); })) {
    widths.assign(widths.size(), usual_half_width);
  }
  fill_missing(widths);
  widths = moving_average(widths, 8);
  for (std::size_t n = 0; n < widths.size(); ++n) canal.sections[n].half_width = widths[n];
}

}  // namespace

CanalSection SpinalCanal::at(double z) const {
  const double n = std::clamp(z - lowest, 0.0, static_cast<double>(sections.size()) - 1.0);
  const auto low = static_cast<std::size_t>(n), high = std::min(low + 1, sections.size() - 1);
  const double f = n - static_cast<double>(low);
  const CanalSection &a = sections[low], &b = sections[high];
  return {a.x + f * (b.x - a.x), a.front + f * (b.front - a.front), a.back + f * (b.back - a.back),
          a.half_width + f * (b.half_width - a.half_width)};
}

double SpinalCanal::cosine(double z) const {
  const CanalSection above = at(z + 6.0), below = at(z - 6.0);
  const double slope = 0.5 * (above.front + above.back - below.front - below.back) / 12.0;
  return 1.0 / std::sqrt(1.0 + slope * slope);
}

std::vector<double> moving_average(const std::vector<double>& values, int reach) {
  std::vector<double> out(values.size());
  const int count = static_cast<int>(values.size());
  for (int n = 0; n < count; ++n) {
    // The window shrinks symmetrically near the ends, so that a slope remains a slope.
    const int r = std::min({reach, n, count - 1 - n});
    double sum = 0.0;
    for (int m = n - r; m <= n + r; ++m) sum += values[static_cast<std::size_t>(m)];
    out[static_cast<std::size_t>(n)] = sum / (2 * r + 1);
  }
  return out;
}

std::optional<SpinalCanal> canal_from_label(const SpineView& view) {
  const auto& size = view.grid().size;
  std::vector<double> x, front, back, width;
  int first = -1;
  for (int k = 0; k < size[2]; ++k) {
    double sum = 0.0;
    int count = 0;
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (view.role.at(i, j, k) == spine_role::canal) sum += i, ++count;
      }
    }
    if (count < 20) {
      if (first >= 0 && x.size() >= 15) break;
      first = -1;
      x.clear(), front.clear(), back.clear(), width.clear();
      continue;
    }
    if (first < 0) first = k;
    // Depth in the middle third of the width, width from the area of the ellipse of that depth.
    const int middle = static_cast<int>(std::lround(sum / count));
    std::vector<double> fronts, backs;
    for (int i = std::max(0, middle - 2); i <= std::min(size[0] - 1, middle + 2); ++i) {
      int low = -1, high = -1;
      for (int j = 0; j < size[1]; ++j) {
        if (view.role.at(i, j, k) != spine_role::canal) continue;
        if (low < 0) low = j;
        high = j;
      }
      if (low >= 0) fronts.push_back(view.y_of(low)), backs.push_back(view.y_of(high));
    }
    if (fronts.empty()) fronts.push_back(missing), backs.push_back(missing);
    const double half_step = 0.5 * view.grid().spacing.y();
    x.push_back(view.x_of(0) + sum / count * view.grid().spacing.x());
    front.push_back(median(fronts) - half_step);
    back.push_back(median(backs) + half_step);
    const double area = count * view.grid().spacing.x() * view.grid().spacing.y();
    width.push_back(std::clamp(area / (back.back() - front.back()) * 2.0 / 3.14159, 6.0, 16.0));
  }
  if (first < 0 || x.size() < 15) return std::nullopt;
  fill_missing(front), fill_missing(back), fill_missing(width);
  x = moving_average(x, 8), width = moving_average(width, 8);
  front = moving_average(front, 3), back = moving_average(back, 3);
  SpinalCanal canal;
  canal.labelled = true;
  canal.lowest = view.z_of(first);
  for (std::size_t n = 0; n < x.size(); ++n) canal.sections.push_back({x[n], front[n], back[n], width[n]});
  return canal;
}

std::optional<CanalGap> canal_gap(const SpineView& view, int i, int k) {
  const auto& size = view.grid().size;
  const double step = view.grid().spacing.y();
  const int side = view.grid().spacing.x() < 1.5 ? 1 : 0;
  if (i - side < 0 || i + side >= size[0]) return std::nullopt;
  const auto bone = [&](int j) {
    int count = 0;
    for (int di = -side; di <= side; ++di) count += view.bone.at(i + di, j, k);
    return count > side;
  };
  // Mean HU of the `mm` before row j, forwards.
  const auto mean_ahead = [&](int j, double mm) {
    double sum = 0.0;
    int count = 0;
    for (int n = 0; n * step < mm && j - n >= 0; ++n) {
      for (int di = -side; di <= side; ++di, ++count) sum += view.hounsfield.at(i + di, j - n, k);
    }
    return count > 0 ? sum / count : -1000.0;
  };
  int tip = -1;  // back end of the bone last met
  for (int j = size[1] - 1; j > 0; --j) {
    if (!bone(j)) continue;
    if (tip < 0) tip = j;
    if (bone(j - 1)) continue;
    // A gap begins before row j: finds its end at a body or a disc.
    int front = j - 1;
    while (front > 0 && !bone(front) &&
           !(mean_ahead(front, 6.0) > 65.0 && mean_ahead(front, 12.0) > 60.0 && (j - front) * step > 9.0))
      --front;
    const double length = (j - 1 - front) * step;
    const bool bounded = front > 0 && mean_ahead(front, 15.0) > 60.0;
    double sum = 0.0;
    for (int n = front + 1; n < j; ++n) sum += view.hounsfield.at(i, n, k);
    const double inside = sum / std::max(1, j - 1 - front);
    int thick = 0;
    while (j + thick < size[1] && bone(j + thick)) ++thick;
    if (bounded && length >= 9.0 && length <= 27.0 && inside > -90.0 && inside < 90.0 && thick * step >= 3.0) {
      return CanalGap{view.y_of(front) + 0.5 * step, view.y_of(j) - 0.5 * step, (tip - j + 1) * step};
    }
  }
  return std::nullopt;
}

std::optional<SpinalCanal> canal_from_bone(const SpineView& view, const std::vector<double>& midline, double least) {
  const auto& size = view.grid().size;
  std::vector<double> front(static_cast<std::size_t>(size[2]), missing), back = front;
  for (int k = 0; k < size[2]; ++k) {
    const auto n = static_cast<std::size_t>(k);
    if (const auto gap = canal_gap(view, view.i_of(midline[n]), k)) front[n] = gap->front, back[n] = gap->back;
  }
  drop_outliers(front, back, 12, 5.0);
  const auto known = [](double value) { return !std::isnan(value); };
  const auto rows = std::count_if(front.begin(), front.end(), known);
  if (static_cast<double>(rows) * view.grid().spacing.z() < least) return std::nullopt;
  const auto first = std::find_if(front.begin(), front.end(), known) - front.begin();
  const auto last = front.rend() - std::find_if(front.rbegin(), front.rend(), known) - 1;
  fill_missing(front), fill_missing(back);
  front = moving_average(front, 4), back = moving_average(back, 3);
  const auto x = moving_average(midline, 10);
  constexpr std::ptrdiff_t beyond = 20;  // mm of canal past the outermost laminae
  SpinalCanal canal;
  const auto from = std::max<std::ptrdiff_t>(0, first - beyond);
  const auto to = std::min<std::ptrdiff_t>(size[2] - 1, last + beyond);
  canal.lowest = view.z_of(static_cast<int>(from));
  for (auto n = static_cast<std::size_t>(from); n <= static_cast<std::size_t>(to); ++n) {
    canal.sections.push_back({x[n], front[n], back[n], usual_half_width});
  }
  centre_sections(view, canal);
  find_widths(view, canal);
  return canal;
}

}  // namespace bodkin::patient
