#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace bodkin::link {

// An independent tracking server: the OpenIGTLink library accepts a client and packs the messages. Stands for
// PlusServer in tests. It sends the pose of one tool a hundred times a second, as TRANSFORM or in a TDATA of two
// tools.
class LibraryServer {
 public:
  enum class Kind { transform, tracking_data };

  // `tool`: at most 20 bytes.
  explicit LibraryServer(const std::string& tool, Kind kind = Kind::transform);
  ~LibraryServer();
  LibraryServer(const LibraryServer&) = delete;
  LibraryServer& operator=(const LibraryServer&) = delete;

  std::uint16_t port() const noexcept { return port_; }
  // RAS mm, upper three rows, row by row.
  void set_matrix(const std::array<float, 12>& rows);
  // Of ReferenceToTracker, the other tool of TDATA.
  void set_reference(const std::array<float, 12>& rows);
  // Sends nothing from now on, like a tracker that does not see its tool.
  void hide(bool on) { hidden_ = on; }
  // Ends the connection; the next client is let in.
  void hang_up() { hang_up_ = true; }
  int clients() const { return clients_; }

 private:
  void serve(const std::stop_token& stop);

  struct Socket;
  std::string tool_;
  Kind kind_;
  std::unique_ptr<Socket> socket_;
  std::uint16_t port_ = 0;
  std::mutex mutex_;
  std::array<float, 12> rows_ = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  std::array<float, 12> reference_ = rows_;
  std::atomic<bool> hidden_{false}, hang_up_{false};
  std::atomic<int> clients_{0};
  std::jthread thread_;
};

}  // namespace bodkin::link
