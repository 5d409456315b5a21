#include "scene/vtk_meshes.h"

#include <array>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "core/error.h"

namespace bodkin::scene {

namespace {

const vtkFloatArray* float_array(vtkPolyData& data, const char* name, int components) {
  auto* array = vtkFloatArray::SafeDownCast(data.GetPointData()->GetArray(name));
  const bool fits = array != nullptr && array->GetNumberOfComponents() == components &&
                    array->GetNumberOfTuples() == data.GetNumberOfPoints();
  return fits ? array : nullptr;
}

}  // namespace

void find_normals(SceneMesh& mesh) {
  mesh.normals.assign(mesh.points.size(), Eigen::Vector3f::Zero());
  const auto point = [&mesh](std::int32_t i) -> Eigen::Vector3f& { return mesh.points[static_cast<std::size_t>(i)]; };
  for (const std::array<std::int32_t, 3>& corners : mesh.triangles) {
    const Eigen::Vector3f& a = point(corners[0]);
    const Eigen::Vector3f across = (point(corners[1]) - a).cross(point(corners[2]) - a);
    for (const std::int32_t c : corners) mesh.normals[static_cast<std::size_t>(c)] += across;
  }
  for (Eigen::Vector3f& normal : mesh.normals) {
    const float length = normal.norm();
    normal = length > 0.0F ? Eigen::Vector3f(normal / length) : Eigen::Vector3f::UnitZ();
  }
}

void to_poly_data(const SceneMesh& mesh, vtkPolyData& data) {
  const auto count = static_cast<vtkIdType>(mesh.points.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(count);
  vtkNew<vtkFloatArray> normals, openness;
  normals->SetName("normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  openness->SetName("openness");
  openness->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector3f& point = mesh.points[at];
    points->SetPoint(i, static_cast<double>(point.x()), static_cast<double>(point.y()),
                     static_cast<double>(point.z()));
    normals->SetTypedTuple(i, mesh.normals[at].data());
    openness->SetValue(i, mesh.openness[at]);
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateEstimate(static_cast<vtkIdType>(mesh.triangles.size()), 3);
  for (const std::array<std::int32_t, 3>& triangle : mesh.triangles) {
    const std::array<vtkIdType, 3> corners = {triangle[0], triangle[1], triangle[2]};
    cells->InsertNextCell(3, corners.data());
  }
  data.SetPoints(points);
  data.SetPolys(cells);
  data.GetPointData()->SetNormals(normals);
  data.GetPointData()->AddArray(openness);
}

SceneMesh to_mesh(vtkPolyData& data) {
  SceneMesh mesh;
  const vtkIdType count = data.GetNumberOfPoints();
  const vtkFloatArray* normals = float_array(data, "normals", 3);
  const vtkFloatArray* openness = float_array(data, "openness", 1);
  for (vtkIdType i = 0; i < count; ++i) {
    double point[3];
    data.GetPoint(i, point);
    mesh.points.push_back(Vec3(point[0], point[1], point[2]).cast<float>());
    float normal[3] = {0.0F, 0.0F, 1.0F};
    if (normals != nullptr) normals->GetTypedTuple(i, normal);
    mesh.normals.emplace_back(normal[0], normal[1], normal[2]);
    mesh.openness.push_back(openness != nullptr ? openness->GetValue(i) : 1.0F);
  }
  vtkCellArray& cells = *data.GetPolys();
  vtkIdType corner_count = 0;
  const vtkIdType* corners = nullptr;
  for (cells.InitTraversal(); cells.GetNextCell(corner_count, corners) != 0;) {
    if (corner_count != 3) continue;
    std::array<std::int32_t, 3> triangle{};
    for (std::size_t c = 0; c < 3; ++c) {
      if (corners[c] < 0 || corners[c] >= count)
        throw InputError("surfaces: a triangle has a corner that is not a point");
      triangle[c] = static_cast<std::int32_t>(corners[c]);
    }
    mesh.triangles.push_back(triangle);
  }
  if (normals == nullptr) find_normals(mesh);
  return mesh;
}

}  // namespace bodkin::scene
