#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "report/learning_plot.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "core/error.h"
#include "core/files.h"
#include "io/resources.h"
#include "io/xml_document.h"
#include "training/recorded_score.h"
#include "training/store/cohort_table.h"
#include "training/store/outbox.h"
#include "training/store/plan_attempts.h"
#include "training/store/results_csv.h"
#include "training/store/store_place.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct ResultsArguments {
  std::string store;
  std::vector<std::string> sessions;
  std::string trainee;
  std::string procedure;
  std::string folder;
  std::string plan;
  std::string from;
  bool owns = false;
  std::string output;
};
using Arguments = std::shared_ptr<ResultsArguments>;

constexpr const char* results_footer = R"(Examples:
  bodkin results add session.bodkin --trainee trainee-07   judges a session and keeps the result
  bodkin results list                                      every trainee at every procedure
  bodkin results show trainee-07 -o curve.svg              the attempts of a trainee, and the learning curve
  bodkin results csv -o results.csv                        one row for each attempt, for statistics
  bodkin results list --store postgresql://station@server/bodkin

Results are kept in results.sqlite in your data folder; --store, or the environment variable BODKIN_STORE, names another
file or a PostgreSQL server. docs/results.md explains all of it.)";

std::string percent_row(const training::CohortRow& row) {
  return fmt::format("{:<24} {:<20} {:>8} {:>7} {:>10} {:>6} {:>9} {:>6.0f}  {:<7} {}", row.trainee, row.procedure,
                     row.attempts, row.passed, row.borderline, row.failed, row.dangerous, row.score,
                     row.mastery ? "yes" : "no", row.last_at.substr(0, 10));
}

void note_waiting(Console& console, const training::Outbox& outbox) {
  const std::int64_t waiting = outbox.waiting();
  if (waiting > 0)
    console.note(fmt::format(
        "attempts of this station that wait for the store: {}; 'bodkin results deliver' tries again", waiting));
  for (const training::PendingAttempts& other : outbox.waiting_elsewhere()) {
    console.note(
        fmt::format("attempts of this station that wait for another store, {}: {}; 'bodkin results deliver --store' "
                    "with its address tries again",
                    other.store, other.attempts));
  }
}

void run_add(const ResultsArguments& arguments, const CommandContext& context) {
  Console console(context);
  training::check_label(arguments.trainee, "--trainee");
  std::optional<training::PlanInUse> plan;
  if (!arguments.plan.empty()) plan = training::read_plan_in_use(arguments.plan);
  // All are scored before the first is stored.
  std::vector<training::AttemptRecord> records;
  for (const std::string& file : arguments.sessions) {
    const training::RecordedScore judged =
        training::score_recording(file, arguments.procedure, arguments.folder, console.progress());
    console.clear_bar();
    if (!judged.missing.empty()) console.note(judged.missing);
    records.push_back(training::record_of(judged.session, judged.description.name, judged.score));
    records.back().trainee = arguments.trainee;
    records.back().owns_file = arguments.owns;
    records.back().file = fs::absolute(file).lexically_normal().string();
  }
  const std::string place = training::store_place(arguments.store);
  training::Outbox outbox(place, training::outbox_folder());
  if (plan) outbox.put_in_plan(*plan, records);
  ordered_json all = ordered_json::array();
  for (std::size_t i = 0; i < records.size(); ++i) {
    using State = training::Delivery::State;
    const training::Delivery delivery = outbox.add(records[i]);
    if (delivery.delivered > 0)
      console.note(fmt::format("attempts that had waited and were delivered: {}", delivery.delivered));
    if (delivery.state == State::waiting) console.note(delivery.reason);
    const char* const state = delivery.state == State::stored  ? "stored"
                              : delivery.state == State::known ? "known before"
                                                               : "waits for the store";
    console.line(fmt::format("{:<40} {:<11} {:>4.0f}  {}", records[i].file, training::name_of(records[i].verdict),
                             records[i].score, state));
    all.push_back({{"session", records[i].file},
                   {"digest", records[i].digest},
                   {"trainee", records[i].trainee},
                   {"procedure", records[i].procedure},
                   {"verdict", training::name_of(records[i].verdict)},
                   {"score", records[i].score},
                   {"plan", records[i].plan},
                   {"stage", records[i].stage},
                   {"state", state}});
  }
  console.json(all.dump(2));
}

