#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "patient/meshing/mesh_record.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "core/error.h"
#include "fem/solid/mesh_soundness.h"
#include "io/case_folder.h"

namespace bodkin::cli {

namespace {

constexpr const char* examples =
    R"(Checks that case.xml fits its schema, that every file is there, undamaged and the one the
case was made with, that the volumes cover the same region, that every label and tissue is
known, that the planned path leads from the skin to its target, and that the mesh, if there is
one, is valid. Lists everything that is wrong.

Examples:
  bodkin case check patient
  bodkin --json case check patient        {"case": ..., "sound": ..., "problems": [...]}

Exit code: 0 if the case is valid, 2 if it is not.)";

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

// Checks the mesh for the deformable body, if the case has one; empty also if its description cannot be read.
std::vector<std::string> mesh_problems(const std::string& folder) {
  anatomy::TissueLibrary library;
  try {
    library = io::read_case_library(folder, io::read_case_description(folder));
  } catch (const InputError&) {
    return {};
  }
  try {
    const std::optional<patient::CaseMesh> found = patient::read_case_mesh(folder, library);
    if (!found) return {};
    try {
      fem::check_mesh(found->mesh);
    } catch (const InputError& error) {
      return {fmt::format("{}: {}", patient::mesh_file_name, error.what())};
    }
  } catch (const InputError& error) {
    return {error.what()};
  }
  if (patient::case_mesh_is_ours(folder)) return {};
  std::error_code problem;
  const std::filesystem::path record = std::filesystem::path(folder) / patient::mesh_record_name;
  if (!std::filesystem::exists(record, problem)) return {};  // a mesh of the user's own
  return {
      fmt::format("{} is not the mesh that {} was written with: it was changed or damaged since; make it again "
                  "with: bodkin case mesh {} --force, or remove {} if the mesh is your own",
                  patient::mesh_file_name, patient::mesh_record_name, folder, patient::mesh_record_name)};
}

void check(const std::string& folder, CommandContext& context) {
  Console console(context);
  std::vector<std::string> problems = io::check_case(folder, console.progress());
  for (std::string& problem : mesh_problems(folder)) problems.push_back(std::move(problem));
  console.clear_bar();
  console.json(nlohmann::json{{"case", folder}, {"sound", problems.empty()}, {"problems", problems}}.dump(
      2, ' ', false, nlohmann::json::error_handler_t::replace));
  if (problems.empty()) {
    console.line(fmt::format("{} is valid: {}", folder, summary(io::read_case_description(folder))));
    return;
  }
  for (const std::string& problem : problems) console.line(problem);
  console.line(
      fmt::format("{} is not valid: {} problem{}", folder, problems.size(), problems.size() == 1 ? "" : "s"));
  context.exit_code = 2;
}

}  // namespace

void add_case_check_command(CLI::App& case_group, CommandContext& context) {
  add_command(case_group, "check", "Find everything that is wrong with a case folder", examples,
              [&context](CLI::App& command) {
                auto folder = std::make_shared<std::string>();
                add_text(command, "CASE", *folder, "Folder of the case").required();
                on_run(command, [folder, &context] { check(*folder, context); });
              });
}

}  // namespace bodkin::cli
