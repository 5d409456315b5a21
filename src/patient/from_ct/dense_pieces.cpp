#include "patient/from_ct/dense_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "patient/from_ct/hounsfield_classes.h"
#include <fmt/format.h>

namespace bodkin::patient {
namespace {

constexpr double deep_below = 45.0;           // mm below the skin: deeper unlabelled tissue is not body wall
constexpr double largest_stone = 5.0;         // mL
constexpr double off_bone = 8.0;              // mm; nearer pieces may be parts of it cut off by thick slices
constexpr double brightest_contrast = 600.0;  // HU, mean
constexpr double contrast_spread = 0.2;       // standard deviation over mean

bool dense(anatomy::TissueId id) {
  return id == anatomy::tissue::cortical_bone || id == anatomy::tissue::cancellous_bone;
}

// Neighbouring voxels of bone along i.
struct Run {
  int j, k, from, to;  // to is one past the last
};

// Sets of connected runs (union-find with path halving).
class Pieces {
 public:
  explicit Pieces(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t find(std::uint32_t n) {
    while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
    return n;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

struct BoneRuns {
  std::vector<Run> runs;                  // row after row
  std::vector<std::uint32_t> row_starts;  // of row j + size_j * k, and the end
};

BoneRuns runs_of(const anatomy::TissueVolume& tissues) {
  const auto& size = tissues.grid.size;
  BoneRuns found;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      found.row_starts.push_back(static_cast<std::uint32_t>(found.runs.size()));
      const anatomy::TissueId* row = &tissues.at(0, j, k);
      for (int i = 0; i < size[0]; ++i) {
        if (!dense(row[i])) continue;
        const int from = i;
        while (i < size[0] && dense(row[i])) ++i;
        found.runs.push_back({j, k, from, i});
      }
    }
  }
  found.row_starts.push_back(static_cast<std::uint32_t>(found.runs.size()));
  return found;
}

// Joins the runs of two rows that touch, through corners too.
void join_rows(const BoneRuns& bone, std::size_t row, std::size_t other, Pieces& pieces) {
  std::uint32_t b = bone.row_starts[other];
  for (std::uint32_t a = bone.row_starts[row]; a < bone.row_starts[row + 1]; ++a) {
    while (b < bone.row_starts[other + 1] && bone.runs[b].to < bone.runs[a].from) ++b;
    for (std::uint32_t n = b; n < bone.row_starts[other + 1] && bone.runs[n].from <= bone.runs[a].to; ++n)
      pieces.join(a, n);
  }
}

struct Piece {
  std::vector<std::uint32_t> runs;
  double volume = 0.0;              // mL
  double mean = 0.0, spread = 0.0;  // HU
  double depth = 0.0;               // mm, mean
  bool labelled = false, at_border = false;
};

Piece measured(std::vector<std::uint32_t> runs, const BoneRuns& bone, const anatomy::TissueVolume& tissues,
               const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures, const TissueLattice& lattice,
               const BodySurface& body) {
  const auto& size = tissues.grid.size;
  Piece piece;
  double count = 0.0, sum = 0.0, squares = 0.0, depths = 0.0;
  for (const std::uint32_t n : runs) {
    const Run& run = bone.runs[n];
    piece.at_border = piece.at_border || run.from == 0 || run.to == size[0] || run.j == 0 || run.j == size[1] - 1 ||
                      run.k == 0 || run.k == size[2] - 1;
    for (int i = run.from; i < run.to; ++i) {
      const int x = i / lattice.parts[0], y = run.j / lattice.parts[1], z = run.k / lattice.parts[2];
      const double value = ct.at(x, y, z);
      sum += value, squares += value * value, ++count;
      piece.labelled = piece.labelled || (!structures.empty() && structures.at(x, y, z) != 0);
    }
    const Vec3 middle = tissues.grid.to_patient(Vec3(0.5 * (run.from + run.to - 1), run.j, run.k));
    depths -= (run.to - run.from) * anatomy::linear(body.distance, middle, 0.0);
  }
  piece.volume = count * tissues.grid.spacing.prod() / 1000.0;
  piece.mean = sum / count;
  piece.spread = std::sqrt(std::max(0.0, squares / count - piece.mean * piece.mean));
  piece.depth = depths / count;
  piece.runs = std::move(runs);
  return piece;
}

// Whether bone of another piece lies within `distance`.
bool near_other_bone(const Piece& piece, const BoneRuns& bone, const anatomy::TissueVolume& tissues, Pieces& pieces,
                     double distance) {
  const auto& size = tissues.grid.size;
  const Vec3& spacing = tissues.grid.spacing;
  const int reach_j = static_cast<int>(distance / spacing[1]), reach_k = static_cast<int>(distance / spacing[2]);
  const int reach_i = static_cast<int>(distance / spacing[0]);
  const std::uint32_t own = pieces.find(piece.runs.front());
  for (const std::uint32_t n : piece.runs) {
    const Run& run = bone.runs[n];
    for (int k = std::max(0, run.k - reach_k); k <= std::min(size[2] - 1, run.k + reach_k); ++k) {
      for (int j = std::max(0, run.j - reach_j); j <= std::min(size[1] - 1, run.j + reach_j); ++j) {
        const auto row =
            static_cast<std::size_t>(j) + static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(k);
        for (std::uint32_t other = bone.row_starts[row]; other < bone.row_starts[row + 1]; ++other) {
          const bool close = bone.runs[other].from <= run.to + reach_i && bone.runs[other].to >= run.from - reach_i;
          if (close && pieces.find(other) != own) return true;
        }
      }
    }
  }
  return false;
}

enum class Kind { bone, speck, stone, contrast };

Kind kind_of(const Piece& piece, const BoneRuns& bone, const anatomy::TissueVolume& tissues, Pieces& pieces,
             const BodySurface& body) {
  if (piece.labelled) return Kind::bone;
  if (piece.volume < smallest_bone) {
    const bool part = piece.at_border || near_other_bone(piece, bone, tissues, pieces, off_bone);
    return part ? Kind::bone : Kind::speck;
  }
  if (!body.has_skin || piece.depth < deep_below) return Kind::bone;
  if (piece.volume < largest_stone) {
    const bool part = piece.at_border || near_other_bone(piece, bone, tissues, pieces, off_bone);
    return part ? Kind::bone : Kind::stone;
  }
  const bool even = piece.mean <= brightest_contrast && piece.spread < contrast_spread * piece.mean;
  return even ? Kind::contrast : Kind::bone;
}

}  // namespace

std::vector<std::string> remove_dense_pieces(anatomy::TissueVolume& tissues, const anatomy::CtVolume& ct,
                                             const anatomy::LabelVolume& structures, const TissueLattice& lattice,
                                             const BodySurface& body) {
  const auto& size = tissues.grid.size;
  const BoneRuns bone = runs_of(tissues);
  Pieces pieces(bone.runs.size());
  const auto rows = static_cast<std::size_t>(size[1]);
  for (std::size_t k = 0; k < static_cast<std::size_t>(size[2]); ++k) {
    for (std::size_t j = 0; j < rows; ++j) {
      const std::size_t row = j + rows * k;
      if (j > 0) join_rows(bone, row, row - 1, pieces);
      if (k == 0) continue;
      for (std::size_t beside = j > 0 ? j - 1 : j; beside <= std::min(j + 1, rows - 1); ++beside)
        join_rows(bone, row, beside + rows * (k - 1), pieces);
    }
  }
  std::vector<std::uint32_t> by_piece(bone.runs.size());
  std::iota(by_piece.begin(), by_piece.end(), 0U);
  std::vector<std::size_t> voxels(bone.runs.size(), 0);
  for (const std::uint32_t n : by_piece)
    voxels[pieces.find(n)] += static_cast<std::size_t>(bone.runs[n].to - bone.runs[n].from);
  std::stable_sort(by_piece.begin(), by_piece.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return pieces.find(a) < pieces.find(b); });
  const auto skeleton = static_cast<std::uint32_t>(std::max_element(voxels.begin(), voxels.end()) - voxels.begin());

