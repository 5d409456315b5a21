#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "anatomy/case.h"

namespace bodkin::session {

// Other numbers of the force models in the middle of a session. From `tick` on the haptic tick is one with these
// numbers that has gone through the inputs `from_tick` to `tick` - 1 before (simulation::ChangingTick).
struct NumberChange {
  std::uint64_t tick = 0, from_tick = 0;
  anatomy::HapticSettings haptics;
  std::vector<anatomy::TissueProperties> tissues;  // those that differ from the case's, and then air
};

// The tissues of `now` that are not as in `before`, and air, without which they are no library; or none.
std::vector<anatomy::TissueProperties> changed_tissues(const std::vector<anatomy::TissueProperties>& now,
                                                       const anatomy::TissueLibrary& before);

// Gives the patient the numbers of the change.
void apply(const NumberChange& change, anatomy::Case& patient);

// As the session file keeps it.
struct NumberChangeTexts {
  std::string haptics, tissues;  // XML; no tissue differs: empty
};
NumberChangeTexts texts_of(const NumberChange& change);
// `origin`: how messages begin. Throws InputError.
void read_texts(const NumberChangeTexts& texts, const std::string& origin, NumberChange& change);
// XXH3 of place and texts.
std::int64_t checksum_of(const NumberChange& change, const NumberChangeTexts& texts);

}  // namespace bodkin::session
