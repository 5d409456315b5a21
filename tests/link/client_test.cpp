// The reconnecting client, against our server and against misbehaving peers.
#include "link/client.h"

#include <atomic>
#include <mutex>

#include "link/contents.h"
#include "tests/link/raw_client.h"
#include <gmock/gmock.h>

#include "core/error.h"

namespace bodkin::link {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

ClientSettings soon(std::uint16_t port) {
  ClientSettings settings;
  settings.host = "127.0.0.1";
  settings.port = port;
  settings.retry = 10ms;
  return settings;
}

TEST(LinkClient, takes_and_sends_messages) {
  Server server(any_port());
  std::mutex mutex;
  std::string heard;
  Client client(soon(server.port()), {.message =
                                          [&](const Message& message) {
                                            if (message.type != "STRING") return;
                                            const std::lock_guard lock(mutex);
                                            heard += read_string(message.content);
                                          },
                                      .connected =
                                          [](Client& self) {
                                            self.send({"STRING", "CMD_1", 0.0, string_content("hello")});
                                          }});
  std::vector<Received> received;
  ASSERT_TRUE(within(10s, [&] {
    for (Received& each : server.take()) received.push_back(std::move(each));
    return !received.empty();
  }));
  EXPECT_EQ(read_string(received.front().message.content), "hello");
  server.publish({"STRING", "Event", 0.0, string_content("a")}, false);
  server.publish({"STRING", "Event", 0.0, string_content("b")}, false);
  EXPECT_TRUE(within(10s, [&] {
    const std::lock_guard lock(mutex);
    return heard == "ab";
  }));
  EXPECT_EQ(client.status().state, ClientState::connected);
  EXPECT_EQ(client.place(), "127.0.0.1:" + std::to_string(server.port()));
}

TEST(LinkClient, says_why_it_is_not_connected_and_finds_a_server_that_comes_later) {
  std::uint16_t port = 0;
  { port = Server(any_port()).port(); }
  const Client client(soon(port), {});
  ASSERT_TRUE(within(10s, [&] { return !client.status().sentence.empty(); }));
  EXPECT_THAT(client.status().sentence, HasSubstr("no server answers at 127.0.0.1:"));
  ServerSettings settings = any_port();
  settings.port = port;
  const Server later(settings);
  EXPECT_TRUE(within(10s, [&] { return client.status().state == ClientState::connected; }));
  EXPECT_TRUE(client.status().sentence.empty());
}

TEST(LinkClient, comes_back_each_time_a_server_is_killed) {
  constexpr int kills = 40;
  auto server = std::make_unique<Server>(any_port());
  const std::uint16_t port = server->port();
  std::atomic<int> last{-1};
  const Client client(soon(port), {.message = [&](const Message& message) {
                        if (message.type == "STRING") last = std::stoi(read_string(message.content));
                      }});
  for (int i = 0; i < kills; ++i) {
    ASSERT_TRUE(within(20s, [&] {
      server->publish({"STRING", "Event", 0.0, string_content(std::to_string(i))}, false);
      return last == i;
    })) << i;
    server.reset();
    ServerSettings settings = any_port();
    settings.port = port;
    server = std::make_unique<Server>(settings);
  }
  EXPECT_GE(client.status().connections, static_cast<std::uint64_t>(kills));
}

TEST(LinkClient, leaves_a_server_that_speaks_another_protocol_or_says_nothing) {
  const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ASSERT_EQ(::listen(listener, 8), 0);
  socklen_t size = sizeof address;
  ASSERT_EQ(::getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
  ClientSettings settings = soon(ntohs(address.sin_port));
  settings.silence = 100ms;
  settings.retry = 20ms;
  std::string told;
  const Client client(settings, {});
  const auto tells = [&](const char* words) {
    return within(10s, [&] {
      told = client.status().sentence;
      return told.find(words) != std::string::npos;
    });
  };
  const int first = ::accept(listener, nullptr, nullptr);
  EXPECT_TRUE(tells("has sent nothing for 0.1 s")) << told;
  const int second = ::accept(listener, nullptr, nullptr);
  const std::string greeting = "220 mail.example.org ESMTP ready, and more words than a header of 58 bytes has\r\n";
  EXPECT_EQ(::send(second, greeting.data(), greeting.size(), MSG_NOSIGNAL), static_cast<ssize_t>(greeting.size()));
  EXPECT_TRUE(tells("another protocol")) << told;
  for (const int each : {first, second, listener}) ::close(each);
}

TEST(LinkClient, says_that_the_server_has_no_place_for_it) {
  ServerSettings settings = any_port();
  settings.most_clients = 1;
  Server server(settings);
  const Client first(soon(server.port()), {});
  ASSERT_TRUE(within(10s, [&] { return server.counts().clients == 1; }));
  ClientSettings patient = soon(server.port());
  patient.retry = 60s;
  const Client second(patient, {});
  EXPECT_TRUE(within(10s, [&] { return second.status().state == ClientState::waiting; }));
  EXPECT_THAT(second.status().sentence, HasSubstr("all 1 places of this server are taken"));
  EXPECT_GE(server.counts().refused, 1U);
  EXPECT_EQ(server.counts().dropped, 0U);
  EXPECT_EQ(first.status().state, ClientState::connected);
}

TEST(LinkClient, reads_names_of_servers_and_refuses_what_is_none) {
  EXPECT_EQ(parse_server("tracker", "x").host, "tracker");
  EXPECT_EQ(parse_server("tracker", "x").port, 18944);
  EXPECT_EQ(parse_server("10.0.0.3:18945", "x").port, 18945);
  EXPECT_EQ(parse_server("[::1]:7", "x").host, "::1");
  EXPECT_EQ(parse_server("[::1]:7", "x").port, 7);
  for (const char* wrong : {"", ":5", "a:", "a:0", "a:65536", "a:1x", "[]:4"})
    EXPECT_THROW(parse_server(wrong, "--connect"), InputError) << wrong;
}

}  // namespace
}  // namespace bodkin::link
