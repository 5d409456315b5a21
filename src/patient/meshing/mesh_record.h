#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "patient/meshing/mesh_plan.h"

#include "anatomy/case.h"
#include "anatomy/tetrahedral_mesh.h"

// The mesh of a case is in its folder as mesh.vtu, together with mesh.json, which records its inputs.

namespace bodkin::patient {

inline constexpr const char* mesh_file_name = "mesh.vtu";
inline constexpr const char* mesh_record_name = "mesh.json";

// The content of mesh.json about mesh.vtu.
struct MeshRecord {
  std::string made_from;    // digest of all inputs of the mesh
  std::string mesh_digest;  // of the bytes of mesh.vtu
  double scale = 1.0;       // of the desired edges; 1 for an imported mesh
  std::string source;       // imported file; empty: generated from the tissues
  std::vector<std::string> notes;
};

// Digest of a mesh generated from tissues with settings, and of one imported from the bytes of a file and of its
// label scheme (may be empty).
std::string mesh_made_from(const anatomy::TissueVolume& tissues, const std::optional<anatomy::NeedlePath>& path,
                           const MeshSettings& settings);
std::string mesh_made_from(std::string_view mesh_bytes, std::string_view scheme_bytes);

// The mesh in a case folder, with its record if it has a matching one.
struct CaseMesh {
  anatomy::TetrahedralMesh mesh;
  std::optional<MeshRecord> record;
};

// The mesh of a case, or nothing if it has none. The tissues of its elements must be in `library`. Throws InputError
// when mesh.vtu is damaged.
std::optional<CaseMesh> read_case_mesh(const std::filesystem::path& folder, const anatomy::TissueLibrary& library);

// Whether the folder has no mesh, or an unchanged one written by write_case_mesh: replacing it loses nothing.
bool case_mesh_is_ours(const std::filesystem::path& folder);

// The record of an existing, unchanged mesh; empty otherwise. Does not parse the mesh.
std::optional<MeshRecord> read_mesh_record(const std::filesystem::path& folder);

// Writes mesh.vtu and mesh.json; computes the digest in `record`. Throws SystemError.
void write_case_mesh(const anatomy::TetrahedralMesh& mesh, MeshRecord record, const std::filesystem::path& folder);

}  // namespace bodkin::patient
