#include "study/compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include "patient/planning/needle_choice.h"
#include "patient/prepared_body.h"
#include "report/compare_plot.h"
#include "report/crossings.h"
#include "study/straight_motion.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/json_values.h"
#include "core/error.h"
#include "core/files.h"
#include "core/parameter_value.h"
#include "forces/needle_law.h"
#include "io/case_folder.h"
#include "io/force_choice.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

struct CompareArguments {
  std::string folder;
  std::string entry, target;
  std::string output;
  std::vector<std::string> models, parts;
  std::string constraint, needle, mechanics, motion, depth = "hand";
  double withdraw_speed = 0.0;
  Argument withdraw_speed_given, pause_given;
  bool no_reinsert = false;
  study::CompareOptions options;
};

constexpr const char* compare_footer = R"(Examples:
  bodkin compare patient                                         every model along the planned path
  bodkin compare patient --models layered,tracking_wall,fracture
  bodkin compare patient --entry 0,95,3 --target 2,45,10 --speed 5 --pause 1 -o out/models
  bodkin compare patient --models "tracking_wall,tracking_wall catch_up_s=0.1,tracking_wall catch_up_s=2"
  bodkin compare patient --models volume_proxy --constraint rail --no-reinsert
  bodkin compare patient --needle 16G,90,tuohy                   with another needle than the case's
  bodkin compare patient --mechanics tables                      with each model's own tissue values
  bodkin compare patient --motion "25 at 10, hold 2, 10 at 20, 45 at 5, hold 1, out"

The models are compared on one description of each tissue, for the case's needle, whatever mechanics the case says.
Each model makes the same motion: in at constant speed, a stop, out, and in again, or the steps of --motion: depths
below the skin in mm, 'target' or 'out', each with 'at' a speed in mm/s, and 'hold' with a time in s. Writes BASE.csv (a row per tick, a
column per model) and BASE.svg (force over depth and over time).
A path that starts with a minus sign needs an equals sign: --entry=-5,95,3)";

nlohmann::json json_of(const study::ModelRun& run, const study::Comparison& comparison,
                       const anatomy::TissueLibrary& library) {
  nlohmann::json work, punctures;
  for (std::size_t phase = 0; phase < study::motion_phases; ++phase) {
    work[std::string(study::phase_names[phase])] = run.work[phase];
    punctures[std::string(study::phase_names[phase])] = run.punctures[phase];
  }
  nlohmann::json peak = nullptr;
  if (run.peak > 0.0) {
    peak = {{"force_N", run.peak},
            {"depth_mm", comparison.depth[run.peak_tick]},
            {"time_s", static_cast<double>(run.peak_tick) * comparison.dt},
            {"tissue", library.title(run.peak_tissue)}};
  }
  nlohmann::json events = nlohmann::json::array();
  for (const study::ReportedEvent& each : run.events)
    events.push_back({{"depth_mm", each.event.depth}, {"text", report::event_text(each.event, library)}});
  return {{"model", run.name},
          {"told", events},
          {"peak", peak},
          {"peak_of_reinsertion_N", run.peak_again},
          {"lowest_N", run.lowest},
          {"end_of_stop_N", run.end_of_stop},
          {"work_N_mm", work},
          {"closed_work_N_mm", comparison.closed > 0 ? nlohmann::json(run.closed_work) : nlohmann::json(nullptr)},
          {"punctures", punctures},
          {"largest_difference_N", run.largest_difference},
          {"rms_difference_N", run.rms_difference},
          {"tick_on_this_machine_ns", run.nanoseconds}};
}

// "22G quincke, 0.72 mm".
std::string words_of(const anatomy::Needle& needle) {
  const std::string gauge = needle.gauge > 0 ? fmt::format("{}G ", needle.gauge) : std::string();
  return fmt::format("{}{}, {:.2f} mm", gauge, value_text(needle.tip), needle.outer_diameter);
}

