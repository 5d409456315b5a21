#include "session/replay.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "patient/prepared_body.h"
#include "session/body_displacement.h"
#include "session/case_digest.h"
#include "session/session_run.h"
#include "session/session_schema.h"
#include "session/tick_codec.h"
#include <fmt/format.h>

#include "core/error.h"
#include "io/resources.h"
#include "simulation/changing_tick.h"
#include "simulation/contact_settings.h"

namespace bodkin::session {

namespace {

constexpr std::uint64_t progress_interval = 4096;  // ticks

std::string bits_text(double value) {
  return fmt::format("{} (bits {:016x})", value, std::bit_cast<std::uint64_t>(value));
}

std::string events_text(std::span<const forces::Event> events) {
  std::string text;
  for (const forces::Event& event : events) {
    text += fmt::format("{}{} in tissue {} at {} with {}", text.empty() ? "" : "; ", event_kind_name(event.kind),
                        event.tissue, bits_text(event.depth), bits_text(event.value));
  }
  return text.empty() ? "none" : text;
}

// Whether the recording has the diagnostics that the tick publishes: true unless a later version of a model publishes
// others.
bool has_same_diagnostics(const SessionHeader& header, std::span<const forces::DiagnosticName> names) {
  return std::equal(header.diagnostics.begin(), header.diagnostics.end(), names.begin(), names.end(),
                    [](const RecordedDiagnostic& recorded, const forces::DiagnosticName& name) {
                      return recorded.name == name.name;
                    });
}

std::vector<std::uint8_t> events_bytes(std::span<const forces::Event> events) {
  std::vector<std::uint8_t> bytes;
  for (const forces::Event& event : events) encode_event(0, event, bytes);
  return bytes;
}

// Until version 2 the force models reported a loss of resistance themselves, some never and each by its own rule; the
// simulation's rule (simulation/loss_of_resistance.h) gives other results for the same forces. The tick knows neither
// whether a tracked hand is seen, nor that a body on another thread has failed.
bool is_compared(const forces::Event& event, const Session& session) {
  if (event.kind == forces::EventKind::hand_lost || event.kind == forces::EventKind::hand_seen ||
      event.kind == forces::EventKind::moving_body_failed)
    return false;
  return session.version >= 3 || event.kind != forces::EventKind::loss_of_resistance;
}

// The fields that differ between two unequal ticks.
ReplayDifference difference_of(const simulation::TickRecord& recorded, const simulation::TickRecord& recomputed,
                               double dt, std::span<const forces::DiagnosticName> names) {
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
  for (std::size_t i = 0; i < names.size() && difference.field.empty(); ++i) {
    const double was = recorded.output.diagnostics[i], is = recomputed.output.diagnostics[i];
    if (std::bit_cast<std::uint64_t>(was) == std::bit_cast<std::uint64_t>(is)) continue;
    difference.field = names[i].name;
    difference.recorded = bits_text(was);
    difference.recomputed = bits_text(is);
  }
  return difference;
}

// The contact points of the needle's own lines: as many in each tick as in the recording.
class RecordedPoints {
 public:
  // Before the first tick.
  RecordedPoints(const Session& session, const anatomy::Case& patient, const fem::BodyDescription* body,
                 simulation::BodyPort* port)
      : port_(port) {
    const bool own_lines = std::any_of(session.events.begin(), session.events.end(), [](const SessionEvent& event) {
      return event.event.kind == forces::EventKind::points_taken ||
             (event.event.kind == forces::EventKind::line_taken &&
              event.event.value == simulation::BodyPort::own_line);
    });
    if (!own_lines) return;
    std::shared_ptr<fem::ContactLine> line;
    if (body != nullptr && port != nullptr)
      line = port->stream_points(simulation::BodyPort::PointTiming::as_recorded);
    if (line == nullptr) {
      throw InputError(
          "the session's needle met contact points of its own line, but the resistance has none here; record it "
          "again");
    }
    const std::shared_ptr<const anatomy::Case> shared(std::shared_ptr<const anatomy::Case>(), &patient);
    stream_ = patient::contact_stream(*body, shared, session.header.path.length(), kept_, std::move(line));
  }

