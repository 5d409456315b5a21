#pragma once

#include <cstdint>

// One function for each word that link_soak is started with; each prints what it found, and returns the exit code: 1
// when it is not as docs/openigtlink.md says.
namespace link_soak {

// Age of the poses of `bodkin serve` at a client: 60 Hz, with 1 kHz of force in batches.
int measure_age(double seconds);
// Late ticks of `bodkin serve`, whose needle is in tissue, without clients and with 8, one of them hostile: so many
// pairs of runs.
int measure_late(int pairs, double seconds);
// So many messages, as a session sends them, as fast as a client takes them, and the memory that they cost.
int measure_messages(std::uint64_t count);
// So many connections of mutated messages, beside a client that must notice nothing.
int measure_fuzz(int count);
// `bodkin serve` or its client killed at random so many times, by `pairs` of them at once.
int measure_kills(int count, int pairs);

}  // namespace link_soak
