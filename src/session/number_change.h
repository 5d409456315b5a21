#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "anatomy/case.h"

namespace bodkin::session {

// A change of the force models' numbers during a session. From `tick` on the haptic tick is one with these numbers
// that has processed the inputs `from_tick` to `tick` - 1 before (simulation::ChangingTick).
struct NumberChange {
  std::uint64_t tick = 0, from_tick = 0;
  anatomy::HapticSettings haptics;
  std::vector<anatomy::TissueProperties> tissues;  // those that differ from the case's, followed by air
};

// The tissues of `now` that differ from those of `before`, and air, which every library needs; or none.
std::vector<anatomy::TissueProperties> changed_tissues(const std::vector<anatomy::TissueProperties>& now,
                                                       const anatomy::TissueLibrary& before);

// Applies the numbers of the change to the patient.
void apply(const NumberChange& change, anatomy::Case& patient);

// In the format of the session file.
struct NumberChangeTexts {
  std::string haptics, tissues;  // XML; empty: no tissue differs
};
NumberChangeTexts texts_of(const NumberChange& change);
// `origin`: prefix of messages. Throws InputError.
void read_texts(const NumberChangeTexts& texts, const std::string& origin, NumberChange& change);
// XXH3 of place and texts.
std::int64_t checksum_of(const NumberChange& change, const NumberChangeTexts& texts);

}  // namespace bodkin::session
