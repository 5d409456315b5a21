#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "link/message.h"

namespace bodkin::link {

struct ServerSettings {
  std::string address = "127.0.0.1";  // of this machine that clients reach; "0.0.0.0": all
  std::uint16_t port = 18944;         // the usual one of OpenIGTLink; 0: any that is free
  std::size_t most_clients = 8;
  std::size_t largest_message = 1 << 20;       // bytes of a body that a client may send
  std::size_t most_messages = 1000;            // that a client may send in a second
  std::size_t largest_queue = 8 << 20;         // bytes that wait for a client, or from it, before it is dropped
  std::chrono::milliseconds patience{5000};    // for the rest of a message that has begun
  std::chrono::milliseconds keep_alive{1000};  // between two STATUS messages to everybody
};

// A message that a client sent.
struct Received {
  std::uint64_t client = 0;
  Message message;
};

struct ServerCounts {
  std::uint64_t clients = 0;             // connected now
  std::uint64_t accepted = 0;            // since the start, and so the others
  std::uint64_t dropped = 0;             // by the server: damaged, slow or flooding
  std::uint64_t refused = 0;             // for whom there was no place
  std::uint64_t sent = 0, received = 0;  // messages
};

// An OpenIGTLink server on a thread of its own. Nobody ever waits for the network: publish() hands a message over and
// returns; a client that does not keep up loses what is no longer new, and in the end its connection. Whatever a
// client sends, the others and the caller do not notice. A client that is refused or dropped is told why in a STATUS,
// unless half a message is on its way to it.
class Server {
 public:
  // Listens from here on. Throws InputError, one sentence, when the address is none of this machine or the port is
  // taken.
  explicit Server(const ServerSettings& settings);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::uint16_t port() const noexcept;
  // Other machines can connect.
  bool is_exposed() const noexcept;

  // To every client; any thread. `replaces`: a message of the same device that still waits is no longer wanted (a
  // pose, a picture), so that a slow client sees the newest one.
  void publish(const Message& message, bool replaces);
  // Clients that asked for TDATA get this one, as often as each asked for, and no oftener than it is given.
  void publish_tracking(const Message& message);
  // To one client; nothing happens when it is gone.
  void send(std::uint64_t client, const Message& message);
  // A packed message too large for the queue of each client, of which all share one copy: a CT. While one of this
  // name is on its way to a client, another one is not sent to it.
  void send_shared(std::uint64_t client, const std::string& name, std::shared_ptr<const Bytes> packed);
  // Waits until everything published has left for the clients, at most so long.
  void flush(std::chrono::milliseconds longest);
  // What came since the last call, in order; at most 1024 are kept. GET_STATUS, STT_TDATA and STP_TDATA are answered
  // by the server itself.
  std::vector<Received> take();
  ServerCounts counts() const;
  // Why clients were dropped or refused since the last call, one sentence each, at most 64.
  std::vector<std::string> take_notes();

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace bodkin::link
