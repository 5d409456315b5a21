#include "session/session_export.h"

#include <iterator>

#include "session/tick_codec.h"
#include <fmt/format.h>

namespace bodkin::session {

namespace {

constexpr std::size_t piece = 1 << 20;  // bytes passed on at once

constexpr std::string_view tick_columns =
    "tick,time_s,tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_y,axis_z,depth_mm,velocity_mm_per_s,resistance_N,constraint_"
    "N,energy_N_mm,"
    "requested_force_x_N,requested_force_y_N,requested_force_z_N,"
    "requested_torque_x_N_mm,requested_torque_y_N_mm,requested_torque_z_N_mm,"
    "applied_force_x_N,applied_force_y_N,applied_force_z_N,"
    "applied_torque_x_N_mm,applied_torque_y_N_mm,applied_torque_z_N_mm,"
    "tissue,in_contact,limits";

// A field of RFC 4180: in quotes if necessary.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char character : text) {
    if (character == '"') quoted += '"';
    quoted += character;
  }
  return quoted + '"';
}

class TissueNames {
 public:
  explicit TissueNames(const SessionHeader& header) {
    for (int id = 0; id < 256; ++id) names_.push_back(std::to_string(id));
    for (const TissueName& tissue : header.tissues) names_[tissue.id] = field(tissue.name);
  }
  const std::string& operator[](anatomy::TissueId id) const { return names_[id]; }

 private:
  std::vector<std::string> names_;  // 256
};

void append(const Vec3& vector, std::string& text) {
  fmt::format_to(std::back_inserter(text), ",{},{},{}", vector.x(), vector.y(), vector.z());
}

}  // namespace

void export_ticks(const Session& session, const TextSink& sink) {
  const TissueNames names(session.header);
  std::string text(tick_columns);
  for (const RecordedDiagnostic& diagnostic : session.header.diagnostics) text += ',' + field(diagnostic.name);
  text += '\n';
  const std::size_t diagnostics = session.header.diagnostics.size();
  for (const simulation::TickRecord& record : session.ticks) {
    const simulation::TickOutput& output = record.output;
    fmt::format_to(std::back_inserter(text), "{},{}", record.tick,
                   static_cast<double>(record.tick) * session.header.dt);
    append(record.input.needle.translation(), text);
    append(needle_axis(record.input.needle), text);
    fmt::format_to(std::back_inserter(text), ",{},{},{},{},{}", output.depth, output.velocity, output.resistance,
                   output.constraint, output.energy);
    append(output.requested.force, text);
    append(output.requested.torque, text);
    append(output.applied.force, text);
    append(output.applied.torque, text);
    fmt::format_to(std::back_inserter(text), ",{},{},{}", names[output.tissue], output.in_contact ? 1 : 0,
                   static_cast<int>(output.limits));
    for (std::size_t i = 0; i < diagnostics; ++i)
      fmt::format_to(std::back_inserter(text), ",{}", output.diagnostics[i]);
    text += '\n';
    if (text.size() < piece) continue;
    sink(text);
    text.clear();
  }
  sink(text);
}

void export_events(const Session& session, const TextSink& sink) {
  const TissueNames names(session.header);
  std::string text = "tick,time_s,depth_mm,kind,tissue,value\n";
  for (const SessionEvent& event : session.events) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", event.tick,
                   static_cast<double>(event.tick) * session.header.dt, event.event.depth,
                   event_kind_name(event.event.kind), names[event.event.tissue], event.event.value);
  }
  sink(text);
}

void export_second(const Session& session, const TextSink& sink) {
  const bool is_plunger = session.header.second && session.header.second->role == SecondRole::plunger;
  std::string text = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,force_N,pressure_MPa,volume_mm3\n";
  for (const SecondSample& sample : session.second) {
    const Eigen::Quaterniond& turn = sample.rotation;
    fmt::format_to(std::back_inserter(text), "{}", sample.time);
    append(sample.position, text);
    fmt::format_to(std::back_inserter(text), ",{},{},{},{},{},", turn.w(), turn.x(), turn.y(), turn.z(),
                   sample.force);
    if (is_plunger) {
      fmt::format_to(std::back_inserter(text), "{},{}\n", sample.pressure, sample.volume);
    } else {
      text += ",\n";
    }
    if (text.size() < piece) continue;
    sink(text);
    text.clear();
  }
  sink(text);
}

}  // namespace bodkin::session
