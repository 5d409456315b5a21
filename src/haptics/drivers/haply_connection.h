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

// What a web server answers.
struct HttpAnswer {
  int status = 0;
  std::string body;
};

// One GET. Throws DriverFailure{BODKIN_NOT_INSTALLED} when the port is closed, {BODKIN_COMMUNICATION_LOST} where
// nobody answers within the patience or what comes is not HTTP; the message says how it failed and nothing else.
HttpAnswer http_get(const HaplyAddress& address, const std::string& path, std::chrono::milliseconds patience);

// A WebSocket on which every call ends by its deadline. Once a call has failed the connection is of no use.
class HaplyConnection {
 public:
  using Clock = std::chrono::steady_clock;

  // Throws as http_get does.
  HaplyConnection(const HaplyAddress& address, std::chrono::milliseconds patience);
  // Says goodbye, and waits for the answer for a fifth of a second at most.
  ~HaplyConnection();
  HaplyConnection(const HaplyConnection&) = delete;
  HaplyConnection& operator=(const HaplyConnection&) = delete;

  // These allocate nothing and lock nothing, save for the first message of each.
  // False: it did not go out.
  bool send(std::string_view text, Clock::time_point deadline) noexcept;
  // Whether something has come since the last read, or comes by the deadline.
  bool arrives(Clock::time_point deadline) const noexcept;
  // Reads one message. False: it did not come whole, or is longer than `to`, or the service has gone.
  bool receive(std::span<char> to, std::size_t& size, Clock::time_point deadline) noexcept;
  // Ends the connection at once: the service sees that we are gone.
  void abandon() noexcept;
  // From any thread: a call that waits returns false, and so does every later one.
  void interrupt() noexcept;

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

}  // namespace bodkin::haptics
