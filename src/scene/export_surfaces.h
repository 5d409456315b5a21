#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "scene/surfaces.h"

namespace bodkin::scene {

enum class SurfaceFormat : std::uint8_t {
  stl,  // binary
  ply,  // binary, with normals
  vtp   // VTK's XML format, with normals and openness
};

// "stl", "ply" or "vtp".
std::optional<SurfaceFormat> surface_format_from(std::string_view name);
std::string_view name_of(SurfaceFormat format);

// Writes each part of the patient to FOLDER/NAME.FORMAT, LPS mm; the folder is made. Returns the files. Throws
// SystemError when one cannot be written.
std::vector<std::filesystem::path> export_surfaces(const PatientSurfaces& surfaces,
                                                   const std::filesystem::path& folder, SurfaceFormat format);

}  // namespace bodkin::scene
