#include "link/client.h"

#include <array>
#include <charconv>
#include <deque>
#include <mutex>
#include <thread>

#include "link/contents.h"
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::link {

namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;

// A client that keeps trying an unused port of this machine is eventually given that very port by the system, and
// connects to itself.
bool is_own_end(const tcp::socket& socket) {
  error_code ignored;
  return socket.local_endpoint(ignored) == socket.remote_endpoint(ignored);
}

}  // namespace

ClientSettings parse_server(const std::string& text, const std::string& what) {
  ClientSettings settings;
  std::string host = text, port;
  if (text.starts_with('[')) {
    const std::size_t end = text.find(']');
    host = text.substr(1, end == std::string::npos ? end : end - 1);
    if (end != std::string::npos && end + 1 < text.size()) port = text.substr(end + 1);
  } else if (const std::size_t colon = text.find(':'); colon != std::string::npos) {
    host = text.substr(0, colon);
    port = text.substr(colon);
  }
  unsigned number = settings.port;
  if (!port.empty()) {
    const char* const end = port.data() + port.size();
    const auto [last, error] = std::from_chars(port.data() + 1, end, number);
    if (port.front() != ':' || error != std::errc() || last != end) number = 0;
  }
  if (host.empty() || number < 1 || number > 65535) {
    throw InputError(
        fmt::format("{} is '{}', expected HOST or HOST:PORT with a port of 1 to 65535, as localhost:18944", what,
                    text.substr(0, 100)));
  }
  settings.host = host;
  settings.port = static_cast<std::uint16_t>(number);
  return settings;
}

// Everything not guarded by the mutex belongs to the client's thread.
struct Client::Shared {
  Shared(Client& client, const ClientSettings& from, Events to)
      : owner(client),
        settings(from),
        place(fmt::format("{}:{}", from.host, from.port)),
        events(std::move(to)),
        resolver(context),
        timer(context) {}

  Client& owner;
  ClientSettings settings;
  std::string place;
  Events events;
  asio::io_context context;
  tcp::resolver resolver;
  asio::steady_timer timer;
  // The present connection; a handler of an older one finds a different number and does nothing.
  std::shared_ptr<tcp::socket> socket;
  std::uint64_t attempt = 0;
  bool is_up = false;
  std::string refusal;  // why the server is about to end the connection, by its STATUS
  Clock::time_point heard;
  std::array<std::uint8_t, header_size> head{};
  MessageHeader header;
  Bytes body;
  std::deque<Bytes> queue;
  std::size_t queued = 0;  // bytes
  mutable std::mutex mutex;
  ClientStatus status;
  std::jthread thread;

  void connect();
  void begin(std::uint64_t number);
  void watch(std::uint64_t number);
  void end(std::uint64_t number, const std::string& why);
  void read(std::uint64_t number);
  void read_body(std::uint64_t number);
  void write(std::uint64_t number);
  std::string reason_of_end() const {
    return refusal.empty() ? fmt::format("{} has ended the connection", place)
                           : fmt::format("{}: {}", place, refusal);
  }
  std::string nobody_answers(const std::string& why) const {
    return fmt::format("no server answers at {} ({}); has it been started?", place, why);
  }
  void hear_status(const Message& message);
  void set(ClientState state, const std::string& sentence) {
    const std::lock_guard lock(mutex);
    status.state = state;
    status.sentence = sentence;
  }
};

void Client::Shared::connect() {
  const std::uint64_t number = ++attempt;
  is_up = false;
  queue.clear();
  queued = 0;
  socket = std::make_shared<tcp::socket>(context);
  {
    const std::lock_guard lock(mutex);
    status.state = ClientState::connecting;
  }
  timer.expires_after(settings.patience);
  timer.async_wait([this, number](const error_code& stopped) {
    if (!stopped && !is_up) end(number, fmt::format("{} does not answer", place));
  });
  resolver.async_resolve(
      settings.host, std::to_string(settings.port), [this, number](const error_code& unknown, const auto& found) {
        if (number != attempt) return;
        if (unknown) return end(number, fmt::format("there is no machine '{}'", settings.host));
        asio::async_connect(*socket, found,
                            [this, number, kept = socket](const error_code& refused, const tcp::endpoint&) {
                              if (number != attempt) return;
                              if (refused) return end(number, nobody_answers(refused.message()));
                              if (is_own_end(*socket)) return end(number, nobody_answers("no server listens there"));
                              begin(number);
                            });
      });
}

