#include "report/report.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "report/session_summary.h"
#include "session/case_digest.h"
#include "session/session_file.h"
#include "session/session_run.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/json_values.h"
#include "core/error.h"
#include "core/files.h"
#include "io/case_folder.h"
#include "io/run_program.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

struct ReportArguments {
  std::string session;
  std::string folder;
  std::string output;
  bool open = false;
};

constexpr const char* report_footer = R"(Examples:
  bodkin report session.bodkin                       writes session.html beside it
  bodkin report session.bodkin -o report.html --open
  bodkin report session.bodkin --case moved/patient  when the case is not where it was recorded)";

nlohmann::json optional_json(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

nlohmann::json json_of(const report::SessionSummary& summary, const report::Verdict& verdict,
                       const anatomy::TissueLibrary& library) {
  nlohmann::json result = {{"headline", verdict.headline},
                           {"remarks", verdict.remarks},
                           {"reached", verdict.reached},
                           {"duration_s", summary.duration},
                           {"time_in_body_s", summary.time_in_body},
                           {"time_to_target_s", optional_json(summary.time_to_target)},
                           {"target_tissue_at_s", optional_json(summary.target_tissue_time)},
                           {"insertions", summary.insertions},
                           {"redirections", summary.redirections},
                           {"path_length_mm", summary.path_length},
                           {"deviation_rms_mm", summary.deviation_rms},
                           {"deviation_max_mm", summary.deviation_max},
                           {"angle_at_contact_deg", summary.angle_at_contact},
                           {"angle_at_end_deg", summary.angle_at_end},
                           {"deepest_mm", summary.deepest},
                           {"peak_force_N", summary.peak_force},
                           {"peak_depth_mm", summary.peak_depth},
                           {"peak_tissue", library.title(summary.peak_tissue)},
                           {"work_N_mm", summary.work},
                           {"final_tip_mm", json_point(summary.final_tip)},
                           {"final_distance_mm", summary.final_error.distance},
                           {"final_axial_mm", summary.final_error.axial},
                           {"final_lateral_mm", summary.final_error.lateral},
                           {"closest_distance_mm", summary.closest_distance},
                           {"bone_contacts", summary.bone_contacts},
                           {"losses_of_resistance", summary.losses_of_resistance},
                           {"interventions", summary.interventions},
                           {"limited_time_s", summary.limited_time}};
  result["critical"] = nlohmann::json::array();
  for (const report::CriticalEntry& entry : summary.critical) {
    result["critical"].push_back({{"structure", entry.structure},
                                  {"first_time_s", entry.time},
                                  {"first_depth_mm", entry.depth},
                                  {"time_inside_s", entry.time_inside},
                                  {"entries", entry.entries}});
  }
  result["tissues"] = nlohmann::json::array();
  for (const report::TissueTotal& total : summary.tissues) {
    result["tissues"].push_back({{"tissue", library.title(total.tissue)},
                                 {"from_mm", total.from},
                                 {"to_mm", total.to},
                                 {"time_s", total.time},
                                 {"peak_force_N", total.peak_force},
                                 {"peak_depth_mm", total.peak_depth}});
  }
  return result;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

bool has_display() {
  const auto given = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return given("DISPLAY") || given("WAYLAND_DISPLAY");
}

void run_report(const ReportArguments& arguments, const CommandContext& context) {
  Console console(context);
  const fs::path file =
      arguments.output.empty() ? fs::path(arguments.session).replace_extension(".html") : fs::path(arguments.output);
  require_writable(file, "--output", arguments.session);
  const session::Session session = session::read_session(arguments.session);
  const fs::path folder =
      arguments.folder.empty() ? fs::path(session.header.case_folder) : fs::path(arguments.folder);
  if (!fs::exists(folder / "case.xml")) {
    throw InputError(
        fmt::format("{} was recorded on the case {}, which holds no case.xml now; name the case with --case DIR",
                    arguments.session, folder.string()));
  }
  const anatomy::Case patient = io::load_case(folder, console.progress());
  const bool changed = !session::is_digest_of_case(session.header.case_digest, patient, text_of(folder / "case.xml"),
                                                   session::mesh_digest(folder, session.header.haptics.resistance));
  if (changed) console.note("the case has changed since the recording; slices and tissues show what it is now");
  const report::SessionSummary summary = report::summarise(session, patient);
  const report::Verdict verdict = report::judge(summary, session, patient);
  const std::string html = report::report_html(session, patient, summary, changed);

  write_file(file, html);
  console.line(verdict.headline);
  for (const std::string& remark : verdict.remarks) console.line("  " + remark);
  console.line(fs::absolute(file).string());
  nlohmann::json result = json_of(summary, verdict, patient.library);
  result["resistance"] = anatomy::name_of(session.header.haptics.resistance);
  result["constraint"] = anatomy::name_of(session.header.haptics.constraint);
  result["report"] = fs::absolute(file).string();
  console.json(result.dump(2));
  if (!arguments.open) return;
  if (!has_display()) {
    console.note("there is no display to open the report on");
    return;
  }
  const io::ProgramResult opened = io::run_program({"xdg-open", fs::absolute(file).string()}, "", "xdg-utils");
  if (opened.exit_code != 0) console.note("no program here opens HTML pages; open the report by its path");
}

}  // namespace

void add_report_command(CLI::App& app, CommandContext& context) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command = add_command(app, "report", "What happened in a session, as one HTML file", report_footer);
  add_text(*command, "SESSION", arguments->session, "File of the session").required();
  add_text(*command, "--case", arguments->folder, "Folder of the case (default: where it was recorded)");
  add_text(*command, "-o,--output", arguments->output, "The report (default: beside the session, ending .html)");
  add_switch(*command, "--open", arguments->open, "Open the report when there is a display");
  on_run(*command, [arguments, &context] { run_report(*arguments, context); });
}

}  // namespace bodkin::cli
