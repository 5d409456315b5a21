#include "report/report.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "report/crossings.h"
#include "report/diagnostic_plot.h"
#include "report/force_limits.h"
#include "report/force_plot.h"
#include "report/report_style.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "imaging/markup.h"
#include "imaging/slice_picture.h"
#include "io/force_choice.h"

namespace bodkin::report {

namespace {

constexpr double travel_step = 0.2;            // mm between the points of the drawn path
constexpr double shown_before_contact = 12.0;  // mm of the path in air that is drawn
constexpr std::size_t most_events = 300;       // rows of the table of events

// The name of a procedure or structure as people write it: "lumbar_puncture" becomes "Lumbar puncture".
std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

// JSON on lines of its own; what is no JSON stays as it is.
std::string indented(const std::string& text) {
  const auto json = nlohmann::ordered_json::parse(text, nullptr, false);
  return json.is_discarded() ? text : json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

// "median 0.4 us, 99 % within 1.2 us, longest 33.0 us"
std::string spread(std::span<const session::TimeBin> bins) {
  return fmt::format("median {:.1f} us, 99 % within {:.1f} us, longest {:.1f} us",
                     1e6 * session::percentile(bins, 0.5), 1e6 * session::percentile(bins, 0.99),
                     1e6 * session::percentile(bins, 1.0));
}

class Page {
 public:
  Page(const session::Session& session, const anatomy::Case& patient, const training::Score& score, bool case_changed)
      : session_(session), patient_(patient), score_(score), case_changed_(case_changed) {}

  std::string write() {
    const std::string title = spoken(patient_.description.procedure.name) + ", " + patient_.description.name;
    emit(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>{}</title>\n"
        "<style>{}</style>\n</head>\n<body>\n<main>\n",
        imaging::escape_markup(title), report_style());
    emit("<h1>{}</h1>\n<p class=\"under\">operator {} · {} · {:.1f} s</p>\n", imaging::escape_markup(title),
         imaging::escape_markup(session_.header.operator_name), imaging::escape_markup(session_.header.started_at),
         static_cast<double>(session_.ticks.back().tick - session_.ticks.front().tick) * session_.header.dt);
    verdict();
    tiles();
    steps();
    force();
    pictures();
    course();
    second_hand();
    tissues();
    events();
    measures();
    provenance();
    emit("</main>\n</body>\n</html>\n");
    return std::move(html_);
  }

 private:
  template <typename... Arguments>
  void emit(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(html_), text, std::forward<Arguments>(arguments)...);
  }

  void figure(const imaging::Canvas& picture, const char* kind, const char* description) {
    emit("<figure{}><img alt=\"{}\" src=\"{}\"/></figure>\n", kind, description,
         imaging::data_uri("image/svg+xml", picture.svg()));
  }

  void verdict() {
    const std::string_view grade = training::name_of(score_.verdict);
    emit("<div class=\"verdict {}\"><strong>{}</strong>\n<ul>\n", grade, imaging::escape_markup(score_.headline));
    for (const training::Finding& each : score_.findings) {
      emit("<li class=\"{}\">{}</li>\n", training::name_of(each.grade), imaging::escape_markup(each.sentence));
    }
    const std::string limits = force_limits(session_).sentence(patient_.description.device);
    if (!limits.empty()) emit("<li>{}</li>\n", imaging::escape_markup(limits));
    emit("</ul>\n</div>\n<p class=\"under\">Judged as {}.</p>\n", imaging::escape_markup(score_.title));
    if (case_changed_) {
      emit(
          "<p class=\"under\">The case on disk has changed since the recording; slices and tissues show what it is "
          "now."
          "</p>\n");
    }
  }

  // A few measures that say most; measures() has them all.
  void tiles() {
    emit("<div class=\"tiles\">\n");
    for (const char* name :
         {"final_distance_mm", "closest_distance_mm", "past_target_mm", "loss_overshoot_mm", "time_in_body_s",
          "deviation_max_mm", "angle_at_contact_deg", "insertions", "redirections", "bone_contacts", "peak_force_N",
          "path_length_mm", "smoothness", "tremor_mm"}) {
      const training::MetricResult* result = score_.find(name);
      if (result == nullptr) continue;
      emit("<div class=\"tile{}\"><b>{}</b><span>{}</span></div>\n", grade_class(*result),
           training::metric_text(*result->metric, result->value), result->metric->title);
    }
    emit("</div>\n");
  }

  static std::string grade_class(const training::MetricResult& result) {
    return result.grade ? fmt::format(" {}", training::name_of(*result.grade)) : std::string();
  }

  void steps() {
    if (score_.steps.empty()) return;
    emit(
        "<h2>Step by step</h2>\n<table class=\"whole\">\n<thead><tr><th>step</th><th class=\"n\">reached at, s</th>"
        "<th class=\"n\">depth, mm</th><th>what to do</th></tr></thead>\n<tbody>\n");
    for (const training::StepResult& each : score_.steps) {
      emit("<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"none\">{}</td></tr>\n",
           imaging::escape_markup(each.title), each.time ? fmt::format("{:.1f}", *each.time) : "",
           each.depth ? fmt::format("{:.1f}", std::max(0.0, *each.depth)) : "", imaging::escape_markup(each.text));
    }
    emit("</tbody>\n</table>\n");
  }

  void measures() {
    emit("<h2>Everything that was measured</h2>\n");
    const bool experts = score_.experts > 0;
    if (experts) {
      emit(
          "<p class=\"under\">Beside each value: the middle nine tenths of {} attempts of experts, and the share of "
          "them with a smaller value.</p>\n",
          score_.experts);
    }
    emit("<table>\n<thead><tr><th>measure</th><th class=\"n\">value</th>{}</tr></thead>\n<tbody>\n",
         experts ? "<th class=\"n\">experts</th><th class=\"n\">percentile</th>" : "");
    for (const training::MetricResult& each : score_.metrics) {
      emit("<tr><td>{}</td><td class=\"n{}\">{}</td>", each.metric->title, grade_class(each),
           training::metric_text(*each.metric, each.value));
      if (experts && each.experts) {
        emit("<td class=\"n\">{} to {}</td><td class=\"n\">{:.0f}</td>",
             training::metric_text(*each.metric, each.experts->low),
             training::metric_text(*each.metric, each.experts->high), each.experts->percentile);
      } else if (experts) {
        emit("<td></td><td></td>");
      }
      emit("</tr>\n");
    }
    emit("</tbody>\n</table>\n");
  }

  void force() {
    emit("<h2>What the needle felt</h2>\n");
    if (!score_.final_tip) {
      emit("<p class=\"none\">Nothing: it never touched the body.</p>\n");
      return;
    }
    figure(draw_plot(force_against_depth(session_.ticks, session_.events, session_.header.dt, patient_)), "",
           "Resistance against depth, with the tissues as coloured bands");
    const std::vector<Plot> published = diagnostics_against_depth(session_.ticks, session_.header.diagnostics);
    if (!published.empty()) figure(draw_plots(published), "", "What the force models published, against depth");
  }

  std::vector<Vec3> travelled() const {
    std::vector<Vec3> points;
    for (const simulation::TickRecord& record : session_.ticks) {
      const Vec3 tip = record.input.needle.translation();
      const bool shown = record.output.in_contact || (tip - session_.header.path.entry).norm() < shown_before_contact;
      if (shown && (points.empty() || (tip - points.back()).norm() >= travel_step)) points.push_back(tip);
    }
    return points;
  }

  void pictures() {
    constexpr double panel_height = 455.0, closest = 80.0, furthest = 260.0, pixels = 620.0;
    const anatomy::NeedlePath& path = session_.header.path;
    if (path.length() <= 0.0 || patient_.ct.empty()) return;
    emit("<h2>Where it went</h2>\n");
    const double side = std::clamp(1.35 * path.length(), closest, furthest);
    const Vec3 middle = 0.5 * (path.entry + path.target);
    const Vec3 level(middle.x(), middle.y(), path.target.z());
    const std::vector<Vec3> tip = travelled();
    std::vector<imaging::SlicePanel> panels;
    panels.push_back({imaging::cut(imaging::sagittal_plane_along(path, middle, side, side, side / pixels),
                                   patient_.ct, patient_.tissues),
                      "sagittal, along the planned path", path, tip});
    panels.push_back({imaging::cut(imaging::view_plane(imaging::View::axial, level, side, side, side / pixels),
                                   patient_.ct, patient_.tissues),
                      "axial, at the level of the target", path, tip});
    figure(imaging::slice_picture(panels, patient_.library, "", panel_height), " class=\"dark\"",
           "Sagittal and axial slices with the planned path and the path of the tip");
  }

  void course() {
    emit("<h2>In the course of time</h2>\n");
    figure(draw_plot(force_and_depth_against_time(session_.ticks, session_.header.dt)), "",
           "Resistance and depth against time");
    figure(draw_plot(energy_against_time(session_.ticks, session_.header.dt)), "",
           "Energy that the hand has given to the tissue, against time");
  }

  void second_hand() {
    if (session_.second.empty()) return;
    const bool is_plunger = session_.header.second->role == session::SecondRole::plunger;
    emit("<h2>The second hand: {}</h2>\n", is_plunger ? "the plunger" : "the ultrasound probe");
    figure(draw_plots(second_hand_against_time(session_)), "",
           is_plunger ? "Pressure in the syringe and force on the thumb against time, with the needle's depth"
                      : "Force of the probe on the skin against time");
  }

  std::string swatch(anatomy::TissueId id) const {
    const anatomy::TissueProperties* properties = patient_.library.find(id);
    return fmt::format("<i class=\"swatch\" style=\"background:{}\"></i>{}",
                       imaging::css_colour(properties != nullptr ? properties->colour : 0x808080U),
                       imaging::escape_markup(patient_.library.title(id)));
  }

  void tissues() {
    emit("<h2>Tissues that the tip was in</h2>\n");
    if (score_.tissues.empty()) {
      emit("<p class=\"none\">None.</p>\n");
      return;
    }
    emit(
        "<table class=\"whole\">\n<thead><tr><th>tissue</th><th class=\"n\">from, mm</th><th class=\"n\">to, "
        "mm</th><th "
        "class=\"n\">time, "
        "s</th>"
        "<th class=\"n\">peak resistance, N</th><th class=\"n\">at, mm</th></tr></thead>\n<tbody>\n");
    for (const training::TissueTotal& total : score_.tissues) {
      emit(
          "<tr><td>{}</td><td class=\"n\">{:.1f}</td><td class=\"n\">{:.1f}</td><td class=\"n\">{:.2f}</td>"
          "<td class=\"n\">{:.2f}</td><td class=\"n\">{:.1f}</td></tr>\n",
          swatch(total.tissue), total.from, total.to, total.time, total.peak_force, total.peak_depth);
    }
    emit("</tbody>\n</table>\n");
  }

  void events() {
    emit("<h2>Events</h2>\n");
    if (session_.events.empty()) {
      emit("<p class=\"none\">None.</p>\n");
      return;
    }
    emit(
        "<table>\n<thead><tr><th class=\"n\">time, s</th><th class=\"n\">depth, mm</th><th>what "
        "happened</th><th>tissue</th>"
        "</tr></thead>\n<tbody>\n");
    const std::size_t rows = std::min(session_.events.size(), most_events);
    for (std::size_t i = 0; i < rows; ++i) {
      const session::SessionEvent& event = session_.events[i];
      emit("<tr><td class=\"n\">{:.3f}</td><td class=\"n\">{:.1f}</td><td>{}</td><td>{}</td></tr>\n",
           static_cast<double>(event.tick) * session_.header.dt, event.event.depth,
           imaging::escape_markup(event_text(event.event, patient_.library)),
           event.event.tissue == anatomy::tissue::air ? std::string() : swatch(event.event.tissue));
    }
    emit("</tbody>\n</table>\n");
    if (rows < session_.events.size()) {
      emit("<p class=\"none\">{} more events are in the session file.</p>\n", session_.events.size() - rows);
    }
  }

  void row(const char* what, const std::string& value) {
    emit("<tr><th>{}</th><td class=\"long\">{}</td></tr>\n", what, imaging::escape_markup(value));
  }

  void provenance() {
    const session::SessionHeader& header = session_.header;
    emit("<h2>Where this comes from</h2>\n<table class=\"whole\">\n");
    row("case", header.case_folder);
    row("fingerprint of the case", header.case_digest);
    const io::ForceTexts forces = io::force_texts(header.haptics);
    row("resistance", forces.resistance);
    row("constraint", forces.constraint);
    for (const std::string& part : forces.parts) row("with the part", part);
    row("operator", header.operator_name);
    if (!header.operator_settings.empty()) {
      emit(
          "<tr><th>its settings</th><td class=\"long\"><details><summary>all that makes this operator</summary>"
          "<pre>{}</pre></details></td></tr>\n",
          imaging::escape_markup(indented(header.operator_settings)));
    }
    if (header.second) {
      row("second hand", fmt::format("{} {}", session::name_of(header.second->role), header.second->device));
    }
    if (!header.moving_body.empty()) row("body that moved on its own time", header.moving_body);
    row("seed", std::to_string(header.seed));
    row("recorded", header.started_at);
    row("length", fmt::format("{} ticks of {:g} ms", session_.ticks.size(), 1000.0 * header.dt));
    if (session_.timings) {
      const session::SessionTimings& timings = *session_.timings;
      row("kept its time",
          fmt::format("{} of {} rounds late; lateness {}; a round took {}", timings.overruns,
                      session::count_of(timings.compute), spread(timings.lateness), spread(timings.compute)));
    }
    row("complete", session_.finished ? "yes" : "no, the recording broke off; this is what was saved");
    row("Bodkin", header.bodkin_version);
    emit("</table>\n");
  }

  const session::Session& session_;
  const anatomy::Case& patient_;
  const training::Score& score_;
  bool case_changed_;
  std::string html_;
};

}  // namespace

std::string report_html(const session::Session& session, const anatomy::Case& patient, const training::Score& score,
                        bool case_changed) {
  return Page(session, patient, score, case_changed).write();
}

}  // namespace bodkin::report
