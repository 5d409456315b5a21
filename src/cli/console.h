#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "cli/commands.h"
#include "core/progress.h"

namespace bodkin::cli {

// Messages of a command to the user at the terminal. Results go to standard output, everything else to standard
// error, so that `bodkin ... > file` and `--json` contain only results.
class Console {
 public:
  explicit Console(const CommandContext& context);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  // A progress bar: drawn in place on a terminal, one line per stage elsewhere, nothing with --quiet. A stage that
  // ends within a second is never drawn on a terminal.
  Progress progress();
  // A remark (repairs, assumptions). Nothing with --quiet.
  void note(std::string_view sentence);
  // One line of the result; nothing with --json.
  void line(std::string_view text) const;
  // The result as JSON text; nothing without --json.
  void json(std::string_view text) const;
  // Removes a visible bar.
  void clear_bar();

 private:
  void draw(std::string_view stage, double fraction);

  bool quiet_;
  bool json_;
  bool terminal_;
  bool drawn_ = false;
  std::string stage_;
  std::chrono::steady_clock::time_point stage_start_{};
  std::chrono::steady_clock::time_point last_draw_{};
};

// Prints why a command has failed: to standard error, and with `as_json` as an object to standard output too.
void write_error(std::string_view sentence, int exit_code, bool as_json);

}  // namespace bodkin::cli
