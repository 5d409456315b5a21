#include "study/profile.h"

#include <filesystem>
#include <memory>

#include "patient/prepared_body.h"
#include "report/crossings.h"
#include "report/diagnostic_plot.h"
#include "report/force_plot.h"
#include "report/material_depth.h"
#include "report/motion_plot.h"
#include "study/straight_motion.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/force_options.h"
#include "cli/json_values.h"
#include "core/error.h"
#include "core/files.h"
#include "io/case_folder.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

struct ProfileArguments {
  std::string folder;
  std::string entry, target;
  std::string output, motion, depth = "hand";
  Argument beyond_given, pause_given;
  study::ProfileOptions options;
  bool deformation = false;
  ForceOptions forces;
};

constexpr const char* profile_footer = R"(Examples:
  bodkin profile patient                                         along the planned path
  bodkin profile patient --entry 0,95,3 --target 2,45,10         along another one
  bodkin profile patient --speed 2 --pause 1 --withdraw -o out/slow
  bodkin profile patient --resistance "tracking_wall catch_up_s=0.3" --constraint "rail torsion_N_mm_per_rad=500"
  bodkin profile patient --resistance tracking_wall --motion "25 at 10, hold 2, 10 at 20, 45 at 5, hold 1, out"
  bodkin profile patient --resistance embedded_needle --deformation              with a figure of the deformed tissue

Writes BASE.csv (a row per tick) and BASE.svg (force against depth with the tissues as bands;
below it what the force models publish, such as the position of the tracking wall; with a rest, a
withdrawal or --motion also position, wall and force over time).
Steps of --motion: depths below the skin in mm, 'target' or 'out', each with 'at' a speed in mm/s, and
'hold' with a time in s.
A path that starts with a minus sign needs an equals sign: --entry=-5,95,3)";

nlohmann::json json_of(const study::Profile& profile, const std::vector<report::TissueCrossing>& crossings,
                       const std::vector<session::SessionEvent>& events, const anatomy::TissueLibrary& library) {
  nlohmann::json result;
  result["entry_mm"] = json_point(profile.path.entry);
  result["target_mm"] = json_point(profile.path.target);
  result["speed_mm_s"] = profile.options.speed;
  result["tissues"] = nlohmann::json::array();
  for (const report::TissueCrossing& crossing : crossings) {
    result["tissues"].push_back({{"tissue", library.title(crossing.tissue)},
                                 {"from_mm", crossing.from},
                                 {"to_mm", crossing.to},
                                 {"peak_force_N", crossing.peak_force},
                                 {"peak_depth_mm", crossing.peak_depth}});
  }
  result["events"] = nlohmann::json::array();
  for (const session::SessionEvent& event : events) {
    result["events"].push_back({{"time_s", static_cast<double>(event.tick) * profile.dt},
                                {"depth_mm", event.event.depth},
                                {"text", report::event_text(event.event, library)},
                                {"tissue", library.title(event.event.tissue)},
                                {"value_N", event.event.value}});
  }
  result["stopped_by_bone_mm"] =
      profile.stopped_by_bone ? nlohmann::json(*profile.stopped_by_bone) : nlohmann::json(nullptr);
  result["outcome"] = profile.outcome;
  result["duration_s"] = static_cast<double>(profile.ticks.size() - 1) * profile.dt;
  result["notes"] = profile.notes;
  return result;
}

void print_table(const Console& console, const std::vector<report::TissueCrossing>& crossings,
                 const std::vector<session::SessionEvent>& events, const anatomy::TissueLibrary& library) {
  console.line(fmt::format("{:<26} {:>8} {:>8} {:>10}   {}", "tissue", "from mm", "to mm", "peak N", "what happens"));
  for (const report::TissueCrossing& crossing : crossings) {
    std::string happened;
    for (const session::SessionEvent& event : events) {
      const bool here = event.event.depth >= crossing.from && event.event.depth < crossing.to;
      if (!here || !report::is_notable(event.event.kind)) continue;
      happened += fmt::format("{}{}", happened.empty() ? "" : "; ", report::event_text(event.event, library));
    }
    console.line(fmt::format("{:<26} {:>8.1f} {:>8.1f} {:>10.2f}   {}", library.title(crossing.tissue), crossing.from,
                             crossing.to, crossing.peak_force, happened));
  }
}