  void prepare_for(std::span<const forces::Event> events) {
    if (stream_ == nullptr) return;
    for (const forces::Event& event : events) {
      if (event.kind == forces::EventKind::points_taken) port_->set_recorded_points(event.value);
      if (event.kind == forces::EventKind::points_coupled) port_->set_recorded_coupling();
    }
  }

  // Why points are missing, one sentence; empty: none are missing.
  std::string failure() {
    const std::vector<std::string> failures =
        stream_ == nullptr ? std::vector<std::string>() : stream_->take_failures();
    return failures.empty() ? std::string() : failures.front();
  }

 private:
  simulation::BodyPort* port_;
  std::shared_ptr<const fem::ContactBody> kept_;
  std::unique_ptr<fem::ContactStream> stream_;
};

// The ticks with other numbers that took over during the session, created in time for their takeover.
class RecordedChanges {
 public:
  RecordedChanges(const Session& session, const anatomy::Case& patient, simulation::HapticTick& first)
      : session_(session), patient_(patient), body_(first.body()), current_(first), next_(session.changes.begin()) {}

  simulation::TickOutput step(const simulation::TickRecord& recorded) {
    if (next_ != session_.changes.end() && next_->tick == recorded.tick) apply_change(*next_++);
    return current_.step(recorded.input);
  }

 private:
  anatomy::BreathState breath_before(std::uint64_t tick) const {
    if (!patient_.description.breathing) return {};
    anatomy::BreathClock clock(*patient_.description.breathing, session_.header.dt);
    for (std::uint64_t each = 0; each < tick; ++each) clock.step(session_.ticks[each].input.other.breath_held);
    return clock.moment();
  }
  struct ChangedTick {
    ChangedTick(const anatomy::Case& from, const NumberChange& change) : patient(with(from, change)), tick(patient) {}
    static anatomy::Case with(anatomy::Case patient, const NumberChange& change) {
      apply(change, patient);
      return patient;
    }
    anatomy::Case patient;
    simulation::HapticTick tick;
  };

  void apply_change(const NumberChange& change) {
    if (body_ != nullptr) {
      anatomy::Case with;
      with.description = patient_.description;
      with.library = patient_.library;
      apply(change, with);
      return body_->change_numbers(simulation::contact_numbers(with));
    }
    auto made = std::make_unique<ChangedTick>(patient_, change);
    made->tick.set_breath(breath_before(change.from_tick));
    for (std::uint64_t tick = change.from_tick; tick < change.tick; ++tick)
      made->tick.step(session_.ticks[tick].input);
    if (!current_.switch_to(made->tick)) {
      throw InputError(
          fmt::format("the session changes its numbers at tick {} while those before still settle; the recording is "
                      "damaged",
                      change.tick));
    }
    before_ = std::exchange(now_, std::move(made));
  }

