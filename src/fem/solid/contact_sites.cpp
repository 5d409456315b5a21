#include "fem/solid/contact_sites.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace bodkin::fem {

namespace {

constexpr double before_entry = 1.0;   // mm: the earliest start of the skin
constexpr double step = 0.05;          // mm between voxel look-ups
constexpr double least_layer = 0.3;    // mm
constexpr double corner_share = 0.75;  // of a voxel
constexpr double along_bone = 3.0;     // mm, error of the known motion of tissue
constexpr double least_rest = 0.5;     // of the site spacing, left to the next border

// A piece of the line in one tissue.
struct Piece {
  anatomy::TissueId tissue;
  double from, to;
  double length() const { return to - from; }
};

bool is_rigid(const anatomy::TissueLibrary& library, anatomy::TissueId id) {
  const anatomy::TissueProperties* tissue = library.find(id);
  return tissue != nullptr && tissue->layered.kind == anatomy::LayeredKind::rigid;
}

// N; with mechanics="physical" that of the tissue's reference needle, which suffices to compare two tissues.
double puncture_force(const anatomy::Case& patient, anatomy::TissueId id) {
  const anatomy::TissueProperties* tissue = patient.library.find(id);
  if (tissue == nullptr) return 0.0;
  const bool is_physical = patient.description.haptics.mechanics == anatomy::Mechanics::physical;
  const anatomy::PhysicalTissue& is = tissue->physical;
  return is_physical && (is.puncture_force > 0.0 || is.friction > 0.0) ? is.puncture_force
                                                                       : tissue->deformable.puncture_force;
}

// From `begin` mm down to the first rigid tissue that is thick enough to be a layer, which is then the last piece.
// `inside`: the tissue of a needle that begins here, even if it first runs along bone in the voxels.
std::vector<Piece> pieces_along(const Vec3& entry, const Vec3& along, double begin, double length,
                                const anatomy::Case& patient, std::optional<anatomy::TissueId> inside = {}) {
  std::vector<Piece> pieces;
  const auto steps = static_cast<long>(std::floor((length - begin) / step));
  for (long i = 0; i <= steps; ++i) {
    const double depth = begin + step * static_cast<double>(i);
    anatomy::TissueId here =
        anatomy::nearest<anatomy::TissueId>(patient.tissues, entry + depth * along, anatomy::tissue::air);
    if (inside && depth < along_bone && is_rigid(patient.library, here)) here = *inside;
    if (pieces.empty() && here == anatomy::tissue::air) continue;
    if (pieces.empty() || pieces.back().tissue != here)
      pieces.push_back({here, depth, depth + step});
    else
      pieces.back().to = depth + step;
    if (is_rigid(patient.library, here) && pieces.back().length() >= least_layer - 0.5 * step) break;
  }
  return pieces;
}

// Joins a piece with its neighbours of the same tissue.
void join(std::vector<Piece>& pieces) {
  std::vector<Piece> joined;
  for (const Piece& piece : pieces) {
    if (!joined.empty() && joined.back().tissue == piece.tissue)
      joined.back().to = piece.to;
    else
      joined.push_back(piece);
  }
  pieces = std::move(joined);
}

// Merges each piece too thin for a layer into the piece before it, thinnest first.
void leave_out_corners(std::vector<Piece>& pieces, double voxel) {
  for (;;) {
    std::size_t thinnest = 0;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      const bool between = i + 1 < pieces.size() && pieces[i - 1].tissue == pieces[i + 1].tissue;
      const double least = between ? std::max(least_layer, corner_share * voxel) : least_layer;
      // The end of the line may have cut off the last piece.
      if (i + 1 == pieces.size() || pieces[i].length() >= least - 0.5 * step) continue;
      if (thinnest == 0 || pieces[i].length() < pieces[thinnest].length()) thinnest = i;
    }
    if (thinnest == 0) return;
    pieces[thinnest].tissue = pieces[thinnest - 1].tissue;
    join(pieces);
  }
}

// The sites of the pieces before the first rigid one. `begins_inside`: the first one has no border before it.
std::vector<ContactSite> contact_sites_of(std::vector<Piece> pieces, bool begins_inside, const Vec3& entry,
                                          const Vec3& along, double apart, const anatomy::Case& patient) {
  leave_out_corners(pieces, patient.tissues.grid.spacing.minCoeff());
  const auto rigid = std::find_if(pieces.begin(), pieces.end(),
                                  [&](const Piece& piece) { return is_rigid(patient.library, piece.tissue); });
  pieces.erase(rigid, pieces.end());
  std::vector<ContactSite> sites;
  double before = 0.0;
  for (const Piece& piece : pieces) {
    const double force = puncture_force(patient, piece.tissue);
    const auto add = [&](double depth, bool border) {
      const Vec3 place = entry + depth * along;
      sites.push_back({place, depth, piece.tissue, border, border && force > before});
    };
    if (!begins_inside || &piece != &pieces.front()) add(piece.from, true);
    for (int i = 1; piece.from + (i + least_rest) * apart <= piece.to; ++i) add(piece.from + i * apart, false);
    before = force;
  }
  return sites;
}

}  // namespace

std::vector<ContactSite> contact_sites_along(const anatomy::NeedlePath& path, double length, double apart,
                                             const anatomy::Case& patient) {
  const Vec3 along = path.direction();
  std::vector<Piece> pieces = pieces_along(path.entry, along, -before_entry, length, patient);
  // A corner of the skin's staircase before more air is not the start of the body.
  while (pieces.size() > 1 && pieces[0].length() < corner_share * patient.tissues.grid.spacing.minCoeff() &&
         pieces[1].tissue == anatomy::tissue::air)
    pieces.erase(pieces.begin(), pieces.begin() + 2);
  return contact_sites_of(std::move(pieces), false, path.entry, along, apart, patient);
}

std::vector<ContactSite> contact_sites_ahead(const Vec3& place, const Vec3& along, double length, double apart,
                                             anatomy::TissueId behind, const anatomy::Case& patient) {
  std::vector<Piece> pieces = pieces_along(place, along, 0.0, length, patient, behind);
  pieces.insert(pieces.begin(), {behind, 0.0, 0.0});
  join(pieces);
  return contact_sites_of(std::move(pieces), true, place, along, apart, patient);
}

}  // namespace bodkin::fem
