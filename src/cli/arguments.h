#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry.h"

namespace CLI {
class App;
class Option;
class ParseError;
}  // namespace CLI

namespace bodkin {

// Options whose every bad value is refused while the command line is read, before anything is opened or written: with
// one InputError that names the option, what was found and what was expected. `name` is as CLI11 takes it
// ("-o,--output"; a name without dashes is a positional argument), `help` the line of --help. The value is left as it
// is where the option is absent.

// A text that is not empty.
CLI::Option* add_text(CLI::App& command, const std::string& name, std::string& value, const std::string& help);

// Texts that are not empty, in the order in which they are given; the option may be repeated.
CLI::Option* add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                       const std::string& help);

// A number from `low` to `high`, both included; NaN and infinity are in no range.
CLI::Option* add_number(CLI::App& command, const std::string& name, double& value, double low, double high,
                        const std::string& help);

// A whole number from `low` to `high`, both included.
CLI::Option* add_whole_number(CLI::App& command, const std::string& name, std::int64_t& value, std::int64_t low,
                              std::int64_t high, const std::string& help);

// A switch; it takes no value.
CLI::Option* add_switch(CLI::App& command, const std::string& name, bool& value, const std::string& help);

// "x,y,z" in LPS mm; throws InputError naming `option` when `text` is not three finite numbers.
Vec3 parse_point(const std::string& text, const std::string& option);

// Throws InputError when `file` cannot be a file to write, because its folder does not exist or it is a folder
// itself, or because it is `input`, which is read (may be empty). For use before the work, so that it is not done in
// vain.
void require_writable(const std::filesystem::path& file, const std::string& option,
                      const std::filesystem::path& input = {});

// What is wrong with a command line that CLI11 refuses, as one sentence; `app` is the program that parsed it.
std::string usage_sentence(const CLI::App& app, const CLI::ParseError& error);

}  // namespace bodkin
