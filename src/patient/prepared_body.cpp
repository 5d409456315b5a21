#include "patient/prepared_body.h"

#include <utility>
#include <variant>
#include <vector>

#include "patient/meshing/mesh_plan.h"
#include "patient/meshing/mesh_record.h"
#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/condensed_cache.h"
#include "fem/solid/factor_cache.h"
#include "fem/solid/patient_body.h"

namespace bodkin::patient {

namespace {

bool same(const anatomy::NeedlePath& one, const anatomy::NeedlePath& other) {
  return one.entry == other.entry && one.target == other.target;
}

// The settings of a needle with contact points on its line; nullptr: it uses nodes.
const anatomy::EmbeddedNeedleSettings* with_points(const anatomy::Case& patient) {
  return std::get_if<anatomy::EmbeddedNeedleSettings>(&patient.description.haptics.resistance);
}

anatomy::CondensedBody points_of(const fem::ContactBody& body, const anatomy::Case& patient,
                                 const anatomy::NeedlePath& path, const anatomy::EmbeddedNeedleSettings& settings) {
  const std::vector<fem::ContactSite> sites =
      fem::contact_sites_along(path, path.length() + settings.points_beyond, settings.point_spacing, patient);
  return body.contact_points(sites, path.direction(), settings.tip_radius, 0, body.bind(patient.left_needles, {}));
}

// `cache`: empty for none.
std::shared_ptr<const fem::ContactBody> contact_body(const std::shared_ptr<const fem::BodyDescription>& body,
                                                     const std::filesystem::path& cache, const Progress& progress,
                                                     const std::function<void(const std::string&)>& note) {
  auto whole = fem::contact_body_with_cache(cache, body, progress, note);
  if (note) {
    note(fmt::format("the needle meets points of its line in a body of {} nodes, whose factor takes {:.2f} GB",
                     body->mesh.nodes.size(), 1e-9 * static_cast<double>(whole->factor().bytes())));
  }
  return whole;
}

// The body of a mesh; `folder`: for the prepared data, empty for none.
std::shared_ptr<const fem::BodyDescription> prepare_body_of(anatomy::TetrahedralMesh mesh, anatomy::Case& patient,
                                                            const std::filesystem::path& folder,
                                                            const anatomy::NeedlePath& about,
                                                            const Progress& progress,
                                                            const std::function<void(const std::string&)>& note,
                                                            std::shared_ptr<const fem::ContactBody>* kept) {
  const anatomy::DeformableBodySettings& settings = *anatomy::body_of(patient.description.haptics.resistance);
  const auto body =
      std::make_shared<fem::BodyDescription>(fem::describe_body(std::move(mesh), patient, settings, about));
  if (const anatomy::EmbeddedNeedleSettings* points = with_points(patient)) {
    const std::filesystem::path cache = folder.empty() ? folder : folder / factor_file_name;
    const auto whole = contact_body(body, cache, progress, note);
    if (note && has_stiff_skin(patient.library)) {
      note(
          "the skin is stiffer than fat: 'bodkin case mesh' keeps it within 12 mm of the planned path; a needle that "
          "enters farther away dimples what lies below it");
    }
    patient.prepared = {std::make_shared<const anatomy::CondensedBody>(points_of(*whole, patient, about, *points)),
                        about};
    if (kept != nullptr) *kept = whole;
    return body;
  }
  std::vector<std::string> notes;
  body->corridor = fem::corridor_about(
      *body, about, std::get<anatomy::ClosestNodeSettings>(patient.description.haptics.resistance).corridor, notes);
  if (note) {
    for (const std::string& sentence : notes) note(sentence);
  }
  const std::optional<anatomy::NeedlePath>& planned = patient.description.procedure.path;
  anatomy::CondensedBody condensed =
      !folder.empty() && planned && same(about, *planned)
          ? fem::condensed_with_cache(folder / body_file_name, *body, {}, progress, note)
          : fem::condense(*body, {}, progress, note);
  fem::take_tissues_of_voxels(condensed, patient);
  patient.prepared = {std::make_shared<const anatomy::CondensedBody>(std::move(condensed)), about};
  return body;
}

}  // namespace

std::shared_ptr<const fem::BodyDescription> prepare_body(anatomy::Case& patient, const std::filesystem::path& folder,
                                                         const std::optional<anatomy::NeedlePath>& path,
                                                         const Progress& progress,
                                                         const std::function<void(const std::string&)>& note,
                                                         std::shared_ptr<const fem::ContactBody>* kept) {
  const anatomy::ResistanceSettings& resistance = patient.description.haptics.resistance;
  const anatomy::DeformableBodySettings* settings = anatomy::body_of(resistance);
  if (settings == nullptr) return nullptr;
  const std::optional<anatomy::NeedlePath>& planned = patient.description.procedure.path;
  const std::optional<anatomy::NeedlePath> about = path ? path : planned;
  if (!about) {
    throw InputError(
        fmt::format("{}: the case has no planned path, about which the deformable body is prepared; give --entry and "
                    "--target, or make the case with them",
                    folder.string()));
  }
  if (progress) progress("Reading the mesh", 0.0);
  std::optional<CaseMesh> mesh = read_case_mesh(folder, patient.library);
  if (!mesh) {
    throw InputError(fmt::format("{}: the case has no mesh, which {} needs; make one with: bodkin case mesh {}",
                                 folder.string(), anatomy::name_of(resistance), folder.string()));
  }
  return prepare_body_of(std::move(mesh->mesh), patient, folder, *about, progress, note, kept);
}

void prepare_body(anatomy::Case& patient, anatomy::TetrahedralMesh mesh, const anatomy::NeedlePath& path,
                  const Progress& progress, std::shared_ptr<const fem::ContactBody>* kept) {
  if (anatomy::body_of(patient.description.haptics.resistance) != nullptr)
    prepare_body_of(std::move(mesh), patient, {}, path, progress, {}, kept);
}

std::unique_ptr<fem::ContactStream> contact_stream(const fem::BodyDescription& body,
                                                   std::shared_ptr<const anatomy::Case> patient, double length,
                                                   std::shared_ptr<const fem::ContactBody>& kept,
                                                   std::shared_ptr<fem::ContactLine> line) {
  const anatomy::EmbeddedNeedleSettings* points = with_points(*patient);
  if (points == nullptr) return nullptr;
  if (kept == nullptr) kept = contact_body(std::make_shared<const fem::BodyDescription>(body), {}, {}, {});
  const fem::ContactStreamSettings settings{.length = length + points->points_beyond,
                                            .spacing = points->point_spacing,
                                            .tip_radius = points->tip_radius,
                                            .left = patient->left_needles};
  return std::make_unique<fem::ContactStream>(kept, std::move(patient), settings, std::move(line));
}

std::unique_ptr<fem::ContactStream> contact_stream(const anatomy::Case& patient, double length,
                                                   std::shared_ptr<const fem::ContactBody> kept,
                                                   std::shared_ptr<fem::ContactLine> line) {
  const std::shared_ptr<const anatomy::Case> shared(std::shared_ptr<const anatomy::Case>(), &patient);
  return contact_stream(kept->description(), shared, length, kept, std::move(line));
}

}  // namespace bodkin::patient
