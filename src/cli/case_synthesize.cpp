#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "patient/synthetic/variant.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/new_case_options.h"
#include "training/procedure_file.h"

namespace bodkin::cli {
namespace {

struct CaseSynthesizeOptions {
  NewCaseOptions common;
  std::int64_t seed = 1;
  bool vary = false;
  // A parameter with its option; --vary draws the ones not given.
  struct Choice {
    double patient::LumbarParameters::*member;
    const char* name;
    double value;
    Argument option;
  };
  std::vector<Choice> choices;
};

constexpr const char* case_synthesize_footer = R"(Examples:
  bodkin case synthesize lumbar patient
  bodkin case synthesize lumbar old_and_stiff --age 82 --flexion 0.2 --seed 7
  bodkin case synthesize lumbar heavy --weight 120 --height 1.68
  bodkin case synthesize lumbar quick --spacing 2
  bodkin case synthesize lumbar curved --scoliosis 25 --calcification 0.6
  bodkin case synthesize lumbar biopsy --lesion 20 --procedure ct_guided_biopsy --target lesion --needle 18,150,chiba
  bodkin case synthesize lumbar patient_7 --vary --seed 7      another person for every seed

The same parameters give the same patient on every machine. docs/synthetic-patient.md says what is in it and where the
numbers come from.)";

void run_case_synthesize(const CaseSynthesizeOptions& options, const CommandContext& context) {
  nlohmann::json request = new_case_request(options.common);
  request["seed"] = options.seed;
  const patient::LumbarVariant drawn = patient::draw_variant(static_cast<std::uint64_t>(options.seed));
  for (const CaseSynthesizeOptions::Choice& each : options.choices) {
    const bool is_drawn = options.vary && !each.option.given();
    request[each.name] = is_drawn ? drawn.parameters.*each.member : each.value;
  }
  if (options.vary && !options.common.needle_is_given()) {
    const training::Procedure procedure = training::find_shipped_procedure(
        options.common.procedure.empty() ? "lumbar_puncture" : options.common.procedure);
    const int gauge = std::clamp(drawn.gauge, procedure.thickest_gauge, procedure.thinnest_gauge);
    request["needle_gauge"] = gauge;
    if (request.contains("needle"))  // of the procedure: its length and tip stay
      request["needle"] = fmt::format("{}{}", gauge, procedure.needle.substr(procedure.needle.find(',')));
  }
  make_case("case-synthesize", request, options.common.folder, context);
}

}  // namespace

void add_case_synthesize_command(CLI::App& case_group, CommandContext& context) {
  CLI::App* group = add_command(case_group, "synthesize", "Make a patient from nothing but parameters and a seed",
                                case_synthesize_footer);
  need_command(*group);
  CLI::App* command =
      add_command(*group, "lumbar", "A lumbar torso, L1 to the sacrum, for lumbar puncture", case_synthesize_footer);
  const auto options = std::make_shared<CaseSynthesizeOptions>();
  add_new_case_options(*command, options->common);
  constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();
  add_whole_number(*command, "--seed", options->seed, 0, any, "Variation of sizes, and the noise");
  using Parameters = patient::LumbarParameters;
  struct Declared {
    double Parameters::*member;
    const char* name;
    double low, high;
    const char* help;
  };
  constexpr std::array<Declared, 8> declared = {{
      {&Parameters::age, "age", 18.0, 95.0, "Years, 18 to 95"},
      {&Parameters::height, "height", 1.40, 2.05, "m, 1.40 to 2.05"},
      {&Parameters::weight, "weight", 40.0, 160.0, "kg, 40 to 160"},
      {&Parameters::flexion, "flexion", 0.0, 1.0, "0 = straight, 1 = fully curled"},
      {&Parameters::scoliosis, "scoliosis", -40.0, 40.0,
       "Degrees of Cobb's angle, -40 to 40; above 0 the curve bows to the patient's left"},
      {&Parameters::calcification, "calcification", 0.0, 1.0,
       "How far the ligaments behind the canal are calcified, from behind: 0 = nowhere, 1 = all the way"},
      {&Parameters::lesion, "lesion", 0.0, 30.0,
       "mm across, 8 to 30: a lesion next to the left psoas at L3, for biopsies; 0: none"},
      {&Parameters::spacing, "spacing", 0.5, 3.0, "mm, of the voxels, 0.5 to 3"},
  }};
  options->choices.reserve(declared.size());  // the options point at the values
  for (const Declared& each : declared) {
    options->choices.push_back({each.member, each.name, Parameters{}.*each.member, {}});
    CaseSynthesizeOptions::Choice& choice = options->choices.back();
    choice.option = add_number(*command, std::string("--") + each.name, choice.value, each.low, each.high, each.help);
  }
  add_switch(*command, "--vary", options->vary,
             "Values that are not given (age, height, weight, flexion, scoliosis, calcification, gauge) are drawn at "
             "random from the seed");
  on_run(*command, [options, &context] { run_case_synthesize(*options, context); });
  add_case_synthesize_body_command(*group, context);
  add_case_synthesize_phantom_command(*group, context);
  add_case_synthesize_shoulder_command(*group, context);
}

}  // namespace bodkin::cli
