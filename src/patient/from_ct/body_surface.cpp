#include "patient/from_ct/body_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel_for.h"

namespace bodkin::patient {
namespace {

constexpr double block_edge = 2.5;         // mm, desired
constexpr double opening = 4.5;            // mm: sheets thinner than twice this are not body
constexpr double least_body = 20.0;        // mL
constexpr double outside_face = 1000.0;    // mm^2 of image face that outside air must reach
constexpr double lung_volume = 60e3;       // mm^3: smaller pockets are bowel gas
constexpr float air_hounsfield = -900.0F;  // outside air has a lower value than this, lung a higher one
constexpr double least_empty = 0.25;       // share of such emptiness in the air about a body on a mattress
constexpr float gas_hounsfield = -400.0F;
constexpr double most_others = 0.35;      // share of couch, arms and thin walls around air inside the body
constexpr float even_hounsfield = 25.0F;  // of similar blocks
constexpr double least_even = 0.62;  // share of similar blocks: 0.73 to 1 in real rooms, 0.38 to 0.53 in a real lung

// Means of whole blocks of voxels; the last block of an axis may be smaller. Labelled lung counts as solid.
anatomy::Volume<float> block_means(const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures,
                                   const std::vector<anatomy::Structure>& table) {
  std::vector<bool> lung(65536, false);
  for (const anatomy::Structure& structure : table) lung[structure.label] = structure.tissue == "lung";
  const bool labels_lung = !structures.empty() && std::find(lung.begin(), lung.end(), true) != lung.end();
  std::array<int, 3> block{};
  anatomy::Grid grid = ct.grid;
  Vec3 first;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    block[a] = std::max(1, static_cast<int>(std::lround(block_edge / ct.grid.spacing[axis])));
    grid.size[a] = (ct.grid.size[a] + block[a] - 1) / block[a];
    grid.spacing[axis] = ct.grid.spacing[axis] * block[a];
    first[axis] = 0.5 * (block[a] - 1);
  }
  grid.origin = ct.grid.to_patient(first);
  anatomy::Volume<float> means(grid);
  parallel_for(grid.size[2], [&](int k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const int i1 = std::min((i + 1) * block[0], ct.grid.size[0]),
                  j1 = std::min((j + 1) * block[1], ct.grid.size[1]);
        const int k1 = std::min((k + 1) * block[2], ct.grid.size[2]);
        int sum = 0, count = 0;
        for (int z = k * block[2]; z < k1; ++z) {
          for (int y = j * block[1]; y < j1; ++y) {
            for (int x = i * block[0]; x < i1; ++x, ++count) {
              const bool solid = labels_lung && lung[structures.at(x, y, z)];
              sum += solid ? 0 : std::clamp<int>(ct.at(x, y, z), -1024, 3000);  // padding counts as air
            }
          }
        }
        means.at(i, j, k) = static_cast<float>(sum) / static_cast<float>(count);
      }
    }
  });
  return means;
}

template <typename Predicate>
MaskVolume mask_where(const anatomy::Grid& grid, const Predicate& predicate) {
  MaskVolume mask(grid);
  for (std::size_t v = 0; v < mask.voxels.size(); ++v) mask.voxels[v] = predicate(v) ? 1 : 0;
  return mask;
}

// The largest solid object without sheets and without parts attached by less than twice the opening.
MaskVolume solid_body(const anatomy::Volume<float>& means, std::vector<std::string>& notes) {
  auto solid = mask_where(means.grid, [&](std::size_t v) { return means.voxels[v] > skin_surface_hounsfield; });
  const auto filled = static_cast<std::size_t>(std::count(solid.voxels.begin(), solid.voxels.end(), 1));
  if (filled == solid.voxels.size()) return solid;
  const double voxel = means.grid.spacing.prod();
  const auto distance = signed_distance(solid);
  const auto core = largest_piece(
      mask_where(means.grid, [&](std::size_t v) { return distance.voxels[v] < -static_cast<float>(opening); }));
  const auto volume = [&](const MaskVolume& mask) {
    return static_cast<double>(std::count(mask.voxels.begin(), mask.voxels.end(), 1)) * voxel / 1e3;
  };
  if (volume(core) < least_body) {
    auto shell = largest_piece(solid);
    if (volume(shell) < least_body) {
      throw InputError(
          fmt::format("the CT holds no body: its largest solid part (above {:.0f} HU) has {:.1f} mL, at least {:.0f} "
                      "mL were expected; "
                      "check that the values are Hounsfield units",
                      static_cast<double>(skin_surface_hounsfield), volume(shell), least_body));
    }
    notes.emplace_back(
        "Nothing in the CT is thicker than 9 mm; its largest thin-walled part was taken for the body.");
    return shell;
  }
  const auto reach = signed_distance(core);
  const auto most = static_cast<float>(opening + 0.9 * means.grid.spacing.maxCoeff());
  auto body = mask_where(means.grid, [&](std::size_t v) { return solid.voxels[v] == 1 && reach.voxels[v] <= most; });
  const auto kept = static_cast<std::size_t>(std::count(body.voxels.begin(), body.voxels.end(), 1));
  const double removed = static_cast<double>(filled - kept) * voxel / 1e3;
  if (removed > 20.0) {
    notes.push_back(fmt::format(
        "Solid objects outside the body (couch, arms, other objects; {:.0f} mL) were left out and have no skin.",
        removed));
  }
  return body;
}

