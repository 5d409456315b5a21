#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"

namespace CLI {
class App;
}

namespace bodkin::cli {

// Force models that override those of the case, for commands that insert a needle into a patient.
struct ForceOptions {
  std::string resistance, constraint;  // empty: the case's
  std::vector<std::string> parts;
  std::string mechanics, force_in_organs;
};

// Adds --resistance, --constraint, --part, --mechanics and --force-in-organs.
void add_force_options(CLI::App& command, ForceOptions& options);

// Overrides the models of the case by the given ones; all --part together override its parts. Throws InputError
// naming option and setting.
void apply(const ForceOptions& options, anatomy::HapticSettings& haptics);

// Short names of the models: "tracking_wall, line_spring" or "tracking_wall + relaxation, line_spring".
std::string force_names(const anatomy::HapticSettings& haptics);

}  // namespace bodkin::cli
