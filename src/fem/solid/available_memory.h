#pragma once

#include <cstddef>

namespace bodkin::fem {

// Bytes of memory still available to this program: those free on the machine (Linux: MemAvailable), or in its
// container (cgroup, version 2), if that is less. The largest number when neither is known.
std::size_t available_memory();

}  // namespace bodkin::fem
