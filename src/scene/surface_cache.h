#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/surfaces.h"

namespace bodkin::scene {

// Surfaces in a file: VTK's XML format for polygons, which ParaView and 3D Slicer open. Cells have the number of
// their part; names, kinds, colours and the digest of what they were made from are field data.

// Replaces the file whole. Throws SystemError when it cannot be written.
void write_surfaces(const PatientSurfaces& surfaces, const std::string& digest, const std::filesystem::path& file);
// Nothing when there is no such file, when it is damaged, or when it was made from something else.
std::optional<PatientSurfaces> read_surfaces(const std::filesystem::path& file, const std::string& digest);

// A fingerprint of the tissues and of how surfaces are made from them.
std::string surfaces_digest(const anatomy::TissueVolume& tissues);

// The surfaces of a case: from surfaces.vtp in its folder, or else made and kept there. A folder that cannot be
// written is no error; an empty name stands for a case that is in memory only. See make_surfaces().
PatientSurfaces surfaces_of_case(const anatomy::TissueVolume& tissues, const std::filesystem::path& folder,
                                 const Progress& progress = {});

}  // namespace bodkin::scene