// The axis that runs along the patient; its two faces are cuts, never the room.
Eigen::Index axis_along(const anatomy::Grid& grid) {
  Eigen::Index along = 0;
  grid.direction.row(2).cwiseAbs().maxCoeff(&along);
  return along;
}

// The number of lateral, front and back faces of the image that contain a voxel; 2 in its corners.
int faces_at(const anatomy::Grid& grid, int i, int j, int k, Eigen::Index along) {
  const std::array<int, 3> at = {i, j, k};
  int faces = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool face = at[axis] == 0 || at[axis] == grid.size[axis] - 1;
    faces += face && static_cast<Eigen::Index>(axis) != along ? 1 : 0;
  }
  return faces;
}

// Share of blocks that differ little from their median: air and foam are uniform, lung is not, with its vessels and
// its weight.
double evenness(std::vector<float>& blocks) {
  if (blocks.empty()) return 1.0;
  const auto middle = blocks.begin() + static_cast<std::ptrdiff_t>(blocks.size() / 2);
  std::nth_element(blocks.begin(), middle, blocks.end());
  const float median = *middle;
  const auto alike =
      std::count_if(blocks.begin(), blocks.end(), [&](float hu) { return std::abs(hu - median) <= even_hounsfield; });
  return static_cast<double>(alike) / static_cast<double>(blocks.size());
}

// The properties of one piece of air.
struct AirPiece {
  double size = 0.0;             // blocks
  bool face = false;             // reaches a lateral, front or back face of the image,
  bool corner = false;           // or a corner between them
  double of_body = 0.0;          // block faces between it and the body,
  double of_others = 0.0;        // and between it and other solid things
  std::vector<float> deep = {};  // HU of the blocks well inside it
};

std::vector<AirPiece> know_pieces(const anatomy::Volume<float>& means, const anatomy::Volume<std::uint32_t>& pieces,
                                  const anatomy::Volume<float>& depth, const anatomy::Volume<float>& from_body) {
  const anatomy::Grid& grid = means.grid;
  const auto mixed = static_cast<float>(-2.5 * grid.spacing.maxCoeff());  // nearer to solid: not only air
  const auto lining = static_cast<float>(2.0 * grid.spacing.maxCoeff());
  std::vector<AirPiece> known(*std::max_element(pieces.voxels.begin(), pieces.voxels.end()) + 1);
  const Eigen::Index along = axis_along(grid);
  const auto touch = [&](std::size_t a, std::size_t b) {
    if ((pieces.voxels[a] == 0) == (pieces.voxels[b] == 0)) return;
    const std::size_t solid = pieces.voxels[a] == 0 ? a : b;
    AirPiece& piece = known[pieces.voxels[solid == a ? b : a]];
    (from_body.voxels[solid] <= lining ? piece.of_body : piece.of_others) += 1.0;
  };
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const std::size_t v = grid.offset(i, j, k);
        if (i + 1 < grid.size[0]) touch(v, grid.offset(i + 1, j, k));
        if (j + 1 < grid.size[1]) touch(v, grid.offset(i, j + 1, k));
        if (k + 1 < grid.size[2]) touch(v, grid.offset(i, j, k + 1));
        if (pieces.voxels[v] == 0) continue;
        AirPiece& piece = known[pieces.voxels[v]];
        piece.size += 1.0;
        if (depth.voxels[v] < mixed) piece.deep.push_back(means.voxels[v]);
        if (means.voxels[v] > gas_hounsfield) continue;
        const int faces = faces_at(grid, i, j, k, along);
        piece.face = piece.face || faces > 0;
        piece.corner = piece.corner || faces == 2;
      }
    }
  }
  return known;
}

// Air inside the body, even if opened by a thin wall, which is not part of `body`, or by the image border: gas
// enclosed by the body, and lung, which is large and uneven and, unlike the room, reaches no corner of the image.
// Includes the solid blocks outside `body` that lie nearer to it than to other air: walls, linings, vessels.
MaskVolume inner_air(const anatomy::Volume<float>& means, const MaskVolume& body) {
  const anatomy::Grid& grid = means.grid;
  const auto air = mask_where(grid, [&](std::size_t v) { return means.voxels[v] <= skin_surface_hounsfield; });
  const auto pieces = number_pieces(air);
  auto known = know_pieces(means, pieces, signed_distance(air), signed_distance(body));
  std::vector<bool> inner;
  for (AirPiece& piece : known) {
    const bool enclosed = !piece.face && piece.of_others < most_others * (piece.of_body + piece.of_others);
    const bool lung =
        !piece.corner && piece.size * grid.spacing.prod() > lung_volume && evenness(piece.deep) < least_even;
    inner.push_back(enclosed || lung);
  }
  inner[0] = false;
  auto found = mask_where(grid, [&](std::size_t v) { return inner[pieces.voxels[v]]; });
  if (std::find(found.voxels.begin(), found.voxels.end(), 1) == found.voxels.end()) return found;
  const auto to_inner = signed_distance(found);
  const auto to_other =
      signed_distance(mask_where(grid, [&](std::size_t v) { return air.voxels[v] == 1 && found.voxels[v] == 0; }));
  return mask_where(grid, [&](std::size_t v) {
    return body.voxels[v] == 0 &&
           (air.voxels[v] == 1 ? found.voxels[v] == 1 : to_inner.voxels[v] < to_other.voxels[v]);
  });
}

