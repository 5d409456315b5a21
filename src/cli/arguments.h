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

// An option that a command has, to say more about it.
class Argument {
 public:
  Argument() = default;
  explicit Argument(CLI::Option* option) : option_(option) {}

  Argument& required();
  // --help shows no default value.
  Argument& without_default();
  // "a,b" is two values; --help shows `type_name` in their place.
  Argument& separated_by_commas(const std::string& type_name);
  // It stands on the command line that was read; an option that there is not stands nowhere.
  bool given() const;

 private:
  CLI::Option* option_ = nullptr;
};

// Adds a command below `parent`; `help` is its line in the parent's --help, `footer` ends its own.
CLI::App* add_command(CLI::App& parent, const std::string& name, const std::string& help, const std::string& footer);

// The command only groups others, one of which must be named.
void need_command(CLI::App& command);

// What the command does once the command line is read.
void on_run(CLI::App& command, std::function<void()> work);

// Options whose every bad value is refused while the command line is read, before anything is opened or written: with
// one InputError that names the option, what was found and what was expected. `name` is as CLI11 takes it
// ("-o,--output"; a name without dashes is a positional argument), `help` the line of --help. The value is left as it
// is where the option is absent.

// A text that is not empty.
Argument add_text(CLI::App& command, const std::string& name, std::string& value, const std::string& help);

// Texts that are not empty, in the order in which they are given. An option may be repeated; a positional argument
// takes one text or more.
Argument add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                   const std::string& help);

// A number from `low` to `high`, both included; NaN and infinity are in no range.
Argument add_number(CLI::App& command, const std::string& name, double& value, double low, double high,
                    const std::string& help);

// A whole number from `low` to `high`, both included.
Argument add_whole_number(CLI::App& command, const std::string& name, std::int64_t& value, std::int64_t low,
                          std::int64_t high, const std::string& help);

// A switch; it takes no value.
Argument add_switch(CLI::App& command, const std::string& name, bool& value, const std::string& help);

// "x,y,z" in LPS mm; throws InputError naming `option` when `text` is not three finite numbers.
Vec3 parse_point(const std::string& text, const std::string& option);

// Throws InputError when `file` cannot be a file to write, because its folder does not exist or it is a folder
// itself, or because it is `input`, which is read (may be empty). For use before the work, so that it is not done in
// vain.
void require_writable(const std::filesystem::path& file, const std::string& option,
                      const std::filesystem::path& input = {});

// What is wrong with a command line that CLI11 refuses, as one sentence; `app` is the program that parsed it.
std::string usage_sentence(const CLI::App& app, const CLI::ParseError& error);

}  // namespace bodkin::cli
