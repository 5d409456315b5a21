#include "training/score_json.h"

#include <cmath>

#include "session/tick_codec.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/parameter_value.h"

namespace bodkin::training {

namespace {

using nlohmann::ordered_json;

ordered_json number_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json metric_json(const MetricResult& result) {
  ordered_json json = {{"name", result.metric->name},
                       {"title", result.metric->title},
                       {"unit", result.metric->unit},
                       {"value", number_or_null(result.value)},
                       {"grade", result.grade ? ordered_json(name_of(*result.grade)) : ordered_json(nullptr)}};
  json["experts"] = nullptr;
  if (result.experts) {
    json["experts"] = {{"percentile", result.experts->percentile},
                       {"z", result.experts->z},
                       {"low", result.experts->low},
                       {"high", result.experts->high}};
  }
  return json;
}

// Values other than the default.
ordered_json thresholds_json(const Thresholds& thresholds) {
  ordered_json json = ordered_json::object();
  for (const auto& [name, value] : own_thresholds(thresholds)) json[std::string(name)] = value;
  return json;
}

ordered_json final_json(const Score& score, const Attempt& attempt) {
  if (!score.final_tip) return nullptr;
  const Vec3& tip = score.final_tip->tip;
  return {{"is_rest", score.final_tip->is_rest},
          {"tip_mm", {tip.x(), tip.y(), tip.z()}},
          {"depth_mm", score.final_tip->depth},
          {"tissue", attempt.title_of(score.final_tip->tissue)}};
}

}  // namespace

std::string score_json(const Score& score, const Attempt& attempt, const std::string& session) {
  ordered_json json = {{"version", score_version},
                       {"verdict", name_of(score.verdict)},
                       {"headline", score.headline},
                       {"procedure", {{"name", score.procedure}, {"title", score.title}}},
                       {"session", session},
                       {"operator", attempt.session().header.operator_name},
                       {"started_at", attempt.session().header.started_at},
                       {"finished", attempt.session().finished},
                       {"reached", score.reached},
                       {"reached_s", number_or_null(score.reached_time)},
                       {"level", score.level.empty() ? ordered_json(nullptr) : ordered_json(score.level)},
                       {"final_position", final_json(score, attempt)},
                       {"experts", score.experts}};
  if (score.thresholds != Thresholds()) json["thresholds"] = thresholds_json(score.thresholds);
  json["findings"] = ordered_json::array();
  for (const Finding& each : score.findings)
    json["findings"].push_back(
        {{"grade", name_of(each.grade)}, {"subject", each.subject}, {"sentence", each.sentence}});
  json["metrics"] = ordered_json::array();
  for (const MetricResult& each : score.metrics) json["metrics"].push_back(metric_json(each));
  json["steps"] = ordered_json::array();
  for (const StepResult& each : score.steps) {
    json["steps"].push_back(
        {{"title", each.title}, {"reached_s", number_or_null(each.time)}, {"depth_mm", number_or_null(each.depth)}});
  }
  json["harms"] = ordered_json::array();
  for (const Harm& each : score.harms) {
    json["harms"].push_back({{"what", each.title},
                             {"grade", name_of(each.grade)},
                             {"entered", each.entered},
                             {"entries", each.entries},
                             {"first_s", each.first_time},
                             {"first_depth_mm", each.first_depth},
                             {"deepest_mm", each.deepest},
                             {"inside_s", each.time_inside},
                             {"closest_mm", each.closest}});
  }
  json["distances"] = ordered_json::array();
  for (const ForbiddenDistance& each : score.distances) {
    const bool near = each.closest.has_value();
    json["distances"].push_back({{"what", each.title},
                                 {"closest_mm", number_or_null(each.closest)},
                                 {"at_s", near ? ordered_json(each.time) : ordered_json(nullptr)},
                                 {"depth_mm", near ? ordered_json(each.depth) : ordered_json(nullptr)}});
  }
  json["punctures"] = ordered_json::array();
  for (const Puncture& each : score.punctures) {
    json["punctures"].push_back({{"kind", session::event_kind_name(each.kind)},
                                 {"tissue", attempt.title_of(each.tissue)},
                                 {"time_s", each.time},
                                 {"depth_mm", each.depth},
                                 {"value", number_or_null(each.force)},
                                 {"overshoot_mm", each.overshoot},
                                 {"speed_mm_per_s", each.speed},
                                 {"reaction_s", each.reaction}});
  }
  json["tissues"] = ordered_json::array();
  for (const TissueTotal& each : score.tissues) {
    json["tissues"].push_back({{"tissue", attempt.title_of(each.tissue)},
                               {"from_mm", each.from},
                               {"to_mm", each.to},
                               {"time_s", each.time},
                               {"peak_force_N", each.peak_force},
                               {"peak_depth_mm", each.peak_depth},
                               {"work_N_mm", each.work}});
  }
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace);
}

std::string score_csv_columns() {
  std::string text = "verdict,reached";
  for (const Metric& metric : all_metrics()) text += fmt::format(",{}", metric.name);
  return text;
}

std::string score_csv_fields(const Score& score) {
  std::string text = fmt::format("{},{}", name_of(score.verdict), score.reached ? 1 : 0);
  for (const Metric& metric : all_metrics()) {
    const MetricResult* result = score.find(metric.name);
    text += ",";
    if (result != nullptr && std::isfinite(result->value)) text += number_text(result->value);
  }
  return text;
}

}  // namespace bodkin::training
