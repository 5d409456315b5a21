#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "anatomy/case.h"
#include "cli/arguments.h"
#include "cli/commands.h"

namespace bodkin::cli {

// The common options of `case new` and `case synthesize`, and their output at the end.
struct NewCaseOptions {
  Argument gauge, needle_option;  // for queries whether they were given
  std::string folder;
  std::string name;
  std::string entry, target;  // "x,y,z"
  std::int64_t needle_gauge = 22;
  std::string needle;  // "GAUGE,LENGTH,TIP"
  bool needle_is_given() const { return gauge.given() || needle_option.given(); }
  std::string mechanics, force_in_organs;
  std::vector<std::string> parts;
  std::string procedure;
  bool overwrite = false;
};

void add_new_case_options(CLI::App& command, NewCaseOptions& options);

// The options in the image worker's format. Throws InputError if one is out of range, or if a path is incomplete.
nlohmann::json new_case_request(const NewCaseOptions& options);

// The output line about the origin of a new case's forces.
std::string forces_line(anatomy::Mechanics mechanics);

// Creates the case in the image worker and prints the outcome.
void make_case(const std::string& verb, const nlohmann::json& request, const std::string& subject,
               const CommandContext& context);

}  // namespace bodkin::cli