std::string words_of(anatomy::Mechanics mechanics, const anatomy::Needle& needle) {
  if (mechanics == anatomy::Mechanics::tables)
    return "Mechanics: tables, each model with its own tissue values, whatever the needle.";
  return fmt::format("Mechanics: physical, one description of each tissue for all models, for the needle {}.",
                     words_of(needle));
}

// Titles, in order, of the punctured tissues on the way without a physical description: there each model keeps its
// own numbers.
std::vector<std::string> undescribed(const study::Comparison& comparison, const anatomy::TissueLibrary& library) {
  std::vector<std::string> titles;
  for (const anatomy::TissueId id : comparison.tissue) {
    const anatomy::TissueProperties* const tissue = library.find(id);
    if (tissue == nullptr || tissue->layered.kind != anatomy::LayeredKind::viscoelastic) continue;
    if (forces::is_described(tissue->physical)) continue;
    if (std::find(titles.begin(), titles.end(), tissue->title) == titles.end()) titles.push_back(tissue->title);
  }
  return titles;
}

nlohmann::json json_of(const study::Comparison& comparison, const anatomy::TissueLibrary& library) {
  nlohmann::json result;
  result["entry_mm"] = json_point(comparison.path.entry);
  result["target_mm"] = json_point(comparison.path.target);
  result["speed_mm_s"] = comparison.options.speed;
  result["constraint"] = comparison.constraint;
  result["deepest_mm"] = *std::max_element(comparison.depth.begin(), comparison.depth.end());
  result["ends_in_bone"] = comparison.ends_in_bone.has_value();
  result["reference"] = comparison.models[comparison.reference].name;
  for (std::size_t part = 0; part < comparison.parts.size(); ++part) {
    const std::size_t end = comparison.first[part + 1];
    result["phases"].push_back({{"phase", study::phase_names[static_cast<std::size_t>(comparison.parts[part])]},
                                {"from_s", static_cast<double>(comparison.first[part]) * comparison.dt},
                                {"to_s", static_cast<double>(end) * comparison.dt},
                                {"to_mm", comparison.depth[end - 1]}});
  }
  for (const study::ModelRun& run : comparison.models) result["models"].push_back(json_of(run, comparison, library));
  result["refused"] = nlohmann::json::array();
  for (const study::ModelRefused& model : comparison.refused)
    result["refused"].push_back({{"model", model.name}, {"reason", model.reason}});
  result["notes"] = comparison.notes;
  return result;
}

// A number with two digits behind the point, and no minus before zero.
std::string two_digits(double value) {
  return fmt::format("{:.2f}", std::abs(value) < 0.005 ? 0.0 : value);
}

void print_tables(const Console& console, const study::Comparison& comparison,
                  const anatomy::TissueLibrary& library) {
  std::size_t name_width = 22;
  for (const study::ModelRun& run : comparison.models) name_width = std::max(name_width, run.name.size());
  const auto row = [&](const auto&... cells) {
    const std::array<std::string, sizeof...(cells)> texts = {cells...};
    std::string text = fmt::format("{:<{}}", texts[0], name_width);
    for (std::size_t i = 1; i < texts.size(); ++i) text += fmt::format(" {:>11}", texts[i]);
    return text;
  };
  console.line(row("N", "peak", "end of", "peak of", "lowest", "largest", "RMS"));
  console.line(row("", "", "stop", "re-insert.", "", "difference", "difference") + "   where the peak is");
  for (const study::ModelRun& run : comparison.models) {
    const std::string place =
        run.peak > 0.0 ? fmt::format("{:.1f} mm, {}", comparison.depth[run.peak_tick], library.title(run.peak_tissue))
                       : "-";
    console.line(row(run.name, two_digits(run.peak), two_digits(run.end_of_stop), two_digits(run.peak_again),
                     two_digits(run.lowest), two_digits(run.largest_difference), two_digits(run.rms_difference)) +
                 "   " + place);
  }
  console.line("");
  console.line(row("N mm of work taken from", "", "", "", "", "punctures", ""));
  console.line(row("the hand", "insertion", "withdrawal", "in and out", "re-insert.", "in, again", "ns a tick *"));
  for (const study::ModelRun& run : comparison.models) {
    console.line(row(run.name, two_digits(run.work[0]), two_digits(run.work[2]),
                     comparison.closed > 0 ? two_digits(run.closed_work) : std::string("-"), two_digits(run.work[3]),
                     fmt::format("{}, {}", run.punctures[0], run.punctures[3]),
                     fmt::format("{:.0f}", run.nanoseconds)));
  }
  console.line("\nPunctures during the insertion, in order, with the depth of the tip in mm");
  for (const study::ModelRun& run : comparison.models) {
    std::string names;
    for (const auto& [tick, event] : run.events) {
      const bool is_loss = event.kind == forces::EventKind::loss_of_resistance;
      names += fmt::format("{}{} {:.1f}", names.empty() ? "" : ", ",
                           is_loss ? "loss of resistance" : library.title(event.tissue), event.depth);
    }
    console.line(fmt::format("{:<{}} {}", run.name, name_width, names.empty() ? "nothing" : names));
  }
  console.line(fmt::format("\nDifferences are from {}. * processor time on this machine.",
                           comparison.models[comparison.reference].name));
}

