#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace boost::asio {
class io_context;
}

namespace bodkin::link {

// Connections to be closed by a server: each client receives the reason in a STATUS message, and is disconnected when
// it has read it or after half a second. Everything belongs to the thread that runs the context.
class ClosingMessages {
 public:
  explicit ClosingMessages(boost::asio::io_context& context) : context_(context) {}

  // Takes over the socket, by its file descriptor. Closed without a message when 16 others are pending, so that a
  // flood of clients cannot exhaust sockets.
  void send(int socket, std::uint16_t code, const std::string& why);

 private:
  boost::asio::io_context& context_;
  std::shared_ptr<int> pending_ = std::make_shared<int>(0);
};

}  // namespace bodkin::link
