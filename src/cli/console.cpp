#include "cli/console.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/ioctl.h>
#include <unistd.h>

#include "cli/standard_streams.h"

namespace bodkin::cli {

namespace {

constexpr int bar_width = 28;
constexpr auto draw_interval = std::chrono::milliseconds(60);
constexpr auto bar_patience = std::chrono::milliseconds(400);  // shorter stages are not worth a bar

}  // namespace

Console::Console(const CommandContext& context)
    : quiet_(context.quiet), json_(context.json), terminal_(isatty(STDERR_FILENO) != 0) {}

Console::~Console() {
  clear_bar();
}

Progress Console::progress() {
  if (quiet_) return {};
  return [this](std::string_view stage, double fraction) { draw(stage, fraction); };
}

void Console::draw(std::string_view stage, double fraction) {
  const auto now = std::chrono::steady_clock::now();
  if (stage != stage_) {
    clear_bar();
    stage_ = stage;
    stage_start_ = now;
    if (!terminal_) write_remark(stage_ + " ...\n");
  }
  if (!terminal_ || now - stage_start_ < bar_patience || (now - last_draw_ < draw_interval && fraction < 1.0)) return;
  last_draw_ = now;
  const double share = std::clamp(fraction, 0.0, 1.0);
  const int filled = static_cast<int>(std::lround(share * bar_width));
  std::string bar;
  for (int cell = 0; cell < bar_width; ++cell) bar += cell < filled ? "█" : "░";
  const double elapsed = std::chrono::duration<double>(now - stage_start_).count();
  const std::string left = share > 0.05 ? fmt::format("{:.0f} s left", elapsed * (1.0 - share) / share) : "";
  write_remark(fmt::format("\r\033[K{:<34} {} {:3.0f} %  {}", stage_, bar, 100.0 * share, left));
  drawn_ = true;
}

void Console::clear_bar() {
  if (!drawn_) return;
  write_remark("\r\033[K");
  drawn_ = false;
}

void Console::note(std::string_view sentence) {
  if (quiet_) return;
  clear_bar();
  write_remark(fmt::format("note: {}\n", sentence));
}

void Console::line(std::string_view text) const {
  if (!json_) write_output(fmt::format("{}\n", text));
}

void Console::json(std::string_view text) const {
  if (json_) write_output(fmt::format("{}\n", text));
}

void write_error(std::string_view sentence, int exit_code, bool as_json) {
  write_remark(fmt::format("bodkin: {}\n", sentence));
  if (!as_json) return;
  const nlohmann::ordered_json json = {{"error", {{"sentence", sentence}, {"exit_code", exit_code}}}};
  try {
    write_output(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  } catch (...) {  // nobody reads it; standard error has it
  }
}

}  // namespace bodkin::cli
