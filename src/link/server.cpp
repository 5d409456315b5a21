#include "link/server.h"

#include <algorithm>
#include <array>
#include <deque>
#include <future>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "link/closing_messages.h"
#include "link/contents.h"
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
using Packed = std::shared_ptr<const Bytes>;

constexpr std::size_t most_received = 1024, most_notes = 64;
constexpr std::chrono::milliseconds watch_interval{100};

// One connection. It belongs entirely to the server's thread.
struct Connection {
  explicit Connection(tcp::socket from) : socket(std::move(from)) {}

  struct Waiting {
    std::string replaceable;  // type and device of a message that a newer one replaces; empty: it is sent in any case
    Packed bytes;
    std::size_t counted = 0;  // bytes of `queued`: none when the message is shared by all
  };

  tcp::socket socket;
  std::string peer;
  std::uint64_t number = 0;
  std::deque<Waiting> queue;
  std::size_t queued = 0;  // bytes
  bool writes = false;
  std::array<std::uint8_t, header_size> head{};
  MessageHeader header;
  Bytes body;
  std::optional<Clock::time_point> began;  // an incomplete message
  Clock::time_point second = Clock::now();
  std::size_t in_second = 0;  // messages since then
  std::size_t untaken = 0;    // bytes that it sent since Shared::takes was `untaken_since`
  std::uint64_t untaken_since = 0;
  std::optional<std::chrono::milliseconds> tracking;  // the requested interval
  Clock::time_point tracked;
};

}  // namespace

struct Server::Shared {
  explicit Shared(const ServerSettings& from)
      : settings(from), acceptor(context), watch(context), closing_messages(context) {}

  ServerSettings settings;
  asio::io_context context;
  tcp::acceptor acceptor;
  asio::steady_timer watch;
  Clock::time_point last_status = Clock::now();
  std::map<std::uint64_t, std::shared_ptr<Connection>> connections;
  std::uint64_t last_number = 0;
  ClosingMessages closing_messages;
  bool reported_full = false;  // since a client was let in
  mutable std::mutex mutex;    // of what follows
  std::deque<Received> received;
  std::uint64_t takes = 0;  // how often it was emptied
  std::vector<std::string> notes;
  ServerCounts counts;
  std::jthread thread;

  void listen();
  void accept();
  void refuse(tcp::socket socket);
  void keep_watch();
  void read_head(const std::shared_ptr<Connection>& connection);
  void read_body(const std::shared_ptr<Connection>& connection);
  void receive_message(Connection& connection, Message message);
  void queue(const std::shared_ptr<Connection>& connection, const std::string& replaceable, const Packed& bytes);
  void write(const std::shared_ptr<Connection>& connection);
  // With a message: the server's own decision.
  void close(Connection& connection, const std::string& why);
};

void Server::Shared::listen() {
  error_code error;
  const auto address = asio::ip::make_address(settings.address, error);
  if (error) {
    throw InputError(
        fmt::format("'{}' is not an address, expected one of this machine such as 127.0.0.1", settings.address));
  }
  const tcp::endpoint endpoint(address, settings.port);
  acceptor.open(endpoint.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(endpoint, error);
  if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
  if (error == asio::error::address_in_use) {
    throw InputError(fmt::format("port {} of {} is in use; end the program that has it, or give another --port",
                                 settings.port, settings.address));
  }
  if (error) {
    throw InputError(
        fmt::format("no client can connect at {}, port {}: {}", settings.address, settings.port, error.message()));
  }
}

void Server::Shared::accept() {
  acceptor.async_accept([this](const error_code& error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error && connections.size() >= settings.most_clients) {
      refuse(std::move(socket));
    } else if (!error) {
      auto connection = std::make_shared<Connection>(std::move(socket));
      error_code ignored;
      connection->socket.set_option(tcp::no_delay(true), ignored);
      const auto peer = connection->socket.remote_endpoint(ignored);
      connection->peer = fmt::format("{}:{}", peer.address().to_string(), peer.port());
      connection->number = ++last_number;
      connections.emplace(connection->number, connection);
      reported_full = false;
      {
        const std::lock_guard lock(mutex);
        ++counts.accepted;
        counts.clients = connections.size();
      }
      read_head(connection);
    }
    accept();
  });
}

void Server::Shared::refuse(tcp::socket socket) {
  const std::string why = fmt::format(
      "all {} places of this server are taken; end another client, or start the server with more --clients",
      settings.most_clients);
  error_code ignored;
  closing_messages.send(socket.release(ignored), status_busy, why);
  const std::lock_guard lock(mutex);
  ++counts.refused;
  if (std::exchange(reported_full, true) || notes.size() == most_notes) return;  // a client may try every second
  notes.push_back(fmt::format("a client was refused: {} are connected already", settings.most_clients));
}

