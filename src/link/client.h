#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "link/message.h"

namespace bodkin::link {

struct ClientSettings {
  std::string host = "localhost";            // name or address
  std::uint16_t port = 18944;                // the usual one of OpenIGTLink
  std::size_t largest_message = 64 << 20;    // bytes of a body that the server may send: a CT is large
  std::size_t largest_queue = 1 << 20;       // bytes waiting for a server that does not read
  std::chrono::milliseconds patience{3000};  // for establishing the connection
  std::chrono::milliseconds retry{1000};     // from the end of a connection to the next attempt
  std::chrono::milliseconds silence{0};      // after which a silent server counts as gone; 0: never
};

enum class ClientState : std::uint8_t {
  connecting,  // for the first time or again
  connected,
  waiting  // for the next attempt
};

struct ClientStatus {
  ClientState state = ClientState::connecting;
  std::string sentence;           // why it is not connected; empty: it is, or has not tried yet
  std::uint64_t connections = 0;  // established so far
  std::uint64_t received = 0;     // messages
};

// "HOST", "HOST:PORT", "[ADDRESS]:PORT". Throws InputError naming `what` for a port that is not a number from 1 to
// 65535.
ClientSettings parse_server(const std::string& text, const std::string& what);

// A client of an OpenIGTLink server on its own thread, which connects, reads, and reconnects when the connection
// ends, for its lifetime. No caller waits for the network.
class Client {
 public:
  // Called on the client's thread, one at a time. They must not throw, nor destroy the client.
  struct Events {
    std::function<void(Message)> message;    // a complete, undamaged message
    std::function<void(Client&)> connected;  // may send
  };

  Client(const ClientSettings& settings, Events events);
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  // Any thread. Dropped without a connection.
  void send(const Message& message);
  ClientStatus status() const;
  // "localhost:18944"
  const std::string& place() const noexcept;

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace bodkin::link
