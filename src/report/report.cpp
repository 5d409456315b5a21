#include "report/report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "report/crossings.h"
#include "report/cut_open_picture.h"
#include "report/diagnostic_plot.h"
#include "report/document_html.h"
#include "report/expert_forces.h"
#include "report/expert_plot.h"
#include "report/force_limits.h"
#include "report/force_plot.h"
#include "report/probe_figures.h"
#include "session/material_tip.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "imaging/slice_picture.h"
#include "io/force_choice.h"

namespace bodkin::report {

namespace {

constexpr double travel_step = 0.2;            // mm between the points of the drawn path
constexpr double shown_before_contact = 12.0;  // mm of the path in air that is drawn
constexpr std::size_t most_events = 300;       // rows of the table of events

// The name of a procedure or structure for people: "lumbar_puncture" becomes "Lumbar puncture".
std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

// JSON on separate lines; other text is unchanged.
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

// A cell with a number with so many digits after the point.
Table::Cell number(double value, int digits) {
  return {fmt::format("{:.{}f}", value, digits)};
}

class ReportWriter {
 public:
  ReportWriter(const session::Session& session, const anatomy::Case& patient, const training::Score& score,
               bool case_changed, PlottedDepth depth)
      : session_(session), patient_(patient), score_(score), case_changed_(case_changed), depth_(depth) {}

  Document write() {
    document_.title = spoken(patient_.description.procedure.name) + ", " + patient_.description.name;
    document_.subtitle = fmt::format(
        "operator {} · {} · {:.1f} s", session_.header.operator_name, session_.header.started_at,
        static_cast<double>(session_.ticks.back().tick - session_.ticks.front().tick) * session_.header.dt);
    verdict();
    tiles();
    expert_band();
    steps();
    force();
    pictures();
    probe();
    course();
    second_hand();
    tissues();
    distances();
    events();
    measures();
    provenance();
    return std::move(document_);
  }

 private:
  void add(Block block) { document_.blocks.push_back(std::move(block)); }
  void heading(const char* text) { add(Heading{text}); }
  void remark(std::string text) { add(Paragraph{std::move(text)}); }
  void nothing(std::string text) { add(Paragraph{std::move(text), true}); }
  void figure(imaging::Canvas picture, const char* description, bool is_dark = false) {
    add(Picture{std::move(picture), description, is_dark});
  }

  void verdict() {
    Verdict verdict{score_.verdict, score_.headline, {}};
    for (const training::Finding& each : score_.findings) verdict.findings.push_back({each.sentence, each.grade});
    const std::string limits = force_limits(session_).sentence(patient_.description.device);
    if (!limits.empty()) verdict.findings.push_back({limits, std::nullopt});
    add(std::move(verdict));
    remark(fmt::format("Judged as {}.", score_.title));
    if (case_changed_) {
      remark("The case on disk has changed since the recording; slices and tissues show its present state.");
    }
  }

  // The most important measures; measures() has them all.
  void tiles() {
    Tiles tiles;
    for (const char* name :
         {"final_distance_mm", "closest_distance_mm", "past_target_mm", "loss_overshoot_mm", "time_in_body_s",
          "deviation_max_mm", "angle_at_contact_deg", "insertions", "redirections", "bone_contacts", "peak_force_N",
          "path_length_mm", "smoothness", "tremor_mm"}) {
      const training::MetricResult* result = score_.find(name);
      if (result == nullptr) continue;
      tiles.tiles.push_back(
          {training::metric_text(*result->metric, result->value), std::string(result->metric->title), result->grade});
    }
    add(std::move(tiles));
  }

  void expert_band() {
    const std::vector<ExpertRow> rows = expert_rows(score_);
    if (rows.empty()) return;
    heading("Among experts");
    const auto outside =
        std::count_if(rows.begin(), rows.end(), [](const ExpertRow& row) { return !row.is_within(); });
    remark(fmt::format(
        "Of {} measures that the procedure judges, {} lie within the range of nine of ten experts ({} attempts of "
        "experts).",
        rows.size(), rows.size() - static_cast<std::size_t>(outside), score_.experts));
    figure(draw_expert_band(rows), "Each judged measure as a dot on the band of the experts' middle nine tenths");
  }

