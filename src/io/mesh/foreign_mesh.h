#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/tetrahedral_mesh.h"

namespace bodkin::io {

// A mesh from a file of another program, with that program's region numbers. Coordinates are finite and within 1e5
// mm, corners are nodes and differ from each other.
struct ForeignMesh {
  std::vector<Vec3> nodes;  // as in the file, assumed to be LPS mm
  std::vector<std::array<std::uint32_t, 4>> elements;
  std::vector<std::int64_t> regions;          // one per element
  std::map<std::int64_t, std::string> names;  // of regions, if the file has any
  std::vector<std::string> notes;             // omissions and assumptions, one sentence each
};

inline constexpr std::size_t most_mesh_nodes = 4'000'000;
inline constexpr std::size_t most_mesh_elements = 24'000'000;
inline constexpr double furthest_mesh_node = 1e5;  // mm from the origin, along each axis

// Reads a Gmsh (.msh) or VTK (.vtu) file by the ending of its name. Throws InputError naming file, line and element.
ForeignMesh read_foreign_mesh(const std::filesystem::path& file);

// Gmsh's MSH format, ASCII, versions 2.2 and 4.1. The region of a tetrahedron is its first physical group; without
// one it is the number of its volume. Elements of other dimensions are left out.
ForeignMesh parse_gmsh(std::string_view text, const std::string& origin);

// VTK's XML format for unstructured grids: one piece; arrays as ascii, binary, or appended (base64 or raw), plain or
// packed by zlib. The region is the cell array `tissue`, or else the first existing one of "gmsh:physical",
// "medit:ref", "region", "material", "label", or else the only array of whole numbers.
ForeignMesh parse_vtu(std::string_view bytes, const std::string& origin);

// A mesh as such a file: ascii, cell array `tissue`; numbers read back to the same bits.
std::string vtu_text(const anatomy::TetrahedralMesh& mesh);

}  // namespace bodkin::io
