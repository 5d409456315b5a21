// A session's data of its patient's voxels.
#include "session/volume_table.h"

#include "session/session_file.h"
#include "tests/session/session_samples.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/nrrd_writer.h"

namespace bodkin {

using namespace bodkin::session;
namespace {

using ::testing::HasSubstr;

anatomy::Case small_patient() {
  anatomy::Grid grid;
  grid.size = {7, 5, 3};
  grid.spacing = Vec3(0.7, 1.0 / 3.0, 2.0);
  grid.origin = Vec3(-3.0, 1e-3, 40.0);
  anatomy::Case patient;
  patient.structures = anatomy::LabelVolume(grid);
  grid.spacing = Vec3(0.35, 0.25, 1.0);
  patient.tissues = anatomy::TissueVolume(grid);
  for (std::size_t i = 0; i < grid.voxel_count(); ++i) {
    patient.structures.voxels[i] = static_cast<std::uint16_t>(631 * i);
    patient.tissues.voxels[i] = static_cast<std::uint8_t>(i % 11);
  }
  return patient;
}

void write_patient(const std::filesystem::path& file, const RecordedVolumes& volumes) {
  SessionHeader header = sample_header();
  header.volumes = volumes;
  SessionWriter writer(file, header, true);
  writer.append(sample_record(0));
  writer.finish();
}

TEST(VolumeTable, the_patient_s_voxels_come_back_to_the_bit) {
  const ScratchSession scratch;
  const anatomy::Case patient = small_patient();
  write_patient(scratch.path(), recorded_volumes(patient));
  const Session session = read_session(scratch.path());
  const anatomy::LabelVolume structures = structures_of(session.header.volumes, "it");
  const anatomy::TissueVolume tissues = tissues_of(session.header.volumes, "it");
  EXPECT_EQ(structures.voxels, patient.structures.voxels);
  EXPECT_EQ(tissues.voxels, patient.tissues.voxels);
  EXPECT_EQ(structures.grid.spacing, patient.structures.grid.spacing);
  EXPECT_EQ(tissues.grid.origin, patient.tissues.grid.origin);
  EXPECT_EQ(tissues.grid.size, patient.tissues.grid.size);
}

TEST(VolumeTable, a_patient_without_a_segmentation_keeps_the_tissues_alone) {
  const ScratchSession scratch;
  anatomy::Case patient = small_patient();
  patient.structures = {};
  write_patient(scratch.path(), recorded_volumes(patient));
  const Session session = read_session(scratch.path());
  EXPECT_TRUE(structures_of(session.header.volumes, "it").empty());
  EXPECT_EQ(tissues_of(session.header.volumes, "it").voxels, patient.tissues.voxels);
}

TEST(VolumeTable, a_recording_that_is_killed_at_once_has_them) {
  const ScratchSession scratch;
  const anatomy::Case patient = small_patient();
  SessionHeader header = sample_header();
  header.volumes = recorded_volumes(patient);
  const SessionWriter writer(scratch.path(), header, true);
  EXPECT_EQ(tissues_of(read_session(scratch.path()).header.volumes, "it").voxels, patient.tissues.voxels);
}

TEST(VolumeTable, a_session_of_version_4_opens_without) {
  const ScratchSession scratch;
  write_patient(scratch.path(), recorded_volumes(small_patient()));
  make_version_4(scratch.path());
  const Session session = read_session(scratch.path());
  EXPECT_EQ(session.version, 4);
  EXPECT_TRUE(session.header.volumes.structures.empty());
  EXPECT_TRUE(session.header.volumes.tissues.empty());
}

TEST(VolumeTable, damaged_rows_are_refused) {
  const ScratchSession scratch;
  const auto after = [&](const char* sql) {
    write_patient(scratch.path(), recorded_volumes(small_patient()));
    SQLite::Database(scratch.path().string(), SQLite::OPEN_READWRITE).exec(sql);
    return refusal_of(scratch.path());
  };
  EXPECT_THAT(after("UPDATE volumes SET nrrd = substr(nrrd, 1, 40) WHERE name = 'tissues'"),
              HasSubstr("the patient's volume 'tissues' is damaged, its checksum does not fit"));
  EXPECT_THAT(after("UPDATE volumes SET name = 'ct' WHERE name = 'tissues'"),
              HasSubstr("the list of the patient's volumes is damaged"));
  EXPECT_THAT(after("DROP TABLE volumes"), HasSubstr("the table 'volumes' is missing"));
}

// A checksum proves nothing about who wrote the bytes.
TEST(VolumeTable, bytes_that_are_no_volume_are_refused_when_they_are_wanted) {
  const auto refusal = [](const std::vector<std::uint8_t>& bytes) -> std::string {
    try {
      tissues_of({.structures = {}, .tissues = bytes}, "a.bodkin");
    } catch (const InputError& error) {
      return error.what();
    }
    return "it was accepted";
  };
  const anatomy::Case patient = small_patient();
  const std::vector<std::uint8_t> sound = io::nrrd_bytes(patient.tissues);
  EXPECT_THAT(refusal({1, 2, 3}), HasSubstr("a.bodkin: the volume 'tissues' is not one that a session keeps"));
  EXPECT_THAT(refusal(io::nrrd_bytes(patient.structures)), HasSubstr("is not one that a session keeps"));
  for (std::size_t length = 7; length < sound.size(); length += 7) {
    const std::vector<std::uint8_t> cut(sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_THAT(refusal(cut), HasSubstr("a.bodkin: the volume 'tissues'"));
  }
  std::vector<std::uint8_t> longer = sound;
  longer.push_back(0);
  EXPECT_THAT(refusal(longer), HasSubstr("a.bodkin: the volume 'tissues'"));
}

}  // namespace
}  // namespace bodkin
