#include "scene/surfaces.h"

#include <algorithm>
#include <array>
#include <optional>

#include "scene/openness.h"
#include "scene/vtk_meshes.h"
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include "core/error.h"
#include "core/parallel_for.h"

namespace bodkin::scene {

namespace {

using anatomy::TissueSet;
using anatomy::TissueVolume;
namespace tissue = anatomy::tissue;

TissueSet set_of(std::initializer_list<anatomy::TissueId> ids) {
  TissueSet set;
  for (const anatomy::TissueId id : ids) set.set(id);
  return set;
}

// The box of voxels around `region`, with a margin of air; nothing if the patient has none of it.
std::optional<TissueVolume> cut_out(const TissueVolume& whole, const TissueSet& region) {
  const anatomy::Grid& grid = whole.grid;
  std::array<int, 3> low = grid.size, high = {-1, -1, -1};
  std::size_t voxel = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      int first = grid.size[0], last = -1;
      for (int i = 0; i < grid.size[0]; ++i, ++voxel) {
        if (!region[whole.voxels[voxel]]) continue;
        first = std::min(first, i);
        last = i;
      }
      if (last < 0) continue;
      low = {std::min(low[0], first), std::min(low[1], j), std::min(low[2], k)};
      high = {std::max(high[0], last), std::max(high[1], j), std::max(high[2], k)};
    }
  }
  if (high[0] < 0) return std::nullopt;
  anatomy::Grid part = grid;
  for (std::size_t a = 0; a < 3; ++a) part.size[a] = high[a] - low[a] + 1;
  part.origin = grid.to_patient(Vec3(low[0], low[1], low[2]));
  TissueVolume volume(part);
  for (int k = 0; k < part.size[2]; ++k) {
    for (int j = 0; j < part.size[1]; ++j) {
      const std::uint8_t* row = &whole.at(low[0], j + low[1], k + low[2]);
      std::copy(row, row + part.size[0], &volume.at(0, j, k));
    }
  }
  return volume;
}

void to_vtk(const anatomy::Surface& surface, vtkPolyData& data) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(static_cast<vtkIdType>(surface.vertices().size()));
  for (std::size_t i = 0; i < surface.vertices().size(); ++i) {
    points->SetPoint(static_cast<vtkIdType>(i), surface.vertices()[i].data());
  }
  vtkNew<vtkCellArray> cells;
  for (const std::array<int, 3>& triangle : surface.triangles()) {
    const std::array<vtkIdType, 3> corners = {triangle[0], triangle[1], triangle[2]};
    cells->InsertNextCell(3, corners.data());
  }
  data.SetPoints(points);
  data.SetPolys(cells);
}

// Without the points that belong to no triangle any more.
SceneMesh used_points(SceneMesh mesh) {
  std::vector<std::int32_t> index(mesh.points.size(), -1);
  SceneMesh used;
  for (std::array<std::int32_t, 3>& triangle : mesh.triangles) {
    for (std::int32_t& corner_index : triangle) {
      const auto old = static_cast<std::size_t>(corner_index);
      if (index[old] < 0) {
        index[old] = static_cast<std::int32_t>(used.points.size());
        used.points.push_back(mesh.points[old]);
        used.normals.push_back(mesh.normals[old]);
      }
      corner_index = index[old];
    }
  }
  used.triangles = std::move(mesh.triangles);
  used.openness.assign(used.points.size(), 1.0F);
  return used;
}

// Smoothed without losing volume, and at most `most` triangles.
SceneMesh refined(const anatomy::Surface& surface, int most) {
  vtkNew<vtkPolyData> raw;
  to_vtk(surface, *raw);
  vtkNew<vtkWindowedSincPolyDataFilter> smoothing;
  smoothing->SetInputData(raw);
  smoothing->SetNumberOfIterations(15);
  smoothing->SetPassBand(0.1);
  smoothing->NormalizeCoordinatesOn();
  smoothing->BoundarySmoothingOff();
  smoothing->FeatureEdgeSmoothingOff();
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputConnection(smoothing->GetOutputPort());
  const auto triangles = static_cast<double>(surface.triangles().size());
  if (triangles <= most) {
    smoothing->Update();
    return used_points(to_mesh(*smoothing->GetOutput()));
  }
  decimation->SetTargetReduction(1.0 - most / triangles);
  decimation->VolumePreservationOn();
  decimation->Update();
  return used_points(to_mesh(*decimation->GetOutput()));
}

}  // namespace

