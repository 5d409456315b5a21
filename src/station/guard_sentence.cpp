#include "station/guard_sentence.h"

#include <fmt/format.h>

namespace bodkin::station {

std::string sentence_of(const haptics::GuardEvent& event) {
  std::string text(haptics::text_of(event.reason));
  if (event.cause != haptics::GuardReason::none) text += fmt::format(": {}", haptics::text_of(event.cause));
  if (event.device_fault != haptics::DeviceFault::none)
    text += fmt::format(": {}", haptics::text_of(event.device_fault));
  return text;
}

}  // namespace bodkin::station
