#include "session/volume_table.h"

#include <optional>
#include <span>

#include "session/session_schema.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "core/error.h"
#include "io/nrrd_reader.h"
#include "io/nrrd_writer.h"

namespace bodkin::session {

namespace {

constexpr const char* structures_row = "structures";
constexpr const char* tissues_row = "tissues";

template <typename Voxel>
anatomy::Volume<Voxel> unpacked(const std::vector<std::uint8_t>& bytes, const std::string& file, const char* row) {
  if (bytes.empty()) return {};
  std::optional<anatomy::Volume<Voxel>> volume =
      io::parse_nrrd<Voxel>(bytes, fmt::format("{}: the volume '{}'", file, row));
  if (!volume) refuse_session(file, fmt::format("the volume '{}' is not one that a session keeps", row));
  return std::move(*volume);
}

}  // namespace

RecordedVolumes recorded_volumes(const anatomy::Case& patient) {
  RecordedVolumes volumes;
  if (!patient.structures.empty()) volumes.structures = io::nrrd_bytes(patient.structures);
  if (!patient.tissues.empty()) volumes.tissues = io::nrrd_bytes(patient.tissues);
  return volumes;
}

void put_volumes(SQLite::Database& database, const RecordedVolumes& volumes) {
  SQLite::Statement insert(database, "INSERT INTO volumes VALUES(?, ?, ?)");
  const auto put = [&](const char* row, const std::vector<std::uint8_t>& bytes) {
    if (bytes.empty()) return;
    insert.bind(1, row);
    insert.bind(2, data_checksum(bytes));
    insert.bindNoCopy(3, bytes.data(), static_cast<int>(bytes.size()));
    insert.exec();
    insert.reset();
  };
  put(structures_row, volumes.structures);
  put(tissues_row, volumes.tissues);
}

RecordedVolumes read_volumes(SQLite::Database& database, const std::string& file) {
  RecordedVolumes volumes;
  SQLite::Statement query(database, "SELECT name, checksum, nrrd FROM volumes");
  while (query.executeStep()) {
    const std::string name = query.getColumn(0).getString();
    if (name != structures_row && name != tissues_row)
      refuse_session(file, "the list of the patient's volumes is damaged");
    const SQLite::Column data = query.getColumn(2);
    const std::span<const std::uint8_t> bytes(static_cast<const std::uint8_t*>(data.getBlob()),
                                              static_cast<std::size_t>(data.getBytes()));
    if (bytes.empty() || query.getColumn(1).getInt64() != data_checksum(bytes))
      refuse_session(file, fmt::format("the patient's volume '{}' is damaged, its checksum does not fit", name));
    (name == structures_row ? volumes.structures : volumes.tissues).assign(bytes.begin(), bytes.end());
  }
  return volumes;
}

anatomy::LabelVolume structures_of(const RecordedVolumes& volumes, const std::string& file) {
  return unpacked<std::uint16_t>(volumes.structures, file, structures_row);
}

anatomy::TissueVolume tissues_of(const RecordedVolumes& volumes, const std::string& file) {
  return unpacked<std::uint8_t>(volumes.tissues, file, tissues_row);
}

}  // namespace bodkin::session
