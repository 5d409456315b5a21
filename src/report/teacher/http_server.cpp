#include "report/teacher/http_server.h"

#include <chrono>
#include <optional>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::report {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::uint32_t largest_header = 8192;  // bytes
constexpr std::uint64_t largest_body = 1024;    // bytes; bodies are ignored
constexpr std::chrono::seconds patience{10};

// One connection: a request, its answer, the next request. It lives as long as one of its operations is pending.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(tcp::socket socket, const HttpServer::Handler& handler, int& open)
      : stream_(std::move(socket)), handler_(handler), open_(open) {
    ++open_;
  }
  ~HttpConnection() { --open_; }
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;

  void read() {
    parser_.emplace();
    parser_->header_limit(largest_header);
    parser_->body_limit(largest_body);
    stream_.expires_after(patience);
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](const error_code& failure, std::size_t) {
      if (!failure) return self->answer();
      if (failure == http::error::header_limit || failure == http::error::body_limit)
        return self->refuse(http::status::payload_too_large);
      if (failure == http::error::end_of_stream || failure == http::error::partial_message) return self->close();
      if (failure.category() == make_error_code(http::error::bad_method).category())
        self->refuse(http::status::bad_request);
    });
  }

 private:
  void answer() {
    const http::request<http::string_body>& request = parser_->get();
    if (request.method() != http::verb::get && request.method() != http::verb::head)
      return refuse(http::status::method_not_allowed);
    HttpReply reply;
    try {
      reply = handler_({std::string(request.target()), std::string(request[http::field::host]),
                        std::string(request[http::field::cookie])});
    } catch (const std::exception&) {
      reply = {.status = 500, .type = "text/plain", .body = "The page could not be made.\n", .cookie = {}};
    }
    send(reply, request.version(), request.keep_alive(), request.method() == http::verb::head);
  }

  void refuse(http::status status) {
    send({.status = static_cast<int>(status),
          .type = "text/plain",
          .body = "This request is not supported.\n",
          .cookie = {}},
         11, false, false);
  }

  void send(const HttpReply& reply, unsigned version, bool keep_alive, bool only_header) {
    response_ = {};
    response_.version(version);
    response_.result(static_cast<unsigned>(reply.status));
    response_.set(http::field::content_type, reply.type);
    response_.set(http::field::cache_control, "no-store");
    response_.set(
        "Content-Security-Policy",
        "default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'; "
        "frame-ancestors 'none'");
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("Referrer-Policy", "no-referrer");
    if (!reply.cookie.empty()) response_.set(http::field::set_cookie, reply.cookie);
    if (reply.status == 405) response_.set(http::field::allow, "GET, HEAD");
    response_.keep_alive(keep_alive);
    if (only_header) {
      response_.content_length(reply.body.size());
    } else {
      response_.body() = reply.body;
      response_.prepare_payload();
    }
    serializer_.emplace(response_);
    const auto sent = [self = shared_from_this(), keep_alive](const error_code& failure, std::size_t) {
      if (failure) return;
      if (!keep_alive) return self->close();
      self->read();
    };
    stream_.expires_after(patience);
    if (only_header)
      http::async_write_header(stream_, *serializer_, sent);
    else
      http::async_write(stream_, *serializer_, sent);
  }

  void close() {
    error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
  }

  beast::tcp_stream stream_;
  beast::flat_buffer buffer_{largest_header + largest_body};
  std::optional<http::request_parser<http::string_body>> parser_;
  http::response<http::string_body> response_;
  std::optional<http::response_serializer<http::string_body>> serializer_;
  const HttpServer::Handler& handler_;
  int& open_;
};

}  // namespace

struct HttpServer::Impl {
  Impl(const std::string& address, std::uint16_t port, Handler its_handler)
      : handler(std::move(its_handler)), acceptor(context) {
    error_code failure;
    const auto place = asio::ip::make_address(address, failure);
    if (failure)
      throw InputError(
          fmt::format("the address is '{}', expected an IP address such as 127.0.0.1 or 0.0.0.0", address));
    const tcp::endpoint endpoint(place, port);
    acceptor.open(endpoint.protocol(), failure);
    if (!failure) acceptor.set_option(tcp::acceptor::reuse_address(true), failure);
    if (!failure) acceptor.bind(endpoint, failure);
    if (!failure) acceptor.listen(HttpServer::most_connections, failure);
    if (failure) {
      throw SystemError(fmt::format("the server cannot listen at {} port {}: {}; choose another port with --port",
                                    address, port, failure.message()));
    }
    accept();
  }

  void accept() {
    acceptor.async_accept([this](const error_code& failure, tcp::socket socket) {
      if (failure == asio::error::operation_aborted) return;
      // A connection beyond the limit is closed at once.
      if (!failure && open < HttpServer::most_connections)
        std::make_shared<HttpConnection>(std::move(socket), handler, open)->read();
      accept();
    });
  }

  Handler handler;
  int open = 0;  // connections
  asio::io_context context{1};
  tcp::acceptor acceptor;
};

HttpServer::HttpServer(const std::string& address, std::uint16_t port, Handler handler)
    : impl_(std::make_unique<Impl>(address, port, std::move(handler))) {}

HttpServer::~HttpServer() = default;

std::uint16_t HttpServer::port() const {
  return impl_->acceptor.local_endpoint().port();
}

void HttpServer::run(bool until_interrupted) {
  asio::signal_set signals(impl_->context);
  if (until_interrupted) {
    signals.add(SIGINT);
    signals.add(SIGTERM);
    signals.async_wait([this](const error_code& failure, int) {
      if (!failure) impl_->context.stop();
    });
  }
  impl_->context.run();
}

void HttpServer::stop() {
  impl_->context.stop();
}

bool is_loopback(const std::string& address) {
  error_code failure;
  const auto place = asio::ip::make_address(address, failure);
  return !failure && place.is_loopback();
}

}  // namespace bodkin::report
