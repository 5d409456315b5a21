#pragma once

#include <string>
#include <vector>

namespace bodkin_test {

// Every command with its arguments and options.
enum class Kind { text, texts, point, number, whole, toggle };

struct OptionRow {
  std::string name;
  Kind kind;
  std::vector<std::string> out_of_range = {};  // numbers of the right kind that are refused
};

struct CommandRow {
  std::string words;      // the command
  std::string arguments;  // that it cannot do without, all good as far as the command line goes
  std::string missing;    // the first of them; empty where there is none
  std::vector<OptionRow> options;
  bool takes_several = false;  // of the last argument, so that no word is one too many
};

const std::vector<CommandRow>& command_table();
// The commands of a build with OpenCV; none in other builds.
std::vector<CommandRow> tracking_commands();

}  // namespace bodkin_test
