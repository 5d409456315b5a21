#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "core/error.h"
#include "training/expert_table.h"
#include "training/procedure_file.h"
#include "training/recorded_score.h"
#include "training/store/attempt_record.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct ExpertsArguments {
  std::vector<std::string> sessions;
  std::string procedure;
  std::string folder;
};

constexpr const char* experts_footer = R"(Examples:
  bodkin experts import expert_*.bodkin      sessions of experts, each at the procedure that its case names
  bodkin experts list                        the experts for comparison, by procedure
  bodkin experts delete lumbar_puncture      compare with the simulated experts again

Imported experts are kept in your data folder, and take the place of the simulated ones in score, report, the teacher's
page and the window. docs/training.md explains the comparison.)";

void import_experts(const ExpertsArguments& arguments, const CommandContext& context) {
  Console console(context);
  std::map<std::string, std::vector<training::ExpertAttempt>> by_procedure;
  int left_out = 0;
  for (const std::string& file : arguments.sessions) {
    training::RecordedScore recorded =
        training::score_recording(file, arguments.procedure, arguments.folder, console.progress());
    console.clear_bar();
    if (!recorded.missing.empty()) console.note(fmt::format("{}: {}", file, recorded.missing));
    training::Score& score = recorded.score;
    if (score.verdict >= training::Grade::fail) {
      ++left_out;
      console.note(fmt::format("{} is left out, because its verdict is {}: {}", file,
                               training::name_of(score.verdict), score.headline));
      continue;
    }
    const std::string procedure = score.procedure;
    by_procedure[procedure].push_back({training::session_digest(recorded.session), std::move(score)});
  }
  if (by_procedure.empty())
    throw InputError("there is no attempt to import, expected at least one that passed or is borderline");
  ordered_json all = ordered_json::array();
  for (const auto& [procedure, attempts] : by_procedure) {
    const fs::path file = training::own_expert_file(procedure);
    const training::ExpertsAdded result = training::add_experts(file, attempts);
    console.line(fmt::format("{}: {} added, {} known before, {} in {}", procedure, result.added, result.known,
                             result.attempts, file.string()));
    constexpr std::size_t fewest = 5;  // as ExpertSet compares
    if (result.attempts < fewest)
      console.note(fmt::format("{}: attempts are compared with experts once there are {} attempts of experts",
                               procedure, fewest));
    all.push_back({{"procedure", procedure},
                   {"added", result.added},
                   {"known", result.known},
                   {"attempts", result.attempts},
                   {"file", file.string()}});
  }
  if (left_out > 0) console.line(fmt::format("{} left out, because they failed or were dangerous", left_out));
  console.json(all.dump(2));
}

void list_experts(const CommandContext& context) {
  const Console console(context);
  ordered_json all = ordered_json::array();
  console.line(fmt::format("{:<28} {:>8}  {}", "procedure", "attempts", "experts"));
  for (const std::string& procedure : training::shipped_procedures()) {
    std::error_code error;
    const bool own = fs::is_regular_file(training::own_expert_file(procedure), error);
    const auto experts = training::experts_of(training::find_shipped_procedure(procedure));
    const std::size_t attempts = experts ? experts->size() : 0;
    const std::string who = own ? "imported: " + experts->origin() : experts ? "simulated, with Bodkin" : "none";
    console.line(fmt::format("{:<28} {:>8}  {}", procedure, attempts, who));
    all.push_back({{"procedure", procedure}, {"attempts", attempts}, {"imported", own}});
  }
  console.json(all.dump(2));
}

void delete_experts(const ExpertsArguments& arguments, const CommandContext& context) {
  const Console console(context);
  const fs::path file = training::own_expert_file(training::find_procedure(arguments.procedure).name);
  std::error_code error;
  if (!fs::remove(file, error)) {
    if (error) throw SystemError(fmt::format("{} cannot be deleted: {}", file.string(), error.message()));
    throw InputError(
        fmt::format("no experts were imported for {}: there is no {}", arguments.procedure, file.string()));
  }
  console.line(fmt::format("{} is deleted", file.string()));
  console.json(ordered_json{{"deleted", file.string()}}.dump(2));
}

}  // namespace

void add_experts_command(CLI::App& app, CommandContext& context) {
  CLI::App* group =
      add_command(app, "experts", "Experts to compare with: import sessions, list, delete", experts_footer);
  need_command(*group);
  const auto arguments = std::make_shared<ExpertsArguments>();
  CLI::App* import = add_command(*group, "import",
                                 "Import sessions of experts, with which attempts are then compared", experts_footer);
  add_texts(*import, "SESSION", arguments->sessions, "Files of sessions").required();
  add_text(*import, "--procedure", arguments->procedure, "Name or file of a procedure (default: the case's)");
  add_text(*import, "--case", arguments->folder, "Folder of the case (default: where it was recorded)");
  on_run(*import, [arguments, &context] { import_experts(*arguments, context); });
  CLI::App* list = add_command(*group, "list", "List the experts with whom attempts are compared", experts_footer);
  on_run(*list, [&context] { list_experts(context); });
  CLI::App* remove = add_command(*group, "delete", "Forget the imported experts at a procedure", experts_footer);
  add_text(*remove, "PROCEDURE", arguments->procedure, "Name of the procedure").required();
  on_run(*remove, [arguments, &context] { delete_experts(*arguments, context); });
}

}  // namespace bodkin::cli
