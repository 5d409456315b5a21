#include "link/closing_messages.h"

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

constexpr int most_pending = 16;
constexpr std::chrono::milliseconds longest{500};

// Kept alive by its handlers.
struct ClosingMessage : std::enable_shared_from_this<ClosingMessage> {
  ClosingMessage(tcp::socket from, asio::io_context& context, Bytes text, std::shared_ptr<int> pending)
      : socket(std::move(from)), timer(context), status(std::move(text)), count(std::move(pending)) {
    ++*count;
  }
  ~ClosingMessage() { --*count; }
  ClosingMessage(const ClosingMessage&) = delete;
  ClosingMessage& operator=(const ClosingMessage&) = delete;

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
  // Closing a socket with unread bytes discards the data just sent.
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

void ClosingMessages::send(int socket, std::uint16_t code, const std::string& why) {
  tcp::socket owned(context_);
  error_code refused;
  owned.assign(tcp::v4(), socket, refused);  // what is asked of it is the same for either protocol
  if (refused) {
    ::close(socket);
    return;
  }
  if (*pending_ >= most_pending) return;  // closed with `owned`
  Bytes status = pack({"STATUS", "Bodkin", time_now(), status_content(code, "", why)});
  std::make_shared<ClosingMessage>(std::move(owned), context_, std::move(status), pending_)->begin();
}

}  // namespace bodkin::link
