#include "report/teacher/teacher_page.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>

#include "report/learning_plot.h"
#include "report/report_style.h"
#include <fmt/format.h>

#include "imaging/markup.h"
#include "training/metric.h"

namespace bodkin::report {

namespace {

using imaging::escape_markup;
using training::AttemptRecord;
using training::CohortRow;

constexpr const char* teacher_style =
    ":root{--link:#0b5cad}@media screen and (prefers-color-scheme:dark){:root{--link:#7db8f0}}"
    "main{max-width:1100px}table{width:100%}td.number,th.number{text-align:right}a{color:var(--link)}td "
    "a{font-weight:600}td "
    "a,td.time{white-space:nowrap}td.pass{color:var(--mark);font-weight:600}svg{max-width:100%;height:auto;"
    "background:#fff;border-radius:6px}";

std::string page_of(const std::string& title, const std::string& under, const std::string& body, bool is_home) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>{0}</title>\n<style>\n{1}{2}</style>\n</"
      "head>\n<body>\n<main>\n{3}<h1>{0}</"
      "h1>\n"
      "<p class=\"under\">{4}</p>\n{5}</main>\n</body>\n</html>\n",
      escape_markup(title), report_style(), teacher_style,
      is_home ? "" : "<p class=\"under\"><a href=\"/\">All trainees</a></p>\n", under, body);
}

std::string trainee_link(const std::string& label) {
  return fmt::format("<a href=\"/trainee/{}\">{}</a>", percent_encoded(label), escape_markup(label));
}

std::string date_of(const std::string& time) {
  std::string text = time.substr(0, std::min<std::size_t>(time.size(), 16));
  std::replace(text.begin(), text.end(), 'T', ' ');
  return escape_markup(text);
}

std::string mastery_words(const CohortRow& row) {
  return row.mastery ? "shown" : "not yet";
}

}  // namespace

std::string percent_encoded(std::string_view text) {
  std::string encoded;
  for (const char each : text) {
    const auto code = static_cast<unsigned char>(each);
    const bool is_plain = code < 0x80 && (std::isalnum(code) != 0 || each == '-' || each == '_' || each == '.');
    encoded += is_plain ? std::string(1, each) : fmt::format("%{:02X}", code);
  }
  return encoded;
}

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    unsigned value = 0;
    if (i + 2 >= text.size()) return std::nullopt;
    const char* const end = text.data() + i + 3;
    const auto read = std::from_chars(text.data() + i + 1, end, value, 16);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    decoded += static_cast<char>(value);
    i += 2;
  }
  return decoded;
}

std::string cohort_page(const std::vector<CohortRow>& rows, const std::vector<PlanPlace>& plans,
                        const std::string& place, bool has_stations) {
  std::string body = has_stations ? "<p><a href=\"/stations\">Stations, live</a></p>\n" : "";
  if (rows.empty()) {
    body +=
        "<p>No attempt has been kept yet. In the window a trainee's attempts are kept once a label is chosen on the "
        "start page; <code>bodkin results add</code> adds sessions that were recorded before.</p>\n";
  } else {
    body +=
        "<table id=\"cohort\">\n<tr><th>Trainee</th><th>Procedure</th><th class=\"number\">Attempts</th><th "
        "class=\"number\">Passed</th><th class=\"number\">Borderline</th><th class=\"number\">Failed</th><th "
        "class=\"number\">Dangerous</th><th class=\"number\">Score, last 5</th><th>Mastery</th><th>Last</th></tr>\n";
    for (const CohortRow& row : rows) {
      body += fmt::format(
          "<tr><td>{}</td><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
          "class=\"number\">{}</td>"
          "<td class=\"number\">{}</td><td class=\"number\">{}</td><td "
          "class=\"number\">{:.0f}</td><td>{}</td><td class=\"time\">{}</td></tr>\n",
          trainee_link(row.trainee), escape_markup(row.procedure), row.attempts, row.passed, row.borderline,
          row.failed, row.dangerous, row.score, mastery_words(row), date_of(row.last_at));
    }
    body += "</table>\n<p><a href=\"/results.csv\">All attempts as a table for statistics</a></p>\n";
  }
  if (!plans.empty()) {
    body += "<h2>Plans</h2>\n<table id=\"plans\">\n<tr><th>Trainee</th><th>Plan</th><th>Where</th></tr>\n";
    for (const PlanPlace& each : plans) {
      body += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", trainee_link(each.trainee),
                          escape_markup(each.plan), escape_markup(each.progress));
    }
    body += "</table>\n";
  }
  return page_of("Trainees", escape_markup(place), body, true);
}

