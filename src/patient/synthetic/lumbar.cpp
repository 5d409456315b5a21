#include "patient/synthetic/lumbar.h"

#include <algorithm>
#include <cmath>

#include "patient/synthetic/approach.h"
#include "patient/synthetic/painter.h"

#include "core/parallel_for.h"

namespace bodkin::patient {
namespace {

constexpr double kMargin = 9.0;  // mm of air around the body
constexpr double kAbove = 14.0;  // mm of the spine above the highest point of L1

// An axial volume from slightly below S1 to a part of T12; the frame is the patient's (LPS).
anatomy::Grid make_grid(const LumbarModel& model, double spacing) {
  const Spine& spine = model.spine();
  const double bottom = spine.bottom(), top = spine.top() + kAbove;
  double back = -1e6;
  for (double z = bottom; z < top; z += 2.0) {
    const SpineSection section = spine.section(z);
    back = std::max(back, model.torso().section(z, section).skin.back);
  }
  const double half_width = model.torso().half_width() + kMargin;
  const double front = model.torso().front() - kMargin;
  back += kMargin;
  anatomy::Grid grid;
  grid.spacing = Vec3::Constant(spacing);
  const auto voxels = [&](double length) { return static_cast<int>(std::ceil(length / spacing)); };
  grid.size = {2 * voxels(half_width), voxels(back - front), voxels(top - bottom)};
  grid.origin = Vec3(-spacing * (voxels(half_width) - 0.5), front, bottom);
  return grid;
}

std::vector<anatomy::Landmark> make_landmarks(const LumbarModel& model) {
  static constexpr std::array<const char*, 5> kNames = {"L1_L2", "L2_L3", "L3_L4", "L4_L5", "L5_S1"};
  std::vector<anatomy::Landmark> landmarks;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const int upper = level::l1 + static_cast<int>(i);
    landmarks.push_back({kNames[i], model.spine().interspace(upper)});
    landmarks.push_back({std::string(kNames[i]) + "_skin", plan_approach(model, upper).path.entry});
  }
  landmarks.push_back({"conus", model.spine().conus()});
  return landmarks;
}

// The path with its target in the middle of the fluid behind the roots, by the voxels.
anatomy::NeedlePath aim_at_fluid(const anatomy::NeedlePath& path, const anatomy::TissueVolume& tissues) {
  const Vec3 direction = path.direction();
  double begin = -1.0, end = -1.0;
  for (double depth = 0.0; depth < path.length() + 12.0; depth += 0.25) {
    const anatomy::TissueId id =
        anatomy::nearest(tissues, Vec3(path.entry + depth * direction), anatomy::tissue::air);
    if (id == anatomy::tissue::cerebrospinal_fluid) {
      if (begin < 0.0) begin = depth;
      end = depth;
    } else if (begin >= 0.0) {
      break;
    }
  }
  if (begin < 0.0) return path;  // voxels too coarse to hold fluid on this line
  return {path.entry, path.entry + 0.5 * (begin + end) * direction};
}

// A ball at the side of the left psoas at L3, half in the muscle and half in the fat around it. Bone, vessels, nerves
// and organs remain unchanged.
void add_lesion(double across, anatomy::TissueVolume& tissues, anatomy::LabelVolume& structures) {
  const anatomy::Grid& grid = tissues.grid;
  const int middle = std::clamp(static_cast<int>(std::lround(grid.to_index(Vec3::Zero()).z())), 0, grid.size[2] - 1);
  Vec3 centre = Vec3::Zero();
  double side = 0.0;
  int count = 0;
  std::size_t at = grid.offset(0, 0, middle);
  for (int j = 0; j < grid.size[1]; ++j) {
    for (int i = 0; i < grid.size[0]; ++i, ++at) {
      if (structures.voxels[at] != structure::iliopsoas_left) continue;
      const Vec3 point = grid.to_patient(Vec3(i, j, middle));
      centre += point;
      side = std::max(side, point.x());
      ++count;
    }
  }
  if (count == 0) return;
  centre /= count;
  centre.x() = side;
  at = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i, ++at) {
        if ((grid.to_patient(Vec3(i, j, k)) - centre).squaredNorm() > 0.25 * across * across) continue;
        anatomy::TissueId& tissue = tissues.voxels[at];
        if (tissue != anatomy::tissue::fat && tissue != anatomy::tissue::muscle && tissue != anatomy::tissue::soft)
          continue;
        tissue = anatomy::tissue::mass;
        structures.voxels[at] = structure::lesion;
      }
    }
  }
}

}  // namespace

SyntheticPatient synthesize_lumbar(const LumbarParameters& parameters, const anatomy::TissueLibrary& library,
                                   const Progress& progress) {
  check_parameters(parameters);
  const LumbarSizes sizes = lumbar_sizes(parameters);
  const LumbarModel model(sizes, parameters.seed);

  SyntheticPatient patient;
  patient.landmarks = make_landmarks(model);
  const anatomy::Grid grid = make_grid(model, parameters.spacing);
  patient.tissues = anatomy::TissueVolume(grid);
  patient.structures = anatomy::LabelVolume(grid);
  parallel_for(grid.size[2], "anatomy", progress, [&](int k) {
    const double z = grid.to_patient(Vec3(0.0, 0.0, k)).z();
    const LumbarModel::Slice slice = model.slice(z, parameters.spacing);
    std::size_t at = grid.offset(0, 0, k);
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i, ++at) {
        const Material material = model.at(grid.to_patient(Vec3(i, j, k)), slice);
        patient.tissues.voxels[at] = material.tissue;
        patient.structures.voxels[at] = material.label;
      }
    }
  });
  patient.path = aim_at_fluid(plan_approach(model, level::l3).path, patient.tissues);
  if (parameters.lesion > 0.0) add_lesion(parameters.lesion, patient.tissues, patient.structures);
  patient.structure_table = lumbar_structures(patient.structures);
  patient.ct = paint_ct(patient.tissues, library, sizes, parameters.seed, progress);
  return patient;
}

}  // namespace bodkin::patient
