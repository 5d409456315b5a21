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

// Prepared data are stored next to the mesh in the case folder: the condensed body of `closest_node`, and the factor
// of `embedded_needle`.
inline constexpr const char* body_file_name = "body.condensed";
inline constexpr const char* factor_file_name = "body.factor";

// Gives a case the deformable body that its resistance needs, from the mesh in `folder` and the settings of the
// resistance. For `embedded_needle` these are the contact points of `path` (the planned one if there is none), and
// `kept`, unless null, becomes the body for contact_stream(), factorised now or read from the cache. For
// `closest_node` it is the nodes of the corridor about the path, condensed now or, for the planned path, read from
// the cache. Returns the description of the body; nullptr, without effect, when the resistance needs no body. `note`
// receives the assumptions, and the memory required before it is allocated. Throws InputError, one sentence, when
// there is no path or no mesh, and whenever describe_body() or condense() does.
std::shared_ptr<const fem::BodyDescription> prepare_body(anatomy::Case& patient, const std::filesystem::path& folder,
                                                         const std::optional<anatomy::NeedlePath>& path,
                                                         const Progress& progress,
                                                         const std::function<void(const std::string&)>& note,
                                                         std::shared_ptr<const fem::ContactBody>* kept = nullptr);

// As above, from a mesh in memory, about `path`; nothing is written. No effect when the resistance needs no body.
// Throws InputError whenever describe_body() or condense() does.
void prepare_body(anatomy::Case& patient, anatomy::TetrahedralMesh mesh, const anatomy::NeedlePath& path,
                  const Progress& progress = {}, std::shared_ptr<const fem::ContactBody>* kept = nullptr);

// Computes the contact points of every line requested through `line`, as deep as `length` mm (that of the planned
// path) plus the addition in the settings. `kept` as above. Throws like prepare_body(); null for a resistance without
// contact points.
std::unique_ptr<fem::ContactStream> contact_stream(const fem::BodyDescription& body,
                                                   std::shared_ptr<const anatomy::Case> patient, double length,
                                                   std::shared_ptr<const fem::ContactBody>& kept,
                                                   std::shared_ptr<fem::ContactLine> line);

// As above, for a patient who outlives it, in the body kept by prepare_body().
std::unique_ptr<fem::ContactStream> contact_stream(const anatomy::Case& patient, double length,
                                                   std::shared_ptr<const fem::ContactBody> kept,
                                                   std::shared_ptr<fem::ContactLine> line);

}  // namespace bodkin::patient
