#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "training/procedure.h"

namespace bodkin::training {

// Reads a procedure (docs/training.md has the format, share/bodkin/procedure.xsd its schema). `origin` names it in
// messages. Throws InputError naming file, line, what was found and what was expected: also for a rule about a metric
// that does not exist, and for an event that no session has.
Procedure parse_procedure(std::string_view document, const std::string& origin);
Procedure read_procedure(const std::filesystem::path& file);

// The procedure that `name` means: one that comes with Bodkin (share/bodkin/procedures), or the path of a file.
// Throws InputError, which lists those that come with Bodkin, when it is neither.
Procedure find_procedure(const std::string& name);

// The same without files. Throws InputError.
Procedure find_shipped_procedure(const std::string& name);

// The procedure that a case names, or `needle_insertion`, which holds what all have in common, when it is none of
// those that come with Bodkin.
Procedure procedure_of_case(const std::string& name);

// Names of the procedures that come with Bodkin, in alphabetical order.
std::vector<std::string> shipped_procedures();

}  // namespace bodkin::training
