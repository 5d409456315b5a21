#include "tests/haptics/spnav_server.h"

#include <cstring>
#include <stdexcept>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace mock {

SpnavServer::SpnavServer() {
  static int count = 0;
  folder_ = std::filesystem::temp_directory_path() /
            ("bodkin_spnav_" + std::to_string(getpid()) + "_" + std::to_string(count++));
  std::filesystem::create_directories(folder_);
  listener_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path().c_str(), sizeof address.sun_path - 1);
  if (bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      listen(listener_, 8) != 0) {
    throw std::runtime_error("no socket at " + path());
  }
}

SpnavServer::~SpnavServer() {
  close_all();
  std::filesystem::remove_all(folder_);
}

void SpnavServer::accept_one() {
  hang_up();
  client_ = accept(listener_, nullptr, nullptr);
}

void SpnavServer::send(const Event& event) const {
  send_bytes(event, 0, sizeof event);
}

void SpnavServer::send_bytes(const Event& event, std::size_t from, std::size_t to) const {
  std::array<char, sizeof(Event)> bytes;
  std::memcpy(bytes.data(), event.data(), bytes.size());
  if (::send(client_, bytes.data() + from, to - from, MSG_NOSIGNAL) < 0) throw std::runtime_error("nobody listens");
}

void SpnavServer::hang_up() {
  if (client_ >= 0) close(client_);
  client_ = -1;
}

void SpnavServer::close_all() {
  hang_up();
  if (listener_ >= 0) close(listener_);  // with it end the connections that wait to be taken
  listener_ = -1;
}

}  // namespace mock
