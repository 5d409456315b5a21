#pragma once

#include <string>

#include "cli/console.h"

namespace bodkin::cli {

// Judges a recorded session and hands the result of `trainee` to the store (`store`: as 'bodkin results --store';
// empty: the usual one). What the store cannot take now waits on this station. Says what came of it.
void deliver_result(const std::string& session, const std::string& trainee, const std::string& store,
                    Console& console);

// What the store could not take before, if anything waits on this station. Says what came of it, and why the store
// does not take it; gives up after two seconds.
void deliver_waiting(const std::string& store, Console& console);

}  // namespace bodkin::cli
