#include "session/tick_codec.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

namespace bodkin::session {

namespace {

constexpr std::array<std::string_view, 29> number_names = {"needle_x_axis_x",
                                                           "needle_x_axis_y",
                                                           "needle_x_axis_z",
                                                           "needle_y_axis_x",
                                                           "needle_y_axis_y",
                                                           "needle_y_axis_z",
                                                           "axis_x",
                                                           "axis_y",
                                                           "axis_z",
                                                           "tip_x",
                                                           "tip_y",
                                                           "tip_z",
                                                           "requested_force_x",
                                                           "requested_force_y",
                                                           "requested_force_z",
                                                           "requested_torque_x",
                                                           "requested_torque_y",
                                                           "requested_torque_z",
                                                           "applied_force_x",
                                                           "applied_force_y",
                                                           "applied_force_z",
                                                           "applied_torque_x",
                                                           "applied_torque_y",
                                                           "applied_torque_z",
                                                           "depth",
                                                           "velocity",
                                                           "resistance",
                                                           "constraint",
                                                           "energy"};

constexpr std::array<std::string_view, 29> kind_names = {
    "contact",         "puncture",        "loss_of_resistance", "bone_contact",   "bone_left",
    "tissue_entered",  "withdrawn",       "force_limited",      "fault",          "points_passed",
    "line_taken",      "moving_body_met", "moving_body_failed", "fluid_returned", "pressure_lost",
    "hub_contact",     "needle_buckled",  "points_taken",       "points_late",    "palpated",
    "stylet_out",      "stylet_in",       "manometer_on",       "manometer_off",  "pressure_read",
    "fluid_collected", "hand_lost",       "hand_seen",          "points_coupled"};

struct EarlierKind {
  std::string_view name;
  forces::EventKind kind;
};
// The format of CSV and JSON files of versions 0.1 and 0.2.
constexpr std::array<EarlierKind, 3> earlier_kinds = {{{"corridor_left", forces::EventKind::points_passed},
                                                       {"corridor_taken", forces::EventKind::line_taken},
                                                       {"corridor_refreshed", forces::EventKind::moving_body_met}}};

// Visits every number of a record in the order of `number_names`; `Record` may be const.
template <typename Record, typename Visit>
void for_each_number(Record& record, Visit&& visit) {
  auto& pose = record.input.needle.matrix();
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) visit(pose(row, column));
  }
  auto& output = record.output;
  for (auto* wrench : {&output.requested, &output.applied}) {
    for (int axis = 0; axis < 3; ++axis) visit(wrench->force[axis]);
    for (int axis = 0; axis < 3; ++axis) visit(wrench->torque[axis]);
  }
  visit(output.depth);
  visit(output.velocity);
  visit(output.resistance);
  visit(output.constraint);
  visit(output.energy);
}

// Little-endian, whatever the machine; compilers turn the loops into single stores and loads.
std::uint8_t* put(std::uint64_t value, int size, std::uint8_t* cursor) {
  for (int byte = 0; byte < size; ++byte) *cursor++ = static_cast<std::uint8_t>(value >> (8 * byte));
  return cursor;
}

std::uint64_t take(const std::uint8_t* bytes, int size) {
  std::uint64_t value = 0;
  for (int byte = 0; byte < size; ++byte) value |= static_cast<std::uint64_t>(bytes[byte]) << (8 * byte);
  return value;
}

std::uint8_t* put_double(double value, std::uint8_t* cursor) {
  return put(std::bit_cast<std::uint64_t>(value), 8, cursor);
}

double take_double(const std::uint8_t* bytes) {
  return std::bit_cast<double>(take(bytes, 8));
}

constexpr double felt_step = 0.01;  // N

// The force at the hand at a puncture, in steps; 0: not known.
std::uint64_t felt_steps(const forces::Event& event) {
  if (event.kind != forces::EventKind::puncture || !(event.felt > 0.0)) return 0;
  return static_cast<std::uint64_t>(std::min(std::round(event.felt / felt_step), 65535.0));
}

std::uint8_t* grow(std::vector<std::uint8_t>& bytes, std::size_t size) {
  bytes.resize(bytes.size() + size);
  return bytes.data() + bytes.size() - size;
}

}  // namespace

std::span<const std::string_view> tick_number_names() {
  return number_names;
}

void tick_numbers(const simulation::TickRecord& record, std::vector<double>& numbers) {
  numbers.clear();
  for_each_number(record, [&](double number) { numbers.push_back(number); });
}

