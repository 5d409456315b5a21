#pragma once

#include <string>

#include "haptics/guard_event.h"

namespace bodkin::station {

// A guard's action and its reason, as a sentence for people.
std::string sentence_of(const haptics::GuardEvent& event);

}  // namespace bodkin::station
