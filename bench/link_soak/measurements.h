#pragma once

#include <cstdint>

// One function per argument of link_soak; each prints its findings, and returns the exit code: 1 if they differ from
// docs/openigtlink.md.
namespace link_soak {

// Age of the poses of `bodkin serve` at a client: 60 Hz, with 1 kHz of force in batches.
int measure_age(double seconds);
// Late ticks of `bodkin serve`, whose needle is in tissue, without clients and with 8, one of them hostile: so many
// pairs of runs.
int measure_late(int pairs, double seconds);
// A number of messages like a session's, as fast as a client takes them, and their memory cost.
int measure_messages(std::uint64_t count);
// A number of connections with mutated messages, beside a client that must not be affected.
int measure_fuzz(int count);
// `bodkin serve` or its client killed at random a number of times, by `pairs` of them at once.
int measure_kills(int count, int pairs);

}  // namespace link_soak
