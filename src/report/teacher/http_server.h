#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace bodkin::report {

struct HttpRequest {
  std::string target;  // "/trainee/a?x=1", as it was sent
  std::string host;    // "127.0.0.1:8080"
  std::string cookie;
};

struct HttpReply {
  int status = 200;
  std::string type = "text/html; charset=utf-8";
  std::string body;
  std::string cookie;  // to be set; empty: none
};

// A small web server that only responds to GET and HEAD, from memory. Everything else is refused; a request has at
// most 8 KiB and ten seconds, and at most most_connections are open at a time. Replies have headers that forbid
// scripts, frames, caches and external content. An exception of the handler becomes a response of status 500 without
// details.
class HttpServer {
 public:
  using Handler = std::function<HttpReply(const HttpRequest&)>;
  static constexpr int most_connections = 64;

  // Listens on an IP address; port 0: any free one. Throws InputError for an invalid address, SystemError when it
  // cannot listen there.
  HttpServer(const std::string& address, std::uint16_t port, Handler handler);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  std::uint16_t port() const;
  // Responds, one request at a time, until stop(), or with `until_interrupted` until SIGINT or SIGTERM.
  void run(bool until_interrupted);
  // Any thread.
  void stop();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// "127.0.0.1", "::1": reachable only by programs of this computer. False for an invalid address.
bool is_loopback(const std::string& address);

}  // namespace bodkin::report
