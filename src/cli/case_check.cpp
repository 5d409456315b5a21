#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "io/case_folder.h"

namespace bodkin::cli {

namespace {

constexpr const char* examples =
    R"(Checks that case.xml fits its schema, that every file is there, undamaged and the one the
case was made with, that the volumes lie on each other, that every label and tissue is known,
and that the planned path leads from the skin to its aim. Says everything that is wrong.

Examples:
  bodkin case check patient
  bodkin --json case check patient        {"case": ..., "sound": ..., "problems": [...]}

Exit code: 0 sound, 2 not.)";

std::string summary(const anatomy::CaseDescription& description) {
  std::string text =
      fmt::format("'{}', {}", description.name,
                  description.structures_file.empty() ? "no segmentation"
                                                      : fmt::format("{} structures", description.structures.size()));
  text += fmt::format(", {}G {} needle of {} mm", description.needle.gauge,
                      anatomy::to_string(description.needle.tip), description.needle.length);
  if (description.procedure.path) {
    text += fmt::format(", {} along {:.1f} mm", description.procedure.name, description.procedure.path->length());
  }
  return text;
}

void check(const std::string& folder, CommandContext& context) {
  Console console(context);
  const std::vector<std::string> problems = io::check_case(folder, console.progress());
  console.clear_bar();
  console.json(nlohmann::json{{"case", folder}, {"sound", problems.empty()}, {"problems", problems}}.dump(
      2, ' ', false, nlohmann::json::error_handler_t::replace));
  if (problems.empty()) {
    console.line(fmt::format("{} is sound: {}", folder, summary(io::read_case_description(folder))));
    return;
  }
  for (const std::string& problem : problems) console.line(problem);
  console.line(
      fmt::format("{} is not sound: {} problem{}", folder, problems.size(), problems.size() == 1 ? "" : "s"));
  context.exit_code = 2;
}

}  // namespace

void add_case_check_command(CLI::App& case_group, CommandContext& context) {
  CLI::App* command = add_command(case_group, "check", "Find everything that is wrong with a case folder", examples);
  auto folder = std::make_shared<std::string>();
  add_text(*command, "CASE", *folder, "Folder of the case").required();
  on_run(*command, [folder, &context] { check(*folder, context); });
}

}  // namespace bodkin::cli
