#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "anatomy/case.h"

namespace SQLite {
class Database;
}

namespace bodkin::session {

// The voxels of the patient, stored in a session so that its metrics can be computed without its case: the content of
// NRRD files (io/nrrd_writer.h). Empty: none.
struct RecordedVolumes {
  std::vector<std::uint8_t> structures;  // labels of the segmentation
  std::vector<std::uint8_t> tissues;     // ids
};

RecordedVolumes recorded_volumes(const anatomy::Case& patient);

// The table `volumes` of a session file. Throws SQLite::Exception.
void put_volumes(SQLite::Database& database, const RecordedVolumes& volumes);
// `file`: prefix of messages. Throws InputError for invalid rows, and SQLite::Exception.
RecordedVolumes read_volumes(SQLite::Database& database, const std::string& file);

// The volumes themselves, empty if not stored. `file`: prefix of messages. Throws InputError for content that is
// damaged in spite of its checksum.
anatomy::LabelVolume structures_of(const RecordedVolumes& volumes, const std::string& file);
anatomy::TissueVolume tissues_of(const RecordedVolumes& volumes, const std::string& file);

}  // namespace bodkin::session
