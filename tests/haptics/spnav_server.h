#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

namespace mock {

// spacenavd's socket, in a scratch folder: takes connections (the system's queue holds them) and sends events to the
// last.
class SpnavServer {
 public:
  using Event = std::array<std::int32_t, 8>;

  SpnavServer();
  ~SpnavServer();
  SpnavServer(const SpnavServer&) = delete;
  SpnavServer& operator=(const SpnavServer&) = delete;

  std::string path() const { return (folder_ / "spnav.sock").string(); }
  // Accepts a connection; blocks until there is one.
  void accept_one();
  void send(const Event& event) const;
  // The first bytes now, the rest with the next call.
  void send_bytes(const Event& event, std::size_t from, std::size_t to) const;
  void hang_up();
  // Accepts no more connections and ends the existing ones, as when the daemon stops.
  void close_all();

 private:
  std::filesystem::path folder_;
  int listener_ = -1;
  int client_ = -1;
};

}  // namespace mock