  void steps() {
    if (score_.steps.empty()) return;
    heading("Step by step");
    Table table{{{"step"}, {"reached at, s", true}, {"depth, mm", true}, {"what to do"}}, {}, true};
    for (const training::StepResult& each : score_.steps) {
      table.rows.push_back({{each.title},
                            each.time ? number(*each.time, 1) : Table::Cell{},
                            each.depth ? number(std::max(0.0, *each.depth), 1) : Table::Cell{},
                            {each.text, {}, {}, true}});
    }
    add(std::move(table));
  }

  void measures() {
    heading("Everything that was measured");
    const bool experts = score_.experts > 0;
    Table table{{{"measure"}, {"value", true}}, {}, false};
    if (experts) {
      remark(fmt::format(
          "Next to each value: the middle nine tenths of {} attempts of experts, and the share of them with "
          "a smaller value.",
          score_.experts));
      table.columns.push_back({"experts", true});
      table.columns.push_back({"percentile", true});
    }
    for (const training::MetricResult& each : score_.metrics) {
      std::vector<Table::Cell> row = {{std::string(each.metric->title)},
                                      {training::metric_text(*each.metric, each.value), each.grade}};
      if (experts && each.experts) {
        row.push_back({fmt::format("{} to {}", training::metric_text(*each.metric, each.experts->low),
                                   training::metric_text(*each.metric, each.experts->high))});
        row.push_back(number(each.experts->percentile, 0));
      } else if (experts) {
        row.resize(4);
      }
      table.rows.push_back(std::move(row));
    }
    add(std::move(table));
  }

  void force() {
    heading("What the needle felt");
    if (!score_.final_tip) {
      nothing("Nothing: it never touched the body.");
      return;
    }
    Plot plot;
    if (depth_ == PlottedDepth::material) {
      const MaterialDepths inside = in_material(session_.ticks, session_.events, session_.header.diagnostics);
      plot = force_against_depth(inside.ticks, inside.events, session_.header.dt, patient_);
    } else {
      plot = force_against_depth(session_.ticks, session_.events, session_.header.dt, patient_);
    }
    plot.x_label = depth_label(depth_);
    if (const auto experts = expert_range()) {
      plot.ranges.push_back(*experts);
      remark(
          fmt::format("Band behind the curve: from the least to the greatest resistance of {} attempts of the "
                      "simulated expert on the way in, on this patient, with this path and these force models.",
                      expert_attempts));
    }
    figure(draw_plot(plot), "Resistance against depth, with the tissues as coloured bands");
    const std::vector<Plot> published = diagnostics_against_depth(session_.ticks, session_.header.diagnostics);
    if (!published.empty()) figure(draw_plots(published), "What the force models published, against depth");
  }

  // Only depths of the hand can be compared, and only on the session's original patient.
  std::optional<PlotRange> expert_range() const {
    if (case_changed_ || depth_ == PlottedDepth::material || score_.expert.empty()) return std::nullopt;
    return expert_forces(patient_, session_.header, score_.expert);
  }

  std::vector<Vec3> travelled() const {
    std::vector<Vec3> points;
    session::MaterialTip material(patient_.description.breathing, session_.header.dt);
    for (const simulation::TickRecord& record : session_.ticks) {
      const Vec3 tip = material.place_of(record);
      const bool shown = record.output.in_contact || (tip - session_.header.path.entry).norm() < shown_before_contact;
      if (shown && (points.empty() || (tip - points.back()).norm() >= travel_step)) points.push_back(tip);
    }
    return points;
  }