void run_compare(const CompareArguments& arguments, const CommandContext& context) {
  Console console(context);
  study::CompareOptions options = arguments.options;
  if (!arguments.entry.empty()) options.entry = parse_point(arguments.entry, "--entry");
  if (!arguments.target.empty()) options.target = parse_point(arguments.target, "--target");
  if (arguments.withdraw_speed_given.given()) options.withdraw_speed = arguments.withdraw_speed;
  if (!arguments.constraint.empty()) options.constraint = io::parse_constraint(arguments.constraint, "--constraint");
  if (!arguments.parts.empty()) options.parts = io::parse_parts(arguments.parts, "--part");
  options.reinsert = !arguments.no_reinsert;
  anatomy::Mechanics mechanics = anatomy::Mechanics::physical;
  if (!arguments.mechanics.empty() && !parse_value(arguments.mechanics, mechanics))
    throw InputError(fmt::format("--mechanics is '{}'; expected tables or physical", arguments.mechanics));
  const report::PlottedDepth depth = report::parse_plotted_depth(arguments.depth, "--depth");
  if (!arguments.motion.empty()) {
    options.motion = study::parse_motion(arguments.motion, "--motion");
    const char* const other = arguments.withdraw_speed_given.given() ? "--withdraw-speed"
                              : arguments.pause_given.given()        ? "--pause"
                              : arguments.no_reinsert                ? "--no-reinsert"
                                                                     : nullptr;
    if (other != nullptr) throw InputError(fmt::format("--motion already states every step; leave out {}", other));
  }
  const bool all = std::find(arguments.models.begin(), arguments.models.end(), "all") != arguments.models.end();

  const std::string base = arguments.output.empty() ? "compare" : arguments.output;
  for (const char* ending : {".csv", ".svg"}) require_writable(base + ending, "--output");
  anatomy::Case patient = io::load_case(arguments.folder, console.progress());
  if (!arguments.needle.empty()) patient.description.needle = patient::parse_needle(arguments.needle);
  patient.description.haptics.mechanics = mechanics;
  options.models =
      study::models_of(all ? std::vector<std::string>{} : arguments.models, patient.description.haptics.resistance);
  const anatomy::TissueLibrary library = patient.library;
  const std::string name = patient.description.name;
  const double peak_force = patient.description.device.peak_force;
  const std::string felt = words_of(mechanics, patient.description.needle);
  const study::Comparison comparison =
      study::compare_models(std::move(patient), options, console.progress(), [&](anatomy::Case& with) {
        patient::prepare_body(with, arguments.folder, study::straight_path(with, options.entry, options.target).path,
                              console.progress(), [&](const std::string& text) { console.note(text); });
      });
  for (const std::string& note : comparison.notes) console.note(note);
  if (mechanics == anatomy::Mechanics::physical) {
    const std::vector<std::string> own = undescribed(comparison, library);
    if (!own.empty())
      console.note(fmt::format("the tissue library does not describe {}: each model keeps its own numbers there",
                               fmt::join(own, ", ")));
  }
  for (const study::ModelRefused& model : comparison.refused)
    console.note(fmt::format("{} is left out: {}", model.name, model.reason));

  std::vector<report::Plot> plots = report::comparison_plots(comparison, library, peak_force, depth);
  plots[0].title = fmt::format("{}, {}, {} constraint", name,
                               arguments.motion.empty() ? fmt::format("{:g} mm/s", options.speed) : arguments.motion,
                               comparison.constraint);
  const std::string picture =
      report::draw_plots(plots).svg();  // before any file is written: a failure leaves no files

  write_file(base + ".csv", study::comparison_csv(comparison));
  write_file(base + ".svg", picture);
  console.line(felt + "\n");
  print_tables(console, comparison, library);
  console.line(fmt::format("\n{}\n{}", fs::absolute(base + ".svg").string(), fs::absolute(base + ".csv").string()));
  nlohmann::json result = json_of(comparison, library);
  result["mechanics"] = value_text(mechanics);
  result["csv"] = fs::absolute(base + ".csv").string();
  result["svg"] = fs::absolute(base + ".svg").string();
  console.json(result.dump(2));
}

}  // namespace

