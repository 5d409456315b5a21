#include "app/models/label_draft.h"

#include <fstream>
#include <string>
#include <system_error>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files.h"
#include "io/digest.h"
#include "io/nrrd_reader.h"
#include "io/nrrd_writer.h"

namespace bodkin::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* voxels_name = "structures.draft.nrrd";
constexpr const char* table_name = "structures.draft.json";

std::string digest_of(const anatomy::LabelVolume& labels) {
  return labels.empty() ? std::string() : io::volume_digest(labels);
}

}  // namespace

void keep_label_draft(const views::OpenCase& patient, const LabelDraft& draft) {
  nlohmann::json table = nlohmann::json::array();
  for (const anatomy::Structure& each : draft.table)
    table.push_back(
        {{"label", each.label}, {"name", each.name}, {"tissue", each.tissue}, {"critical", each.critical}});
  io::write_nrrd(draft.labels, patient.folder / voxels_name);
  const nlohmann::json whole = {{"of", digest_of(patient.patient.structures)}, {"structures", table}};
  write_file(patient.folder / table_name, whole.dump(1) + "\n");
}

std::optional<LabelDraft> kept_label_draft(const views::OpenCase& patient) {
  std::ifstream stream(patient.folder / table_name);
  if (!stream) return std::nullopt;
  try {
    const nlohmann::json whole = nlohmann::json::parse(stream);
    if (whole.at("of").get<std::string>() != digest_of(patient.patient.structures)) return std::nullopt;
    LabelDraft draft;
    for (const nlohmann::json& each : whole.at("structures"))
      draft.table.push_back({each.at("label").get<std::uint16_t>(), each.at("name").get<std::string>(),
                             each.at("tissue").get<std::string>(), each.at("critical").get<bool>()});
    std::optional<anatomy::LabelVolume> labels = io::read_nrrd<std::uint16_t>(patient.folder / voxels_name);
    if (!labels || labels->voxels.size() != patient.patient.ct.voxels.size()) return std::nullopt;
    draft.labels = std::move(*labels);
    return draft;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void forget_label_draft(const views::OpenCase& patient) noexcept {
  std::error_code ignored;
  for (const char* name : {voxels_name, table_name}) fs::remove(patient.folder / name, ignored);
}

}  // namespace bodkin::app
