#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "anatomy/case.h"
#include "cli/arguments.h"
#include "cli/commands.h"

namespace bodkin::cli {

// What `case new` and `case synthesize` have in common: options, and what is said at the end.
struct NewCaseOptions {
  Argument gauge, needle_option;  // may be asked whether they were given
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

// The options as the image worker takes them. Throws InputError when one is out of range, or when a path is half
// given.
nlohmann::json new_case_request(const NewCaseOptions& options);

// What is said of where a new case has its forces from.
std::string forces_line(anatomy::Mechanics mechanics);

// Has the image worker make the case and says what came of it.
void make_case(const std::string& verb, const nlohmann::json& request, const std::string& subject,
               const CommandContext& context);

}  // namespace bodkin::cli
