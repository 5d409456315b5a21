#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/geometry.h"

namespace CLI {
class App;
class Option;
class ParseError;
}  // namespace CLI

namespace bodkin::cli {

// An option of a command, for further declarations.
class Argument {
 public:
  Argument() = default;
  explicit Argument(CLI::Option* option) : option_(option) {}

  Argument& required();
  // --help shows no default value.
  Argument& without_default();
  // "a,b" is two values; --help shows `type_name` for them.
  Argument& separated_by_commas(const std::string& type_name);
  // It was given on the command line; false for an absent option object.
  bool given() const;

 private:
  CLI::Option* option_ = nullptr;
};

// Adds a command below `parent`; `help` is its line in the parent's --help, `footer` ends its own.
CLI::App* add_command(CLI::App& parent, const std::string& name, const std::string& help, const std::string& footer);

// As above, with options and work that `declare` adds only when this command is called: each start of the program
// would otherwise declare those of all commands.
void add_command(CLI::App& parent, const std::string& name, const std::string& help, const std::string& footer,
                 std::function<void(CLI::App& command)> declare);

// Requires one of the command's subcommands.
void need_command(CLI::App& command);

// Sets the function to call after the command line is read.
void on_run(CLI::App& command, std::function<void()> work);

// Options whose invalid values are refused while the command line is read, before anything is opened or written, with
// one InputError that names the option, the value and the expectation. `name` is as for CLI11 ("-o,--output"; a name
// without dashes is a positional argument), `help` the line of --help. An absent option leaves the value unchanged.

// A non-empty text.
Argument add_text(CLI::App& command, const std::string& name, std::string& value, const std::string& help);

// Non-empty texts, in the given order. An option may be repeated; a positional argument takes one text or more.
Argument add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                   const std::string& help);

// A number from `low` to `high`, both included; NaN and infinity are refused.
Argument add_number(CLI::App& command, const std::string& name, double& value, double low, double high,
                    const std::string& help);

// A whole number from `low` to `high`, both included.
Argument add_whole_number(CLI::App& command, const std::string& name, std::int64_t& value, std::int64_t low,
                          std::int64_t high, const std::string& help);

// A switch without a value.
Argument add_switch(CLI::App& command, const std::string& name, bool& value, const std::string& help);

// "x,y,z" in LPS mm; throws InputError naming `option` when `text` is not three finite numbers.
Vec3 parse_point(const std::string& text, const std::string& option);

// Throws InputError if `file` cannot be written because its folder does not exist, it is a folder itself, or it is
// the input file `input` (may be empty). To be called before the work, which would otherwise be lost.
void require_writable(const std::filesystem::path& file, const std::string& option,
                      const std::filesystem::path& input = {});

// The error of a command line refused by CLI11, as one sentence; `app` is the program that parsed it.
std::string usage_sentence(const CLI::App& app, const CLI::ParseError& error);

}  // namespace bodkin::cli
