#include "training/replay.h"

#include <bit>

#include <fmt/format.h>

#include "core/error.h"
#include "io/resources.h"
#include "simulation/haptic_tick.h"
#include "training/session_run.h"
#include "training/session_schema.h"
#include "training/tick_codec.h"

namespace bodkin {

namespace {

constexpr std::uint64_t progress_interval = 4096;  // ticks

std::string bits_text(double value) {
  return fmt::format("{} (bits {:016x})", value, std::bit_cast<std::uint64_t>(value));
}

std::string events_text(std::span<const Event> events) {
  std::string text;
  for (const Event& event : events) {
    text += fmt::format("{}{} in tissue {} at {} with {}", text.empty() ? "" : "; ", event_kind_name(event.kind),
                        event.tissue, bits_text(event.depth), bits_text(event.value));
  }
  return text.empty() ? "none" : text;
}

std::vector<std::uint8_t> events_bytes(std::span<const Event> events) {
  std::vector<std::uint8_t> bytes;
  for (const Event& event : events) encode_event(0, event, bytes);
  return bytes;
}

// What differs between two ticks that are not equal.
ReplayDifference difference_of(const TickRecord& recorded, const TickRecord& recomputed, double dt) {
  ReplayDifference difference{recorded.tick, static_cast<double>(recorded.tick) * dt, {}, {}, {}};
  std::vector<double> before, after;
  tick_numbers(recorded, before);
  tick_numbers(recomputed, after);
  for (std::size_t column = 0; column < before.size(); ++column) {
    if (std::bit_cast<std::uint64_t>(before[column]) == std::bit_cast<std::uint64_t>(after[column])) continue;
    difference.field = tick_number_names()[column];
    difference.recorded = bits_text(before[column]);
    difference.recomputed = bits_text(after[column]);
    return difference;
  }
  const auto differs = [&](const char* field, int was, int is) {
    if (was == is || !difference.field.empty()) return;
    difference.field = field;
    difference.recorded = std::to_string(was);
    difference.recomputed = std::to_string(is);
  };
  differs("tissue", recorded.output.tissue, recomputed.output.tissue);
  differs("in_contact", recorded.output.in_contact ? 1 : 0, recomputed.output.in_contact ? 1 : 0);
  differs("limits", recorded.output.limits, recomputed.output.limits);
  return difference;
}

}  // namespace

ReplayResult replay_session(const Session& session, Case patient, const Progress& progress) {
  if (session.ticks.empty()) throw InputError("the session holds no ticks, there is nothing to replay");
  patient.description.haptics = session.header.haptics;
  if (session.header.device) patient.description.device = *session.header.device;
  HapticTick haptics(patient);
  if (haptics.dt() != session.header.dt) {
    throw InputError(
        fmt::format("the session has a tick of {} s, but its force models ran with one of {} s; record it again",
                    session.header.dt, haptics.dt()));
  }
  ReplayResult result;
  std::vector<std::uint8_t> was, is, all_events;
  std::uint64_t chain = 0;
  auto event = session.events.begin();
  for (const TickRecord& recorded : session.ticks) {
    if (recorded.tick != result.ticks) {
      throw InputError(
          fmt::format("tick {} is missing from the session, a replay needs every tick from the first", result.ticks));
    }
    TickRecord recomputed{recorded.tick, recorded.input, haptics.step(recorded.input)};
    was.clear();
    is.clear();
    encode_tick(recorded, was);
    encode_tick(recomputed, is);
    if (was != is) {
      result.difference = difference_of(recorded, recomputed, session.header.dt);
      return result;
    }
    std::vector<Event> recorded_events;
    for (; event != session.events.end() && event->tick == recorded.tick; ++event)
      recorded_events.push_back(event->event);
    const std::span<const Event> found(recomputed.output.events.begin(), recomputed.output.events.end());
    const std::vector<std::uint8_t> found_bytes = events_bytes(found);
    if (events_bytes(recorded_events) != found_bytes) {
      result.difference = ReplayDifference{recorded.tick, static_cast<double>(recorded.tick) * session.header.dt,
                                           "events", events_text(recorded_events), events_text(found)};
      return result;
    }
    is.insert(is.end(), found_bytes.begin(), found_bytes.end());
    chain = std::bit_cast<std::uint64_t>(chunk_checksum(chain, 1, 0, is));
    ++result.ticks;
    if (progress && result.ticks % progress_interval == 0) {
      progress("replaying", static_cast<double>(result.ticks) / static_cast<double>(session.ticks.size()));
    }
  }
  result.digest = fmt::format("{:016x}", chain);
  return result;
}

void check_same_case(const Session& session, const Case& patient, const std::string& case_folder) {
  const std::string xml = read_text_file(std::filesystem::path(case_folder) / "case.xml", largest_case_xml);
  const std::string digest = case_digest(patient, xml);
  if (digest == session.header.case_digest) return;
  const char* what =
      xml != session.header.case_xml ? "its case.xml is not the one" : "its voxels or tissues are not those";
  throw InputError(fmt::format("{}: {} of the session (digest {}, recorded {}); give the case as it was with --case",
                               case_folder, what, digest, session.header.case_digest));
}

}  // namespace bodkin
