#include "training/prepared_body.h"

#include <memory>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/condensed_cache.h"
#include "fem/solid/patient_body.h"
#include "io/mesh/mesh_record.h"

namespace bodkin {

void prepare_body(Case& patient, const std::filesystem::path& folder, const Progress& progress,
                  const std::function<void(const std::string&)>& note) {
  const ResistanceSettings& resistance = patient.description.haptics.resistance;
  const DeformableBodySettings* settings = body_of(resistance);
  if (settings == nullptr) return;
  if (progress) progress("Reading the mesh", 0.0);
  std::optional<CaseMesh> mesh = read_case_mesh(folder, patient.library);
  if (!mesh) {
    throw InputError(fmt::format("{}: the case has no mesh, which {} needs; make one with: bodkin case mesh {}",
                                 folder.string(), name_of(resistance), folder.string()));
  }
  PatientBody described = describe_body(std::move(mesh->mesh), patient, *settings);
  if (note) {
    for (const std::string& sentence : described.notes) note(sentence);
  }
  auto body = std::make_shared<CondensedBody>(
      condensed_with_cache(folder / body_file_name, described.body, {}, progress, note));
  take_tissues_of_voxels(*body, patient);
  patient.body = std::move(body);
}

}  // namespace bodkin
