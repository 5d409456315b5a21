#include "patient/from_ct/lumbar_landmarks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace bodkin::patient {
namespace {

constexpr double deepest_search = 60.0;                // mm behind the canal, searched for spinous processes
constexpr double within_sacrum = 12.0;                 // mm below its top: a gap there is not in the lumbar spine
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

// LPS z of the conus, between two named interspaces, or beyond them by their mean distance.
std::optional<double> conus_height(const LevelEvidence& evidence, const VertebralLevels& levels, SpinePlace conus) {
  constexpr double usual = 32.0;  // mm from interspace to interspace, if only one is visible
  const auto& gaps = evidence.interspaces;
  std::optional<std::size_t> first, last;  // named ones
  for (std::size_t n = 0; n < gaps.size(); ++n) {
    if (!levels.places[n]) continue;
    if (!first) first = n;
    last = n;
  }
  if (!first) return std::nullopt;
  for (std::size_t n = *first; n < *last; ++n) {
    const double above = *levels.places[n], below = *levels.places[n + 1];
    if (conus >= above && conus <= below) return gaps[n].z + (conus - above) * (gaps[n + 1].z - gaps[n].z);
  }
  const double step = *last > *first ? (gaps[*first].z - gaps[*last].z) / static_cast<double>(*last - *first) : usual;
  if (conus < *levels.places[*first]) return gaps[*first].z + (*levels.places[*first] - conus) * step;
  return gaps[*last].z - (conus - *levels.places[*last]) * step;
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

// Bone in the midline just behind the canal, and its vertebra.
struct BehindCanal {
  int bone = 0, count = 0;
  std::array<int, 256> roles{};
  bool lamina() const { return bone > 0.15 * count; }
};

// At section n, along a line backwards that rises by `slope` mm a millimetre.
BehindCanal behind_canal(const SpineView& view, const SpinalCanal& canal, std::size_t n, double slope) {
  const CanalSection& s = canal.sections[n];
  const double z = ahead(canal, n), along = 1.0 / std::sqrt(1.0 + slope * slope);
  const int middle = view.i_of(s.x);
  BehindCanal behind;
  for (double d = -1.0; d <= 8.0; d += 1.0) {
    const int j = view.j_of(s.back + d * along), k = view.k_of(z + d * along * slope);
    for (int i = middle - 2; i <= middle + 2; ++i, ++behind.count) {
      if (!view.bone_at(i, j, k)) continue;
      ++behind.bone;
      ++behind.roles[view.role.at(i, j, k)];
    }
  }
  return behind;
}

// Laminae overhang the gap below them, so a gap is searched along a level line. Where the canal runs steeply
// backwards, as at L5/S1, a level line meets both the lamina above and the sacrum below; there a line across the
// canal finds the gap.
bool lamina_behind(const SpineView& view, const SpinalCanal& canal, std::size_t n, BehindCanal& level) {
  level = behind_canal(view, canal, n, 0.0);
  if (!level.lamina()) return false;
  constexpr double steep = 0.3;
  const double z = ahead(canal, n), slope = (canal.at(z - 6.0).back - canal.at(z + 6.0).back) / 12.0;
  return slope < steep || behind_canal(view, canal, n, slope).lamina();
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
    BehindCanal here;
    const bool lamina = lamina_behind(view, canal, static_cast<std::size_t>(n), here);
    if (stretches.empty() || stretches.back().bone != lamina) {
      close_stretch();
      stretches.push_back({n, n, lamina, spine_role::none});
    }
    stretches.back().last = n;
    for (std::size_t v = 0; v < votes.size(); ++v) votes[v] += here.roles[v];
  }
  close_stretch();
  return stretches;
}

// Joins stretches separated only by one too low to count.
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

// The gaps between the laminae with their naming evidence; fills spine.interspaces with those of the lumbar spine.
void name_gaps(const std::vector<Stretch>& stretches, const SpinalCanal& canal, const LevelTexts& words,
               LumbarSpine& spine) {
  LevelEvidence evidence;
  std::vector<Interspace> gaps;  // from head to foot
  for (std::size_t n = stretches.size(); n-- > 0;) {
    if (stretches[n].bone || n == 0 || n + 1 == stretches.size()) continue;
    const Stretch& below = stretches[n - 1];
    Interspace gap{"", ahead(canal, static_cast<std::size_t>(stretches[n].first)) - 0.5,
                   ahead(canal, static_cast<std::size_t>(stretches[n].last)) + 0.5, 0.0};
    if (words.landmarks.sacrum && gap.middle() < *words.landmarks.sacrum - within_sacrum) continue;
    evidence.interspaces.push_back({gap.middle(), stretches[n + 1].level, below.level});
    gaps.push_back(gap);
  }
  evidence.sacrum = words.landmarks.sacrum;
  evidence.lowest_rib = words.landmarks.lowest_rib;
  evidence.iliac_crest = words.landmarks.iliac_crest;
  evidence.lowest_vertebra = words.lowest_vertebra;
  spine.levels = name_levels(evidence);
  spine.conus_place = words.conus;
  if (spine.levels.known()) spine.conus = conus_height(evidence, spine.levels, words.conus);
  for (std::size_t n = 0; n < gaps.size(); ++n) {
    gaps[n].name = spine.levels.names[n];
    gaps[n].place = spine.levels.places[n];
    const bool lumbar = !spine.levels.known() || (gaps[n].place && *gaps[n].place >= 1.0);
    if (lumbar && !gaps[n].name.empty()) spine.interspaces.push_back(gaps[n]);
  }
}

}  // namespace

