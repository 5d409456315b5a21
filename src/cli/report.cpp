#include "report/report.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "report/document_html.h"
#include "report/document_pdf.h"
#include "report/force_limits.h"
#include "report/recorded_report.h"
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
#include "training/expert_table.h"
#include "training/procedure_file.h"
#include "training/recorded_score.h"
#include "training/score_json.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

struct ReportArguments {
  std::string session;
  std::string folder;
  std::string output;
  std::string procedure;
  std::string experts, depth = "hand";
  bool open = false;
};

constexpr const char* report_footer = R"(Examples:
  bodkin report session.bodkin                       writes session.html next to it
  bodkin report session.bodkin -o report.html --open
  bodkin report session.bodkin -o report.pdf         pages of A4, to print or to keep
  bodkin report session.bodkin --case moved/patient  if the case folder was moved)";

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
  const bool is_pdf = file.extension() == ".pdf";
  require_writable(file, "--output", arguments.session);
  if (!is_pdf && file.extension() != ".html" && file.extension() != ".htm") {
    throw InputError(fmt::format("the report {} has the ending '{}', expected .html or .pdf", file.string(),
                                 file.extension().string()));
  }
  const report::PlottedDepth depth = report::parse_plotted_depth(arguments.depth, "--depth");
  const session::Session session = training::read_attempt(arguments.session);
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
  if (changed) console.note("the case has changed since the recording; slices and tissues show its present state");
  const anatomy::CaseDescription description = training::description_of(session);
  const training::Procedure procedure = arguments.procedure.empty()
                                            ? training::procedure_of_case(description.procedure.name)
                                            : training::find_procedure(arguments.procedure);
  const auto experts =
      arguments.experts.empty() ? training::experts_of(procedure) : training::ExpertSet::read(arguments.experts);
  const training::Score score =
      report::score_for_report(session, patient, changed, procedure, experts ? &*experts : nullptr);
  const report::Document document = report::report_document(session, patient, score, changed, depth);

  write_file(file, is_pdf ? report::pdf_of(document) : report::html_of(document));
  console.line(score.headline);
  for (const training::Finding& each : score.findings) console.line("  " + each.sentence);
  console.line(fs::absolute(file).string());
  nlohmann::ordered_json result;
  result["resistance"] = anatomy::name_of(session.header.haptics.resistance);
  result["constraint"] = anatomy::name_of(session.header.haptics.constraint);
  const report::ForceLimits limits = report::force_limits(session);
  result["interventions"] = limits.interventions;
  result["limited_time_s"] = limits.time;
  result["report"] = fs::absolute(file).string();
  const training::Attempt attempt(session, description, procedure.thresholds);
  result["score"] = nlohmann::ordered_json::parse(training::score_json(score, attempt, arguments.session));
  console.json(result.dump(2));
  if (!arguments.open) return;
  if (!has_display()) {
    console.note("there is no display to open the report on");
    return;
  }
  const io::ProgramResult opened = io::run_program({"xdg-open", fs::absolute(file).string()}, "", "xdg-utils");
  if (opened.exit_code != 0) console.note("no program here opens such files; open the report by its path");
}

}  // namespace

void add_report_command(CLI::App& app, CommandContext& context) {
  add_command(
      app, "report", "What happened in a session, as one HTML or PDF file", report_footer,
      [&context](CLI::App& command) {
        auto arguments = std::make_shared<ReportArguments>();
        add_text(command, "SESSION", arguments->session, "File of the session").required();
        add_text(command, "--case", arguments->folder, "Folder of the case (default: where it was recorded)");
        add_text(command, "-o,--output", arguments->output,
                 "The report, ending .html or .pdf (default: next to the session, ending .html)");
        add_text(command, "--procedure", arguments->procedure, "Name or file of a procedure (default: the case's)");
        add_text(command, "--experts", arguments->experts, "Table of attempts of experts to compare with");
        add_text(
            command, "--depth", arguments->depth,
            "Depth axis of the force plot: hand (depth of the tip) or material (depth at rest of the tissue at the "
            "tip) (default: hand)");
        add_switch(command, "--open", arguments->open, "Open the report when there is a display");
        on_run(command, [arguments, &context] { run_report(*arguments, context); });
      });
}

}  // namespace bodkin::cli
