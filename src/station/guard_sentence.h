#pragma once

#include <string>

#include "haptics/guard_event.h"

namespace bodkin::station {

// What the guard did and why, as a person reads it.
std::string sentence_of(const haptics::GuardEvent& event);

}  // namespace bodkin::station
