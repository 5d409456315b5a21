// A session file's data of its ultrasound machine.
#include "session/scan_table.h"

#include <string>

#include "session/session_file.h"
#include "tests/session/session_samples.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/probe_library_file.h"

namespace bodkin {

using namespace bodkin::session;
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

ScanSample scan_sample(int number) {
  ScanSample sample;
  sample.time = 0.02 * number;
  sample.probe.translation() = Vec3(1.0 / 3.0, -2.5, 0.1 * number);
  sample.probe.linear() = Eigen::Quaterniond(0.6, 0.0, -0.8, 0.0).toRotationMatrix();
  sample.settings = {.depth = 50.0 + number, .gain = -3.0, .dynamic_range = 70.0, .focus = 30.0, .frequency = 8.0};
  sample.settings.sliders[7] = 1.5;
  sample.settings.gel = number % 2 == 0;
  return sample;
}

constexpr int scan_samples = 30;

void write_scans(const fs::path& file, bool finish = true) {
  SessionHeader header = sample_header();
  header.ultrasound = io::find_probe("L14-5");
  SessionWriter writer(file, header, true);
  for (int number = 0; number < scan_samples; ++number) {
    writer.append(sample_record(static_cast<std::uint64_t>(number)));
    writer.append(scan_sample(number));
    if (number == 10) writer.append(ScannedPart{false, "nerve", 0.2});
    if (number == 12) writer.append(ScannedPart{true, "vertebrae_L3", 0.24});
    if (number == 20) writer.append(ScannedPart{false, "nerve", 0.4});  // it was seen before
    if (number == 15) writer.commit();
  }
  if (finish) writer.finish();
}

TEST(ScanTable, probe_machine_and_what_was_seen_come_back) {
  const ScratchSession scratch;
  write_scans(scratch.path());
  const Session session = read_session(scratch.path());
  EXPECT_EQ(session.version, 5);
  ASSERT_TRUE(session.header.ultrasound.has_value());
  const anatomy::UltrasoundProbe wanted_probe = io::find_probe("L14-5");
  EXPECT_EQ(session.header.ultrasound->name, wanted_probe.name);
  EXPECT_EQ(session.header.ultrasound->pitch, wanted_probe.pitch);
  EXPECT_EQ(session.header.ultrasound->source, wanted_probe.source);
  ASSERT_EQ(session.scans.size(), static_cast<std::size_t>(scan_samples));
  for (int number = 0; number < scan_samples; ++number) {
    const ScanSample &read = session.scans[static_cast<std::size_t>(number)], wanted = scan_sample(number);
    EXPECT_EQ(read.time, wanted.time);
    EXPECT_EQ(read.probe.translation(), wanted.probe.translation());
    EXPECT_LT((read.probe.linear() - wanted.probe.linear()).norm(), 1e-15);
    EXPECT_EQ(read.settings, wanted.settings);
  }
  const std::vector<ScannedPart> parts = {{false, "nerve", 0.2}, {true, "vertebrae_L3", 0.24}};
  EXPECT_EQ(session.scanned, parts);
}

TEST(ScanTable, a_killed_recording_keeps_what_was_saved) {
  const ScratchSession scratch;
  write_scans(scratch.path(), false);
  const Session session = read_session(scratch.path());
  EXPECT_FALSE(session.finished);
  EXPECT_EQ(session.scans.size(), static_cast<std::size_t>(scan_samples));
}

TEST(ScanTable, a_session_without_a_machine_keeps_no_samples) {
  const ScratchSession scratch;
  {
    SessionWriter writer(scratch.path(), sample_header(), true);
    writer.append(sample_record(0));
    writer.append(scan_sample(0));
    writer.append(ScannedPart{false, "nerve", 0.0});
    writer.finish();
  }
  const Session session = read_session(scratch.path());
  EXPECT_TRUE(session.scans.empty());
  EXPECT_TRUE(session.scanned.empty());
}

TEST(ScanTable, rows_that_no_writer_makes_are_refused) {
  const ScratchSession scratch;
  const auto tamper = [&](const std::string& sql) {
    write_scans(scratch.path());
    SQLite::Database(scratch.path().string(), SQLite::OPEN_READWRITE).exec(sql);
    return refusal_of(scratch.path());
  };
  EXPECT_EQ(tamper("SELECT 1"), "it was accepted");
  for (const std::string change : {"time_s=0.02", "time_s=-1", "time_s=9e999", "time_s='late'", "x_mm=9e999",
                                   "y_mm=-1e6", "qw=0.61", "depth_mm=5", "depth_mm=9e999", "gain_dB=41",
                                   "frequency_MHz=99", "slider_8_dB=21", "gel=2", "gel='wet'", "sample=900"}) {
    EXPECT_THAT(tamper("UPDATE scans SET " + change + " WHERE sample=7"),
                HasSubstr("sample 7 of the ultrasound probe is damaged"))
        << change;
  }
  EXPECT_THAT(tamper("DELETE FROM scans WHERE sample=29"), HasSubstr("samples of the ultrasound probe are missing"));
  EXPECT_THAT(tamper("DELETE FROM scans WHERE sample=3"), HasSubstr("sample 3"));
  EXPECT_THAT(tamper("UPDATE scanned SET first_s=-1"), HasSubstr("what the ultrasound showed is damaged"));
  EXPECT_THAT(tamper("UPDATE scanned SET is_structure=2"), HasSubstr("what the ultrasound showed is damaged"));
  EXPECT_THAT(tamper("UPDATE header SET value='' WHERE key='ultrasound_xml'"), HasSubstr("header is damaged"));
  EXPECT_THAT(tamper("DROP TABLE scans"), HasSubstr("'scans' is missing"));
  SessionWriter(scratch.path(), sample_header(), true).finish();
  SQLite::Database(scratch.path().string(), SQLite::OPEN_READWRITE)
      .exec("INSERT INTO scanned VALUES(0, 'nerve', 0.5)");
  EXPECT_THAT(refusal_of(scratch.path()), HasSubstr("what the ultrasound showed is damaged"));
}

}  // namespace
}  // namespace bodkin