  const Session& session_;
  const anatomy::Case& patient_;
  simulation::BodyPort* body_;  // null: a rigid patient
  simulation::ChangingTick current_;
  std::vector<NumberChange>::const_iterator next_;
  std::unique_ptr<ChangedTick> now_, before_;  // the latter fades
};

// The equations of the body are those of the session, since check_same_case() has compared the case.
std::string body_difference(const Session& session, const anatomy::Case& patient) {
  const std::string now = digest_of_body(patient);
  const std::string &recorded = session.header.body_digest, &points = session.header.body_points;
  if (recorded.empty() || now == recorded) return {};
  const char* what = "another compliance than in the session";
  if (now.empty()) what = "not been prepared, unlike that of the session";
  if (!now.empty() && !points.empty())
    what = points == digest_of_points(patient) ? "the contact points of the session, but another compliance of them"
                                               : "other contact points than in the session";
  return fmt::format(
      "the deformable body of the same case has {} (digest {}, recorded {}): it was prepared by another version of "
      "Bodkin or METIS",
      what, now.empty() ? "none" : now, recorded);
}

}  // namespace

void check_recomputable(const Session& session) {
  for (const SessionEvent& event : session.events) {
    if (event.event.kind == forces::EventKind::line_taken && event.event.value >= 0.0) {
      throw InputError(fmt::format(
          "the session cannot be recomputed: at {:.3f} s its needle took another corridor of mesh nodes, which older "
          "versions of Bodkin prepared; 'bodkin report' and 'bodkin export' show what was felt",
          static_cast<double>(event.tick) * session.header.dt));
    }
  }
  check_moved_body(session);
}

ReplayResult replay_session(const Session& session, anatomy::Case patient, const Progress& progress,
                            const fem::BodyDescription* body) {
  if (session.ticks.empty()) throw InputError("the session holds no ticks, there is nothing to replay");
  check_recomputable(session);
  patient.description.haptics = session.header.haptics;
  if (session.header.device) patient.description.device = *session.header.device;
  simulation::HapticTick haptics(patient);
  if (haptics.dt() != session.header.dt) {
    throw InputError(
        fmt::format("the session has a tick of {} s, but its force models ran with one of {} s; record it again",
                    session.header.dt, haptics.dt()));
  }
  ReplayResult result;
  result.body_difference = body_difference(session, patient);
  std::vector<std::uint8_t> was, is, all_events;
  std::uint64_t chain = 0;
  BodyDisplacement moved(session, body, haptics.body());
  RecordedPoints points(session, patient, body, haptics.body());
  const std::span<const forces::DiagnosticName> published = haptics.diagnostic_names();
  const auto names = has_same_diagnostics(session.header, published) ? published : published.first(0);
  auto event = session.events.begin();
  RecordedChanges changes(session, patient, haptics);
  for (const simulation::TickRecord& recorded : session.ticks) {
    if (recorded.tick != result.ticks) {
      throw InputError(
          fmt::format("tick {} is missing from the session, a replay needs every tick from the first", result.ticks));
    }
    std::vector<forces::Event> recorded_events;
    for (; event != session.events.end() && event->tick == recorded.tick; ++event)
      if (is_compared(event->event, session)) recorded_events.push_back(event->event);
    points.prepare_for(recorded_events);
    moved.prepare_for(recorded.tick);
    if (result.body_difference.empty()) result.body_difference = moved.difference();
    simulation::TickRecord recomputed{recorded.tick, recorded.input, changes.step(recorded)};
    was.clear();
    is.clear();
    encode_tick(recorded, was);
    encode_tick(recomputed, is);
    encode_diagnostics(recorded, names.size(), was);
    encode_diagnostics(recomputed, names.size(), is);
    if (was != is) {
      result.difference = difference_of(recorded, recomputed, session.header.dt, names);
      if (result.body_difference.empty()) result.body_difference = points.failure();
      return result;
    }
    std::vector<forces::Event> found;
    for (const forces::Event& one : recomputed.output.events) {
      if (is_compared(one, session)) found.push_back(one);
    }
    const std::vector<std::uint8_t> found_bytes = events_bytes(found);
    if (events_bytes(recorded_events) != found_bytes) {
      result.difference = ReplayDifference{recorded.tick, static_cast<double>(recorded.tick) * session.header.dt,
                                           "events", events_text(recorded_events), events_text(found)};
      if (result.body_difference.empty()) result.body_difference = points.failure();
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

void check_same_case(const Session& session, const anatomy::Case& patient, const std::string& case_folder) {
  const std::string xml = io::read_text_file(std::filesystem::path(case_folder) / "case.xml", largest_case_xml);
  const std::string mesh = mesh_digest(case_folder, session.header.haptics.resistance);
  const std::string& recorded = session.header.case_digest;
  if (is_digest_of_case(recorded, patient, xml, mesh)) return;
  const std::string& parts = session.header.case_parts;
  std::string what =
      mesh.empty() ? "its voxels or tissues are not those" : "its voxels, tissues or mesh are not those";
  if (const std::string changed = changed_parts(parts, patient, mesh); !parts.empty() && !changed.empty()) {
    what = fmt::format("its {} {} not {}", changed, changed == "mesh" ? "is" : "are",
                       changed == "mesh" ? "the one" : "those");
  }
  if (xml != session.header.case_xml) what = "its case.xml is not the one";
  throw InputError(fmt::format("{}: {} of the session (digest {}, recorded {}); give the case as it was with --case",
                               case_folder, what, case_digest(patient, xml, mesh), recorded));
}

}  // namespace bodkin::session
