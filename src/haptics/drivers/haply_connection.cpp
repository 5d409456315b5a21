#include "haptics/drivers/haply_connection.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "haptics/bodkin_driver.h"
#include "haptics/drivers/driver_adapter.h"

namespace bodkin::haptics {

namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using boost::system::error_code;
using Clock = HaplyConnection::Clock;

constexpr std::chrono::milliseconds goodbye{200};
constexpr std::size_t most_pieces = 8;           // of one message that goes out in one call
constexpr std::size_t longest_answer = 1 << 20;  // bytes, of HTTP

// Waits until `file` is ready for `events`; false at the deadline.
bool wait_for(int file, short events, Clock::time_point deadline) noexcept {
  while (true) {
    const auto left = std::max(deadline - Clock::now(), Clock::duration::zero());
    const auto whole = std::chrono::duration_cast<std::chrono::seconds>(left);
    const timespec pause{whole.count(), static_cast<long>((left - whole).count())};
    pollfd one{file, events, 0};
    const int ready = ppoll(&one, 1, &pause, nullptr);
    if (ready > 0) return true;
    if (ready == 0 || errno != EINTR) return false;
  }
}

[[noreturn]] void refuse(int result, const std::string& why) {
  throw DriverFailure(result, why);
}

struct Addresses {
  Addresses(const HaplyAddress& address) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    const int error = getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &first);
    if (error != 0) refuse(BODKIN_NOT_INSTALLED, gai_strerror(error));
  }
  ~Addresses() { freeaddrinfo(first); }
  Addresses(const Addresses&) = delete;
  Addresses& operator=(const Addresses&) = delete;
  addrinfo* first = nullptr;
};

// A TCP socket that waits at most until a deadline, with the interface of Beast's streams.
class TimedSocket {
 public:
  using executor_type = asio::io_context::executor_type;

  TimedSocket(asio::io_context& context, const HaplyAddress& address, std::chrono::milliseconds patience)
      : context_(context), deadline_(Clock::now() + patience) {
    const Addresses found(address);
    int error = ECONNREFUSED;
    for (const addrinfo* one = found.first; one != nullptr && file_ < 0; one = one->ai_next) error = try_one(*one);
    if (file_ < 0) {
      refuse(error == ETIMEDOUT ? BODKIN_COMMUNICATION_LOST : BODKIN_NOT_INSTALLED, std::strerror(error));
    }
    const int yes = 1;
    setsockopt(file_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  }
  ~TimedSocket() { close(); }
  TimedSocket(const TimedSocket&) = delete;
  TimedSocket& operator=(const TimedSocket&) = delete;

  executor_type get_executor() noexcept { return context_.get_executor(); }
  void set_deadline(Clock::time_point deadline) noexcept { deadline_ = deadline; }
  bool readable(Clock::time_point deadline) const noexcept { return file_ >= 0 && wait_for(file_, POLLIN, deadline); }
  void shut_down() noexcept {
    if (file_ >= 0) ::shutdown(file_, SHUT_RDWR);
  }
  void close() noexcept {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
  }

  template <typename Buffers>
  std::size_t read_some(const Buffers& buffers, error_code& error) noexcept {
    return transfer(buffers, POLLIN, error, [this](msghdr& message) {
      const ssize_t size = recvmsg(file_, &message, 0);
      if (size == 0) errno = ECONNRESET;
      return size == 0 ? -1 : size;
    });
  }
  template <typename Buffers>
  std::size_t write_some(const Buffers& buffers, error_code& error) noexcept {
    return transfer(buffers, POLLOUT, error,
                    [this](msghdr& message) { return sendmsg(file_, &message, MSG_NOSIGNAL); });
  }
  template <typename Buffers>
  std::size_t read_some(const Buffers& buffers) {
    error_code error;
    const std::size_t size = read_some(buffers, error);
    if (error) throw boost::system::system_error(error);
    return size;
  }
  template <typename Buffers>
  std::size_t write_some(const Buffers& buffers) {
    error_code error;
    const std::size_t size = write_some(buffers, error);
    if (error) throw boost::system::system_error(error);
    return size;
  }

 private:
  // The error; 0 when connected.
  int try_one(const addrinfo& to) noexcept {
    file_ = socket(to.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (file_ < 0) return errno;
    int error = connect(file_, to.ai_addr, to.ai_addrlen) == 0 ? 0 : errno;
    if (error == EINPROGRESS) {
      socklen_t size = sizeof error;
      if (!wait_for(file_, POLLOUT, deadline_)) {
        error = ETIMEDOUT;
      } else if (getsockopt(file_, SOL_SOCKET, SO_ERROR, &error, &size) != 0) {
        error = errno;
      }
    }
    if (error != 0) close();
    return error;
  }

  template <typename Buffers, typename Call>
  std::size_t transfer(const Buffers& buffers, short events, error_code& error, Call call) noexcept {
    std::array<iovec, most_pieces> pieces{};
    msghdr message{};
    message.msg_iov = pieces.data();
    const auto end = asio::buffer_sequence_end(buffers);
    for (auto at = asio::buffer_sequence_begin(buffers); at != end && message.msg_iovlen < most_pieces; ++at) {
      const auto piece = *at;
      // iovec serves both directions and so has no const.
      if (piece.size() > 0) pieces[message.msg_iovlen++] = {const_cast<void*>(piece.data()), piece.size()};
    }
    error = {};
    if (message.msg_iovlen == 0) return 0;
    while (true) {
      const ssize_t size = file_ < 0 ? (errno = EBADF, -1) : call(message);
      if (size >= 0) return static_cast<std::size_t>(size);
      if (errno == EINTR) continue;
      if (errno == EAGAIN || errno == EWOULDBLOCK) {
        if (wait_for(file_, events, deadline_)) continue;
        errno = ETIMEDOUT;
      }
      error = error_code(errno, boost::system::system_category());
      return 0;
    }
  }

  asio::io_context& context_;
  Clock::time_point deadline_;
  int file_ = -1;
};

// Called by Beast at the end of a WebSocket.
void teardown(boost::beast::role_type, TimedSocket& socket, error_code& error) noexcept {
  socket.shut_down();
  error = {};
}

}  // namespace

HttpAnswer http_get(const HaplyAddress& address, const std::string& path, std::chrono::milliseconds patience) {
  asio::io_context context;
  TimedSocket socket(context, address, patience);
  http::request<http::empty_body> request{http::verb::get, path, 11};
  request.set(http::field::host, address.text());
  request.set(http::field::connection, "close");
  error_code error;
  http::write(socket, request, error);
  boost::beast::flat_buffer buffer(longest_answer);
  http::response_parser<http::string_body> parser;
  parser.body_limit(longest_answer);
  if (!error) http::read(socket, buffer, parser, error);
  if (error) refuse(BODKIN_COMMUNICATION_LOST, error.message());
  return {static_cast<int>(parser.get().result_int()), parser.get().body()};
}

struct HaplyConnection::Stream {
  Stream(const HaplyAddress& address, std::chrono::milliseconds patience) : socket(context, address, patience) {}

