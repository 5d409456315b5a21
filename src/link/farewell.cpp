#include "link/farewell.h"

#include <array>
#include <chrono>

#include "link/contents.h"
#include "link/message.h"
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <unistd.h>

namespace bodkin::link {

namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr int most_under_way = 16;
constexpr std::chrono::milliseconds longest{500};

// Keeps itself alive through its handlers.
struct Farewell : std::enable_shared_from_this<Farewell> {
  Farewell(tcp::socket from, asio::io_context& context, Bytes text, std::shared_ptr<int> among)
      : socket(std::move(from)), timer(context), status(std::move(text)), count(std::move(among)) {
    ++*count;
  }
  ~Farewell() { --*count; }
  Farewell(const Farewell&) = delete;
  Farewell& operator=(const Farewell&) = delete;

  void begin() {
    timer.expires_after(longest);
    timer.async_wait([self = shared_from_this()](const error_code& /*stopped*/) { self->close(); });
    asio::async_write(socket, asio::buffer(status),
                      [self = shared_from_this()](const error_code& failed, std::size_t /*size*/) {
                        error_code ignored;
                        if (!failed) self->socket.shutdown(tcp::socket::shutdown_send, ignored);
                        self->drain();
                      });
  }
  // A socket that is closed with bytes unread takes back what it has just sent.
  void drain() {
    socket.async_read_some(asio::buffer(rest),
                           [self = shared_from_this()](const error_code& ended, std::size_t /*size*/) {
                             if (!ended) return self->drain();
                             self->timer.cancel();
                           });
  }
  void close() {
    error_code ignored;
    socket.close(ignored);
  }

  tcp::socket socket;
  asio::steady_timer timer;
  Bytes status;
  std::array<std::uint8_t, 4096> rest{};
  std::shared_ptr<int> count;
};

}  // namespace

void Farewells::say(int socket, std::uint16_t code, const std::string& why) {
  tcp::socket taken(context_);
  error_code refused;
  taken.assign(tcp::v4(), socket, refused);  // what is asked of it is the same for either protocol
  if (refused) {
    ::close(socket);
    return;
  }
  if (*under_way_ >= most_under_way) return;  // closed with `taken`
  Bytes status = pack({"STATUS", "Bodkin", time_now(), status_content(code, "", why)});
  std::make_shared<Farewell>(std::move(taken), context_, std::move(status), under_way_)->begin();
}

}  // namespace bodkin::link