  void pictures() {
    constexpr double panel_height = 455.0, closest = 80.0, furthest = 260.0, pixels = 620.0;
    constexpr double relief_width = 640.0, relief_height = 420.0;
    const anatomy::NeedlePath& path = session_.header.path;
    if (path.length() <= 0.0 || patient_.ct.empty()) return;
    heading("Where it went");
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
    figure(imaging::slice_picture(panels, patient_.library, "", panel_height),
           "Sagittal and axial slices with the planned path and the path of the tip", true);
    const ProbeFigures probe(session_);
    const ProbePath probe_path = probe.empty() ? ProbePath{} : probe.path(time_of_final_position());
    figure(cut_open_picture(patient_, path, tip, relief_width, relief_height, probe_path),
           probe.empty() ? "The patient in 3-D, cut open along the planned path, with the path of the tip"
                         : "The patient in 3-D, cut open along the planned path, with the path of the tip, the path "
                           "of the ultrasound probe and its slice",
           true);
  }

  // s since the first tick: of the final position, or of the last tick.
  double time_of_final_position() const {
    const std::size_t tick = score_.final_tip ? score_.final_tip->tick : session_.ticks.size() - 1;
    return static_cast<double>(session_.ticks[tick].tick - session_.ticks.front().tick) * session_.header.dt;
  }

  void probe() {
    const ProbeFigures probe(session_);
    if (probe.empty()) return;
    heading("Where the ultrasound probe was");
    remark(probe.sentence(score_));
    if (session_.header.path.length() <= 0.0 || patient_.ct.empty()) return;
    constexpr double panel_height = 455.0;
    std::vector<ProbeFigures::Moment> moments;
    for (const session::SessionEvent& each : session_.events) {
      if (each.event.kind != forces::EventKind::contact) continue;
      const double time = static_cast<double>(each.tick - session_.ticks.front().tick) * session_.header.dt;
      moments.push_back({time, fmt::format("at {:.1f} s, when the needle touched the skin", time)});
      break;
    }
    const double end = time_of_final_position();
    const bool rested = score_.final_tip && score_.final_tip->is_rest;
    moments.push_back({end, fmt::format("at {:.1f} s, {}", end,
                                        rested             ? "when the tip came to rest"
                                        : score_.final_tip ? "when the tip was deepest"
                                                           : "at the end")});
    figure(
        imaging::slice_picture(probe.panels(patient_, moments, travelled()), patient_.library, "", panel_height),
        "The CT in the slice of the ultrasound probe, with the edges of its picture, the planned path and the path "
        "of the tip",
        true);
  }

  void course() {
    heading("Over time");
    figure(draw_plot(force_and_depth_against_time(session_.ticks, session_.header.dt)),
           "Resistance and depth against time");
    figure(draw_plot(energy_against_time(session_.ticks, session_.header.dt)),
           "Energy that the hand has given to the tissue, against time");
  }

  void second_hand() {
    if (session_.second.empty()) return;
    const bool is_plunger = session_.header.second->role == session::SecondRole::plunger;
    heading(is_plunger ? "The second hand: the plunger" : "The second hand: the ultrasound probe");
    figure(draw_plots(second_hand_against_time(session_)),
           is_plunger ? "Pressure in the syringe and force on the thumb against time, with the needle's depth"
                      : "Force of the probe on the skin against time");
  }

  Table::Cell tissue_cell(anatomy::TissueId id) const {
    const anatomy::TissueProperties* properties = patient_.library.find(id);
    return {std::string(patient_.library.title(id)), {}, properties != nullptr ? properties->colour : 0x808080U};
  }

  void tissues() {
    heading("Tissues that the tip was in");
    if (score_.tissues.empty()) {
      nothing("None.");
      return;
    }
    Table table{{{"tissue"},
                 {"from, mm", true},
                 {"to, mm", true},
                 {"time, s", true},
                 {"peak resistance, N", true},
                 {"at, mm", true}},
                {},
                true};
    for (const training::TissueTotal& total : score_.tissues) {
      table.rows.push_back({tissue_cell(total.tissue), number(total.from, 1), number(total.to, 1),
                            number(total.time, 2), number(total.peak_force, 2), number(total.peak_depth, 1)});
    }
    add(std::move(table));
  }

