#include "bench/link_soak/parts.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fstream>

#include "link/command.h"
#include "link/contents.h"
#include "tests/session/slab_case.h"
#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "core/random.h"
#include "io/case_folder.h"

namespace link_soak {

using namespace std::chrono_literals;
using namespace bodkin::link;

ServerSettings free_port() {
  ServerSettings settings;
  settings.port = 0;
  return settings;
}

ClientSettings client_of(std::uint16_t port) {
  ClientSettings settings;
  settings.host = "127.0.0.1";
  settings.port = port;
  settings.retry = 5ms;
  return settings;
}

int connect_to(std::uint16_t port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return socket;
  ::close(socket);
  return -1;
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

double memory_held() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1048576.0;
}

CaseFolder::CaseFolder()
    : path_(std::filesystem::temp_directory_path() / ("link_soak_" + std::to_string(::getpid()))) {
  std::filesystem::create_directories(path_);
  bodkin::anatomy::Case patient = bodkin::slab_case(bodkin::lumbar_slabs());
  bodkin::io::write_case(patient.description, patient.ct, patient.tissues, {}, &patient.library, path_ / "slabs");
}

CaseFolder::~CaseFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string serve_arguments(double seconds, const std::string& session) {
  return fmt::format(
      "--json serve slabs simulated --settings 'speed_mm_s=20 start_mm=2 depth_mm=35 wait_s=600' --max-time {} "
      "--port "
      "0 -o {}",
      seconds, session);
}

HostileClient::HostileClient(std::uint16_t port)
    : thread_([port](const std::stop_token& stop) {
        const Bytes good = pack({"STRING", "CMD_1", 0.0, string_content("<Command Name='GetUsParameter'/>")});
        Bytes garbage(4096);
        bodkin::Random random(7);
        for (std::uint8_t& byte : garbage) byte = static_cast<std::uint8_t>(random.next());
        for (int turn = 0; !stop.stop_requested(); ++turn) {
          const int socket = connect_to(port);
          if (socket < 0) {
            std::this_thread::sleep_for(5ms);
            continue;
          }
          const auto send = [&](const std::uint8_t* bytes, std::size_t size) {
            return ::send(socket, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT) > 0 || errno == EAGAIN;
          };
          switch (turn % 4) {
            case 0:
              for (int i = 0; i < 20000 && !stop.stop_requested() && send(good.data(), good.size()); ++i) {
              }
              break;
            case 1:
              std::this_thread::sleep_for(300ms);  // takes none of the sent data
              break;
            case 2:
              send(good.data(), good.size() / 2);
              std::this_thread::sleep_for(100ms);
              break;
            default:
              send(garbage.data(), garbage.size());
              std::this_thread::sleep_for(20ms);
          }
          ::close(socket);
        }
      }) {}

}  // namespace link_soak
