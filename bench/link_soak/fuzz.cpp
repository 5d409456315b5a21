#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include "bench/link_soak/measurements.h"
#include "bench/link_soak/parts.h"
#include "link/command.h"
#include "link/contents.h"
#include "tests/link/mutated_stream.h"
#include <sys/socket.h>
#include <unistd.h>

#include "core/error.h"
#include "core/random.h"

namespace link_soak {

using namespace bodkin;
using namespace bodkin::link;
using namespace std::chrono_literals;
using Steady = std::chrono::steady_clock;

int measure_fuzz(int count) {
  ServerSettings settings = free_port();
  settings.patience = 200ms;
  Server server(settings);
  std::atomic<std::uint64_t> heard{0};
  const Client good(client_of(server.port()), {.message = [&](const Message&) { ++heard; }});
  while (server.counts().clients == 0) std::this_thread::sleep_for(1ms);
  Random random(static_cast<std::uint64_t>(count));
  std::uint64_t bytes = 0;
  const double before = memory_held();
  for (int i = 0; i < count; ++i) {
    const int socket = connect_to(server.port());
    if (socket < 0) return 1;
    const Bytes stream = mutated_stream(random);
    bytes += stream.size();
    (void)!::send(socket, stream.data(), stream.size(), MSG_NOSIGNAL);
    ::close(socket);
    for (const Received& received : server.take()) {
      try {
        if (const auto command = command_of(received.message))
          server.send(received.client, reply_to(received.message, true, command->name, 0.0));
      } catch (const InputError& error) {
        server.send(received.client, reply_to(received.message, false, error.what(), 0.0));
      }
    }
    server.take_notes();
    server.publish({"STRING", "Event", 0.0, string_content("x")}, false);
  }
  const auto end = Steady::now() + 30s;
  while (heard < static_cast<std::uint64_t>(count) && Steady::now() < end) std::this_thread::sleep_for(1ms);
  const ServerCounts counts = server.counts();
  std::printf(
      "%d hostile connections, %llu bytes: %llu let in, %llu dropped by the server, the good client heard %llu "
      "messages in %llu connection, memory %.1f MiB before and %.1f MiB after\n",
      count, static_cast<unsigned long long>(bytes), static_cast<unsigned long long>(counts.accepted),
      static_cast<unsigned long long>(counts.dropped), static_cast<unsigned long long>(heard.load()),
      static_cast<unsigned long long>(good.status().connections), before, memory_held());
  return good.status().connections == 1 ? 0 : 1;
}

}  // namespace link_soak
