#pragma once

#include <chrono>
#include <functional>
#include <span>
#include <thread>

#include "link/server.h"
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace bodkin::link {

// A server that takes any port that is free, and loses patience soon.
inline ServerSettings any_port() {
  ServerSettings settings;
  settings.port = 0;
  settings.patience = std::chrono::milliseconds(300);
  return settings;
}

// Polls until the condition holds.
inline bool within(std::chrono::milliseconds most, const std::function<bool()>& reached) {
  for (const auto end = std::chrono::steady_clock::now() + most; std::chrono::steady_clock::now() < end;) {
    if (reached()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return reached();
}

// Unchecked bytes, straight into the server.
class RawClient {
 public:
  explicit RawClient(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  ~RawClient() { ::close(socket_); }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  void send(std::span<const std::uint8_t> bytes) const {
    EXPECT_GE(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL), 0);
  }
  // As long as the server permits it.
  bool flood(std::span<const std::uint8_t> bytes, int times) const {
    for (int i = 0; i < times; ++i) {
      if (::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) return false;
    }
    return true;
  }

 private:
  int socket_;
};

}  // namespace bodkin::link
