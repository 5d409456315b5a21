#include <algorithm>
#include <memory>

#include "patient/planning/path_search.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/json_values.h"
#include "core/error.h"
#include "io/case_folder.h"
#include "io/case_soundness.h"
#include "training/planning_rules.h"
#include "training/procedure_file.h"

namespace bodkin::cli {

namespace {

using nlohmann::json;

constexpr const char* plan_examples =
    R"(Lists straight paths from the skin to the target, the best first, which keep a margin to bone, to whatever
the procedure of the case forbids, and to every structure that the case marks as critical.

Examples:
  bodkin case plan patient                              other paths to the target of the case
  bodkin case plan patient --target liver_lesion        to the middle of a structure
  bodkin case plan patient --target 12,-80,240 --save 1 the best one becomes the path of the case
  bodkin --json case plan patient                       with the clearance to every structure in 30 mm

Exit code: 0 if there is a path, 2 for bad input, 3 if there is no path; the output says why.)";

struct CasePlanOptions {
  std::string folder, target, procedure;
  std::int64_t count = 6, save = 0;
};

Vec3 target_of(const CasePlanOptions& options, const anatomy::Case& patient) {
  if (options.target.empty()) {
    if (patient.description.procedure.path) return patient.description.procedure.path->target;
    throw InputError(
        fmt::format("{} has no target yet; give one with --target, a point x,y,z or a structure", options.folder));
  }
  if (options.target.find(',') != std::string::npos) return parse_point(options.target, "--target");
  return patient::target_in_structure(patient::view_of(patient), options.target);
}

std::string crossed(const anatomy::Case& patient, const patient::PathReport& report) {
  std::string text, last;
  for (const patient::Crossed& each : report.crosses) {
    const std::string title = patient.library.title(each.tissue);
    if (title != last) text += (text.empty() ? "" : ", ") + title;
    last = title;
  }
  return text;
}

json report_json(const anatomy::Case& patient, const patient::Obstacles& obstacles,
                 const patient::PathReport& report) {
  json near = json::array(), crosses = json::array();
  for (const patient::Clearance& each : report.near) {
    const patient::Obstacle& kind = obstacles.kinds[each.kind];
    near.push_back({{"name", kind.name}, {"clearance_mm", each.distance}, {"margin_mm", kind.margin}});
  }
  for (const patient::Crossed& each : report.crosses) {
    crosses.push_back({{"tissue", patient.library.title(each.tissue)}, {"from_mm", each.from}, {"to_mm", each.to}});
  }
  return {{"entry_mm", json_point(report.path.entry)},
          {"target_mm", json_point(report.path.target)},
          {"length_mm", report.path.length()},
          {"cranial_deg", report.cranial},
          {"left_deg", report.lateral},
          {"nearest", near},
          {"crosses", crosses}};
}

void plan(const CasePlanOptions& options, CommandContext& context) {
  Console console(context);
  anatomy::Case patient = io::load_case(options.folder, console.progress());
  console.clear_bar();
  const std::string& named = patient.description.procedure.name;
  const training::Procedure procedure =
      options.procedure.empty() ? training::procedure_of_case(named) : training::find_procedure(options.procedure);
  const patient::PlanningRules rules = training::planning_rules(procedure);
  const patient::PatientView view = patient::view_of(patient);
  const Vec3 target = target_of(options, patient);
  patient::PathCriteria criteria = patient::criteria_for(patient.description.needle, rules);
  criteria.count = static_cast<std::size_t>(options.count);
  const patient::Obstacles obstacles = patient::find_obstacles(view, rules, target);
  patient::PathSearch search;
  if (const auto problem = patient::level_problem(view, rules, target)) {
    search.why_not = fmt::format("No path is planned there for {}: {}.", procedure.title, *problem);
  } else {
    search = patient::search_paths(view, obstacles, target, criteria);
  }
  json paths = json::array();
  for (const patient::PathReport& each : search.proposals) paths.push_back(report_json(patient, obstacles, each));
  json result = {
      {"case", options.folder}, {"procedure", procedure.name}, {"target_mm", json_point(target)}, {"paths", paths}};
  if (search.proposals.empty()) {
    result["why_none"] = search.why_not;
    console.json(result.dump(2, ' ', false, json::error_handler_t::replace));
    console.line(search.why_not);
    context.exit_code = 3;
    return;
  }
  if (options.save > 0) {
    if (static_cast<std::size_t>(options.save) > search.proposals.size()) {
      throw InputError(fmt::format("--save is {}, but there are {} paths", options.save, search.proposals.size()));
    }
    const anatomy::NeedlePath& chosen = search.proposals[static_cast<std::size_t>(options.save - 1)].path;
    const std::vector<std::string> problems = io::path_problems(patient, chosen);
    if (!problems.empty()) throw InputError(fmt::format("the path is not saved: {}", problems.front()));
    patient.description.procedure.path = chosen;
    io::write_case_description(patient.description, options.folder);
    result["saved"] = options.save;
  }
  console.json(result.dump(2, ' ', false, json::error_handler_t::replace));
  console.line(fmt::format("Paths to ({:.1f}, {:.1f}, {:.1f}) mm, {} directions tried; angles in degrees", target.x(),
                           target.y(), target.z(), search.looked_at));
  console.line(fmt::format("{:>3} {:>8} {:>8} {:>6}  {:<26} {:<46} {}", "", "length", "cranial", "left", "entry, mm",
                           "nearest", "crosses"));
  for (std::size_t i = 0; i < search.proposals.size(); ++i) {
    const patient::PathReport& each = search.proposals[i];
    const Vec3& entry = each.path.entry;
    console.line(fmt::format("{:>3} {:>5.1f} mm {:>8.1f} {:>6.1f}  {:<26} {:<46} {}", i + 1, each.path.length(),
                             each.cranial, each.lateral,
                             fmt::format("({:.1f}, {:.1f}, {:.1f})", entry.x(), entry.y(), entry.z()),
                             patient::nearest_text(obstacles, each, 2), crossed(patient, each)));
  }
  if (options.save > 0) console.line(fmt::format("Path {} is the path of {} now.", options.save, options.folder));
}

}  // namespace

void add_case_plan_command(CLI::App& case_group, CommandContext& context) {
  add_command(case_group, "plan", "List the best straight paths to a target, and what they keep clear of",
              plan_examples, [&context](CLI::App& command) {
                const auto options = std::make_shared<CasePlanOptions>();
                add_text(command, "CASE", options->folder, "Folder of the case").required();
                add_text(
                    command, "--target", options->target,
                    "x,y,z in LPS mm, or the name of a structure (its middle) (default: the target of the case)");
                add_text(command, "--procedure", options->procedure,
                         "Procedure that says what to keep clear of: a name or a file (default: that of the case)");
                add_whole_number(command, "--count", options->count, 1, 20, "How many paths, 1 to 20");
                add_whole_number(command, "--save", options->save, 1, 20,
                                 "Number of the path to save as the path of the case")
                    .without_default();
                on_run(command, [options, &context] { plan(*options, context); });
              });
}

}  // namespace bodkin::cli