  void distances() {
    if (score_.distances.empty()) return;
    heading("Distances to what must not be entered");
    Table table{{{"what"}, {"least distance, mm", true}, {"at, s", true}, {"depth, mm", true}}, {}, false};
    for (const training::ForbiddenDistance& each : score_.distances) {
      if (each.closest) {
        table.rows.push_back(
            {{each.title}, number(*each.closest, 1), number(each.time, 1), number(std::max(0.0, each.depth), 1)});
      } else {
        table.rows.push_back({{each.title}, {"over 100"}, {}, {}});
      }
    }
    add(std::move(table));
  }

  void events() {
    heading("Events");
    if (session_.events.empty()) {
      nothing("None.");
      return;
    }
    Table table{{{"time, s", true}, {"depth, mm", true}, {"what happened"}, {"tissue"}}, {}, false};
    const std::size_t rows = std::min(session_.events.size(), most_events);
    for (std::size_t i = 0; i < rows; ++i) {
      const session::SessionEvent& event = session_.events[i];
      const bool has_tissue = event.event.tissue != anatomy::tissue::air;
      table.rows.push_back({number(static_cast<double>(event.tick) * session_.header.dt, 3),
                            number(event.event.depth, 1),
                            {event_text(event.event, patient_.library)},
                            has_tissue ? tissue_cell(event.event.tissue) : Table::Cell{}});
    }
    add(std::move(table));
    if (rows < session_.events.size())
      nothing(fmt::format("{} more events are in the session file.", session_.events.size() - rows));
  }

  void provenance() {
    const session::SessionHeader& header = session_.header;
    heading("Recording and settings");
    Facts facts;
    const auto row = [&](const char* what, std::string value) { facts.facts.push_back({what, std::move(value)}); };
    row("case", header.case_folder);
    row("digest of the case", header.case_digest);
    const io::ForceTexts forces = io::force_texts(header.haptics);
    row("resistance", forces.resistance);
    row("constraint", forces.constraint);
    for (const std::string& part : forces.parts) row("with the part", part);
    row("operator", header.operator_name);
    if (!header.operator_settings.empty())
      facts.facts.push_back({"its settings", "all that makes this operator", indented(header.operator_settings)});
    if (header.second) {
      row("second hand", fmt::format("{} {}", session::name_of(header.second->role), header.second->device));
    }
    if (!header.moving_body.empty()) row("moving body", header.moving_body);
    row("seed", std::to_string(header.seed));
    row("recorded", header.started_at);
    row("length", fmt::format("{} ticks of {:g} ms", session_.ticks.size(), 1000.0 * header.dt));
    if (session_.timings) {
      const session::SessionTimings& timings = *session_.timings;
      row("timing of the ticks",
          fmt::format("{} of {} ticks late; lateness {}; a tick took {}", timings.overruns,
                      session::count_of(timings.compute), spread(timings.lateness), spread(timings.compute)));
    }
    row("complete", session_.finished ? "yes" : "no, the recording broke off; this is what was saved");
    row("Bodkin", header.bodkin_version);
    add(std::move(facts));
  }

  const session::Session& session_;
  const anatomy::Case& patient_;
  const training::Score& score_;
  bool case_changed_;
  PlottedDepth depth_;
  Document document_;
};

}  // namespace

Document report_document(const session::Session& session, const anatomy::Case& patient, const training::Score& score,
                         bool case_changed, PlottedDepth depth) {
  return ReportWriter(session, patient, score, case_changed, depth).write();
}

std::string report_html(const session::Session& session, const anatomy::Case& patient, const training::Score& score,
                        bool case_changed) {
  return html_of(report_document(session, patient, score, case_changed));
}

}  // namespace bodkin::report