std::size_t PatientSurfaces::triangles() const {
  std::size_t sum = 0;
  for (const PatientSurface& part : parts) sum += part.mesh.triangles.size();
  return sum;
}

std::vector<SurfacePlan> surface_plans() {
  using enum SurfaceKind;
  return {
      {skin, "skin", 0xE0B596, anatomy::body_tissues(), {2.5, 2.0}, 16000},
      {bone, "bone", 0xE9DEC6, anatomy::bone_tissues(), {1.5, 0.8}, 25000},
      {tissue, "disc", 0x6EBEC7, set_of({tissue::disc}), {1.5, 0.8}, 3000},
      {tissue, "ligamentum_flavum", 0xD09500, set_of({tissue::ligamentum_flavum}), {1.0, 0.6}, 2500},
      {tissue,
       "dural_sac",
       0x9D4FC6,
       set_of({tissue::dura, tissue::cerebrospinal_fluid, tissue::nerve, tissue::spinal_cord}),
       {1.0, 0.7},
       3000},
      {tissue, "lesion", 0xCC79A7, set_of({tissue::mass}), {1.0, 0.6}, 1000},
      {tissue, "cartilage", 0xB6D9E0, set_of({tissue::cartilage}), {1.5, 0.8}, 2000},
      {tissue, "metal", 0xA9B4C0, set_of({tissue::metal}), {1.0, 0.4}, 1000},
      {forbidden, "vessel", 0xD8202C, set_of({tissue::vessel}), {1.5, 0.8}, 2500},
      {forbidden, "organ", 0x8A5878, set_of({tissue::organ}), {2.0, 1.2}, 4000},
  };
}

namespace {

// Nothing for a part missing in the patient, or too small to draw.
std::optional<PatientSurface> make_surface(const TissueVolume& tissues, const SurfacePlan& plan,
                                           const TissueSet& inside) {
  const bool is_skin = plan.kind == SurfaceKind::skin;
  const std::optional<TissueVolume> part = cut_out(tissues, plan.tissues);
  if (!part && is_skin) {
    throw InputError(
        "surfaces: the tissue map is empty or all air, expected a body; check the case with bodkin case "
        "check");
  }
  if (!part) return std::nullopt;
  SceneMesh mesh;
  try {
    mesh = refined(anatomy::tissue_surface(*part, plan.tissues, plan.settings), plan.most_triangles);
  } catch (const InputError&) {
    if (is_skin) throw;
  }
  if (mesh.empty()) return std::nullopt;
  find_openness(tissues, is_skin ? plan.tissues : inside, plan.settings.edge, mesh);
  return PatientSurface{plan.kind, std::string(plan.name), plan.colour, std::move(mesh)};
}

}  // namespace

PatientSurfaces make_surfaces(const TissueVolume& tissues, const Progress& progress) {
  const std::vector<SurfacePlan> plans = surface_plans();
  TissueSet inside;
  for (const SurfacePlan& plan : plans) {
    if (plan.kind != SurfaceKind::skin) inside |= plan.tissues;
  }
  std::vector<std::optional<PatientSurface>> made(plans.size());
  parallel_for(plans.size(), "drawing surfaces", progress,
               [&](std::size_t i) { made[i] = make_surface(tissues, plans[i], inside); });
  PatientSurfaces surfaces;
  for (std::optional<PatientSurface>& part : made) {
    if (part) surfaces.parts.push_back(std::move(*part));
  }
  return surfaces;
}

}  // namespace bodkin::scene
