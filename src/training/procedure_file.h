#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "training/procedure.h"

namespace bodkin::training {

// Reads a procedure (docs/training.md has the format, share/bodkin/procedure.xsd its schema). `origin` names it in
// messages. Throws InputError naming file, line, what was found and what was expected; also for a rule about an
// unknown metric, and for an unknown event.
Procedure parse_procedure(std::string_view document, const std::string& origin);
Procedure read_procedure(const std::filesystem::path& file);

// The procedure named `name`: one that comes with Bodkin (share/bodkin/procedures), or the path of a file. Otherwise
// throws InputError, which lists those that come with Bodkin.
Procedure find_procedure(const std::string& name);

// As above, without files. Throws InputError.
Procedure find_shipped_procedure(const std::string& name);

// The procedure named in a case, or, if it does not come with Bodkin, `needle_insertion`, which contains what all
// have in common.
Procedure procedure_of_case(const std::string& name);

// Names of the procedures that come with Bodkin, in alphabetical order.
std::vector<std::string> shipped_procedures();

}  // namespace bodkin::training
