#pragma once

#include <filesystem>
#include <string>

#include "anatomy/case.h"

namespace bodkin::session {

// A digest of everything in a case that a replay depends on: case.xml, the tissue voxels, every parameter of every
// tissue, and the mesh (`mesh`: mesh_digest()). "3:" and 16 hexadecimal digits.
std::string case_digest(const anatomy::Case& patient, const std::string& case_xml, const std::string& mesh);

// A digest of the mesh in the case's folder, for a resistance with a deformable body; otherwise, and without a mesh,
// empty. Throws SystemError when the mesh cannot be read.
std::string mesh_digest(const std::filesystem::path& case_folder, const anatomy::ResistanceSettings& resistance);

// The separate digests behind case_digest(), so that a replay can say what has changed: a line each for voxels,
// tissues and mesh, its name, a blank and 16 hexadecimal digits; no line without a mesh.
std::string case_parts(const anatomy::Case& patient, const std::string& mesh);

// The parts of the case that differ from `recorded`, a result of case_parts(): "voxels", "tissues and mesh"; empty:
// none.
std::string changed_parts(const std::string& recorded, const anatomy::Case& patient, const std::string& mesh);

// A digest of the case's deformable body, 16 hexadecimal digits; empty without one.
std::string digest_of_body(const anatomy::Case& patient);
// As digest_of_body(), only of its contact points, without the compliance between them.
std::string digest_of_points(const anatomy::Case& patient);

// The digest of Bodkin 0.1: 16 hexadecimal digits, without the mesh and the parameters `deformable` and `acoustic`.
std::string first_case_digest(const anatomy::Case& patient, const std::string& case_xml);

// The digest from before tissues had a physical description: "2:" and 16 hexadecimal digits, without `physical`.
std::string second_case_digest(const anatomy::Case& patient, const std::string& case_xml, const std::string& mesh);

// Whether a session that stored `digest` was recorded on this case: "3:" is compared with case_digest(), "2:" with
// second_case_digest(), anything else with first_case_digest().
bool is_digest_of_case(const std::string& digest, const anatomy::Case& patient, const std::string& case_xml,
                       const std::string& mesh);

}  // namespace bodkin::session
