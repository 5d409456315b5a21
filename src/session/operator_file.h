#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulation/operator_script.h"

namespace bodkin::session {

// Names of the operators that come with Bodkin (share/bodkin/operators), in alphabetical order. Throws SystemError.
std::vector<std::string> shipped_operators();

// The operator named `name`: one that comes with Bodkin, such as "expert", or the path of an operator file
// (docs/running.md describes the format). Throws InputError naming file, line, what was found and what was expected.
simulation::OperatorScript load_operator(const std::string& name);

// As above, from text in memory; `origin` names it in messages.
simulation::OperatorScript parse_operator(std::string_view text, const std::string& origin);

// Every parameter of a script as one JSON object, units in the keys.
std::string operator_json(const simulation::OperatorScript& script);

}  // namespace bodkin::session