// Ends stalled connections, and shows every client that the server lives.
void Server::Shared::keep_watch() {
  watch.expires_after(watch_interval);
  watch.async_wait([this](const error_code& error) {
    if (error) return;
    const Clock::time_point now = Clock::now();
    std::vector<std::shared_ptr<Connection>> all;
    for (const auto& [number, connection] : connections) all.push_back(connection);
    for (const auto& connection : all) {
      if (connection->began && now - *connection->began > settings.patience)
        close(*connection, "the rest of a message did not arrive");
    }
    if (now - last_status >= settings.keep_alive) {
      last_status = now;
      const auto status =
          std::make_shared<const Bytes>(pack({"STATUS", "Bodkin", time_now(), status_content(1, "", "")}));
      for (const auto& connection : all) queue(connection, "STATUS", status);
    }
    keep_watch();
  });
}

void Server::Shared::close(Connection& connection, const std::string& why) {
  const auto self = connections.find(connection.number);
  if (self == connections.end()) return;  // it was closed before
  const std::shared_ptr<Connection> kept = self->second;
  connections.erase(self);
  error_code ignored;
  if (why.empty() || connection.writes) {  // in the middle of a message there is no other one
    connection.socket.close(ignored);
  } else {
    closing_messages.send(connection.socket.release(ignored), status_error, "the connection is ended: " + why);
  }
  const std::lock_guard lock(mutex);
  counts.clients = connections.size();
  if (why.empty()) return;
  ++counts.dropped;
  if (notes.size() < most_notes)
    notes.push_back(fmt::format("the client at {} was dropped: {}", connection.peer, why));
}

void Server::Shared::read_head(const std::shared_ptr<Connection>& connection) {
  connection->began.reset();
  // The first byte separately: it starts the time limit for the rest.
  asio::async_read(connection->socket, asio::buffer(connection->head.data(), 1),
                   [this, connection](const error_code& error, std::size_t /*size*/) {
                     if (error) return close(*connection, {});
                     connection->began = Clock::now();
                     asio::async_read(connection->socket, asio::buffer(connection->head.data() + 1, header_size - 1),
                                      [this, connection](const error_code& failed, std::size_t /*size*/) {
                                        if (failed) return close(*connection, {});
                                        read_body(connection);
                                      });
                   });
}

void Server::Shared::read_body(const std::shared_ptr<Connection>& connection) {
  try {
    connection->header = read_header(connection->head);
  } catch (const InputError& error) {
    return close(*connection, error.what());
  }
  if (connection->header.body_size > settings.largest_message) {
    return close(*connection, fmt::format("a message of {} bytes, at most {} are accepted",
                                          connection->header.body_size, settings.largest_message));
  }
  connection->body.resize(connection->header.body_size);
  asio::async_read(connection->socket, asio::buffer(connection->body),
                   [this, connection](const error_code& error, std::size_t /*size*/) {
                     if (error) return close(*connection, {});
                     const Clock::time_point now = Clock::now();
                     if (now - connection->second > std::chrono::seconds(1)) {
                       connection->second = now;
                       connection->in_second = 0;
                     }
                     if (++connection->in_second > settings.most_messages) {
                       return close(*connection,
                                    fmt::format("more than {} messages in a second", settings.most_messages));
                     }
                     try {
                       receive_message(*connection, unpack(connection->header, connection->body));
                     } catch (const InputError& refused) {
                       return close(*connection, refused.what());
                     }
                     read_head(connection);
                   });
}

void Server::Shared::receive_message(Connection& connection, Message message) {
  const auto self = connections.find(connection.number);
  if (self == connections.end()) return;
  {
    const std::lock_guard lock(mutex);
    ++counts.received;
  }
  const auto answer = [&](const Message& with) {
    queue(self->second, {}, std::make_shared<const Bytes>(pack(with)));
  };
  if (message.type == "GET_STATUS") return answer({"STATUS", "Bodkin", time_now(), status_content(1, "", "")});
  if (message.type == "STT_TDATA") {
    constexpr std::uint32_t least = 1, most = 60000;  // ms
    ByteReader reader(message.content);
    connection.tracking = std::chrono::milliseconds(std::clamp(reader.u32(), least, most));
    return answer({"RTS_TDATA", message.device, time_now(), Bytes{0}});  // 0: it will come
  }
  if (message.type == "STP_TDATA") return connection.tracking.reset();
  {
    const std::lock_guard lock(mutex);
    if (std::exchange(connection.untaken_since, takes) != takes) connection.untaken = 0;
    connection.untaken += message.content.size();
    if (connection.untaken <= settings.largest_queue) {
      if (received.size() < most_received) received.push_back({connection.number, std::move(message)});
      return;
    }
  }
  close(connection, "it sends more than is accepted");
}

void Server::Shared::queue(const std::shared_ptr<Connection>& connection, const std::string& replaceable,
                           const Packed& bytes) {
  if (!connections.contains(connection->number)) return;
  if (!replaceable.empty()) {
    // The first message in the queue is being written.
    for (std::size_t i = connection->writes ? 1 : 0; i < connection->queue.size(); ++i) {
      Connection::Waiting& waiting = connection->queue[i];
      if (waiting.replaceable != replaceable) continue;
      connection->queued += bytes->size();
      connection->queued -= waiting.counted;
      waiting.bytes = bytes;
      waiting.counted = bytes->size();
      return;
    }
  }
  if (connection->queued + bytes->size() > settings.largest_queue)
    return close(*connection, "it does not read what it asked for");
  connection->queue.push_back({replaceable, bytes, bytes->size()});
  connection->queued += bytes->size();
  if (!connection->writes) write(connection);
}

