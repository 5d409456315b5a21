#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace bodkin::haptics {

struct HaplyAddress {
  std::string host;
  int port = 0;
  std::string text() const { return host + ":" + std::to_string(port); }
};

// A web server's response.
struct HttpAnswer {
  int status = 0;
  std::string body;
};

// One GET. Throws DriverFailure{BODKIN_NOT_INSTALLED} when the port is closed, {BODKIN_COMMUNICATION_LOST} if there
// is no response within the patience or it is not HTTP; the message says only how it failed.
HttpAnswer http_get(const HaplyAddress& address, const std::string& path, std::chrono::milliseconds patience);

// A WebSocket on which every call ends by its deadline. After a failed call the connection can no longer be used.
class HaplyConnection {
 public:
  using Clock = std::chrono::steady_clock;

  // Throws as http_get does.
  HaplyConnection(const HaplyAddress& address, std::chrono::milliseconds patience);
  // Closes the connection, waiting at most a fifth of a second for the response.
  ~HaplyConnection();
  HaplyConnection(const HaplyConnection&) = delete;
  HaplyConnection& operator=(const HaplyConnection&) = delete;

  // These functions allocate and lock nothing, except for the first message of each.
  // False: it was not sent.
  bool send(std::string_view text, Clock::time_point deadline) noexcept;
  // Whether data has come since the last read, or comes by the deadline.
  bool arrives(Clock::time_point deadline) const noexcept;
  // Reads one message. False: it was incomplete or longer than `to`, or the service has gone.
  bool receive(std::span<char> to, std::size_t& size, Clock::time_point deadline) noexcept;
  // Ends the connection at once, visibly for the service.
  void abandon() noexcept;
  // From any thread: makes a waiting call and all later ones return false.
  void interrupt() noexcept;

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

}  // namespace bodkin::haptics
