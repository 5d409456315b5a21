#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "patient/planning/needle_choice.h"
#include "patient/shoulder/shoulder_case.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/new_case_options.h"
#include "core/error.h"
#include "core/parameter_value.h"
#include "training/procedure_file.h"

namespace bodkin::cli {
namespace {

struct CaseSynthesizeShoulderOptions {
  std::string folder, name, side = "right", target = "joint", needle, mechanics, procedure;
  bool overwrite = false, vary = false;
  std::int64_t seed = 1;
  // A parameter with its option; --vary draws the ones not given.
  struct Choice {
    double patient::ShoulderParameters::*member;
    double value;
    Argument option;
  };
  std::vector<Choice> choices;
  Argument side_option;
};

constexpr const char* case_synthesize_shoulder_footer = R"(Examples:
  bodkin case synthesize shoulder patient
  bodkin case synthesize shoulder stout --weight 105 --height 1.70 --side left
  bodkin case synthesize shoulder dry --fluid 3 --age 70
  bodkin case synthesize shoulder block --target suprascapular_nerve
  bodkin case synthesize shoulder patient_7 --vary --seed 7      another person for every seed

The planned path is the posterior approach: 2 cm below and 1 cm medial of the posterolateral corner of the acromion,
towards the coracoid. With --target suprascapular_nerve it goes from behind and above to a place next to that nerve,
for an ultrasound-guided nerve block. docs/synthetic-shoulder.md says what is in it and where the numbers come from.)";

patient::BodySide side_of(const std::string& text) {
  if (text == "left") return patient::BodySide::left;
  if (text == "right") return patient::BodySide::right;
  throw InputError(fmt::format("--side is '{}'; expected left or right", text));
}

patient::ShoulderTarget target_of(const std::string& text) {
  if (text == "joint") return patient::ShoulderTarget::joint;
  if (text == "suprascapular_nerve") return patient::ShoulderTarget::suprascapular_nerve;
  throw InputError(fmt::format("--target is '{}'; expected joint or suprascapular_nerve", text));
}

void run_case_synthesize_shoulder(const CaseSynthesizeShoulderOptions& options, const CommandContext& context) {
  Console console(context);
  const patient::ShoulderVariant drawn = patient::draw_shoulder(static_cast<std::uint64_t>(options.seed));
  patient::ShoulderCase wanted;
  wanted.folder = options.folder;
  wanted.overwrite = options.overwrite;
  wanted.name = options.name;
  wanted.target = target_of(options.target);
  if (!options.procedure.empty()) wanted.procedure = training::find_shipped_procedure(options.procedure).name;
  if (!options.needle.empty()) wanted.needle = patient::parse_needle(options.needle);
  if (options.vary) wanted.gauge = drawn.gauge;
  if (!options.mechanics.empty() && !parse_value(options.mechanics, wanted.mechanics))
    throw InputError(fmt::format("--mechanics is '{}'; expected tables or physical", options.mechanics));
  patient::ShoulderParameters& shoulder = wanted.shoulder;
  shoulder.seed = static_cast<std::uint64_t>(options.seed);
  shoulder.side = options.vary && !options.side_option.given() ? drawn.parameters.side : side_of(options.side);
  for (const CaseSynthesizeShoulderOptions::Choice& each : options.choices) {
    const bool is_drawn = options.vary && !each.option.given();
    shoulder.*each.member = is_drawn ? drawn.parameters.*each.member : each.value;
  }
  const anatomy::CaseDescription made = patient::write_shoulder_case(wanted, console.progress());
  console.clear_bar();
  const anatomy::NeedlePath& path = *made.procedure.path;
  console.line(fmt::format("{} is ready: {}", options.folder, made.description));
  console.line(fmt::format(
      "  path      from ({:.1f}, {:.1f}, {:.1f}) to ({:.1f}, {:.1f}, {:.1f}) mm, {:.1f} mm long, needle of {:g} mm",
      path.entry.x(), path.entry.y(), path.entry.z(), path.target.x(), path.target.y(), path.target.z(),
      path.length(), made.needle.length));
  console.line(forces_line(made.haptics.mechanics));
  console.line(fmt::format("Next: bodkin case show {0}, bodkin profile {0}, bodkin app {0}", options.folder));
  const nlohmann::ordered_json json = {{"folder", options.folder},
                                       {"name", made.name},
                                       {"description", made.description},
                                       {"mechanics", value_text(made.haptics.mechanics)},
                                       {"entry_mm", {path.entry.x(), path.entry.y(), path.entry.z()}},
                                       {"target_mm", {path.target.x(), path.target.y(), path.target.z()}}};
  console.json(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace

void add_case_synthesize_shoulder_command(CLI::App& group, CommandContext& context) {
  add_command(
      group, "shoulder", "A shoulder, for an injection into its joint or a nerve block",
      case_synthesize_shoulder_footer, [&context](CLI::App& command) {
        auto options = std::make_shared<CaseSynthesizeShoulderOptions>();
        add_text(command, "DIR", options->folder, "Folder of the case; it must not exist yet").required();
        add_text(command, "--name", options->name, "Name of the patient (default: the folder's)");
        constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();
        add_whole_number(command, "--seed", options->seed, 0, any, "Variation of sizes, and the noise");
        using Parameters = patient::ShoulderParameters;
        struct Declared {
          double Parameters::*member;
          const char* name;
          double low, high;
          const char* help;
        };
        constexpr std::array<Declared, 5> declared = {{
            {&Parameters::age, "--age", 18.0, 95.0, "Years, 18 to 95"},
            {&Parameters::height, "--height", 1.40, 2.05, "m, 1.40 to 2.05"},
            {&Parameters::weight, "--weight", 40.0, 160.0, "kg, 40 to 160"},
            {&Parameters::fluid, "--fluid", 2.5, 8.0,
             "mm of fluid between the head of the humerus and the capsule, 2.5 to 8"},
            {&Parameters::spacing, "--spacing", 0.6, 2.0, "mm, of the voxels, 0.6 to 2"},
        }};
        options->choices.reserve(declared.size());  // the options point at the values
        for (const Declared& each : declared) {
          options->choices.push_back({each.member, Parameters{}.*each.member, {}});
          CaseSynthesizeShoulderOptions::Choice& choice = options->choices.back();
          choice.option = add_number(command, each.name, choice.value, each.low, each.high, each.help);
        }
        options->side_option = add_text(command, "--side", options->side, "left or right");
        add_text(
            command, "--needle", options->needle,
            "GAUGE,LENGTH,TIP, such as 21,90,quincke (default: 22 gauge, 50 mm where that reaches, or else 90 mm)");
        add_text(command, "--mechanics", options->mechanics,
                 "Source of the force models' tissue values: tables or physical (default: physical)");
        add_text(command, "--target", options->target,
                 "joint or suprascapular_nerve: where the planned needle goes (default: joint)");
        add_text(command, "--procedure", options->procedure,
                 "Procedure to practise, one that comes with Bodkin (default: joint_injection, or "
                 "ultrasound_guided_nerve_block at the nerve)");
        add_switch(
            command, "--vary", options->vary,
            "Values that are not given (age, height, weight, fluid, side, gauge) are drawn at random from the seed");
        add_switch(command, "--overwrite", options->overwrite, "Replace a case that is already there");
        on_run(command, [options, &context] { run_case_synthesize_shoulder(*options, context); });
      });
}

}  // namespace bodkin::cli
