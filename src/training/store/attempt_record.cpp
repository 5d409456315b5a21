#include "training/store/attempt_record.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "core/error.h"
#include "io/digest.h"
#include "io/xml_document.h"

namespace bodkin::training {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t longest_label = 64;  // characters

std::size_t characters_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }));
}

bool is_label_byte(char byte) {
  const auto code = static_cast<unsigned char>(byte);
  return code >= 0x80 || std::isalnum(code) != 0 || std::strchr(" _-.", byte) != nullptr;
}

}  // namespace

std::string session_digest(const session::Session& session) {
  std::string bytes = fmt::format("{}\n{}\n{}\n{}\n{}\n", session.header.started_at, session.header.case_digest,
                                  session.header.operator_name, session.header.seed, session.ticks.size());
  // Two stations started in the same second can record the same motion to the bit.
  if (!session.header.recording_id.empty()) bytes += session.header.recording_id + '\n';
  constexpr std::size_t numbers = 8;
  bytes.reserve(bytes.size() + session.ticks.size() * numbers * sizeof(double));
  for (const simulation::TickRecord& each : session.ticks) {
    const Vec3 tip = each.input.needle.translation(), axis = each.input.needle.linear().col(2);
    const std::array<double, numbers> values = {
        static_cast<double>(each.tick), tip.x(), tip.y(), tip.z(), axis.x(), axis.y(), axis.z(),
        each.output.resistance};
    char raw[sizeof values];
    std::memcpy(raw, values.data(), sizeof values);
    bytes.append(raw, sizeof values);
  }
  return io::bytes_digest(bytes);
}

AttemptRecord record_of(const session::Session& session, const std::string& patient, const Score& score) {
  AttemptRecord record;
  record.digest = session_digest(session);
  record.procedure = score.procedure;
  record.patient = patient;
  record.station = station_name();
  record.started_at = session.header.started_at;
  if (!session.ticks.empty())
    record.duration = static_cast<double>(session.ticks.back().tick - session.ticks.front().tick) * session.header.dt;
  record.verdict = score.verdict;
  record.reached = score.reached;
  record.score = score_points(score);
  record.headline = score.headline;
  for (const MetricResult& each : score.metrics)
    if (std::isfinite(each.value)) record.metrics.emplace_back(each.metric->name, each.value);
  record.findings = score.findings;
  return record;
}

void check_label(const std::string& label, const std::string& what) {
  const bool fits = !label.empty() && characters_of(label) <= longest_label && label.front() != ' ' &&
                    label.back() != ' ' && std::all_of(label.begin(), label.end(), is_label_byte);
  if (fits) return;
  throw InputError(fmt::format(
      "{} is {}, expected a label of 1 to {} letters, digits, blanks, '_', '-' and '.', such as trainee-07", what,
      io::in_quotes(label), longest_label));
}

Grade grade_of_name(std::string_view name, const std::string& origin) {
  for (const Grade grade : {Grade::pass, Grade::borderline, Grade::fail, Grade::dangerous})
    if (name_of(grade) == name) return grade;
  throw InputError(
      fmt::format("{}: a verdict is {}, expected pass, borderline, fail or dangerous", origin, io::in_quotes(name)));
}

std::string station_name() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0 || name[0] == '\0') return "station";
  return name.data();
}

std::string metrics_json(const AttemptRecord& record) {
  ordered_json json = ordered_json::object();
  for (const auto& [name, value] : record.metrics) json[name] = value;
  return json.dump();
}

std::string findings_json(const AttemptRecord& record) {
  ordered_json json = ordered_json::array();
  for (const Finding& each : record.findings)
    json.push_back({{"grade", name_of(each.grade)}, {"subject", each.subject}, {"sentence", each.sentence}});
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

void read_metrics(AttemptRecord& record, std::string_view text, const std::string& origin) {
  const ordered_json json = ordered_json::parse(text, nullptr, false);
  if (!json.is_object()) throw InputError(fmt::format("{}: the metrics of an attempt are no JSON object", origin));
  record.metrics.clear();
  for (const auto& [name, value] : json.items())
    if (value.is_number()) record.metrics.emplace_back(name, value.get<double>());
}

void read_findings(AttemptRecord& record, std::string_view text, const std::string& origin) {
  const ordered_json json = ordered_json::parse(text, nullptr, false);
  if (!json.is_array()) throw InputError(fmt::format("{}: the findings of an attempt are no JSON array", origin));
  record.findings.clear();
  for (const ordered_json& each : json) {
    if (!each.is_object()) continue;
    record.findings.push_back(
        {grade_of_name(each.value("grade", "fail"), origin), each.value("subject", ""), each.value("sentence", "")});
  }
}

}  // namespace bodkin::training
