#include "session/session_file.h"

#include "tests/io/wild_haptics.h"
#include "tests/session/session_samples.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::forces;
using namespace bodkin::haptics;
using namespace bodkin::session;
using namespace bodkin::simulation;
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string read_bytes(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_bytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

void write_sample(const fs::path& file, std::uint64_t ticks, bool finish = true) {
  SessionWriter writer(file, sample_header(), true);
  for (std::uint64_t tick = 0; tick < ticks; ++tick) writer.append(sample_record(tick));
  if (finish) writer.finish();
}

TEST(SessionFile, comes_back_bit_for_bit) {
  const ScratchSession scratch;
  constexpr std::uint64_t ticks = 1234;
  write_sample(scratch.path(), ticks);
  const Session session = read_session(scratch.path());
  const SessionHeader wanted = sample_header();
  EXPECT_TRUE(session.finished);
  EXPECT_EQ(session.header.bodkin_version, wanted.bodkin_version);
  EXPECT_EQ(session.header.case_folder, wanted.case_folder);
  EXPECT_EQ(session.header.case_digest, wanted.case_digest);
  EXPECT_EQ(session.header.case_xml, wanted.case_xml);
  EXPECT_EQ(session.header.operator_name, wanted.operator_name);
  EXPECT_EQ(session.header.operator_settings, wanted.operator_settings);
  EXPECT_EQ(session.header.seed, wanted.seed);
  EXPECT_EQ(session.header.body_digest, wanted.body_digest);
  EXPECT_EQ(session.header.dt, wanted.dt);
  EXPECT_EQ(session.header.started_at, wanted.started_at);
  EXPECT_EQ(session.header.recording_id, wanted.recording_id);
  EXPECT_EQ(session.header.path.entry, wanted.path.entry);
  EXPECT_EQ(session.header.path.target, wanted.path.target);
  EXPECT_TRUE(same_bits(session.header.haptics, wanted.haptics));
  ASSERT_EQ(session.header.tissues.size(), 3u);
  EXPECT_EQ(session.header.tissues[1].title, "skin, \"thick\"");
  EXPECT_EQ(session.header.tissues[2].id, 200);
  ASSERT_EQ(session.ticks.size(), ticks);
  auto event = session.events.begin();
  for (std::uint64_t tick = 0; tick < ticks; ++tick) {
    const TickRecord wanted_record = sample_record(tick);
    EXPECT_EQ(session.ticks[tick].tick, tick);
    ASSERT_EQ(bytes_of(session.ticks[tick]), bytes_of(wanted_record)) << tick;
    for (const Event& wanted_event : wanted_record.output.events) {
      ASSERT_NE(event, session.events.end());
      EXPECT_EQ(event->tick, tick);
      EXPECT_EQ(bytes_of(event->event), bytes_of(wanted_event));
      ++event;
    }
  }
  EXPECT_EQ(event, session.events.end());
}

TEST(SessionFile, replaces_an_unfinished_session_with_its_log_and_leaves_nothing_beside_it) {
  const ScratchSession scratch;
  const fs::path kept = scratch.path().string() + ".copy";
  {
    SessionWriter writer(scratch.path(), sample_header(), true);
    for (std::uint64_t tick = 0; tick < 600; ++tick) writer.append(sample_record(tick));
    writer.commit();
    // As a process that was killed leaves it: the log holds the ticks.
    for (const char* ending : {"", "-wal"}) fs::copy_file(scratch.path().string() + ending, kept.string() + ending);
  }
  write_sample(kept, 10);
  EXPECT_EQ(read_session(kept).ticks.size(), 10U);
  for (const char* ending : {"-wal", "-shm", "-journal", ".replaced", ".replaced-wal", ".replaced-shm"})
    EXPECT_FALSE(fs::exists(kept.string() + ending)) << ending;
  fs::remove(kept);
}

TEST(SessionFile, keeps_how_well_it_kept_its_time) {
  const ScratchSession scratch;
  ServoTimings servo;
  for (int i = 0; i < 97; ++i) servo.lateness.record(2e-6);
  for (int i = 0; i < 3; ++i) servo.lateness.record(0.25);
  for (int i = 0; i < 100; ++i) servo.compute.record(1e-7 * (i + 1));
  servo.overruns = 3;
  SessionWriter writer(scratch.path(), sample_header(), true);
  writer.append(sample_record(0));
  writer.finish(timings_of(servo));
  const std::optional<SessionTimings> timings = read_session(scratch.path()).timings;
  ASSERT_TRUE(timings.has_value());
  EXPECT_EQ(timings->overruns, 3u);
  EXPECT_EQ(count_of(timings->lateness), 100u);
  EXPECT_NEAR(percentile(timings->lateness, 0.97), 2e-6, 2e-6 / 16.0);
  EXPECT_EQ(percentile(timings->lateness, 1.0), 0.25) << "the longest, exactly";
  EXPECT_NEAR(percentile(timings->compute, 0.5), 5e-6, 5e-6 / 16.0);
  EXPECT_EQ(percentile(timings->compute, 1.0), servo.compute.maximum());
}

TEST(SessionFile, a_session_off_the_clock_has_no_timings) {
  const ScratchSession scratch;
  write_sample(scratch.path(), 3);
  EXPECT_FALSE(read_session(scratch.path()).timings.has_value());
}

TEST(SessionFile, is_a_single_file_when_finished) {
  const ScratchSession scratch;
  write_sample(scratch.path(), 500);
  EXPECT_TRUE(fs::exists(scratch.path()));
  EXPECT_FALSE(fs::exists(scratch.path().string() + "-wal"));
  EXPECT_FALSE(fs::exists(scratch.path().string() + "-shm"));
}

TEST(SessionFile, the_bytes_of_a_tick_do_not_depend_on_the_machine) {
  TickRecord record;
  record.input.needle.matrix()(0, 0) = 1.0;  // 3F F0 00 00 00 00 00 00
  record.output.constraint = -2.0;           // C0 00 00 00 00 00 00 00
  record.output.tissue = 10;
  record.output.in_contact = true;
  record.output.limits = 5;
  record.input.thumb = Thumb::of_force(2.0);
  const std::vector<std::uint8_t> bytes = bytes_of(record);
  ASSERT_EQ(bytes.size(), 29u * 8u + 4u);
  EXPECT_EQ(bytes[6], 0xF0);
  EXPECT_EQ(bytes[7], 0x3F);
  EXPECT_EQ(bytes[27 * 8 + 7], 0xC0);
  EXPECT_EQ(bytes[29 * 8 + 0], 10);
  EXPECT_EQ(bytes[29 * 8 + 1], 1);
  EXPECT_EQ(bytes[29 * 8 + 2], 5);
  EXPECT_EQ(bytes[29 * 8 + 3], 11);
  TickRecord read;
  ASSERT_TRUE(decode_tick(bytes, read));
  EXPECT_EQ(read.input.thumb.byte(), 11);
}

TEST(SessionFile, an_unfinished_session_can_be_read_while_it_is_written_and_afterwards) {
  const ScratchSession scratch;
  {
    SessionWriter writer(scratch.path(), sample_header(), false);
    for (std::uint64_t tick = 0; tick < 700; ++tick) writer.append(sample_record(tick));
    writer.commit();
    const Session during = read_session(scratch.path());
    EXPECT_FALSE(during.finished);
    EXPECT_EQ(during.ticks.size(), 700u);
  }
  EXPECT_EQ(read_session(scratch.path()).ticks.size(), 700u);
}

TEST(SessionFile, missing_ticks_are_kept_apart) {
  const ScratchSession scratch;
  SessionWriter writer(scratch.path(), sample_header(), false);
  for (const std::uint64_t tick : {0, 1, 2, 10, 11}) writer.append(sample_record(tick));
  writer.finish();
  const Session session = read_session(scratch.path());
  ASSERT_EQ(session.ticks.size(), 5u);
  EXPECT_EQ(session.ticks[3].tick, 10u);
}

TEST(SessionFile, an_existing_file_is_replaced_only_when_asked) {
  const ScratchSession scratch;
  write_sample(scratch.path(), 3);
  EXPECT_THROW(SessionWriter(scratch.path(), sample_header(), false), InputError);
  EXPECT_EQ(read_session(scratch.path()).ticks.size(), 3u);
  write_sample(scratch.path(), 4);
  EXPECT_EQ(read_session(scratch.path()).ticks.size(), 4u);
  EXPECT_THROW(SessionWriter("/no/such/folder/x.bodkin", sample_header(), false), SystemError);
  EXPECT_THROW(SessionWriter(fs::temp_directory_path(), sample_header(), true), InputError);
}

TEST(SessionFile, keeps_the_diagnostics_of_the_force_models) {
  const ScratchSession scratch;
  SessionHeader header = sample_header();
  header.diagnostics = {{"wall_mm", "position W of the wall"}, {"grip", "factor"}};
  constexpr std::uint64_t ticks = 700;
  const auto record_of = [](std::uint64_t tick) {
    TickRecord record = sample_record(tick);
    record.output.diagnostics = {0.1 * static_cast<double>(tick), tick == 3 ? std::nan("7") : -1.0, 99.0};
    return record;
  };
  SessionWriter writer(scratch.path(), header, true);
  for (std::uint64_t tick = 0; tick < ticks; ++tick) writer.append(record_of(tick));
  writer.finish();
  const Session session = read_session(scratch.path());
  ASSERT_EQ(session.header.diagnostics.size(), 2U);
  EXPECT_EQ(session.header.diagnostics[0].name, "wall_mm");
  EXPECT_EQ(session.header.diagnostics[0].title, "position W of the wall");
  ASSERT_EQ(session.ticks.size(), ticks);
  for (std::uint64_t tick = 0; tick < ticks; ++tick) {
    const Diagnostics &was = record_of(tick).output.diagnostics, &is = session.ticks[tick].output.diagnostics;
    ASSERT_EQ(is[0], was[0]) << tick;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(is[1]), std::bit_cast<std::uint64_t>(was[1])) << tick;
    ASSERT_EQ(is[2], 0.0) << "has no name, so it is not kept";
  }
  SQLite::Database(scratch.path().string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE diagnostics SET checksum = checksum + 1 WHERE first_tick = 250");
  EXPECT_THAT(refusal_of(scratch.path()), HasSubstr("diagnostics at tick 250 are damaged"));
  SQLite::Database(scratch.path().string(), SQLite::OPEN_READWRITE)
      .exec("DELETE FROM diagnostics WHERE first_tick >= 250");
  EXPECT_THAT(refusal_of(scratch.path()), HasSubstr("diagnostics from tick 250 on are missing"));
}

TEST(SessionFile, one_of_version_2_opens_without_diagnostics) {
  const ScratchSession scratch;
  write_sample(scratch.path(), 321);
  make_version_2(scratch.path());
  const Session session = read_session(scratch.path());
  EXPECT_EQ(session.version, 2);
  EXPECT_TRUE(session.finished);
  EXPECT_TRUE(session.header.diagnostics.empty());
  EXPECT_TRUE(session.header.recording_id.empty());
  ASSERT_EQ(session.ticks.size(), 321U);
  EXPECT_EQ(bytes_of(session.ticks[320]), bytes_of(sample_record(320)));
}

TEST(SessionFile, one_of_version_3_opens_without_ultrasound) {
  const ScratchSession scratch;
  write_sample(scratch.path(), 321);
  make_version_3(scratch.path());
  const Session session = read_session(scratch.path());
  EXPECT_EQ(session.version, 3);
  EXPECT_TRUE(session.finished);
  EXPECT_FALSE(session.header.ultrasound.has_value());
  EXPECT_TRUE(session.scans.empty());
  ASSERT_EQ(session.ticks.size(), 321U);
}

TEST(SessionFile, foreign_files_are_refused_in_a_sentence) {
  const ScratchSession scratch;
  EXPECT_THAT(refusal_of("/no/such.bodkin"), HasSubstr("there is no such file"));
  EXPECT_THAT(refusal_of(fs::temp_directory_path()), HasSubstr("not a file"));
  write_bytes(scratch.path(), "");
  EXPECT_THAT(refusal_of(scratch.path()), HasSubstr("not a session file"));
  write_bytes(scratch.path(), std::string(5000, 'x'));
  EXPECT_THAT(refusal_of(scratch.path()), HasSubstr("not a session file"));
  fs::remove(scratch.path());
  {
    SQLite::Database other(scratch.path().string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    other.exec("CREATE TABLE t(x)");
  }
  EXPECT_THAT(refusal_of(scratch.path()), HasSubstr("another program"));
  write_sample(scratch.path(), 10);
  SQLite::Database(scratch.path().string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version=7");
  EXPECT_THAT(refusal_of(scratch.path()), HasSubstr("format version 7"));
}

TEST(SessionFile, tables_that_a_writer_does_not_make_are_refused) {
  const ScratchSession scratch;
  const auto tamper = [&](const std::string& sql) {
    write_sample(scratch.path(), 10);
    SQLite::Database(scratch.path().string(), SQLite::OPEN_READWRITE).exec(sql);
    return refusal_of(scratch.path());
  };
  EXPECT_THAT(tamper("CREATE VIEW v AS SELECT 1"), HasSubstr("not those of a session"));
  EXPECT_THAT(tamper("DROP TABLE chunks; CREATE VIEW chunks AS SELECT 0 AS first_tick"), HasSubstr("not those"));
  EXPECT_THAT(tamper("CREATE TRIGGER t AFTER INSERT ON events BEGIN DELETE FROM chunks; END"),
              HasSubstr("not those"));
  EXPECT_THAT(tamper("DROP TABLE events"), HasSubstr("'events' is missing"));
  EXPECT_THAT(tamper("UPDATE header SET value='8' WHERE key='seed'"), HasSubstr("header is damaged"));
  EXPECT_THAT(tamper("UPDATE header SET value=replace(value, 'none', 'rail') WHERE key='haptics_xml'"),
              HasSubstr("header is damaged"));
  EXPECT_THAT(tamper("DELETE FROM header WHERE key='dt_s'"), HasSubstr("header is damaged"));
  EXPECT_THAT(tamper("UPDATE tissues SET name='bone' WHERE id=1"), HasSubstr("header is damaged"));
  EXPECT_THAT(tamper("UPDATE chunks SET ticks=9"), HasSubstr("wrong size"));
  EXPECT_THAT(tamper("UPDATE chunks SET first_tick=5"), HasSubstr("checksum"));
  EXPECT_THAT(tamper("UPDATE chunks SET first_tick=-5"), HasSubstr("not in order"));
  EXPECT_THAT(tamper("UPDATE chunks SET data=zeroblob(length(data))"), HasSubstr("checksum"));
  EXPECT_THAT(tamper("UPDATE chunks SET data='text'"), HasSubstr("wrong size"));
  EXPECT_THAT(tamper("DELETE FROM chunks"), HasSubstr("ticks are missing"));
  EXPECT_THAT(tamper("INSERT INTO timings VALUES('tea', 0.1, 1)"), HasSubstr("timings are damaged"));
  EXPECT_THAT(tamper("INSERT INTO timings VALUES('compute', 9e999, 1)"), HasSubstr("timings are damaged"));
  EXPECT_THAT(tamper("INSERT INTO timings VALUES('compute', 0.1, -1)"), HasSubstr("timings are damaged"));
}

SecondSample second_sample(int number) {
  SecondSample sample;
  sample.time = 0.01 * number;
  sample.position = Vec3(1.0, -2.5, 0.1 * number);
  sample.rotation = Eigen::Quaterniond(0.6, 0.0, -0.8, 0.0);
  sample.force = 0.3 * number;
  sample.pressure = 1.0 / (3.0 + number);
  sample.volume = 17.0 * number;
  return sample;
}

void write_second(const fs::path& file, SecondRole role, bool finish = true) {
  SessionHeader header = sample_header();
  header.second = SecondHeader{role, "{\"driver\":\"simulated\"}"};
  SessionWriter writer(file, header, true);
  for (int number = 0; number < 50; ++number) {
    writer.append(sample_record(static_cast<std::uint64_t>(number)));
    writer.append(second_sample(number));
    if (number == 20) writer.commit();
  }
  if (finish) writer.finish();
}

TEST(SessionFile, a_second_hand_comes_back_to_the_bit) {
  const ScratchSession scratch;
  for (const SecondRole role : {SecondRole::plunger, SecondRole::probe}) {
    write_second(scratch.path(), role);
    const Session session = read_session(scratch.path());
    ASSERT_TRUE(session.header.second.has_value());
    EXPECT_EQ(session.header.second->role, role);
    EXPECT_EQ(session.header.second->device, "{\"driver\":\"simulated\"}");
    ASSERT_EQ(session.second.size(), 50u);
    for (int number = 0; number < 50; ++number) {
      const SecondSample& read = session.second[static_cast<std::size_t>(number)];
      const SecondSample wanted = second_sample(number);
      EXPECT_EQ(read.time, wanted.time);
      EXPECT_EQ(read.position, wanted.position);
      EXPECT_EQ(read.rotation.coeffs(), wanted.rotation.coeffs());
      EXPECT_EQ(read.force, wanted.force);
      EXPECT_EQ(read.pressure, role == SecondRole::plunger ? wanted.pressure : 0.0);
      EXPECT_EQ(read.volume, role == SecondRole::plunger ? wanted.volume : 0.0);
    }
  }
}

TEST(SessionFile, a_second_hand_that_no_writer_makes_is_refused) {
  const ScratchSession scratch;
  const auto tamper = [&](const std::string& sql, SecondRole role = SecondRole::plunger, bool finish = true) {
    write_second(scratch.path(), role, finish);
    SQLite::Database(scratch.path().string(), SQLite::OPEN_READWRITE).exec(sql);
    return refusal_of(scratch.path());
  };
  EXPECT_EQ(tamper("SELECT 1"), "it was accepted");
  for (const std::string change :
       {"time_s=0.05", "time_s=-1", "time_s=9e999", "time_s='late'", "x_mm=9e999", "y_mm=-1e6", "z_mm='down'",
        "qw=0.61", "qx=9e999", "force_N=1e5", "force_N=-9e999", "pressure_MPa=NULL", "pressure_MPa=-1",
        "pressure_MPa=11", "volume_mm3=-0.1", "volume_mm3=9e999", "volume_mm3=x'00'", "sample=900"}) {
    EXPECT_THAT(tamper("UPDATE second_hand SET " + change + " WHERE sample=7"),
                HasSubstr("sample 7 of the second hand is damaged"))
        << change;
  }
  EXPECT_THAT(tamper("UPDATE second_hand SET pressure_MPa=0.1 WHERE sample=7", SecondRole::probe),
              HasSubstr("sample 7 of the second hand is damaged"));
  EXPECT_THAT(tamper("DELETE FROM second_hand WHERE sample=49"), HasSubstr("samples of the second hand are missing"));
  EXPECT_THAT(tamper("DELETE FROM second_hand WHERE sample=3"), HasSubstr("sample 3"));
  EXPECT_THAT(tamper("DELETE FROM header WHERE key='second_samples'"), HasSubstr("lacks 'second_samples'"));
  EXPECT_THAT(tamper("UPDATE header SET value='probe' WHERE key='second_role'"), HasSubstr("header is damaged"));
  EXPECT_THAT(tamper("DELETE FROM header WHERE key='second_role'"), HasSubstr("header is damaged"));
  EXPECT_THAT(tamper("DROP TABLE second_hand"), HasSubstr("'second_hand' is missing"));
  EXPECT_EQ(tamper("DELETE FROM second_hand WHERE sample>40", SecondRole::plunger, false), "it was accepted")
      << "not finished: what was saved is there";
  write_sample(scratch.path(), 3);
  SQLite::Database(scratch.path().string(), SQLite::OPEN_READWRITE)
      .exec("INSERT INTO second_hand VALUES(0, 0.5, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, NULL, NULL)");
  EXPECT_THAT(refusal_of(scratch.path()), HasSubstr("the header names none"));
}

TEST(SessionFile, a_truncated_file_is_refused_at_every_length) {
  const ScratchSession scratch;
  write_sample(scratch.path(), 600);
  const std::string whole = read_bytes(scratch.path());
  for (std::size_t length = 0; length < whole.size(); length += 3001) {
    write_bytes(scratch.path(), whole.substr(0, length));
    EXPECT_THAT(refusal_of(scratch.path()), HasSubstr("give a session file")) << length;
  }
}

TEST(SessionFile, no_flipped_bit_changes_a_tick_unnoticed) {
  const ScratchSession scratch;
  write_sample(scratch.path(), 300);
  const std::string whole = read_bytes(scratch.path());
  Random random(11);
  int refused = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::string bytes = whole;
    const std::size_t position = random.next() % bytes.size();
    bytes[position] = static_cast<char>(bytes[position] ^ (1 << (random.next() % 8)));
    write_bytes(scratch.path(), bytes);
    try {
      const Session session = read_session(scratch.path());
      ASSERT_EQ(session.ticks.size(), 300u) << position;
      for (std::uint64_t tick = 0; tick < 300; ++tick) {
        ASSERT_EQ(bytes_of(session.ticks[tick]), bytes_of(sample_record(tick))) << position;
      }
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 50) << "a good part of the file is chunks";
}

}  // namespace
}  // namespace bodkin
