#include "patient/from_ct/label_plausibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "core/error.h"
#include "io/label_scheme.h"

namespace bodkin::patient {
namespace {

enum class Substance { bone, muscle, other };

Substance substance_of(const std::string& tissue) {
  if (tissue.find("bone") != std::string::npos) return Substance::bone;
  return tissue == "muscle" ? Substance::muscle : Substance::other;
}

// Organs that often contain gas.
const std::set<std::string> hollow = {"stomach", "small_bowel", "duodenum", "colon", "esophagus", "trachea"};

bool fits(Substance substance, int hounsfield) {
  return substance == Substance::bone ? hounsfield > 100 : hounsfield >= -80 && hounsfield <= 150;
}

// One substance by label; other labels are left out.
std::vector<Substance> substances_of(const std::vector<anatomy::Structure>& table) {
  std::vector<Substance> substances(65536, Substance::other);
  for (const anatomy::Structure& structure : table) substances[structure.label] = substance_of(structure.tissue);
  return substances;
}

// Shares of bone and muscle with fitting HU.
struct Agreement {
  std::array<double, 2> fitting{};  // share, of bone and of muscle
  std::array<std::size_t, 2> count{};
  bool poor(std::size_t substance) const {
    constexpr std::size_t enough = 500;  // voxels examined
    return count[substance] >= enough && fitting[substance] < 1.0 / 3.0;
  }
  bool poor() const { return poor(0) || poor(1); }
};

Agreement agreement_of(const anatomy::CtVolume& ct, const anatomy::LabelVolume& labels,
                       const std::vector<Substance>& substances) {
  const auto& size = ct.grid.size;
  const int stride = ct.grid.voxel_count() > 4'000'000 ? 3 : 1;
  Agreement agreement;
  for (int k = 0; k < size[2]; k += stride) {
    for (int j = 0; j < size[1]; j += stride) {
      for (int i = 0; i < size[0]; i += stride) {
        const Substance substance = substances[labels.at(i, j, k)];
        if (substance == Substance::other) continue;
        const auto which = static_cast<std::size_t>(substance);
        ++agreement.count[which];
        agreement.fitting[which] += fits(substance, ct.at(i, j, k)) ? 1.0 : 0.0;
      }
    }
  }
  for (std::size_t n = 0; n < 2; ++n)
    agreement.fitting[n] /= static_cast<double>(std::max<std::size_t>(1, agreement.count[n]));
  return agreement;
}

// The other numbering of TotalSegmentator under which the labels fit, if there is one.
std::optional<std::string> other_numbering(const anatomy::CtVolume& ct, const anatomy::LabelVolume& labels,
                                           const std::vector<anatomy::Structure>& table) {
  for (const char* scheme : {"totalsegmentator_v1", "totalsegmentator"}) {
    const auto other = io::read_label_scheme(scheme);
    const bool same = std::all_of(table.begin(), table.end(), [&](const anatomy::Structure& structure) {
      return std::any_of(other.begin(), other.end(), [&](const anatomy::Structure& entry) {
        return entry.label == structure.label && entry.name == structure.name;
      });
    });
    if (same) continue;
    const Agreement agreement = agreement_of(ct, labels, substances_of(other));
    if (agreement.count[0] + agreement.count[1] > 1000 && !agreement.poor()) return scheme;
  }
  return std::nullopt;
}

// A sample of the labelled bone, as indices.
std::vector<std::array<int, 3>> bone_sample(const anatomy::LabelVolume& labels,
                                            const std::vector<Substance>& substances) {
  constexpr std::size_t enough = 20'000;
  std::size_t count = 0;
  for (const std::uint16_t label : labels.voxels) count += substances[label] == Substance::bone ? 1 : 0;
  const std::size_t stride = std::max<std::size_t>(1, count / enough);
  std::vector<std::array<int, 3>> sample;
  std::size_t met = 0, at = 0;
  for (int k = 0; k < labels.grid.size[2]; ++k) {
    for (int j = 0; j < labels.grid.size[1]; ++j) {
      for (int i = 0; i < labels.grid.size[0]; ++i, ++at) {
        if (substances[labels.voxels[at]] == Substance::bone && met++ % stride == 0) sample.push_back({i, j, k});
      }
    }
  }
  return sample;
}

// The share of the sample, moved by `shift` voxels, that is bone in the CT.
double bone_share(const anatomy::CtVolume& ct, const std::vector<std::array<int, 3>>& sample,
                  const std::array<int, 3>& shift) {
  std::size_t count = 0, bone = 0;
  for (const auto& [i, j, k] : sample) {
    if (!ct.grid.contains(i + shift[0], j + shift[1], k + shift[2])) continue;
    ++count;
    if (fits(Substance::bone, ct.at(i + shift[0], j + shift[1], k + shift[2]))) ++bone;
  }
  return 2 * count < sample.size() ? 0.0 : static_cast<double>(bone) / static_cast<double>(count);
}

// mm, the shift along one axis that brings clearly more of the labelled bone onto bone; nothing if none does.
std::optional<Vec3> shift_that_fits(const anatomy::CtVolume& ct, const anatomy::LabelVolume& labels,
                                    const std::vector<Substance>& substances) {
  constexpr double furthest = 60.0, step = 4.0;  // mm
  constexpr double clearly = 0.08, good = 0.5;   // share of the bone
  constexpr std::size_t enough = 500;            // voxels
  const auto sample = bone_sample(labels, substances);
  if (sample.size() < enough) return std::nullopt;
  std::optional<Vec3> best;
  double most = std::max(good, bone_share(ct, sample, {0, 0, 0}) + clearly);
  for (int axis = 0; axis < 3; ++axis) {
    for (double way = -furthest; way <= furthest; way += step) {
      std::array<int, 3> shift = {0, 0, 0};
      int& voxels = shift[static_cast<std::size_t>(axis)];
      voxels = static_cast<int>(std::lround(way / ct.grid.spacing[axis]));
      const double share = bone_share(ct, sample, shift);
      if (share <= most) continue;
      most = share;
      best = voxels * ct.grid.spacing[axis] * ct.grid.direction.col(axis);
    }
  }
  return best;
}

[[noreturn]] void refuse(const anatomy::CtVolume& ct, const anatomy::LabelVolume& labels,
                         const std::vector<anatomy::Structure>& table, const Agreement& found) {
  const std::size_t which = found.poor(0) ? 0 : 1;
  const std::string what =
      fmt::format("only {:.0f} % of what the labels call {} has HU that {} can have", 100.0 * found.fitting[which],
                  which == 0 ? "bone" : "muscle", which == 0 ? "bone" : "muscle");
  if (const auto scheme = other_numbering(ct, labels, table)) {
    throw InputError(fmt::format("{}; these look like {} numbers: use --scheme {}", what,
                                 *scheme == "totalsegmentator_v1" ? "TotalSegmentator v1" : "TotalSegmentator v2",
                                 *scheme));
  }
  throw InputError(fmt::format("{}; give the labels of this CT, or the --scheme that they are numbered by", what));
}

}  // namespace

std::vector<std::string> check_labels(const anatomy::CtVolume& ct, const anatomy::LabelVolume& labels,
                                      const std::vector<anatomy::Structure>& table) {
  const std::vector<Substance> substances = substances_of(table);
  const Agreement found = agreement_of(ct, labels, substances);
  if (const auto shift = shift_that_fits(ct, labels, substances)) {
    throw InputError(
        fmt::format("the labels are shifted against the CT: moved by ({:.0f}, {:.0f}, {:.0f}) mm (LPS) far more of "
                    "what they call "
                    "bone would lie on bone; segment this CT, or mend the position in the header of the labels",
                    shift->x() + 0.0, shift->y() + 0.0, shift->z() + 0.0));
  }
  if (found.poor()) refuse(ct, labels, table, found);
  constexpr int lowest = -1100, highest = 3200, width = 10;  // HU of the histograms
  constexpr std::size_t bins = (highest - lowest) / width;
  std::vector<int> row_of(65536, -1);
  for (std::size_t n = 0; n < table.size(); ++n) row_of[table[n].label] = static_cast<int>(n);
  std::vector<std::array<std::uint32_t, bins>> histograms(table.size());
  std::vector<std::size_t> counts(table.size(), 0);
  for (std::size_t n = 0; n < labels.voxels.size(); ++n) {
    const int row = row_of[labels.voxels[n]];
    if (row < 0) continue;
    const int bin = (std::clamp<int>(ct.voxels[n], lowest, highest - 1) - lowest) / width;
    ++histograms[static_cast<std::size_t>(row)][static_cast<std::size_t>(bin)];
    ++counts[static_cast<std::size_t>(row)];
  }
  const double millilitres = ct.grid.spacing.prod() / 1000.0;
  std::vector<std::string> notes;
  for (std::size_t n = 0; n < table.size(); ++n) {
    constexpr std::size_t enough = 100;  // voxels
    if (counts[n] < enough) continue;
    std::size_t below = 0, bin = 0;
    while (below + histograms[n][bin] < (counts[n] + 1) / 2) below += histograms[n][bin++];
    const int median = lowest + static_cast<int>(bin) * width + width / 2;
    const std::string& tissue = table[n].tissue;
    const char* expected = nullptr;
    if (substance_of(tissue) == Substance::bone && median < 50) expected = "above 50 for bone";
    const bool may_hold_gas = hollow.contains(table[n].name);
    if ((tissue == "muscle" || tissue == "organ") && ((median < -80 && !may_hold_gas) || median > 300))
      expected = "-80 to 300";
    if (tissue == "lung" && median > -250) expected = "below -250 for lung";
    if (expected != nullptr) {
      notes.push_back(fmt::format("Label {} ({}) is unlike its name: median of about {} HU, expected {}.",
                                  table[n].label, table[n].name, median, expected));
    }
    const double volume = static_cast<double>(counts[n]) * millilitres;
    if (table[n].name.find("vertebra") != std::string::npos && volume > 200.0) {
      notes.push_back(fmt::format("Label {} ({}) holds {:.0f} mL, more than one vertebra has.", table[n].label,
                                  table[n].name, volume));
    }
  }
  return notes;
}

}  // namespace bodkin::patient
