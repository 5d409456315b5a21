#include "patient/from_ct/lumbar_landmarks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

namespace bodkin::patient {
namespace {

constexpr double deepest_search = 60.0;                // mm behind the canal that is searched for spinous processes
constexpr double sacral_plate = 35.0;                  // mm: no lumbar lamina is so high
constexpr double least_gap = 3.0, least_lamina = 4.0;  // mm of height

// Thickness of the ligamentum flavum in mm (Khasawneh, Abu El-Rub and Allouh 2023, MRI of 350 adults;
// reference/layer_thickness.csv). Above L2 the value of L2/L3; without levels that of L3/L4.
double flavum_thickness(const std::string& name) {
  static const std::map<std::string, double> known = {{"L2_L3", 3.19}, {"L3_L4", 3.38}, {"L4_L5", 3.71},
                                                      {"L5_S1", 3.64}, {"L1_L2", 3.19}, {"T12_L1", 3.19}};
  const auto found = known.find(name);
  return found == known.end() ? 3.38 : found->second;
}

double ahead(const SpinalCanal& canal, std::size_t n) {
  return canal.lowest + static_cast<double>(n);
}

// Line along the tips: the hindmost bone of each height, carried across the gaps between processes.
void find_tips(const SpineView& view, LumbarSpine& spine) {
  const auto& sections = spine.canal.sections;
  const int count = static_cast<int>(sections.size());
  std::vector<double> hindmost(sections.size(), -1e9), sum(sections.size(), 0.0), weight(sections.size(), 0.0);
  for (int n = 0; n < count; ++n) {
    const auto at = static_cast<std::size_t>(n);
    const CanalSection& s = sections[at];
    const int k = view.k_of(ahead(spine.canal, at)), middle = view.i_of(s.x);
    for (int j = view.j_of(s.back + 4.0); j <= view.j_of(s.back + deepest_search); ++j) {
      int bone = 0;
      for (int i = middle - 5; i <= middle + 5; ++i) {
        if (!view.bone_at(i, j, k)) continue;
        ++bone;
        if (view.y_of(j) > s.back + 10.0) sum[at] += view.x_of(i), weight[at] += 1.0;
      }
      if (bone >= 3) hindmost[at] = view.y_of(j) + 0.5;
    }
  }
  // Closing along the spine: a window wide enough to hold a process somewhere, then back to the processes' own
  // heights.
  const auto window = [&](const std::vector<double>& values, int reach, bool most) {
    std::vector<double> out(values.size());
    for (int n = 0; n < count; ++n) {
      const auto from = values.begin() + std::max(0, n - reach), to = values.begin() + std::min(count, n + reach + 1);
      out[static_cast<std::size_t>(n)] = most ? *std::max_element(from, to) : *std::min_element(from, to);
    }
    return out;
  };
  constexpr int reach = 18;
  auto tips = window(window(hindmost, reach, true), reach, false);
  double last = -1e9;
  for (const double tip : tips) last = std::max(last, tip);
  for (int n = 0; n < count; ++n) {
    const auto at = static_cast<std::size_t>(n);
    if (tips[at] < -1e8) tips[at] = n > 0 && tips[at - 1] > -1e8 ? tips[at - 1] : sections[at].back + 30.0;
    tips[at] = std::max(tips[at], sections[at].back + 12.0);
  }
  spine.tip = moving_average(tips, 6);
  // Across the gaps, the processes' own midline; where there are none the canal's.
  spine.tip_x.resize(sections.size());
  for (int n = 0; n < count; ++n) {
    double x = 0.0, w = 0.0;
    for (int m = std::max(0, n - 25); m <= std::min(count - 1, n + 25); ++m) {
      x += sum[static_cast<std::size_t>(m)], w += weight[static_cast<std::size_t>(m)];
    }
    const auto at = static_cast<std::size_t>(n);
    spine.tip_x[at] = w > 30.0 ? x / w : sections[at].x;
  }
  spine.tip_x = moving_average(spine.tip_x, 8);
}

// A stretch of heights with or without a lamina in the midline.
struct Stretch {
  int first, last;  // sections
  bool bone;
  std::uint8_t level;  // role of most of its labelled voxels
};

std::vector<Stretch> stretches_of(const SpineView& view, const SpinalCanal& canal) {
  std::vector<Stretch> stretches;
  std::array<int, 256> votes{};
  const auto close_stretch = [&] {
    if (stretches.empty()) return;
    const auto most = std::max_element(votes.begin() + 1, votes.begin() + spine_role::vertebra);
    stretches.back().level = *most > 0 ? static_cast<std::uint8_t>(most - votes.begin()) : spine_role::none;
    votes.fill(0);
  };
  for (int n = 0; n < static_cast<int>(canal.sections.size()); ++n) {
    const CanalSection& s = canal.sections[static_cast<std::size_t>(n)];
    const int k = view.k_of(ahead(canal, static_cast<std::size_t>(n))), middle = view.i_of(s.x);
    int bone = 0, count = 0;
    std::array<int, 256> here{};
    for (int j = view.j_of(s.back - 1.0); j <= view.j_of(s.back + 8.0); ++j) {
      for (int i = middle - 2; i <= middle + 2; ++i, ++count) {
        if (!view.bone_at(i, j, k)) continue;
        ++bone;
        ++here[view.role.at(i, j, k)];
      }
    }
    const bool lamina = bone > 0.15 * count;
    if (stretches.empty() || stretches.back().bone != lamina) {
      close_stretch();
      stretches.push_back({n, n, lamina, spine_role::none});
    }
    stretches.back().last = n;
    for (std::size_t v = 0; v < here.size(); ++v) votes[v] += here[v];
  }
  close_stretch();
  return stretches;
}

// Joins stretches that a stretch too low to count keeps apart.
void drop_short(std::vector<Stretch>& stretches) {
  for (std::size_t n = 1; n + 1 < stretches.size();) {
    Stretch& s = stretches[n];
    if (s.last - s.first + 1 < (s.bone ? least_lamina : least_gap)) {
      Stretch& below = stretches[n - 1];
      const Stretch& above = stretches[n + 1];
      if (below.level == spine_role::none) below.level = above.level;
      below.last = above.last;
      stretches.erase(stretches.begin() + static_cast<std::ptrdiff_t>(n),
                      stretches.begin() + static_cast<std::ptrdiff_t>(n) + 2);
    } else {
      ++n;
    }
  }
}

// How far the true wall of the canal stands behind `back` in an interspace: the posterior epidural fat shows where it
// ends. Nothing when no fat is seen.
std::optional<double> fat_behind(const SpineView& view, const SpinalCanal& canal, const Interspace& gap,
                                 double most) {
  constexpr int from = -4, to = 10;  // mm about `back`
  std::array<double, to - from + 1> profile{};
  for (int n = from; n <= to; ++n) {
    double sum = 0.0;
    int count = 0;
    for (double z = gap.middle() - 3.0; z <= gap.middle() + 3.0; z += 1.0) {
      const CanalSection s = canal.at(z);
      for (double x = s.x - 2.0; x <= s.x + 2.0; x += 1.0, ++count) {
        sum += anatomy::linear(view.hounsfield, Vec3(x, s.back + n, z), 0.0);
      }
    }
    profile[static_cast<std::size_t>(n - from)] = sum / count;
  }
  const auto least = std::min_element(profile.begin(), profile.begin() + (4 - from) + 1);
  if (*least > 5.0) return std::nullopt;
  const double ligament = *std::max_element(least, profile.end());
  const double border = 0.5 * (*least + std::clamp(ligament, 20.0, 60.0));
  const auto edge = std::find_if(least, profile.end(), [&](double hu) { return hu > border; });
  return std::clamp(static_cast<double>(edge - profile.begin() + from) - 0.5, 0.0, most);
}

std::vector<Interspace> gaps_between(const std::vector<Stretch>& stretches, const SpinalCanal& canal,
                                     LumbarSpine& spine) {
  struct Gap {
    Interspace space;
    std::uint8_t above, below;
    double below_height;  // mm of lamina below the gap
  };
  std::vector<Gap> gaps;  // from head to foot
  for (std::size_t n = stretches.size(); n-- > 0;) {
    if (stretches[n].bone || n == 0 || n + 1 == stretches.size()) continue;
    const Stretch& below = stretches[n - 1];
    gaps.push_back({{"", ahead(canal, static_cast<std::size_t>(stretches[n].first)) - 0.5,
                     ahead(canal, static_cast<std::size_t>(stretches[n].last)) + 0.5, 0.0},
                    stretches[n + 1].level,
                    below.level,
                    static_cast<double>(below.last - below.first + 1)});
  }
  std::vector<Interspace> found;
  const bool named = std::any_of(gaps.begin(), gaps.end(), [](const Gap& g) { return g.above != 0 && g.below != 0; });
  const auto sacrum =
      std::find_if(gaps.begin(), gaps.end(), [](const Gap& g) { return g.below_height > sacral_plate; });
  if (named) {
    spine.levels_known = true;
    for (Gap& g : gaps) {
      const bool lumbar =
          g.below >= spine_role::l1 && g.below <= spine_role::sacrum && g.above >= 12 && g.above < g.below;
      if (!lumbar) continue;
      g.space.name = level_name(g.above) + "_" + level_name(g.below);
      found.push_back(g.space);
    }
  } else if (sacrum != gaps.end()) {
    spine.levels_known = spine.counted_from_sacrum = true;
    const auto count = sacrum - gaps.begin() + 1;  // interspaces at and above the sacrum
    for (std::ptrdiff_t n = std::max<std::ptrdiff_t>(0, count - 5); n < count; ++n) {
      const auto upper = 5 - (count - 1 - n);
      gaps[static_cast<std::size_t>(n)].space.name = upper == 5 ? "L5_S1" : fmt::format("L{}_L{}", upper, upper + 1);
      found.push_back(gaps[static_cast<std::size_t>(n)].space);
    }
  } else {
    for (std::size_t n = 0; n < gaps.size(); ++n) {
      gaps[n].space.name = fmt::format("interspace_{}", gaps.size() - n);
      found.push_back(gaps[n].space);
    }
  }
  return found;
}

}  // namespace

LumbarSpine find_interspaces(const SpineView& view, SpinalCanal canal) {
  LumbarSpine spine;
  auto stretches = stretches_of(view, canal);
  drop_short(stretches);
  spine.interspaces = gaps_between(stretches, canal, spine);
  spine.canal = std::move(canal);
  for (Interspace& gap : spine.interspaces) {
    gap.flavum = flavum_thickness(gap.name);
    // A label reaches the wall or falls short of the fat; the line along the fronts of the laminae always runs in
    // front of the flavum, which bridges their backs.
    constexpr double most = 3.0;
    gap.bulge = fat_behind(view, spine.canal, gap, most).value_or(spine.canal.labelled ? 0.0 : most);
  }
  find_tips(view, spine);
  return spine;
}

}  // namespace bodkin::patient
