#include "patient/meshing/mesh_record.h"

#include <algorithm>

#include "patient/meshing/mesh_regions.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files.h"
#include "io/digest.h"
#include "io/mesh/foreign_mesh.h"
#include "io/resources.h"
#include "io/text_encoding.h"

namespace bodkin::patient {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int mesher_version = 1;  // increased when the same input gives another mesh
constexpr std::size_t largest_record = 1U << 20U, largest_mesh = std::size_t{2} << 30U;  // bytes

std::optional<MeshRecord> parse_record(const std::string& text) {
  const json value = json::parse(text, nullptr, false);
  if (!value.is_object()) return std::nullopt;
  try {
    return MeshRecord{value.at("made_from").get<std::string>(), value.at("mesh_digest").get<std::string>(),
                      value.at("scale").get<double>(), value.at("source").get<std::string>(),
                      value.at("notes").get<std::vector<std::string>>()};
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

std::optional<MeshRecord> record_for(const fs::path& folder, std::string_view mesh_bytes) {
  std::error_code ignored;
  if (!fs::is_regular_file(folder / mesh_record_name, ignored)) return std::nullopt;
  std::optional<MeshRecord> record = parse_record(io::read_text_file(folder / mesh_record_name, largest_record));
  if (record && record->mesh_digest != io::bytes_digest(mesh_bytes)) return std::nullopt;
  return record;
}

}  // namespace

std::string mesh_made_from(const anatomy::TissueVolume& tissues, const std::optional<anatomy::NeedlePath>& path,
                           const MeshSettings& settings) {
  std::string text = fmt::format("mesher {} tissues {} nodes {} fine {} coarse {} corridor {} {} reach {}",
                                 mesher_version, io::volume_digest(tissues), settings.nodes, settings.fine,
                                 settings.coarse, settings.corridor_radius, settings.corridor_beyond, settings.reach);
  if (path) {
    for (const Vec3& end : {path->entry, path->target}) text += fmt::format(" {} {} {}", end.x(), end.y(), end.z());
  }
  if (settings.preserve_layers) text += " layers held";
  if (settings.preserve_layers && settings.stiff_skin) text += " stiff skin";
  return io::bytes_digest(text);
}

std::string mesh_made_from(std::string_view mesh_bytes, std::string_view scheme_bytes) {
  return io::bytes_digest(
      fmt::format("imported {} {}", io::bytes_digest(mesh_bytes), io::bytes_digest(scheme_bytes)));
}

std::optional<MeshRecord> read_mesh_record(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_regular_file(folder / mesh_file_name, ignored)) return std::nullopt;
  return record_for(folder, io::read_text_file(folder / mesh_file_name, largest_mesh));
}

bool case_mesh_is_ours(const fs::path& folder) {
  std::error_code ignored;
  return !fs::exists(fs::symlink_status(folder / mesh_file_name, ignored)) || read_mesh_record(folder).has_value();
}

std::optional<CaseMesh> read_case_mesh(const fs::path& folder, const anatomy::TissueLibrary& library) {
  const fs::path file = folder / mesh_file_name;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::nullopt;
  const std::string bytes = io::read_text_file(file, largest_mesh);
  std::vector<std::string> notes;
  CaseMesh found{with_tissues(io::parse_vtu(bytes, file.string()), library, {}, file.string(), notes),
                 record_for(folder, bytes)};
  return found;
}

void write_case_mesh(const anatomy::TetrahedralMesh& mesh, MeshRecord record, const fs::path& folder) {
  const std::string text = io::vtu_text(mesh);
  record.mesh_digest = io::bytes_digest(text);
  const json value = {{"made_from", record.made_from},
                      {"mesh_digest", record.mesh_digest},
                      {"scale", record.scale},
                      {"source", io::valid_text(record.source)},
                      {"notes", record.notes}};
  write_file(folder / mesh_file_name, text);
  write_file(folder / mesh_record_name, value.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

}  // namespace bodkin::patient