void add_compare_command(CLI::App& app, CommandContext& context) {
  add_command(
      app, "compare", "One motion through every force model: figures, table and plot", compare_footer,
      [&context](CLI::App& command) {
        auto arguments = std::make_shared<CompareArguments>();
        study::CompareOptions& options = arguments->options;
        add_text(command, "CASE", arguments->folder, "Folder of the case").required();
        add_text(command, "--entry", arguments->entry,
                 "Where the path begins, x,y,z in LPS mm (default: as planned)");
        add_text(command, "--target", arguments->target, "Where it ends, x,y,z in LPS mm (default: as planned)");
        add_texts(command, "--models", arguments->models,
                  fmt::format("All of them, or some of {}; or NAME SETTING=VALUE ... (default: all)",
                              fmt::join(study::compared_names(), ", ")))
            .separated_by_commas("NAME,NAME,...");
        add_text(command, "--needle", arguments->needle,
                 "Needle to use instead of the case's: GAUGE,LENGTH,TIP, such as 16G,90,tuohy");
        add_text(command, "--mechanics", arguments->mechanics,
                 "Source of the models' tissue values: physical (one description of each tissue, for the needle) or "
                 "tables "
                 "(each model has its own) (default: physical)");
        add_text(command, "--constraint", arguments->constraint,
                 "Constraint that keeps the needle on its path, instead of the case's: \"NAME SETTING=VALUE ...\"");
        add_texts(command, "--part", arguments->parts,
                  "Part to add to every resistance, may be repeated; \"none\" leaves out the case's parts");
        add_number(command, "--speed", options.speed, 0.5, 500.0, "mm/s inwards, 0.5 to 500");
        arguments->withdraw_speed_given = add_number(command, "--withdraw-speed", arguments->withdraw_speed, 0.5,
                                                     500.0, "mm/s outwards, 0.5 to 500 (default: as --speed)");
        arguments->withdraw_speed_given.without_default();
        arguments->pause_given =
            add_number(command, "--pause", options.pause, 0.0, 60.0, "s at the deepest point, 0 to 60");
        add_switch(command, "--no-reinsert", arguments->no_reinsert, "End with the withdrawal");
        add_text(command, "--motion", arguments->motion,
                 "Steps of a motion, such as \"25 at 10, hold 2, 10, 45 at 5, out\": mm below the skin, target or "
                 "out, each "
                 "'at' mm/s (default: --speed), and 'hold' s");
        add_text(
            command, "--depth", arguments->depth,
            "Depth axis of the plot: hand (depth of the tip) or material (depth at rest of the tissue at the tip, in "
            "each model) (default: hand)");
        add_text(command, "-o,--output", arguments->output, "BASE of BASE.csv and BASE.svg (default: compare)");
        on_run(command, [arguments, &context] { run_compare(*arguments, context); });
      });
}

}  // namespace bodkin::cli
