#include "cli/second_options.h"

#include <utility>

#include <fmt/format.h>

#include "cli/arguments.h"
#include "core/error.h"

namespace bodkin::cli {

void add_second_options(CLI::App& command, SecondOptions& options) {
  add_text(command, "--second", options.device.device,
           "A second device, for the other hand: DRIVER or DRIVER:IDENTITY");
  add_text(command, "--second-as", options.role, "What it holds: plunger (of the syringe, the default) or probe");
  add_text(command, "--second-settings", options.device.settings, "Settings of its driver, \"KEY=VALUE ...\"");
}

std::optional<station::SecondChoice> choose_second(const SecondOptions& options, const station::DeviceChoice& first) {
  if (options.device.device.empty()) {
    for (const auto& [option, text] :
         {std::pair("--second-as", &options.role), std::pair("--second-settings", &options.device.settings)}) {
      if (text->empty()) continue;
      throw InputError(
          fmt::format("{} is '{}', but there is no second device; name it with --second DEVICE", option, *text));
    }
    return std::nullopt;
  }
  const std::optional<session::SecondRole> role =
      session::second_role(options.role.empty() ? "plunger" : options.role);
  if (!role) throw InputError(fmt::format("--second-as is '{}'; expected plunger or probe", options.role));
  if (is_mouse(options.device)) {
    throw InputError("--second is the mouse, which can only hold the needle; name the mouse as DEVICE");
  }
  station::SecondChoice choice{choose_device(options.device), *role};
  const bool same = choice.device.driver == first.driver && choice.device.identity == first.identity;
  const bool same_tool = !first.is_seen() || choice.device.settings == first.settings;
  if (same && same_tool && !first.is_simulated()) {
    throw InputError(
        fmt::format("--second is '{}', the device that holds the needle; expected another one, as DRIVER:IDENTITY "
                    "where both are of one driver",
                    options.device.device));
  }
  return choice;
}

}  // namespace bodkin::cli
