#pragma once

#include <cstddef>

namespace bodkin::fem {

// Bytes of memory that this program can still get: what the machine has left (Linux: MemAvailable), or what the
// container that it runs in (cgroup, version 2) has left, if that is less. The largest number where neither is said.
std::size_t available_memory();

}  // namespace bodkin::fem
