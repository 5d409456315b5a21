#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "link/message.h"

namespace bodkin::link {

// An independent OpenIGTLink client: the library connects, reads and packs. Stands for 3D Slicer in tests.
class LibraryClient {
 public:
  explicit LibraryClient(std::uint16_t port);
  ~LibraryClient();
  LibraryClient(const LibraryClient&) = delete;
  LibraryClient& operator=(const LibraryClient&) = delete;

  // As they are.
  void send_bytes(std::span<const std::uint8_t> bytes);
  void send_string(const std::string& device, const std::string& text);
  void start_tracking(int interval);  // ms
  void ask_for_image(const std::string& device);
  // Reads until a message of this type ("": of any) pleases `is_it`. False when none came in time.
  bool wait_for(const std::string& type, std::chrono::milliseconds most,
                const std::function<bool(const Message&)>& is_it);
  // Reads what has come, and for so long what comes, and counts those of the type.
  std::size_t count(const std::string& type, std::chrono::milliseconds longer);

 private:
  bool read(Message& message);

  struct Socket;
  std::unique_ptr<Socket> socket_;
};

}  // namespace bodkin::link
