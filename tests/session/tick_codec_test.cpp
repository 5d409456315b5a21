#include "session/tick_codec.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::forces;
using namespace bodkin::session;
namespace {

TEST(TickCodec, a_tick_keeps_what_the_other_hand_does) {
  for (unsigned byte = 0; byte < 16; ++byte) {
    simulation::TickRecord record, found;
    record.output.in_contact = byte % 2 == 1;
    record.input.other = *simulation::OtherHand::from_byte(byte);
    std::vector<std::uint8_t> bytes;
    encode_tick(record, bytes);
    ASSERT_TRUE(decode_tick(bytes, found));
    EXPECT_EQ(found.input.other.byte(), byte);
    EXPECT_EQ(found.output.in_contact, byte % 2 == 1);
    bytes[29 * 8 + 1] = 32;
    EXPECT_FALSE(decode_tick(bytes, found)) << "what no hand does";
  }
}

TEST(TickCodec, a_puncture_keeps_what_the_hand_felt_to_a_hundredth_of_a_newton) {
  for (const double felt : {0.0, 0.01, 2.874, 655.35, 1e6}) {
    std::vector<std::uint8_t> bytes;
    encode_event(7, {EventKind::puncture, anatomy::tissue::dura, 51.5, 0.9, felt}, bytes);
    std::uint32_t tick = 0;
    Event found{};
    ASSERT_TRUE(decode_event(bytes, tick, found));
    EXPECT_EQ(tick, 7U);
    EXPECT_DOUBLE_EQ(found.value, 0.9);
    EXPECT_NEAR(found.felt, felt > 655.35 ? 655.35 : felt, 0.005 + 1e-9);
    std::vector<std::uint8_t> again;
    encode_event(7, found, again);
    EXPECT_EQ(again, bytes) << "a replay compares bytes";
  }
}

TEST(TickCodec, other_events_keep_these_bytes_at_zero) {
  std::vector<std::uint8_t> bytes;
  encode_event(0, {EventKind::contact, anatomy::tissue::skin, 0.0, 0.0, 3.0}, bytes);
  EXPECT_EQ(bytes[6], 0U);
  EXPECT_EQ(bytes[7], 0U);
  bytes[6] = 1;
  std::uint32_t tick = 0;
  Event found{};
  EXPECT_FALSE(decode_event(bytes, tick, found));
}

TEST(TickCodec, every_kind_of_event_has_a_name) {
  for (int kind = 0; kind <= static_cast<int>(EventKind::points_coupled); ++kind) {
    const std::string_view name = event_kind_name(static_cast<EventKind>(kind));
    EXPECT_NE(name, "unknown") << kind;
    EXPECT_EQ(event_kind_of(name), static_cast<EventKind>(kind)) << name;
  }
  EXPECT_EQ(event_kind_name(EventKind::needle_buckled), "needle_buckled");
  EXPECT_EQ(event_kind_name(EventKind::points_late), "points_late");
  EXPECT_FALSE(event_kind_of("corridor").has_value());
}

// Sessions have their numbers, CSV files and messages their names.
TEST(TickCodec, events_of_earlier_versions_are_read) {
  const std::vector<std::pair<std::string, EventKind>> earlier = {{"corridor_left", EventKind::points_passed},
                                                                  {"corridor_taken", EventKind::line_taken},
                                                                  {"corridor_refreshed", EventKind::moving_body_met}};
  std::uint8_t number = 9;
  for (const auto& [name, kind] : earlier) {
    EXPECT_EQ(event_kind_of(name), kind) << name;
    std::vector<std::uint8_t> bytes;
    encode_event(0, {kind, anatomy::tissue::skin, 12.0, 1.0}, bytes);
    EXPECT_EQ(bytes[4], number++) << name;
  }
}

}  // namespace
}  // namespace bodkin