  std::array<int, 4> count{};
  std::array<double, 4> volume{};
  for (auto first = by_piece.begin(); first != by_piece.end();) {
    const std::uint32_t root = pieces.find(*first);
    const auto last = std::find_if(first, by_piece.end(), [&](std::uint32_t n) { return pieces.find(n) != root; });
    std::vector<std::uint32_t> runs(first, last);
    first = last;
    if (root == skeleton) continue;
    const Piece piece = measured(std::move(runs), bone, tissues, ct, structures, lattice, body);
    const Kind kind = kind_of(piece, bone, tissues, pieces, body);
    if (kind == Kind::bone) continue;
    ++count[static_cast<std::size_t>(kind)];
    volume[static_cast<std::size_t>(kind)] += piece.volume;
    anatomy::TissueId into =
        piece.depth > deep_below || !body.has_skin ? anatomy::tissue::soft : anatomy::tissue::muscle;
    if (kind == Kind::contrast) into = anatomy::tissue::vessel;
    for (const std::uint32_t n : piece.runs) {
      const Run& run = bone.runs[n];
      std::fill(&tissues.at(run.from, run.j, run.k), &tissues.at(run.from, run.j, run.k) + (run.to - run.from), into);
    }
  }
  std::vector<std::string> notes;
  const auto note = [&](Kind kind, const char* text) {
    const auto n = static_cast<std::size_t>(kind);
    if (count[n] > 0) notes.push_back(fmt::format(fmt::runtime(text), count[n], volume[n]));
  };
  note(Kind::speck,
       "Specks as dense as bone (pieces: {}, {:.2f} mL in all, each below 0.05 mL) were taken for soft tissue.");
  note(Kind::stone,
       "Stones or calcifications deep in the body, apart from the skeleton (pieces: {}, {:.1f} mL in all), were "
       "taken for "
       "soft tissue.");
  note(Kind::contrast,
       "Contrast deep in the body, apart from the skeleton and even in HU (pieces: {}, {:.0f} mL in all), was taken "
       "for "
       "vessels, not bone.");
  return notes;
}

}  // namespace bodkin::patient
