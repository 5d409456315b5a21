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
  std::string address = "127.0.0.1";  // of this machine, for clients; "0.0.0.0": all
  std::uint16_t port = 18944;         // the usual one of OpenIGTLink; 0: any free port
  std::size_t most_clients = 8;
  std::size_t largest_message = 1 << 20;       // bytes of a body that a client may send
  std::size_t most_messages = 1000;            // that a client may send in a second
  std::size_t largest_queue = 8 << 20;         // bytes waiting for or from a client before it is dropped
  std::chrono::milliseconds patience{5000};    // for the rest of an incomplete message
  std::chrono::milliseconds keep_alive{1000};  // between two STATUS messages to all clients
};

// A message that a client sent.
struct Received {
  std::uint64_t client = 0;
  Message message;
};

struct ServerCounts {
  std::uint64_t clients = 0;             // connected now
  std::uint64_t accepted = 0;            // since the start, as the following numbers
  std::uint64_t dropped = 0;             // by the server: damaged, slow or flooding
  std::uint64_t refused = 0;             // because the capacity was reached
  std::uint64_t sent = 0, received = 0;  // messages
};

// An OpenIGTLink server on its own thread. No caller waits for the network: publish() queues a message and returns; a
// client that does not keep up loses outdated messages, and finally its connection. No message from a client affects
// the others or the caller. A client that is refused or dropped receives the reason in a STATUS, unless half a
// message is on its way to it.
class Server {
 public:
  // Starts listening. Throws InputError, one sentence, when the address is not of this machine or the port is in use.
  explicit Server(const ServerSettings& settings);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::uint16_t port() const noexcept;
  // Whether other machines can connect.
  bool is_exposed() const noexcept;

  // To every client; any thread. `replaces`: replaces a waiting message of the same device (a pose, an image), so
  // that a slow client gets the newest one.
  void publish(const Message& message, bool replaces);
  // For clients that requested TDATA, at the requested rate, and at most at the rate of calls.
  void publish_tracking(const Message& message);
  // To one client; no effect when it is gone.
  void send(std::uint64_t client, const Message& message);
  // Sends a packed message that is too large for the queue of each client and shared by all: a CT. While one of this
  // name is on its way to a client, no other one is sent to it.
  void send_shared(std::uint64_t client, const std::string& name, std::shared_ptr<const Bytes> packed);
  // Waits until everything published has left for the clients, at most so long.
  void flush(std::chrono::milliseconds longest);
  // The messages received since the last call, in order; at most 1024 are kept. The server itself replies to
  // GET_STATUS, STT_TDATA and STP_TDATA.
  std::vector<Received> take();
  ServerCounts counts() const;
  // The reasons for which clients were dropped or refused since the last call, one sentence each, at most 64.
  std::vector<std::string> take_notes();

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace bodkin::link
