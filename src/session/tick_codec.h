#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/tick_record.h"

namespace bodkin::session {

// The numbers of a tick, in the order of a recording, with their names. Columns 0 to 11 are the input: the rotation
// of the needle's pose, column by column, then its tip. The rest is the result of the tick.
std::span<const std::string_view> tick_number_names();

// The numbers of a record, in the order of tick_number_names().
void tick_numbers(const simulation::TickRecord& record, std::vector<double>& numbers);

// The number of bytes of one tick: every number as an IEEE 754 double, little-endian, bit for bit; then tissue,
// contact and limits and thumb as one byte each.
std::size_t encoded_tick_size();

// Appends the bytes of a tick; its tick number and its events are not part of them.
void encode_tick(const simulation::TickRecord& record, std::vector<std::uint8_t>& bytes);
// Reads the output of encode_tick. `bytes` holds encoded_tick_size() bytes. False when a byte has an invalid value.
bool decode_tick(std::span<const std::uint8_t> bytes, simulation::TickRecord& record);

// The first `count` diagnostics of a tick as doubles, 8 bytes each.
void encode_diagnostics(const simulation::TickRecord& record, std::size_t count, std::vector<std::uint8_t>& bytes);
// Reads them; `bytes` holds 8 `count` of them.
void decode_diagnostics(std::span<const std::uint8_t> bytes, std::size_t count, simulation::TickRecord& record);

// The bytes of one event: tick of the chunk (4 bytes), kind, tissue, two zero bytes, depth and value as doubles.
inline constexpr std::size_t encoded_event_size = 24;
void encode_event(std::uint32_t tick_of_chunk, const forces::Event& event, std::vector<std::uint8_t>& bytes);
bool decode_event(std::span<const std::uint8_t> bytes, std::uint32_t& tick_of_chunk, forces::Event& event);

// The name of the kind of an event in sessions and CSV files: "puncture", "loss_of_resistance", ...
std::string_view event_kind_name(forces::EventKind kind);
// The kind of that name, or of its name in an earlier version; empty for an unknown name.
std::optional<forces::EventKind> event_kind_of(std::string_view name);
// Whether an event of this name comes only from a second hand: a palpating finger, stylet, manometer and fluid. Not
// every patient has them.
bool is_of_other_hand(std::string_view event) noexcept;

}  // namespace bodkin::session
