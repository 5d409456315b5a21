#include "training/score.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "session/session_file.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "core/error.h"
#include "core/files.h"
#include "training/expert_table.h"
#include "training/procedure_file.h"
#include "training/recorded_patient.h"
#include "training/recorded_score.h"
#include "training/score_json.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

constexpr int exit_not_passed = 3;

struct ScoreArguments {
  std::vector<std::string> sessions;
  std::string procedure;
  std::string folder;
  std::string experts;
  std::string table;
};

constexpr const char* score_footer = R"(Examples:
  bodkin score session.bodkin                        the verdict, and why
  bodkin score session.bodkin --procedure epidural   by the rules of another procedure than the case's
  bodkin --json score session.bodkin                 every metric, for a program
  bodkin score *.bodkin --csv table.csv              one row for each session

Exit code 0: pass or borderline. 3: one of the attempts failed or was dangerous. docs/training.md explains the verdict
and procedures of your own.)";

// A field of RFC 4180: in quotes if necessary.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char character : text) quoted += character == '"' ? std::string("\"\"") : std::string(1, character);
  return quoted + '"';
}

void print_score(const Console& console, const training::Score& score) {
  console.line(score.headline);
  for (const training::Finding& each : score.findings) {
    console.line(fmt::format("  {:<11} {}", training::name_of(each.grade), each.sentence));
  }
  console.line(fmt::format("\n{:<58} {:>12}  {}", "measure", "value", score.experts > 0 ? "experts" : ""));
  for (const training::MetricResult& each : score.metrics) {
    const std::string grade = each.grade ? std::string(training::name_of(*each.grade)) : std::string();
    const std::string experts = each.experts ? fmt::format("{:.0f} %", each.experts->percentile) : std::string();
    console.line(fmt::format("{:<58} {:>12}  {:<6} {}", each.metric->title,
                             training::metric_text(*each.metric, each.value), experts, grade));
  }
}

void run_score(const ScoreArguments& arguments, CommandContext& context) {
  Console console(context);
  if (!arguments.table.empty()) require_writable(arguments.table, "--csv", arguments.sessions.front());
  std::optional<training::Procedure> chosen;
  if (!arguments.procedure.empty()) chosen = training::find_procedure(arguments.procedure);
  std::optional<training::ExpertSet> given;
  if (!arguments.experts.empty()) given = training::ExpertSet::read(arguments.experts);
  std::string table = "session," + training::score_csv_columns() + "\n";
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const std::string& file : arguments.sessions) {
    const session::Session session = training::read_attempt(file);
    const anatomy::CaseDescription description = training::description_of(session);
    const training::Procedure procedure = chosen ? *chosen : training::procedure_of_case(description.procedure.name);
    if (!chosen && procedure.name != description.procedure.name) {
      console.note(fmt::format("{}: the case names the procedure {}, which Bodkin does not have; judged as {}", file,
                               description.procedure.name, procedure.name));
    }
    const training::RecordedPatient patient =
        training::read_recorded_patient(session, description, arguments.folder, procedure, console.progress());
    console.clear_bar();
    if (!patient.missing.empty()) {
      if (!arguments.folder.empty()) throw InputError(fmt::format("--case: {}", patient.missing));
      console.note(patient.missing);
    }
    const auto experts = given ? given : training::experts_of(procedure);
    const training::Score score =
        training::score(session, description, procedure, patient.volumes(), experts ? &*experts : nullptr);
    if (score.verdict >= training::Grade::fail) context.exit_code = exit_not_passed;
    if (arguments.sessions.size() > 1) {
      console.line(fmt::format("{:<40} {:<11} {}", file, training::name_of(score.verdict), score.headline));
    } else {
      print_score(console, score);
    }
    table += fmt::format("{},{}\n", csv_field(fs::path(file).filename().string()), training::score_csv_fields(score));
    if (context.json) {
      const training::Attempt attempt(session, description, procedure.thresholds);
      all.push_back(nlohmann::ordered_json::parse(training::score_json(score, attempt, file)));
    }
  }
  if (!arguments.table.empty()) write_file(arguments.table, table);
  console.json(all.size() == 1 ? all.front().dump(2) : all.dump(2));
}

}  // namespace

void add_score_command(CLI::App& app, CommandContext& context) {
  add_command(app, "score", "How good an attempt was, by the rules of its procedure", score_footer,
              [&context](CLI::App& command) {
                auto arguments = std::make_shared<ScoreArguments>();
                add_texts(command, "SESSION", arguments->sessions, "Files of sessions").required();
                add_text(command, "--procedure", arguments->procedure,
                         "Name or file of a procedure (default: the case's)");
                add_text(command, "--case", arguments->folder,
                         "Folder of the case (default: the patient that the session keeps)");
                add_text(command, "--experts", arguments->experts, "Table of attempts of experts to compare with");
                add_text(command, "--csv", arguments->table, "Table to write, a row for each session");
                on_run(command, [arguments, &context] { run_score(*arguments, context); });
              });
}

}  // namespace bodkin::cli
