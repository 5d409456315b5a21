#include "scene/export_surfaces.h"

#include <array>
#include <string>
#include <system_error>

#include "scene/vtk_meshes.h"
#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include "core/error.h"

namespace bodkin::scene {

namespace {

constexpr std::array<std::string_view, 3> format_names = {"stl", "ply", "vtp"};

template <typename Writer>
bool written(Writer& writer, vtkPolyData& data, const std::filesystem::path& file) {
  writer.SetInputData(&data);
  writer.SetFileName(file.c_str());
  std::error_code error;
  return writer.Write() == 1 && std::filesystem::file_size(file, error) > 0 && !error;
}

bool write_part(vtkPolyData& data, const std::filesystem::path& file, SurfaceFormat format) {
  switch (format) {
    case SurfaceFormat::stl: {
      vtkNew<vtkSTLWriter> writer;
      writer->SetFileTypeToBinary();
      writer->SetHeader("Bodkin: LPS, mm");
      return written(*writer, data, file);
    }
    case SurfaceFormat::ply: {
      vtkNew<vtkPLYWriter> writer;
      writer->SetFileTypeToBinary();
      return written(*writer, data, file);
    }
    case SurfaceFormat::vtp: {
      vtkNew<vtkXMLPolyDataWriter> writer;
      return written(*writer, data, file);
    }
  }
  return false;
}

}  // namespace

std::optional<SurfaceFormat> surface_format_from(std::string_view name) {
  for (std::size_t i = 0; i < format_names.size(); ++i) {
    if (format_names[i] == name) return static_cast<SurfaceFormat>(i);
  }
  return std::nullopt;
}

std::string_view name_of(SurfaceFormat format) {
  return format_names[static_cast<std::size_t>(format)];
}

std::vector<std::filesystem::path> export_surfaces(const PatientSurfaces& surfaces,
                                                   const std::filesystem::path& folder, SurfaceFormat format) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw SystemError(fmt::format("export of surfaces: the folder {} cannot be made ({}); choose another one",
                                  folder.string(), error.message()));
  }
  std::vector<std::filesystem::path> files;
  for (const PatientSurface& part : surfaces.parts) {
    vtkNew<vtkPolyData> data;
    to_poly_data(part.mesh, *data);
    files.push_back(folder / fmt::format("{}.{}", part.name, name_of(format)));
    if (!write_part(*data, files.back(), format)) {
      throw SystemError(
          fmt::format("export of surfaces: {} cannot be written; check that the folder may be written to "
                      "and that the disk has room",
                      files.back().string()));
    }
  }
  return files;
}

}  // namespace bodkin::scene
