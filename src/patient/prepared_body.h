#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "anatomy/case.h"
#include "anatomy/tetrahedral_mesh.h"
#include "core/progress.h"
#include "fem/solid/contact_body.h"
#include "fem/solid/contact_stream.h"

namespace bodkin::patient {

// What was prepared is stored next to the mesh that it was made from, in the case folder: the condensed body of
// `closest_node`, and the factor of `embedded_needle`.
inline constexpr const char* body_file_name = "body.condensed";
inline constexpr const char* factor_file_name = "body.factor";

// Gives a case the deformable body that its resistance needs, from the mesh in `folder` and the settings of the
// resistance. For `embedded_needle` that is the contact points of `path` (the planned one where there is none), and
// `kept`, unless null, becomes the body for contact_stream(), factorised now or read back when that was done before.
// For `closest_node` it is the nodes of the corridor about the path, condensed now or, about the planned path, read
// back when that was done before.
// Returns what the body was made from; nullptr, and nothing done, when the resistance needs no body. `note` hears
// what was assumed, and what memory the work takes, before it takes it. Throws InputError, one sentence, when there
// is no path or no mesh, and for everything that describe_body() and condense() refuse.
std::shared_ptr<const fem::BodyDescription> prepare_body(anatomy::Case& patient, const std::filesystem::path& folder,
                                                         const std::optional<anatomy::NeedlePath>& path,
                                                         const Progress& progress,
                                                         const std::function<void(const std::string&)>& note,
                                                         std::shared_ptr<const fem::ContactBody>* kept = nullptr);

// The same from a mesh in memory, about `path`; nothing is written. Nothing is done when the
// resistance needs no body. Throws InputError for everything that describe_body() and condense() refuse.
void prepare_body(anatomy::Case& patient, anatomy::TetrahedralMesh mesh, const anatomy::NeedlePath& path,
                  const Progress& progress = {}, std::shared_ptr<const fem::ContactBody>* kept = nullptr);

// Computes the contact points of every line that `line` is asked for, as deep as `length` mm (that of the planned
// path) and what the settings add to it. `kept` as above. Throws like prepare_body(); null for a resistance without
// contact points.
std::unique_ptr<fem::ContactStream> contact_stream(const fem::BodyDescription& body,
                                                   std::shared_ptr<const anatomy::Case> patient, double length,
                                                   std::shared_ptr<const fem::ContactBody>& kept,
                                                   std::shared_ptr<fem::ContactLine> line);

// The same for a patient who outlives it, in the body that prepare_body() has kept.
std::unique_ptr<fem::ContactStream> contact_stream(const anatomy::Case& patient, double length,
                                                   std::shared_ptr<const fem::ContactBody> kept,
                                                   std::shared_ptr<fem::ContactLine> line);

}  // namespace bodkin::patient