void run_profile(const ProfileArguments& arguments, const CommandContext& context) {
  Console console(context);
  study::ProfileOptions options = arguments.options;
  if (!arguments.entry.empty()) options.entry = parse_point(arguments.entry, "--entry");
  if (!arguments.target.empty()) options.target = parse_point(arguments.target, "--target");
  if (!arguments.motion.empty()) {
    options.motion = study::parse_motion(arguments.motion, "--motion");
    const char* const other = arguments.beyond_given.given()  ? "--beyond"
                              : arguments.pause_given.given() ? "--pause"
                              : options.withdraw              ? "--withdraw"
                                                              : nullptr;
    if (other != nullptr) throw InputError(fmt::format("--motion already states every step; leave out {}", other));
  }
  const std::string base = arguments.output.empty() ? "profile" : arguments.output;
  const report::PlottedDepth depth = report::parse_plotted_depth(arguments.depth, "--depth");
  for (const char* ending : {".csv", ".svg"}) require_writable(base + ending, "--output");
  if (arguments.deformation) require_writable(base + "-deformation.svg", "--output");
  anatomy::Case patient = io::load_case(arguments.folder, console.progress());
  apply(arguments.forces, patient.description.haptics);
  if (arguments.deformation && anatomy::body_of(patient.description.haptics.resistance) == nullptr) {
    throw InputError(fmt::format("--deformation: {} has no deformable body; add --resistance embedded_needle",
                                 anatomy::name_of(patient.description.haptics.resistance)));
  }
  const std::shared_ptr<const fem::BodyDescription> body = patient::prepare_body(
      patient, arguments.folder, study::straight_path(patient, options.entry, options.target).path,
      console.progress(), [&](const std::string& text) { console.note(text); });
  const study::Profile profile = study::insert_at_constant_speed(patient, options, console.progress());
  for (const std::string& note : profile.notes) console.note(note);

  const std::vector<session::SessionEvent> events = report::events_of(profile.ticks);
  const std::vector<report::TissueCrossing> crossings = report::tissues_crossed(profile.ticks, profile.dt);
  std::vector<session::RecordedDiagnostic> published;
  for (const forces::DiagnosticName& one : profile.diagnostics)
    published.push_back({std::string(one.name), std::string(one.title)});
  report::Plot plot;
  if (depth == report::PlottedDepth::material) {
    const report::MaterialDepths inside = report::in_material(profile.ticks, events, published);
    plot = report::force_against_depth(inside.ticks, inside.events, profile.dt, patient);
  } else {
    plot = report::force_against_depth(profile.ticks, events, profile.dt, patient);
  }
  plot.x_label = report::depth_label(depth);
  plot.title = fmt::format("{}, {}, {}", patient.description.name,
                           arguments.motion.empty() ? fmt::format("{:g} mm/s", options.speed) : arguments.motion,
                           anatomy::name_of(patient.description.haptics.resistance));
  std::vector<report::Plot> plots = {plot};
  for (report::Plot& one : report::diagnostics_against_depth(profile.ticks, published))
    plots.push_back(std::move(one));
  if (!options.motion.empty() || options.pause > 0.0 || options.withdraw) {
    for (report::Plot& one : report::profile_against_time(profile, patient.library)) plots.push_back(std::move(one));
  }
  const std::string picture =
      report::draw_plots(plots).svg();  // before any file is written: what fails leaves nothing behind

  std::string deformation;
  if (arguments.deformation && profile.strongest.forces.count > 0)
    deformation = study::deformation_picture(patient, *body, profile.strongest, console.progress()).svg();

  write_file(base + ".csv", study::profile_csv(profile, patient));
  if (!deformation.empty()) write_file(base + "-deformation.svg", deformation);
  write_file(base + ".svg", picture);
  print_table(console, crossings, events, patient.library);
  console.line("\n" + profile.outcome);
  if (!deformation.empty()) console.line("\n" + fs::absolute(base + "-deformation.svg").string());
  console.line(fmt::format("\n{}\n{}", fs::absolute(base + ".svg").string(), fs::absolute(base + ".csv").string()));
  nlohmann::json result = json_of(profile, crossings, events, patient.library);
  result["resistance"] = anatomy::name_of(patient.description.haptics.resistance);
  result["constraint"] = anatomy::name_of(patient.description.haptics.constraint);
  result["csv"] = fs::absolute(base + ".csv").string();
  result["svg"] = fs::absolute(base + ".svg").string();
  if (!deformation.empty()) result["deformation_svg"] = fs::absolute(base + "-deformation.svg").string();
  console.json(result.dump(2));
}

}  // namespace

void add_profile_command(CLI::App& app, CommandContext& context) {
  add_command(
      app, "profile", "Force against depth of a needle driven in at constant speed, or moved step by step",
      profile_footer, [&context](CLI::App& command) {
        auto arguments = std::make_shared<ProfileArguments>();
        add_text(command, "CASE", arguments->folder, "Folder of the case").required();
        add_text(command, "--entry", arguments->entry,
                 "Where the path begins, x,y,z in LPS mm (default: as planned)");
        add_text(command, "--target", arguments->target, "Where it ends, x,y,z in LPS mm (default: as planned)");
        add_number(command, "--speed", arguments->options.speed, 0.5, 500.0, "mm/s, 0.5 to 500");
        arguments->beyond_given =
            add_number(command, "--beyond", arguments->options.beyond, 0.0, 200.0, "mm past the target, 0 to 200");
        arguments->pause_given =
            add_number(command, "--pause", arguments->options.pause, 0.0, 60.0, "s at the deepest point, 0 to 60");
        add_switch(command, "--withdraw", arguments->options.withdraw, "Pull the needle out again at the same speed");
        add_text(command, "--motion", arguments->motion,
                 "Steps of a motion, such as \"25 at 10, hold 2, 10, 45 at 5, out\": mm below the skin, target or "
                 "out, each "
                 "'at' mm/s (default: --speed), and 'hold' s");
        add_text(
            command, "--depth", arguments->depth,
            "Depth axis of the plot: hand (depth of the tip) or material (depth at rest of the tissue at the tip) "
            "(default: hand)");
        add_text(command, "-o,--output", arguments->output, "BASE of BASE.csv and BASE.svg (default: profile)");
        add_switch(command, "--deformation", arguments->deformation,
                   "With a deformable body: also write BASE-deformation.svg, the patient at rest and where it "
                   "resisted most");
        add_force_options(command, arguments->forces);
        on_run(command, [arguments, &context] { run_profile(*arguments, context); });
      });
}

}  // namespace bodkin::cli
