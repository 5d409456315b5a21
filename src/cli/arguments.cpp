#include "cli/arguments.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/error.h"
#include "core/parse_numbers.h"

namespace bodkin::cli {
namespace {

namespace fs = std::filesystem;

// "--output" of "-o,--output".
std::string spoken(const std::string& name) {
  return name.substr(name.rfind(',') + 1);
}

// All of `text` as a number; nothing if it is not one.
template <typename Number>
std::optional<Number> number_of(const std::string& text) {
  Number number{};
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

template <typename Number>
Argument add_range(CLI::App& command, const std::string& name, Number& value, Number low, Number high,
                   const std::string& expected, const std::string& help) {
  const std::string spoken_name = spoken(name);
  CLI::Option* option = command.add_option_function<std::string>(
      name,
      [&value, low, high, expected, spoken_name](const std::string& text) {
        const auto number = number_of<Number>(text);
        if (!number || !(*number >= low && *number <= high)) {
          throw InputError(fmt::format("{} is '{}'; expected {}", spoken_name, text, expected));
        }
        value = *number;
      },
      help);
  return Argument(option->default_str(fmt::format("{}", value))->type_name("NUMBER"));
}

// The names of possible subcommands.
std::string commands_of(const CLI::App& app) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  return names;
}

// "bodkin case new"
std::string full_name(const CLI::App& app) {
  return app.get_parent() == nullptr ? "bodkin" : full_name(*app.get_parent()) + " " + app.get_name();
}

// The last named command, and the words before it that no option accepted.
struct ReachedCommand {
  const CLI::App* command;
  std::vector<std::string> left;
};

ReachedCommand reached_command(const CLI::App& app) {
  ReachedCommand so_far{&app, {}};
  for (const CLI::App* next = &app; next != nullptr;) {
    so_far.command = next;
    const auto left = next->remaining();
    so_far.left.insert(so_far.left.end(), left.begin(), left.end());
    const auto named = next->get_subcommands();
    next = named.empty() ? nullptr : named.front();
  }
  return so_far;
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-';
}

std::string lower_first(std::string text) {
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0) {
    text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
  }
  return text;
}

// The text of an option in --help, without its default.
std::string about(const CLI::App& command, const std::string& name) {
  const CLI::Option* option = command.get_option_no_throw(name);
  return option == nullptr ? "a value"
                           : lower_first(option->get_description().substr(0, option->get_description().find(" (")));
}

}  // namespace

Argument& Argument::required() {
  option_->required();
  return *this;
}

Argument& Argument::without_default() {
  option_->default_str("");
  return *this;
}

Argument& Argument::separated_by_commas(const std::string& type_name) {
  option_->delimiter(',')->type_name(type_name);
  return *this;
}

bool Argument::given() const {
  return option_ != nullptr && option_->count() > 0;
}

CLI::App* add_command(CLI::App& parent, const std::string& name, const std::string& help, const std::string& footer) {
  CLI::App* command = parent.add_subcommand(name, help);
  command->footer(footer);
  return command;
}

void add_command(CLI::App& parent, const std::string& name, const std::string& help, const std::string& footer,
                 std::function<void(CLI::App& command)> declare) {
  CLI::App* command = add_command(parent, name, help, footer);
  command->preparse_callback([command, declare = std::move(declare)](std::size_t) { declare(*command); });
}

void need_command(CLI::App& command) {
  command.require_subcommand(1);
}

void on_run(CLI::App& command, std::function<void()> work) {
  command.callback(std::move(work));
}

Argument add_text(CLI::App& command, const std::string& name, std::string& value, const std::string& help) {
  const std::string spoken_name = spoken(name);
  CLI::Option* option = command.add_option_function<std::string>(
      name,
      [&value, spoken_name, help](const std::string& text) {
        if (text.empty()) {
          throw InputError(
              fmt::format("{} is empty; expected {}", spoken_name, lower_first(help.substr(0, help.find(" (")))));
        }
        value = text;
      },
      help);
  return Argument(option->default_str(value)->type_name("TEXT"));
}