void Server::Shared::write(const std::shared_ptr<Connection>& connection) {
  connection->writes = true;
  const Packed bytes = connection->queue.front().bytes;
  asio::async_write(connection->socket, asio::buffer(*bytes),
                    [this, connection, bytes](const error_code& error, std::size_t /*size*/) {
                      connection->writes = false;
                      if (error) return close(*connection, {});
                      connection->queued -= connection->queue.front().counted;
                      connection->queue.pop_front();
                      {
                        const std::lock_guard lock(mutex);
                        ++counts.sent;
                      }
                      if (!connection->queue.empty()) write(connection);
                    });
}

Server::Server(const ServerSettings& settings) : shared_(std::make_unique<Shared>(settings)) {
  shared_->listen();
  shared_->accept();
  shared_->keep_watch();
  shared_->thread = std::jthread([shared = shared_.get()] { shared->context.run(); });
}

Server::~Server() {
  shared_->context.stop();
  shared_->thread.join();
}

std::uint16_t Server::port() const noexcept {
  error_code ignored;
  return shared_->acceptor.local_endpoint(ignored).port();
}

bool Server::is_exposed() const noexcept {
  error_code ignored;
  return !shared_->acceptor.local_endpoint(ignored).address().is_loopback();
}

void Server::publish(const Message& message, bool replaces) {
  const auto bytes = std::make_shared<const Bytes>(pack(message));
  std::string replaceable = replaces ? message.type + ' ' + message.device : std::string();
  asio::post(shared_->context, [shared = shared_.get(), bytes, replaceable = std::move(replaceable)] {
    std::vector<std::shared_ptr<Connection>> all;
    for (const auto& [number, connection] : shared->connections) all.push_back(connection);
    for (const auto& connection : all) shared->queue(connection, replaceable, bytes);
  });
}

void Server::publish_tracking(const Message& message) {
  const auto bytes = std::make_shared<const Bytes>(pack(message));
  asio::post(shared_->context, [shared = shared_.get(), bytes] {
    const Clock::time_point now = Clock::now();
    std::vector<std::shared_ptr<Connection>> all;
    for (const auto& [number, connection] : shared->connections) {
      // A slightly early message is better than messages at half the rate.
      if (connection->tracking && now - connection->tracked >= *connection->tracking * 9 / 10)
        all.push_back(connection);
    }
    for (const auto& connection : all) {
      connection->tracked = now;
      shared->queue(connection, "TDATA", bytes);
    }
  });
}

void Server::send(std::uint64_t client, const Message& message) {
  const auto bytes = std::make_shared<const Bytes>(pack(message));
  asio::post(shared_->context, [shared = shared_.get(), bytes, client] {
    const auto found = shared->connections.find(client);
    if (found == shared->connections.end()) return;
    const std::shared_ptr<Connection> connection = found->second;
    shared->queue(connection, {}, bytes);
  });
}

void Server::send_shared(std::uint64_t client, const std::string& name, std::shared_ptr<const Bytes> packed) {
  asio::post(shared_->context, [shared = shared_.get(), packed = std::move(packed), client, name] {
    const auto found = shared->connections.find(client);
    if (found == shared->connections.end()) return;
    Connection& connection = *found->second;
    const bool is_under_way = std::any_of(connection.queue.begin(), connection.queue.end(),
                                          [&name](const auto& waiting) { return waiting.replaceable == name; });
    if (is_under_way) return;
    connection.queue.push_back({name, packed, 0});
    if (!connection.writes) shared->write(found->second);
  });
}

void Server::flush(std::chrono::milliseconds longest) {
  constexpr std::chrono::milliseconds between{5};
  for (const Clock::time_point end = Clock::now() + longest; Clock::now() < end;
       std::this_thread::sleep_for(between)) {
    const auto is_empty = std::make_shared<std::promise<bool>>();
    std::future<bool> answer = is_empty->get_future();
    asio::post(shared_->context, [shared = shared_.get(), is_empty] {
      is_empty->set_value(std::all_of(shared->connections.begin(), shared->connections.end(), [](const auto& each) {
        return each.second->queue.empty() && !each.second->writes;
      }));
    });
    if (answer.wait_until(end) == std::future_status::ready && answer.get()) return;
  }
}

std::vector<Received> Server::take() {
  const std::lock_guard lock(shared_->mutex);
  std::vector<Received> all(std::make_move_iterator(shared_->received.begin()),
                            std::make_move_iterator(shared_->received.end()));
  shared_->received.clear();
  ++shared_->takes;
  return all;
}

ServerCounts Server::counts() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->counts;
}

std::vector<std::string> Server::take_notes() {
  const std::lock_guard lock(shared_->mutex);
  return std::exchange(shared_->notes, {});
}

}  // namespace bodkin::link