LumbarSpine find_interspaces(const SpineView& view, SpinalCanal canal, const LevelTexts& words) {
  LumbarSpine spine;
  auto stretches = stretches_of(view, canal);
  drop_short(stretches);
  name_gaps(stretches, canal, words, spine);
  spine.canal = std::move(canal);
  for (Interspace& gap : spine.interspaces) {
    gap.flavum = flavum_thickness(gap.name);
    gap.seen = see_layers(view, spine.canal, gap.low + 1.0, gap.high - 1.0, words.voxel);
    // Used where the CT shows no wall: a label ends at it, and the line along the fronts of the laminae runs in front
    // of the flavum, which bridges their backs.
    constexpr double in_front = 3.0;
    gap.bulge = gap.seen.wall ? gap.seen.wall->value : spine.canal.labelled ? 0.0 : in_front;
  }
  find_tips(view, spine);
  return spine;
}

void mark_cut(LumbarSpine& spine, const anatomy::Grid& image, const anatomy::LabelVolume& structures,
              const std::vector<std::uint8_t>& roles) {
  constexpr double vertebra = 40.0,
                   sacrum = 25.0;  // mm of image from the middle of an interspace
  const auto within = [&](double x, double y, double z) {
    const Vec3 index = image.to_index(Vec3(x, y, z));
    for (int axis = 0; axis < 3; ++axis) {
      if (index[axis] < -0.5 || index[axis] > image.size[static_cast<std::size_t>(axis)] - 0.5) return false;
    }
    return true;
  };
  const auto labelled_cut = [&](int vertebra_number) -> std::optional<bool> {
    const int role = spine_role::l1 + vertebra_number - 1;
    const auto known = static_cast<std::uint8_t>(vertebra_number < 1 ? 12 + vertebra_number : role);
    if (vertebra_number > 6 || known < 1) return std::nullopt;
    const auto box = box_of_roles(structures, roles, known, known);
    if (!box) return std::nullopt;
    const PatientBox border = box_of_image(image);
    const double edge = 1.5 * image.spacing.maxCoeff();
    return box->low.z() < border.low.z() + edge || box->high.z() > border.high.z() - edge;
  };
  for (Interspace& gap : spine.interspaces) {
    const CanalSection canal = spine.canal.at(gap.middle());
    const double front = canal.front - 15.0;
    const int above = gap.place ? static_cast<int>(*gap.place) - 1 : -100;
    const bool on_sacrum = gap.name.ends_with("_S1");
    const auto above_cut = gap.place ? labelled_cut(above) : std::nullopt;
    const auto below_cut = gap.place && !on_sacrum ? labelled_cut(above + 1) : std::nullopt;
    gap.cut = above_cut.value_or(!within(canal.x, front, gap.middle() + vertebra)) ||
              below_cut.value_or(!within(canal.x, front, gap.middle() - (on_sacrum ? sacrum : vertebra)));
  }
}

}  // namespace bodkin::patient
