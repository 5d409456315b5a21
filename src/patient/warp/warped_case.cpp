#include "patient/warp/warped_case.h"

#include <cmath>

#include <fmt/format.h>

#include "anatomy/tissue_surface.h"
#include "core/parallel_for.h"

namespace bodkin::patient {

namespace {

constexpr double cell = 6.0;  // mm between the places at which the bend is computed; it is smooth

// Origin of each voxel of a lattice: the bend at the corners of coarse cells, trilinear between them.
class CoarseMap {
 public:
  CoarseMap(const SkinFit& fit, const anatomy::Grid& fine) : to_patient_(fit.moved().inverse()) {
    coarse_ = fine;
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const double extent = fine.spacing[axis] * (fine.size[i] - 1);
      coarse_.spacing[axis] = cell;
      coarse_.size[i] = static_cast<int>(std::ceil(extent / cell)) + 2;
    }
    for (auto& component : moved_) component = anatomy::Volume<double>(coarse_);
    std::size_t voxel = 0;
    for (int k = 0; k < coarse_.size[2]; ++k) {
      for (int j = 0; j < coarse_.size[1]; ++j) {
        for (int i = 0; i < coarse_.size[0]; ++i, ++voxel) {
          const Vec3 place = coarse_.to_patient(Vec3(i, j, k));
          const Vec3 bend = fit.to_patient(place) - to_patient_ * place;
          for (int axis = 0; axis < 3; ++axis) moved_[static_cast<std::size_t>(axis)].voxels[voxel] = bend[axis];
        }
      }
    }
  }
  Vec3 operator()(const Vec3& place) const {
    const Vec3 index = coarse_.to_index(place);
    Vec3 bend;
    for (int axis = 0; axis < 3; ++axis)
      bend[axis] = anatomy::linear_at_index(moved_[static_cast<std::size_t>(axis)], index, 0.0);
    return to_patient_ * place + bend;
  }

 private:
  Pose to_patient_;
  anatomy::Grid coarse_;
  std::array<anatomy::Volume<double>, 3> moved_;
};

anatomy::Grid moved_grid(const anatomy::Grid& grid, const Pose& moved) {
  anatomy::Grid result = grid;
  result.direction = moved.linear() * grid.direction;
  result.origin = moved * grid.origin;
  return result;
}

// `value`(source volume, place in the patient) of each voxel, on all cores.
template <typename Voxel, typename Value>
anatomy::Volume<Voxel> resampled(const anatomy::Volume<Voxel>& from, const SkinFit& fit, const Value& value) {
  if (from.empty()) return {};
  anatomy::Volume<Voxel> to(moved_grid(from.grid, fit.moved()));
  const CoarseMap map(fit, to.grid);
  parallel_for(to.grid.size[2], [&](int k) {
    for (int j = 0; j < to.grid.size[1]; ++j)
      for (int i = 0; i < to.grid.size[0]; ++i) to.at(i, j, k) = value(from, map(to.grid.to_patient(Vec3(i, j, k))));
  });
  return to;
}

}  // namespace

Skin skin_of(const anatomy::TissueVolume& tissues) {
  anatomy::TissueSurfaceSettings settings;
  settings.edge = 3.0;
  return {anatomy::tissue_surface(tissues, anatomy::body_tissues(), settings), tissues.grid};
}

anatomy::Case warped_case(const anatomy::Case& patient, const SkinFit& fit, const Progress& progress) {
  constexpr const char* stage = "warping the volumes";
  if (progress) progress(stage, 0.0);
  anatomy::Case made;
  made.description = patient.description;
  made.library = patient.library;
  made.ct = resampled(patient.ct, fit, [](const anatomy::CtVolume& from, const Vec3& place) {
    return static_cast<std::int16_t>(std::lround(anatomy::linear(from, place, anatomy::lowest_hounsfield)));
  });
  if (progress) progress(stage, 0.4);
  made.structures = resampled(patient.structures, fit, [](const anatomy::LabelVolume& from, const Vec3& place) {
    return anatomy::nearest<std::uint16_t>(from, place, 0);
  });
  if (progress) progress(stage, 0.7);
  made.tissues = resampled(patient.tissues, fit, [](const anatomy::TissueVolume& from, const Vec3& place) {
    return anatomy::nearest<anatomy::TissueId>(from, place, anatomy::tissue::air);
  });
  if (progress) progress(stage, 1.0);
  if (std::optional<anatomy::NeedlePath>& path = made.description.procedure.path) {
    path->entry = fit.to_body(path->entry);
    path->target = fit.to_body(path->target);
  }
  for (anatomy::Landmark& landmark : made.description.landmarks) landmark.position = fit.to_body(landmark.position);
  made.description.notes.push_back(fmt::format(
      "warped to the skin of another body: {:.1f} mm RMS between the skins before, {:.1f} moved, {:.1f} bent",
      fit.at_start().rms, fit.when_moved().rms, fit.when_bent().rms));
  return made;
}

}  // namespace bodkin::patient
