#include "cli/new_case_options.h"

#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "anatomy/case.h"
#include "anatomy/needle.h"
#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/json_values.h"
#include "core/error.h"
#include "core/parameter_value.h"
#include "io/force_choice.h"
#include "io/image_worker.h"
#include "training/planning_rules.h"
#include "training/procedure_file.h"

namespace bodkin::cli {
namespace {

using nlohmann::json;

constexpr std::size_t longest_name = 200;  // characters; case.xml allows no more
constexpr double furthest = 1e5;           // mm

json checked_point(const std::string& text, const std::string& option) {
  const Vec3 point = parse_point(text, option);
  if (point.cwiseAbs().maxCoeff() > furthest) {
    throw InputError(fmt::format("{} is {}; expected coordinates within {:g} mm", option, text, furthest));
  }
  return json_point(point);
}

// The worker's planning rules.
void say_rules(const patient::PlanningRules& rules, json& request) {
  json avoid = json::array();
  for (const patient::AvoidRule& rule : rules.avoid) {
    avoid.push_back(
        {{"tissue", rule.tissue}, {"structure", rule.structure}, {"title", rule.title}, {"margin_mm", rule.margin}});
  }
  request["avoid"] = avoid;
  request["levels"] = rules.levels;
}

void say_summary(const json& result, const Console& console, const std::string& folder) {
  const auto numbers = [&](const char* key) { return result.at(key).get<std::array<double, 3>>(); };
  const auto size = result.at("size").get<std::array<int, 3>>();
  const auto spacing = numbers("spacing_mm"), tissue = numbers("tissue_spacing_mm");
  console.line(fmt::format("{} is ready: {}", folder, result.value("name", "")));
  console.line(fmt::format("  CT        {} x {} x {} voxels of {:.4g} x {:.4g} x {:.4g} mm, axes {}", size[0],
                           size[1], size[2], spacing[0], spacing[1], spacing[2], result.value("axes", "")));
  console.line(fmt::format("  tissues   voxels of {:.3g} x {:.3g} x {:.3g} mm, {} labelled structures", tissue[0],
                           tissue[1], tissue[2], result.value("structures", 0)));
  for (const json& amount : result.at("tissues")) {
    console.line(fmt::format("    {:<24} {:>10.1f} ml", amount.value("tissue", ""), amount.value("volume_ml", 0.0)));
  }
  if (result.contains("path")) {
    const auto entry = result["path"].at("entry_mm").get<std::array<double, 3>>();
    const auto target = result["path"].at("target_mm").get<std::array<double, 3>>();
    console.line(fmt::format(
        "  path      from ({:.1f}, {:.1f}, {:.1f}) to ({:.1f}, {:.1f}, {:.1f}) mm, {:.1f} mm long", entry[0],
        entry[1], entry[2], target[0], target[1], target[2], result["path"].value("length_mm", 0.0)));
  } else {
    console.line("  path      none was planned; the notes say why. Give --target, or what the notes ask for");
  }
  console.line(forces_line(result.value("mechanics", "") == "physical" ? anatomy::Mechanics::physical
                                                                       : anatomy::Mechanics::tables));
  console.line(fmt::format("Next: bodkin case show {0}, bodkin profile {0}", folder));
}

}  // namespace

std::string forces_line(anatomy::Mechanics mechanics) {
  return mechanics == anatomy::Mechanics::physical ? "  forces    physical: the needle's, for every model"
                                                   : "  forces    tables: each model's own, whatever the needle";
}

void add_new_case_options(CLI::App& command, NewCaseOptions& options) {
  add_text(command, "DIR", options.folder, "Folder of the case; it must not exist yet").required();
  add_text(command, "--name", options.name, "Name of the patient (default: the folder's)");
  add_text(command, "--entry", options.entry, "Where the planned path enters the skin: x,y,z in LPS mm");
  add_text(command, "--target", options.target,
           "Where the needle's tip should end: x,y,z in LPS mm, or the name of a structure (its middle); without "
           "--entry the best path is planned");
  options.gauge =
      add_whole_number(command, "--needle-gauge", options.needle_gauge, anatomy::gauge_sizes().front().gauge,
                       anatomy::gauge_sizes().back().gauge,
                       "Gauge of a Quincke needle of 90 mm, 10 to 34 (default: the procedure's needle, or 22)");
  options.needle_option = add_text(
      command, "--needle", options.needle,
      "The whole needle: GAUGE,LENGTH,TIP, such as 18,90,tuohy; tips are quincke, whitacre, tuohy, chiba, trephine, "
      "filiform, sprotte, diamond, conical");
  add_text(command, "--mechanics", options.mechanics,
           "Source of the force models' tissue values: tables (each model has its own) or physical (one description "
           "of each tissue, for the needle) (default: physical)");
  add_texts(command, "--part", options.parts,
            fmt::format("An addition to the force along the needle, \"NAME SETTING=VALUE ...\", may be repeated: {}",
                        fmt::join(io::part_names, ", ")));
  add_text(command, "--force-in-organs", options.force_in_organs,
           "Force while the tip is in a critical structure, an organ or a lung: felt (as the models compute it) or "
           "none (the force falls to zero) (default: felt)");
  add_text(command, "--procedure", options.procedure,
           "What is practised: a procedure that comes with Bodkin (default: lumbar_puncture where there is a lumbar "
           "spine)");
  add_switch(command, "--overwrite", options.overwrite, "Replace a case that is already there");
}

json new_case_request(const NewCaseOptions& options) {
  if (options.name.size() > longest_name) {
    throw InputError(fmt::format("--name has {} characters; expected at most {}", options.name.size(), longest_name));
  }
  if (!anatomy::gauge_size(static_cast<int>(options.needle_gauge))) {
    throw InputError(fmt::format("--needle-gauge is {}; expected {} to {}", options.needle_gauge,
                                 anatomy::gauge_sizes().front().gauge, anatomy::gauge_sizes().back().gauge));
  }
  if (!options.entry.empty() && options.target.empty())
    throw InputError("--target is missing: a path needs both --entry and --target");
  const bool is_point = options.target.find(',') != std::string::npos;
  if (!options.entry.empty() && !is_point) {
    throw InputError(fmt::format(
        "--target is '{}'; expected three numbers x,y,z with --entry; without --entry the path is planned",
        options.target));
  }
  json request = {{"folder", io::path_text(options.folder)},
                  {"overwrite", options.overwrite},
                  {"name", io::path_text(options.name)},
                  {"needle_gauge", options.needle_gauge}};
  if (!options.needle.empty()) request["needle"] = options.needle;
  if (!options.mechanics.empty()) {
    anatomy::Mechanics mechanics{};
    if (!parse_value(options.mechanics, mechanics))
      throw InputError(fmt::format("--mechanics is '{}'; expected tables or physical", options.mechanics));
    request["mechanics"] = options.mechanics;
  }
  if (!options.parts.empty()) {
    io::parse_parts(options.parts, "--part");
    request["parts"] = options.parts;
  }
  if (!options.force_in_organs.empty()) {
    anatomy::ForceInOrgans value{};
    if (!parse_value(options.force_in_organs, value))
      throw InputError(fmt::format("--force-in-organs is '{}'; expected felt or none", options.force_in_organs));
    request["force_in_organs"] = options.force_in_organs;
  }
  const bool plans = !options.target.empty() && options.entry.empty();
  if (!options.procedure.empty() || plans) {
    const training::Procedure procedure =
        training::find_shipped_procedure(options.procedure.empty() ? "needle_insertion" : options.procedure);
    say_rules(training::planning_rules(procedure), request);
    request["procedure"] = procedure.name;
    if (!procedure.needle.empty() && !options.needle_is_given()) request["needle"] = procedure.needle;
    for (const training::Goal& goal : procedure.goals)
      if (!goal.tissue.empty()) request["target_tissue"] = goal.tissue;
  }
  if (plans) {
    if (is_point) {
      request["target"] = checked_point(options.target, "--target");
    } else {
      request["target_structure"] = options.target;
    }
  }
  if (!options.entry.empty()) {
    request["entry"] = checked_point(options.entry, "--entry");
    request["target"] = checked_point(options.target, "--target");
    if (request["entry"] == request["target"]) {
      throw InputError(fmt::format("--entry and --target are both {}; expected two points", options.entry));
    }
  }
  return request;
}

void make_case(const std::string& verb, const json& request, const std::string& subject,
               const CommandContext& context) {
  Console console(context);
  const io::WorkerReport report = io::run_image_worker(verb, request.dump(), subject, console.progress());
  console.clear_bar();
  for (const std::string& note : report.notes) console.note(note);
  json result = json::parse(report.result);
  const std::string folder = request.at("folder");
  result["folder"] = folder;
  result["mechanics"] = request.value("mechanics", value_text(anatomy::Mechanics::physical));
  say_summary(result, console, folder);
  console.json(result.dump(-1, ' ', false, json::error_handler_t::replace));
}

}  // namespace bodkin::cli
