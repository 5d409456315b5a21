#include "training/session_file.h"

#include "tests/io/wild_haptics.h"
#include "tests/training/session_samples.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bodkin {
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
  EXPECT_EQ(session.header.dt, wanted.dt);
  EXPECT_EQ(session.header.started_at, wanted.started_at);
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
  const std::vector<std::uint8_t> bytes = bytes_of(record);
  ASSERT_EQ(bytes.size(), 28u * 8u + 4u);
  EXPECT_EQ(bytes[6], 0xF0);
  EXPECT_EQ(bytes[7], 0x3F);
  EXPECT_EQ(bytes[27 * 8 + 7], 0xC0);
  EXPECT_EQ(bytes[28 * 8 + 0], 10);
  EXPECT_EQ(bytes[28 * 8 + 1], 1);
  EXPECT_EQ(bytes[28 * 8 + 2], 5);
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