void run_list(const ResultsArguments& arguments, const CommandContext& context) {
  Console console(context);
  const std::string place = training::store_place(arguments.store);
  training::ResultStore store(place);
  const std::vector<training::CohortRow> rows = training::cohort_table(store.summaries());
  console.line(fmt::format("{:<24} {:<20} {:>8} {:>7} {:>10} {:>6} {:>9} {:>6}  {:<7} {}", "trainee", "procedure",
                           "attempts", "passed", "borderline", "failed", "dangerous", "score", "mastery", "last"));
  ordered_json all = ordered_json::array();
  for (const training::CohortRow& row : rows) {
    console.line(percent_row(row));
    all.push_back({{"trainee", row.trainee},
                   {"procedure", row.procedure},
                   {"attempts", row.attempts},
                   {"passed", row.passed},
                   {"borderline", row.borderline},
                   {"failed", row.failed},
                   {"dangerous", row.dangerous},
                   {"passed_last_in_a_row", row.last_in_a_row},
                   {"recent_score", row.score},
                   {"mastery", row.mastery},
                   {"last_at", row.last_at}});
  }
  note_waiting(console, training::Outbox(place, training::outbox_folder()));
  console.json(ordered_json{{"store", store.place()}, {"rows", all}}.dump(2));
}

void require_trainee(training::ResultStore& store, const std::string& label) {
  const std::vector<std::string> labels = store.trainees();
  if (std::find(labels.begin(), labels.end(), label) != labels.end()) return;
  throw InputError(fmt::format("the store {} has no trainee {}; 'bodkin results list' names them", store.place(),
                               io::in_quotes(label)));
}

void write_curve(training::ResultStore& store, const ResultsArguments& arguments) {
  const auto attempts = store.summaries(arguments.trainee, arguments.procedure);
  if (attempts.empty() || attempts.front().procedure != attempts.back().procedure) {
    throw InputError(fmt::format("a learning curve is of one procedure, and {} has {}; name one with --procedure",
                                 arguments.trainee, attempts.empty() ? "no attempt at this one" : "several"));
  }
  write_file(arguments.output, report::draw_learning_curve(attempts).svg());
}

void run_show(const ResultsArguments& arguments, const CommandContext& context) {
  Console console(context);
  if (!arguments.output.empty()) require_writable(arguments.output, "--output");
  training::ResultStore store(training::store_place(arguments.store));
  require_trainee(store, arguments.trainee);
  if (!arguments.output.empty()) write_curve(store, arguments);
  ordered_json all = ordered_json::array();
  for (const training::AttemptRecord& each : store.attempts(arguments.trainee)) {
    if (!arguments.procedure.empty() && each.procedure != arguments.procedure) continue;
    console.line(fmt::format("{}  {:<20} {:<11} {:>4.0f}  {}", each.started_at, each.procedure,
                             training::name_of(each.verdict), each.score, each.headline));
    all.push_back({{"digest", each.digest},
                   {"procedure", each.procedure},
                   {"started_at", each.started_at},
                   {"duration_s", each.duration},
                   {"station", each.station},
                   {"verdict", training::name_of(each.verdict)},
                   {"reached", each.reached},
                   {"score", each.score},
                   {"headline", each.headline},
                   {"plan", each.plan},
                   {"stage", each.stage},
                   {"metrics", ordered_json::parse(training::metrics_json(each))},
                   {"findings", ordered_json::parse(training::findings_json(each))},
                   {"session", each.file}});
  }
  console.json(ordered_json{{"trainee", arguments.trainee}, {"attempts", all}}.dump(2));
}

void run_csv(const ResultsArguments& arguments, const CommandContext& context) {
  Console console(context);
  require_writable(arguments.output, "--output");
  training::ResultStore store(training::store_place(arguments.store));
  if (!arguments.trainee.empty()) require_trainee(store, arguments.trainee);
  const std::vector<training::AttemptRecord> attempts = store.attempts(arguments.trainee);
  write_file(arguments.output, training::results_csv(attempts));
  const std::string file = fs::absolute(arguments.output).lexically_normal().string();
  console.line(fmt::format("{} attempts: {}", attempts.size(), file));
  console.json(ordered_json{{"attempts", attempts.size()}, {"table", file}}.dump(2));
}

