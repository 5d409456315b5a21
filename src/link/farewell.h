#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace boost::asio {
class io_context;
}

namespace bodkin::link {

// Connections that a server gives up: each is told why in a STATUS message, and closed when the client has taken it
// or half a second has passed. All of it belongs to the thread that runs the context.
class Farewells {
 public:
  explicit Farewells(boost::asio::io_context& context) : context_(context) {}

  // Takes the socket, as the system numbers it. Closed without a word when 16 others are under way, lest a flood of
  // clients keep sockets.
  void say(int socket, std::uint16_t code, const std::string& why);

 private:
  boost::asio::io_context& context_;
  std::shared_ptr<int> under_way_ = std::make_shared<int>(0);
};

}  // namespace bodkin::link
