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
           fmt::format("Force along the needle, instead of the case's, \"NAME SETTING=VALUE ...\": {}",
                       fmt::join(anatomy::resistance_names, ", ")));
  add_text(command, "--constraint", options.constraint,
           fmt::format("Constraint that keeps the needle on its path, instead of the case's, in the same form: {}",
                       fmt::join(anatomy::constraint_names, ", ")));
  add_texts(command, "--part", options.parts,
            fmt::format("Part to add to the resistance, instead of the case's parts, may be repeated: {}, or none",
                        fmt::join(io::part_names, ", ")));
  add_text(command, "--mechanics", options.mechanics,
           "Source of the models' tissue values, instead of the case's: tables (each model has its own) or physical "
           "(one description of each tissue, for the needle of the case)");
  add_text(command, "--force-in-organs", options.force_in_organs,
           "Force while the tip is in a critical structure, an organ or a lung, instead of what the case says: felt "
           "(as the models compute it) or none (the force falls to zero)");
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
