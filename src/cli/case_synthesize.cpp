#include <cstdint>
#include <limits>
#include <memory>

#include "patient/synthetic/lumbar.h"
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/new_case_options.h"

namespace bodkin::cli {
namespace {

struct CaseSynthesizeOptions {
  NewCaseOptions common;
  patient::LumbarParameters parameters;
  std::int64_t seed = 1;
};

constexpr const char* case_synthesize_footer = R"(Examples:
  bodkin case synthesize lumbar patient
  bodkin case synthesize lumbar old_and_stiff --age 82 --flexion 0.2 --seed 7
  bodkin case synthesize lumbar heavy --weight 120 --height 1.68
  bodkin case synthesize lumbar quick --spacing 2

The same parameters give the same patient on every machine. docs/synthetic-patient.md says what is in it and where the
numbers come from.)";

void run_case_synthesize(const CaseSynthesizeOptions& options, const CommandContext& context) {
  nlohmann::json request = new_case_request(options.common);
  const patient::LumbarParameters& parameters = options.parameters;
  request["seed"] = options.seed;
  request["age"] = parameters.age;
  request["height"] = parameters.height;
  request["weight"] = parameters.weight;
  request["flexion"] = parameters.flexion;
  request["spacing"] = parameters.spacing;
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
  patient::LumbarParameters& parameters = options->parameters;
  add_new_case_options(*command, options->common);
  constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();
  add_whole_number(*command, "--seed", options->seed, 0, any, "Variation of sizes, and the noise");
  add_number(*command, "--age", parameters.age, 18.0, 95.0, "Years, 18 to 95");
  add_number(*command, "--height", parameters.height, 1.40, 2.05, "m, 1.40 to 2.05");
  add_number(*command, "--weight", parameters.weight, 40.0, 160.0, "kg, 40 to 160");
  add_number(*command, "--flexion", parameters.flexion, 0.0, 1.0, "0 = straight, 1 = fully curled");
  add_number(*command, "--spacing", parameters.spacing, 0.5, 3.0, "mm, of the voxels, 0.5 to 3");
  on_run(*command, [options, &context] { run_case_synthesize(*options, context); });
  add_case_synthesize_body_command(*group, context);
  add_case_synthesize_phantom_command(*group, context);
}

}  // namespace bodkin::cli
