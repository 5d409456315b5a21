#include "cli/force_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/arguments.h"
#include "core/error.h"
#include "core/parameter.h"
#include "core/parameter_value.h"
#include "io/force_choice.h"

namespace bodkin::cli {

void add_force_options(CLI::App& command, ForceOptions& options) {
  add_text(command, "--resistance", options.resistance,
           fmt::format("Another force along the needle than the case's, \"NAME SETTING=VALUE ...\": {}",
                       fmt::join(anatomy::resistance_names, ", ")));
  add_text(command, "--constraint", options.constraint,
           fmt::format("Another force that keeps the needle on its path, in the same form: {}",
                       fmt::join(anatomy::constraint_names, ", ")));
  add_texts(command, "--part", options.parts,
            fmt::format("Another addition to the resistance, may be repeated: {}, or none",
                        fmt::join(io::part_names, ", ")));
  add_text(
      command, "--mechanics", options.mechanics,
      "Where the models have the numbers of the tissues from, other than the case's: tables (each model its own) "
      "or physical (one description of each tissue, for the needle of the case)");
  add_text(
      command, "--force-in-organs", options.force_in_organs,
      "What is felt while the tip is in a critical structure, an organ or a lung, other than the case says: felt "
      "(what the models say) or none (the force falls to zero)");
}

void apply(const ForceOptions& options, anatomy::HapticSettings& haptics) {
  if (!options.resistance.empty()) haptics.resistance = io::parse_resistance(options.resistance, "--resistance");
  if (!options.constraint.empty()) haptics.constraint = io::parse_constraint(options.constraint, "--constraint");
  if (!options.parts.empty()) haptics.parts = io::parse_parts(options.parts, "--part");
  if (!options.mechanics.empty() && !parse_value(options.mechanics, haptics.mechanics))
    throw InputError(fmt::format("--mechanics is '{}'; expected tables or physical", options.mechanics));
  if (!options.force_in_organs.empty() && !parse_value(options.force_in_organs, haptics.force_in_organs))
    throw InputError(fmt::format("--force-in-organs is '{}'; expected felt or none", options.force_in_organs));
}

std::string force_names(const anatomy::HapticSettings& haptics) {
  std::string names(anatomy::model_name(haptics.resistance));
  for_each_inside(
      [&names](const auto& part, const auto& chosen) {
        bool is_there = false;
        if constexpr (requires { chosen.has_value(); }) {
          is_there = chosen.has_value();
        } else {
          is_there = !chosen.empty();
        }
        if (is_there) names.append(" + ").append(part.name);
      },
      haptics.parts);
  return fmt::format("{}, {}", names, anatomy::name_of(haptics.constraint));
}

}  // namespace bodkin::cli