std::string trainee_page(const std::vector<AttemptRecord>& attempts) {
  std::map<std::string, std::vector<training::AttemptSummary>> by_procedure;
  for (const AttemptRecord& each : attempts) {
    by_procedure[each.procedure].push_back({.trainee = each.trainee,
                                            .procedure = each.procedure,
                                            .started_at = each.started_at,
                                            .digest = each.digest,
                                            .verdict = each.verdict,
                                            .score = each.score,
                                            .stage = each.stage});
  }
  std::string body;
  for (const auto& [procedure, summaries] : by_procedure) body += draw_learning_curve(summaries).svg() + "\n";
  body +=
      "<h2>Attempts</h2>\n<table id=\"attempts\">\n<tr><th>Time</th><th>Procedure</th><th>Verdict</th><th "
      "class=\"number\">Score</th><th>What happened</th></tr>\n";
  for (auto each = attempts.rbegin(); each != attempts.rend(); ++each) {
    body += fmt::format(
        "<tr><td><a href=\"/attempt/{}\">{}</a></td><td>{}</td><td class=\"{}\">{}</td><td "
        "class=\"number\">{:.0f}</td><td>{}</td></tr>\n",
        percent_encoded(each->digest), date_of(each->started_at), escape_markup(each->procedure),
        training::name_of(each->verdict), training::name_of(each->verdict), each->score,
        escape_markup(each->headline));
  }
  body += "</table>\n";
  return page_of(attempts.front().trainee, fmt::format("{} attempts", attempts.size()), body, false);
}

std::string attempt_page(const AttemptRecord& attempt, bool has_report) {
  std::string body = fmt::format("<div class=\"verdict {}\"><strong>{}</strong>\n<ul>\n",
                                 training::name_of(attempt.verdict), escape_markup(attempt.headline));
  for (const training::Finding& each : attempt.findings)
    body += fmt::format("<li class=\"{}\">{}</li>\n", training::name_of(each.grade), escape_markup(each.sentence));
  body += "</ul>\n</div>\n";
  body += has_report ? fmt::format("<p><a href=\"/attempt/{}/report\">The whole report, with pictures</a></p>\n",
                                   percent_encoded(attempt.digest))
                     : fmt::format("<p>The session is kept on {}; its report can be seen there.</p>\n",
                                   escape_markup(attempt.station));
  body += "<h2>Measures</h2>\n<table>\n<tr><th>Measure</th><th class=\"number\">Value</th></tr>\n";
  for (const auto& [name, value] : attempt.metrics) {
    const training::Metric* const metric = training::find_metric(name);
    body += fmt::format("<tr><td>{}</td><td class=\"number\">{}</td></tr>\n",
                        escape_markup(metric == nullptr ? name : std::string(metric->title)),
                        metric == nullptr ? fmt::format("{:g}", value) : escape_markup(metric_text(*metric, value)));
  }
  body += "</table>\n";
  const std::string under =
      fmt::format("{} · {} · {} · {:.0f} s · score {:.0f}", trainee_link(attempt.trainee),
                  escape_markup(attempt.procedure), date_of(attempt.started_at), attempt.duration, attempt.score);
  return page_of("Attempt", under, body, false);
}

std::string message_page(const std::string& title, const std::string& sentence) {
  return page_of(title, "", fmt::format("<p>{}</p>\n", escape_markup(sentence)), false);
}

}  // namespace bodkin::report