  TimedSocket& raw() { return socket.next_layer(); }

  asio::io_context context;  // never run: every call is synchronous
  websocket::stream<TimedSocket, false> socket;
};

HaplyConnection::HaplyConnection(const HaplyAddress& address, std::chrono::milliseconds patience)
    : stream_(std::make_unique<Stream>(address, patience)) {
  error_code error;
  stream_->socket.handshake(address.text(), "/", error);
  if (error) refuse(BODKIN_COMMUNICATION_LOST, error.message());
  stream_->socket.text(true);
  stream_->socket.auto_fragment(false);
}

HaplyConnection::~HaplyConnection() {
  stream_->raw().set_deadline(Clock::now() + goodbye);
  error_code error;
  stream_->socket.close(websocket::close_code::normal, error);
}

bool HaplyConnection::send(std::string_view text, Clock::time_point deadline) noexcept {
  try {
    stream_->raw().set_deadline(deadline);
    error_code error;
    stream_->socket.write(asio::buffer(text.data(), text.size()), error);
    return !error;
  } catch (...) {
    return false;
  }
}

bool HaplyConnection::arrives(Clock::time_point deadline) const noexcept {
  return stream_->raw().readable(deadline);
}

bool HaplyConnection::receive(std::span<char> to, std::size_t& size, Clock::time_point deadline) noexcept {
  try {
    stream_->raw().set_deadline(deadline);
    size = 0;
    do {
      if (size == to.size()) return false;
      error_code error;
      size += stream_->socket.read_some(asio::buffer(to.data() + size, to.size() - size), error);
      if (error) return false;
    } while (!stream_->socket.is_message_done());
    return true;
  } catch (...) {
    return false;
  }
}

void HaplyConnection::interrupt() noexcept {
  stream_->raw().shut_down();
}

void HaplyConnection::abandon() noexcept {
  stream_->raw().close();
}

}  // namespace bodkin::haptics
