// Whole connections of invalid bytes: the server survives, and a client beside them is not affected.
#include "link/command.h"
#include "link/server.h"
#include "tests/link/library_client.h"
#include "tests/link/mutated_stream.h"
#include "tests/link/raw_client.h"

#include "core/error.h"

namespace bodkin::link {
namespace {

using namespace std::chrono_literals;

TEST(SocketFuzz, three_hundred_hostile_connections_leave_a_good_one_alone) {
  ServerSettings settings = any_port();
  settings.most_clients = 16;
  Server server(settings);
  LibraryClient good(server.port());
  ASSERT_TRUE(within(10s, [&] { return server.counts().clients == 1; }));
  Random random(18944);
  for (int i = 0; i < 300; ++i) {
    const RawClient hostile(server.port());
    const Bytes stream = mutated_stream(random);
    hostile.flood(stream, 1);  // the server may have closed it already
    for (const Received& received : server.take()) {
      // As a session answers.
      try {
        if (const auto command = command_of(received.message))
          server.send(received.client, reply_to(received.message, true, command->name, 0.0));
      } catch (const InputError& error) {
        server.send(received.client, reply_to(received.message, false, error.what(), 0.0));
      }
    }
  }
  server.publish({"STRING", "Event", time_now(), string_content("still here")}, false);
  EXPECT_TRUE(good.wait_for("STRING", 10s, [](const Message& message) { return message.device == "Event"; }));
  EXPECT_TRUE(within(10s, [&] { return server.counts().clients == 1; })) << "the others are gone";
}

// So many are admitted; the next one is rejected, and admitted when there is room again.
TEST(SocketFuzz, more_clients_than_are_let_in_take_no_place) {
  ServerSettings settings = any_port();
  settings.most_clients = 2;
  Server server(settings);
  auto first = std::make_unique<RawClient>(server.port());
  const RawClient second(server.port());
  ASSERT_TRUE(within(10s, [&] { return server.counts().clients == 2; }));
  const RawClient third(server.port());
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(server.counts().clients, 2U);
  EXPECT_EQ(server.counts().accepted, 2U);
  first.reset();
  ASSERT_TRUE(within(10s, [&] { return server.counts().clients == 1; }));
  const RawClient fourth(server.port());
  EXPECT_TRUE(within(10s, [&] { return server.counts().clients == 2; }));
}

}  // namespace
}  // namespace bodkin::link
