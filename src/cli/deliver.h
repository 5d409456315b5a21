#pragma once

#include <string>

#include "cli/console.h"

namespace bodkin::cli {

// Judges a recorded session and adds the result of `trainee` to the store (`store`: as 'bodkin results --store';
// empty: the default). A result that the store cannot accept now waits on this station. Prints the outcome.
void deliver_result(const std::string& session, const std::string& trainee, const std::string& store,
                    Console& console);

// Delivers results waiting on this station, if any. Prints the outcome, and why the store does not accept them; gives
// up after two seconds.
void deliver_waiting(const std::string& store, Console& console);

}  // namespace bodkin::cli
