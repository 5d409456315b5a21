#include "scene/surface_cache.h"

#include <array>
#include <system_error>

#include "scene/vtk_meshes.h"
#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include "core/error.h"
#include "core/files.h"
#include "io/digest.h"

namespace bodkin::scene {

namespace {

constexpr int surfaces_version = 2;  // increased whenever make_surfaces() gives others for the same tissues

// All parts as one mesh.
SceneMesh joined(const PatientSurfaces& surfaces) {
  SceneMesh all;
  for (const PatientSurface& part : surfaces.parts) {
    const auto first = static_cast<std::int32_t>(all.points.size());
    all.points.insert(all.points.end(), part.mesh.points.begin(), part.mesh.points.end());
    all.normals.insert(all.normals.end(), part.mesh.normals.begin(), part.mesh.normals.end());
    all.openness.insert(all.openness.end(), part.mesh.openness.begin(), part.mesh.openness.end());
    for (const auto& corners : part.mesh.triangles) {
      all.triangles.push_back({corners[0] + first, corners[1] + first, corners[2] + first});
    }
  }
  return all;
}

// The triangles of `all` that belong to `number`, with their points.
SceneMesh separated(const SceneMesh& all, vtkIntArray& parts, int number) {
  SceneMesh mesh;
  std::vector<std::int32_t> index(all.points.size(), -1);
  for (std::size_t t = 0; t < all.triangles.size(); ++t) {
    if (parts.GetValue(static_cast<vtkIdType>(t)) != number) continue;
    std::array<std::int32_t, 3> triangle{};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto old = static_cast<std::size_t>(all.triangles[t][c]);
      if (index[old] < 0) {
        index[old] = static_cast<std::int32_t>(mesh.points.size());
        mesh.points.push_back(all.points[old]);
        mesh.normals.push_back(all.normals[old]);
        mesh.openness.push_back(all.openness[old]);
      }
      triangle[c] = index[old];
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

// VTK prints errors of a file; a damaged one needs no message, since it is recreated.
class NoWarnings {
 public:
  NoWarnings() { vtkObject::GlobalWarningDisplayOff(); }
  ~NoWarnings() { vtkObject::SetGlobalWarningDisplay(before_); }
  NoWarnings(const NoWarnings&) = delete;
  NoWarnings& operator=(const NoWarnings&) = delete;

 private:
  int before_ = vtkObject::GetGlobalWarningDisplay();
};

template <typename Array>
Array* field(vtkPolyData& data, const char* name, vtkIdType count) {
  auto* array = Array::SafeDownCast(data.GetFieldData()->GetAbstractArray(name));
  return array != nullptr && array->GetNumberOfValues() == count ? array : nullptr;
}

}  // namespace

void write_surfaces(const PatientSurfaces& surfaces, const std::string& digest, const std::filesystem::path& file) {
  vtkNew<vtkPolyData> data;
  to_poly_data(joined(surfaces), *data);
  vtkNew<vtkIntArray> parts, kinds, colours;
  vtkNew<vtkStringArray> names, digests;
  parts->SetName("part");
  kinds->SetName("kinds");
  colours->SetName("colours");
  names->SetName("names");
  digests->SetName("digest");
  digests->InsertNextValue(digest);
  for (std::size_t number = 0; number < surfaces.parts.size(); ++number) {
    const PatientSurface& part = surfaces.parts[number];
    for (std::size_t t = 0; t < part.mesh.triangles.size(); ++t) parts->InsertNextValue(static_cast<int>(number));
    kinds->InsertNextValue(static_cast<int>(part.kind));
    colours->InsertNextValue(static_cast<int>(part.colour));
    names->InsertNextValue(part.name);
  }
  data->GetCellData()->AddArray(parts);
  data->GetFieldData()->AddArray(kinds);
  data->GetFieldData()->AddArray(colours);
  data->GetFieldData()->AddArray(names);
  data->GetFieldData()->AddArray(digests);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetHeaderTypeToUInt64();
  writer->SetEncodeAppendedData(0);
  writer->WriteToOutputStringOn();
  if (writer->Write() != 1) {
    throw SystemError(
        fmt::format("{}: the surfaces could not be written; check that the disk has room", file.string()));
  }
  write_file(file, writer->GetOutputString());
}

std::optional<PatientSurfaces> read_surfaces(const std::filesystem::path& file, const std::string& digest) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  const NoWarnings quiet;
  vtkNew<vtkXMLPolyDataReader> reader;
  if (reader->CanReadFile(file.c_str()) != 1) return std::nullopt;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  auto* digests = field<vtkStringArray>(*data, "digest", 1);
  if (reader->GetErrorCode() != 0 || digests == nullptr || digests->GetValue(0) != digest) return std::nullopt;
  auto* parts = vtkIntArray::SafeDownCast(data->GetCellData()->GetArray("part"));
  auto* names = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("names"));
  if (parts == nullptr || names == nullptr || names->GetNumberOfValues() == 0) return std::nullopt;
  auto* kinds = field<vtkIntArray>(*data, "kinds", names->GetNumberOfValues());
  auto* colours = field<vtkIntArray>(*data, "colours", names->GetNumberOfValues());
  if (kinds == nullptr || colours == nullptr) return std::nullopt;
  try {
    const SceneMesh all = to_mesh(*data);
    if (static_cast<vtkIdType>(all.triangles.size()) != parts->GetNumberOfValues()) return std::nullopt;
    PatientSurfaces surfaces;
    for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i) {
      const int kind = kinds->GetValue(i);
      if (kind < 0 || kind > static_cast<int>(SurfaceKind::forbidden)) return std::nullopt;
      surfaces.parts.push_back({static_cast<SurfaceKind>(kind), names->GetValue(i),
                                static_cast<std::uint32_t>(colours->GetValue(i)) & 0xFFFFFFU,
                                separated(all, *parts, static_cast<int>(i))});
    }
    if (surfaces.parts.front().kind != SurfaceKind::skin) return std::nullopt;
    return surfaces;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::string surfaces_digest(const anatomy::TissueVolume& tissues) {
  return fmt::format("{}:{}", surfaces_version, io::volume_digest(tissues));
}

PatientSurfaces surfaces_of_case(const anatomy::TissueVolume& tissues, const std::filesystem::path& folder,
                                 const Progress& progress) {
  if (folder.empty()) return make_surfaces(tissues, progress);
  const std::string digest = surfaces_digest(tissues);
  const std::filesystem::path file = folder / "surfaces.vtp";
  if (std::optional<PatientSurfaces> kept = read_surfaces(file, digest)) return std::move(*kept);
  PatientSurfaces surfaces = make_surfaces(tissues, progress);
  try {
    write_surfaces(surfaces, digest, file);
  } catch (const SystemError&) {
    // They are recreated next time.
  }
  return surfaces;
}

}  // namespace bodkin::scene
