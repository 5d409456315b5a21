#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"

namespace CLI {
class App;
}

namespace bodkin::cli {

// Other force models than those of the case, for commands that let a needle into a patient.
struct ForceOptions {
  std::string resistance, constraint;  // empty: the case's
  std::vector<std::string> parts;
  std::string mechanics, force_in_organs;
};

// Adds --resistance, --constraint, --part, --mechanics and --force-in-organs.
void add_force_options(CLI::App& command, ForceOptions& options);

// What was given takes the place of what the case says; all --part together that of its parts. Throws InputError
// naming option and setting.
void apply(const ForceOptions& options, anatomy::HapticSettings& haptics);

// "tracking_wall, line_spring" or "tracking_wall + relaxation, line_spring": the models in few words.
std::string force_names(const anatomy::HapticSettings& haptics);

}  // namespace bodkin::cli