Argument add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                   const std::string& help) {
  const std::string spoken_name = spoken(name);
  CLI::Option* option = command.add_option_function<std::vector<std::string>>(
      name,
      [&values, spoken_name, help](const std::vector<std::string>& texts) {
        if (std::find(texts.begin(), texts.end(), "") != texts.end()) {
          throw InputError(
              fmt::format("{} is empty; expected {}", spoken_name, lower_first(help.substr(0, help.find(" (")))));
        }
        values = texts;
      },
      help);
  // A positional argument takes all that follow; an option takes one at a time and may be repeated.
  if (name.starts_with('-')) {
    option->allow_extra_args(false);
  } else {
    option->expected(-1);
  }
  return Argument(option->type_name("TEXT"));
}

Argument add_number(CLI::App& command, const std::string& name, double& value, double low, double high,
                    const std::string& help) {
  return add_range(command, name, value, low, high, fmt::format("a number from {} to {}", low, high), help);
}

Argument add_whole_number(CLI::App& command, const std::string& name, std::int64_t& value, std::int64_t low,
                          std::int64_t high, const std::string& help) {
  const bool open = high == std::numeric_limits<std::int64_t>::max();
  const std::string expected =
      open ? fmt::format("a whole number from {}", low) : fmt::format("a whole number from {} to {}", low, high);
  return add_range(command, name, value, low, high, expected, help);
}

Argument add_switch(CLI::App& command, const std::string& name, bool& value, const std::string& help) {
  return Argument(command.add_flag(name, value, help)->disable_flag_override());
}

Vec3 parse_point(const std::string& text, const std::string& option) {
  return bodkin::parse_point(text, option);
}

void require_writable(const fs::path& file, const std::string& option, const fs::path& input) {
  std::error_code ignored;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored)) {
    throw InputError(fmt::format("{} is '{}'; expected a file in a folder that exists", option, file.string()));
  }
  if (fs::is_directory(file, ignored) || !file.has_filename()) {
    throw InputError(
        fmt::format("{} is '{}', which is a folder; expected the name of a file", option, file.string()));
  }
  if (!input.empty() && fs::equivalent(file, input, ignored)) {
    throw InputError(
        fmt::format("{} is '{}', which is also an input; expected the name of another file", option, file.string()));
  }
}

std::string usage_sentence(const CLI::App& app, const CLI::ParseError& error) {
  const auto [command, left] = reached_command(app);
  const std::string help = fmt::format("'{} --help' explains it", full_name(*command));
  const std::string kind = error.get_name(), what = error.what();
  const bool wants_command = !command->get_subcommands([](const CLI::App*) { return true; }).empty();
  const auto option = std::find_if(left.begin(), left.end(), is_option);
  if (option != left.end()) {
    return fmt::format("{} has no option {}; {}", full_name(*command), *option, help);
  }
  if (wants_command && !left.empty()) {
    return fmt::format("{} has no command '{}'; expected {}", full_name(*command), left.front(),
                       commands_of(*command));
  }
  if (wants_command && kind == "RequiredError") {
    return fmt::format("{} needs a command; expected {}", full_name(*command), commands_of(*command));
  }
  if (kind == "RequiredError") {
    const std::string name = what.substr(0, what.find(" is required"));
    return fmt::format("{} is missing; expected {}; {}", name, about(*command, name), help);
  }
  if (!left.empty()) {
    return fmt::format("{} does not take '{}'; {}", full_name(*command), left.front(), help);
  }
  if (const auto end = what.find(" was given a disallowed flag override"); end != std::string::npos) {
    return fmt::format("--{} is a switch and takes no value; {}", what.substr(0, end),
                       help);  // CLI11 drops the dashes
  }
  if (kind == "ArgumentMismatch") {
    const std::string name = what.substr(0, what.find(':'));
    if (what.find("At Most") != std::string::npos) {
      return fmt::format("{} is given more than once; expected once; {}", name, help);
    }
    return fmt::format("{0} has no value; expected {1}, as {0}=VALUE when it starts with a minus sign", name,
                       about(*command, name));
  }
  return fmt::format("{}; {}", what.substr(0, what.find('\n')), help);
}

}  // namespace bodkin::cli
