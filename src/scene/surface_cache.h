#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/surfaces.h"

namespace bodkin::scene {

// Surfaces in a file: VTK's XML format for polygons, readable by ParaView and 3D Slicer. Cells have the number of
// their part; names, kinds, colours and the digest of the inputs are field data.

// Replaces the file atomically. Throws SystemError when it cannot be written.
void write_surfaces(const PatientSurfaces& surfaces, const std::string& digest, const std::filesystem::path& file);
// Empty when the file does not exist, is damaged, or has other inputs.
std::optional<PatientSurfaces> read_surfaces(const std::filesystem::path& file, const std::string& digest);

// A digest of the tissues and of the method by which surfaces are computed.
std::string surfaces_digest(const anatomy::TissueVolume& tissues);

// The surfaces of a case: from surfaces.vtp in its folder, or else computed and stored there. An unwritable folder is
// not an error; an empty name means a case that is only in memory. See make_surfaces().
PatientSurfaces surfaces_of_case(const anatomy::TissueVolume& tissues, const std::filesystem::path& folder,
                                 const Progress& progress = {});

}  // namespace bodkin::scene
