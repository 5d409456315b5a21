// Cost and robustness of `bodkin serve` and its OpenIGTLink server. Run from a release build:
//   link_soak age [SECONDS]           age of poses at a client: 60 Hz, and 1 kHz of force in batches
//   link_soak late [PAIRS [SECONDS]]  late ticks without clients and with 8, one of them hostile
//   link_soak messages [COUNT]        as many messages as fast as a client takes them, and the memory they cost
//   link_soak fuzz [COUNT]            connections of mutated messages beside a client that must notice nothing
//   link_soak kills [COUNT [PAIRS]]   server or client killed (SIGKILL) at random, and what the other makes of it
//   link_soak all                     one after the other, as docs/openigtlink.md has them
// The exit code is 1 when something is not as that page says.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "bench/link_soak/measurements.h"

namespace {

constexpr double day = 25'920'000.0;  // messages that a session of 24 hours sends: 300 a second

int measure_all() {
  const auto begin = std::chrono::steady_clock::now();
  int failed = link_soak::measure_age(30.0);
  failed += link_soak::measure_late(10, 5.0);
  failed += link_soak::measure_messages(static_cast<std::uint64_t>(day));
  failed += link_soak::measure_fuzz(20000);
  failed += link_soak::measure_kills(1000, 8);
  std::printf("%.0f s, %d of 5 not as they should be\n",
              std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), failed);
  return failed == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string mode = argc > 1 ? argv[1] : "";
  const auto number = [&](int at, double otherwise) {
    return argc > at ? std::strtod(argv[at], nullptr) : otherwise;
  };
  if (mode == "age") return link_soak::measure_age(number(2, 30.0));
  if (mode == "late") return link_soak::measure_late(static_cast<int>(number(2, 10.0)), number(3, 5.0));
  if (mode == "messages") return link_soak::measure_messages(static_cast<std::uint64_t>(number(2, day)));
  if (mode == "fuzz") return link_soak::measure_fuzz(static_cast<int>(number(2, 20000.0)));
  if (mode == "kills")
    return link_soak::measure_kills(static_cast<int>(number(2, 1000.0)), static_cast<int>(number(3, 8.0)));
  if (mode == "all") return measure_all();
  std::fprintf(stderr,
               "link_soak age [SECONDS] | late [PAIRS [SECONDS]] | messages [COUNT] | fuzz [COUNT] | "
               "kills [COUNT [PAIRS]] | all\n");
  return 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "link_soak: %s\n", error.what());
  return 1;
}