void run_delete(const ResultsArguments& arguments, const CommandContext& context) {
  Console console(context);
  const std::string place = training::store_place(arguments.store);
  training::Outbox outbox(place, training::outbox_folder());
  training::ResultStore store(place);
  const std::int64_t waited = outbox.remove_trainee(arguments.trainee).attempts;
  training::Deletion done;
  try {
    done = store.remove_trainee(arguments.trainee);
  } catch (const InputError&) {
    if (waited == 0) throw;  // nothing of that name here or there
  }
  console.line(fmt::format("deleted of {}: attempts {}, session files {}", arguments.trainee, done.attempts + waited,
                           done.deleted_files.size()));
  for (const std::string& file : done.other_files)
    console.note(fmt::format("a session file is still to be deleted by hand: {}", file));
  for (const training::PendingAttempts& other : outbox.waiting_elsewhere()) {
    console.note(
        fmt::format("attempts of this station that wait for another store, {}: {}; what {} has there is deleted with "
                    "--store and its address",
                    other.store, other.attempts, arguments.trainee));
  }
  console.json(ordered_json{{"attempts", done.attempts + waited},
                            {"deleted_files", done.deleted_files.size()},
                            {"remaining_files", done.other_files}}
                   .dump(2));
}

void run_deliver(const ResultsArguments& arguments, const CommandContext& context) {
  Console console(context);
  training::Outbox outbox(training::store_place(arguments.store), training::outbox_folder());
  const std::int64_t delivered = arguments.from.empty() ? outbox.deliver() : outbox.take_over(arguments.from);
  note_waiting(console, outbox);
  console.line(fmt::format("attempts delivered: {}", delivered));
  console.json(ordered_json{{"delivered", delivered}}.dump(2));
}

// A command of the group with the common options.
CLI::App* add_one(CLI::App& group, CommandContext& context, const Arguments& arguments, const std::string& name,
                  const std::string& help, void (*work)(const ResultsArguments&, const CommandContext&)) {
  CLI::App* command = add_command(group, name, help, results_footer);
  add_text(*command, "--store", arguments->store, "File or postgresql:// address of the store");
  on_run(*command, [arguments, &context, work] { work(*arguments, context); });
  return command;
}

}  // namespace

void add_results_command(CLI::App& app, CommandContext& context) {
  CLI::App* group = add_command(app, "results", "Results of trainees: keep, list, show, delete", results_footer);
  need_command(*group);
  const auto fresh = [] { return std::make_shared<ResultsArguments>(); };

  Arguments add = fresh();
  CLI::App* command = add_one(*group, context, add, "add", "Score sessions and keep the results", run_add);
  add_texts(*command, "SESSION", add->sessions, "Files of sessions").required();
  add_text(*command, "--trainee", add->trainee, "Label of the trainee, not a name: trainee-07").required();
  add_text(*command, "--procedure", add->procedure, "Name or file of a procedure (default: the case's)");
  add_text(*command, "--plan", add->plan, "Plan that the attempts belong to, a file or a name");
  add_switch(*command, "--own", add->owns, "Deleting the trainee deletes the session files too");
  add_text(*command, "--case", add->folder, "Folder of the case (default: where it was recorded)");

  add_one(*group, context, fresh(), "list", "Every trainee at every procedure", run_list);

  Arguments show = fresh();
  command = add_one(*group, context, show, "show", "The attempts of a trainee, and the learning curve", run_show);
  add_text(*command, "TRAINEE", show->trainee, "Label of the trainee").required();
  add_text(*command, "--procedure", show->procedure, "Only attempts at this one");
  add_text(*command, "-o,--output", show->output, "Learning curve with CUSUM, an SVG picture");

  Arguments csv = fresh();
  csv->output = "results.csv";
  command = add_one(*group, context, csv, "csv", "A table of attempts, for statistics", run_csv);
  add_text(*command, "--trainee", csv->trainee, "Only attempts of this one");
  add_text(*command, "-o,--output", csv->output, "The table (default: results.csv); it is replaced");

  Arguments gone = fresh();
  command = add_one(*group, context, gone, "delete", "Delete all data of a trainee, permanently", run_delete);
  add_text(*command, "TRAINEE", gone->trainee, "Label of the trainee").required();

  Arguments deliver = fresh();
  command = add_one(*group, context, deliver, "deliver",
                    "Deliver the results that wait on this station for the store", run_deliver);
  add_text(*command, "--from", deliver->from,
           "Former address of a store that has moved: results that wait for it go to this store");
}

}  // namespace bodkin::cli