std::size_t encoded_tick_size() {
  return number_names.size() * 8 + 4;
}

void encode_tick(const simulation::TickRecord& record, std::vector<std::uint8_t>& bytes) {
  std::uint8_t* cursor = grow(bytes, encoded_tick_size());
  for_each_number(record, [&](double number) { cursor = put_double(number, cursor); });
  cursor = put(record.output.tissue, 1, cursor);
  cursor = put((record.output.in_contact ? 1U : 0U) | record.input.other.byte() << 1U, 1, cursor);
  cursor = put(record.output.limits, 1, cursor);
  put(record.input.thumb.byte(), 1, cursor);
}

bool decode_tick(std::span<const std::uint8_t> bytes, simulation::TickRecord& record) {
  if (bytes.size() != encoded_tick_size()) return false;
  const std::uint8_t* cursor = bytes.data();
  record.input.needle = Pose::Identity();
  for_each_number(record, [&](double& number) {
    number = take_double(cursor);
    cursor += 8;
  });
  const std::optional<simulation::OtherHand> other = simulation::OtherHand::from_byte(cursor[1] >> 1U);
  if (!other) return false;
  record.output.tissue = cursor[0];
  record.output.in_contact = (cursor[1] & 1U) == 1;
  record.input.other = *other;
  record.output.limits = cursor[2];
  record.input.thumb = simulation::Thumb::from_byte(cursor[3]);
  record.output.events.clear();
  return true;
}

void encode_diagnostics(const simulation::TickRecord& record, std::size_t count, std::vector<std::uint8_t>& bytes) {
  std::uint8_t* cursor = grow(bytes, count * 8);
  for (std::size_t i = 0; i < count; ++i) cursor = put_double(record.output.diagnostics[i], cursor);
}

void decode_diagnostics(std::span<const std::uint8_t> bytes, std::size_t count, simulation::TickRecord& record) {
  for (std::size_t i = 0; i < count; ++i) record.output.diagnostics[i] = take_double(bytes.data() + 8 * i);
}

void encode_event(std::uint32_t tick_of_chunk, const forces::Event& event, std::vector<std::uint8_t>& bytes) {
  std::uint8_t* cursor = grow(bytes, encoded_event_size);
  cursor = put(tick_of_chunk, 4, cursor);
  cursor = put(static_cast<std::uint64_t>(event.kind), 1, cursor);
  cursor = put(event.tissue, 1, cursor);
  cursor = put(felt_steps(event), 2, cursor);
  cursor = put_double(event.depth, cursor);
  put_double(event.value, cursor);
}

bool decode_event(std::span<const std::uint8_t> bytes, std::uint32_t& tick_of_chunk, forces::Event& event) {
  if (bytes.size() != encoded_event_size || bytes[4] >= kind_names.size()) return false;
  const std::uint64_t felt = take(bytes.data() + 6, 2);
  if (felt != 0 && static_cast<forces::EventKind>(bytes[4]) != forces::EventKind::puncture) return false;
  tick_of_chunk = static_cast<std::uint32_t>(take(bytes.data(), 4));
  event.kind = static_cast<forces::EventKind>(bytes[4]);
  event.tissue = bytes[5];
  event.depth = take_double(bytes.data() + 8);
  event.value = take_double(bytes.data() + 16);
  event.felt = felt_step * static_cast<double>(felt);
  return true;
}

std::string_view event_kind_name(forces::EventKind kind) {
  const auto position = static_cast<std::size_t>(kind);
  return position < kind_names.size() ? kind_names[position] : "unknown";
}

std::optional<forces::EventKind> event_kind_of(std::string_view name) {
  const auto* const found = std::find(kind_names.begin(), kind_names.end(), name);
  if (found != kind_names.end()) return static_cast<forces::EventKind>(found - kind_names.begin());
  const auto* const earlier = std::ranges::find(earlier_kinds, name, &EarlierKind::name);
  if (earlier == earlier_kinds.end()) return std::nullopt;
  return earlier->kind;
}

bool is_of_other_hand(std::string_view event) noexcept {
  constexpr std::array<std::string_view, 6> names = {"palpated",  "fluid_returned", "stylet_out",
                                                     "stylet_in", "pressure_read",  "fluid_collected"};
  return std::find(names.begin(), names.end(), event) != names.end();
}

}  // namespace bodkin::session