// Air of the room: empty pieces that broadly reach the lateral, front or back faces of the image.
MaskVolume outside_air(const anatomy::Volume<float>& means, const MaskVolume& body) {
  const anatomy::Grid& grid = means.grid;
  const auto inner = inner_air(means, body);
  const auto pieces =
      number_pieces(mask_where(grid, [&](std::size_t v) { return body.voxels[v] == 0 && inner.voxels[v] == 0; }));
  const std::uint32_t count = *std::max_element(pieces.voxels.begin(), pieces.voxels.end());
  std::vector<double> face(count + 1, 0.0), empty(count + 1, 0.0), size(count + 1, 0.0);
  const Eigen::Index along = axis_along(grid);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const std::size_t v = grid.offset(i, j, k);
        const std::uint32_t piece = pieces.voxels[v];
        if (piece == 0) continue;
        size[piece] += 1.0;
        if (means.voxels[v] < air_hounsfield) empty[piece] += 1.0;
        const std::array<int, 3> at = {i, j, k};
        for (int axis = 0; axis < 3; ++axis) {
          const auto a = static_cast<std::size_t>(axis);
          if (means.voxels[v] > gas_hounsfield) continue;  // a couch or a cut limb at the border is not air
          if (axis == along || (at[a] != 0 && at[a] != grid.size[a] - 1)) continue;
          face[piece] += grid.spacing.prod() / grid.spacing[axis];
        }
      }
    }
  }
  return mask_where(grid, [&](std::size_t v) {
    const std::uint32_t piece = pieces.voxels[v];
    return piece != 0 && face[piece] > outside_face && empty[piece] > least_empty * size[piece];
  });
}

MaskVolume find_lung(const anatomy::Volume<float>& means, const MaskVolume& outside) {
  const auto pieces = number_pieces(mask_where(
      means.grid, [&](std::size_t v) { return outside.voxels[v] == 0 && means.voxels[v] < gas_hounsfield; }));
  const std::uint32_t count = *std::max_element(pieces.voxels.begin(), pieces.voxels.end());
  std::vector<double> size(count + 1, 0.0), sum(count + 1, 0.0);
  std::vector<std::vector<float>> deep(count + 1);
  const auto depth = signed_distance(mask_where(means.grid, [&](std::size_t v) { return pieces.voxels[v] != 0; }));
  const auto mixed = static_cast<float>(-2.5 * means.grid.spacing.maxCoeff());
  for (std::size_t v = 0; v < pieces.voxels.size(); ++v) {
    size[pieces.voxels[v]] += 1.0;
    sum[pieces.voxels[v]] += means.voxels[v];
    if (depth.voxels[v] < mixed) deep[pieces.voxels[v]].push_back(means.voxels[v]);
  }
  std::vector<bool> is_lung(count + 1, false);
  for (std::uint32_t piece = 1; piece <= count; ++piece) {
    is_lung[piece] = size[piece] * means.grid.spacing.prod() > lung_volume && sum[piece] / size[piece] > -950.0 &&
                     evenness(deep[piece]) < least_even;
  }
  auto lung = mask_where(means.grid, [&](std::size_t v) { return is_lung[pieces.voxels[v]]; });
  if (std::find(lung.voxels.begin(), lung.voxels.end(), 1) == lung.voxels.end()) return lung;
  const auto distance = signed_distance(lung);  // one block more, for the voxels at its surface
  const auto rim = static_cast<float>(1.1 * means.grid.spacing.maxCoeff());
  return mask_where(means.grid, [&](std::size_t v) { return distance.voxels[v] < rim; });
}

}  // namespace

BodySurface find_body(const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures,
                      const std::vector<anatomy::Structure>& table) {
  BodySurface surface;
  const auto means = block_means(ct, structures, table);
  surface.edge = means.grid.spacing.maxCoeff();
  const auto body = solid_body(means, surface.notes);
  const auto outside = outside_air(means, body);
  surface.lung = find_lung(means, outside);
  surface.has_skin = std::find(outside.voxels.begin(), outside.voxels.end(), 1) != outside.voxels.end();
  if (surface.has_skin) {
    surface.distance = signed_distance(mask_where(means.grid, [&](std::size_t v) { return outside.voxels[v] == 0; }));
  } else {
    surface.distance = anatomy::Volume<float>(means.grid, -20.0F);
    surface.notes.emplace_back("The image lies wholly inside the body, so this patient has no skin.");
  }
  return surface;
}

}  // namespace bodkin::patient