void Client::Shared::begin(std::uint64_t number) {
  error_code ignored;
  socket->set_option(tcp::no_delay(true), ignored);
  socket->set_option(asio::socket_base::keep_alive(true), ignored);
  is_up = true;
  refusal.clear();
  heard = Clock::now();
  timer.cancel();
  {
    const std::lock_guard lock(mutex);
    status.state = ClientState::connected;
    status.sentence.clear();
    ++status.connections;
  }
  if (events.connected) events.connected(owner);
  if (settings.silence.count() > 0) watch(number);
  read(number);
}

void Client::Shared::watch(std::uint64_t number) {
  timer.expires_after(settings.silence / 4 + std::chrono::milliseconds(1));
  timer.async_wait([this, number](const error_code& stopped) {
    if (stopped || number != attempt) return;
    if (Clock::now() - heard > settings.silence)
      return end(number, fmt::format("{} has sent nothing for {} s", place,
                                     std::chrono::duration<double>(settings.silence).count()));
    watch(number);
  });
}

void Client::Shared::end(std::uint64_t number, const std::string& why) {
  if (number != attempt) return;
  ++attempt;  // pending work belongs to the old connection
  is_up = false;
  error_code ignored;
  socket->close(ignored);
  resolver.cancel();
  set(ClientState::waiting, why);
  timer.expires_after(settings.retry);
  timer.async_wait([this](const error_code& stopped) {
    if (!stopped) connect();
  });
}

void Client::Shared::read(std::uint64_t number) {
  asio::async_read(*socket, asio::buffer(head),
                   [this, number, kept = socket](const error_code& error, std::size_t /*size*/) {
                     if (number != attempt) return;
                     if (error) return end(number, reason_of_end());
                     try {
                       header = read_header(head);
                     } catch (const InputError& refused) {
                       return end(number, fmt::format("{}: {}", place, refused.what()));
                     }
                     if (header.body_size > settings.largest_message) {
                       return end(number, fmt::format("{} sent a message of {} bytes, at most {} are accepted", place,
                                                      header.body_size, settings.largest_message));
                     }
                     read_body(number);
                   });
}

void Client::Shared::read_body(std::uint64_t number) {
  body.resize(header.body_size);
  asio::async_read(*socket, asio::buffer(body),
                   [this, number, kept = socket](const error_code& error, std::size_t /*size*/) {
                     if (number != attempt) return;
                     if (error) return end(number, reason_of_end());
                     heard = Clock::now();
                     Message message;
                     try {
                       message = unpack(header, body);
                     } catch (const InputError& refused) {
                       return end(number, fmt::format("{}: {}", place, refused.what()));
                     }
                     {
                       const std::lock_guard lock(mutex);
                       ++status.received;
                     }
                     hear_status(message);
                     if (events.message) events.message(std::move(message));
                     read(number);
                   });
}

void Client::Shared::hear_status(const Message& message) {
  if (message.type != "STATUS") return;
  try {
    const StatusText reply = read_status(message.content);
    refusal = reply.code == status_ok ? std::string() : reply.message;
  } catch (const InputError&) {
    return;  // a truncated STATUS is ignored
  }
}

void Client::Shared::write(std::uint64_t number) {
  asio::async_write(*socket, asio::buffer(queue.front()),
                    [this, number, kept = socket](const error_code& error, std::size_t size) {
                      if (number != attempt) return;
                      if (error) return end(number, reason_of_end());
                      queued -= size;
                      queue.pop_front();
                      if (!queue.empty()) write(number);
                    });
}

Client::Client(const ClientSettings& settings, Events events)
    : shared_(std::make_unique<Shared>(*this, settings, std::move(events))) {
  asio::post(shared_->context, [shared = shared_.get()] { shared->connect(); });
  shared_->thread = std::jthread([shared = shared_.get()] { shared->context.run(); });
}

Client::~Client() {
  shared_->context.stop();
  shared_->thread.join();
}

void Client::send(const Message& message) {
  asio::post(shared_->context, [shared = shared_.get(), bytes = pack(message)]() mutable {
    if (!shared->is_up || shared->queued + bytes.size() > shared->settings.largest_queue) return;
    shared->queued += bytes.size();
    shared->queue.push_back(std::move(bytes));
    if (shared->queue.size() == 1) shared->write(shared->attempt);
  });
}

ClientStatus Client::status() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->status;
}

const std::string& Client::place() const noexcept {
  return shared_->place;
}

}  // namespace bodkin::link
