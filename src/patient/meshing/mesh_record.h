#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "patient/meshing/mesh_plan.h"

#include "anatomy/case.h"
#include "anatomy/tetrahedral_mesh.h"

// The mesh of a case lies in its folder as mesh.vtu, together with mesh.json, which records what it was made from.

namespace bodkin::patient {

inline constexpr const char* mesh_file_name = "mesh.vtu";
inline constexpr const char* mesh_record_name = "mesh.json";

// What mesh.json says of mesh.vtu.
struct MeshRecord {
  std::string made_from;    // fingerprint of everything that the mesh follows from
  std::string mesh_digest;  // of the bytes of mesh.vtu
  double scale = 1.0;       // of the wished edges; 1 for an imported mesh
  std::string source;       // file that the mesh was imported from; empty: made from the tissues
  std::vector<std::string> notes;
};

// Fingerprint of a mesh made from tissues with settings, and of one imported from the bytes of a file and of its
// label scheme (may be empty).
std::string mesh_made_from(const anatomy::TissueVolume& tissues, const std::optional<anatomy::NeedlePath>& path,
                           const MeshSettings& settings);
std::string mesh_made_from(std::string_view mesh_bytes, std::string_view scheme_bytes);

// The mesh that a case folder holds, with its record when it has one that fits the mesh.
struct CaseMesh {
  anatomy::TetrahedralMesh mesh;
  std::optional<MeshRecord> record;
};

// The mesh of a case, or nothing when it has none. The tissues of its elements must be in `library`. Throws
// InputError when mesh.vtu is damaged.
std::optional<CaseMesh> read_case_mesh(const std::filesystem::path& folder, const anatomy::TissueLibrary& library);

// Whether the folder's mesh is one that write_case_mesh left there, unchanged since, or it has none: nothing is lost
// when it is replaced.
bool case_mesh_is_ours(const std::filesystem::path& folder);

// The record of a mesh that is there and unchanged; nothing otherwise. Does not parse the mesh.
std::optional<MeshRecord> read_mesh_record(const std::filesystem::path& folder);

// Writes mesh.vtu and mesh.json; the digest in `record` is found here. Throws SystemError.
void write_case_mesh(const anatomy::TetrahedralMesh& mesh, MeshRecord record, const std::filesystem::path& folder);

}  // namespace bodkin::patient
