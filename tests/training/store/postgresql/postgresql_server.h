#pragma once

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bodkin {

// A PostgreSQL server for the test, on a free port of this computer; removed with its data. The server refuses to run
// as root, so root runs it as the user postgres.
class PostgresqlServer {
 public:
  PostgresqlServer() {
    for (const auto& version : {"17", "16", "15", "14", "13"}) {
      const std::string folder = fmt::format("/usr/lib/postgresql/{}/bin", version);
      if (std::filesystem::exists(folder + "/initdb")) {
        programs_ = folder;
        break;
      }
    }
    if (programs_.empty()) {
      missing_ = "no PostgreSQL server is installed here (package postgresql)";
      return;
    }
    std::array<char, 64> name{"/tmp/bodkin_postgresql_XXXXXX"};
    if (mkdtemp(name.data()) == nullptr) {
      missing_ = "no folder for a server could be made";
      return;
    }
    folder_ = name.data();
    if (geteuid() == 0 && std::system(fmt::format("chown postgres {}", folder_).c_str()) != 0) {
      missing_ = "there is no user postgres who could run the server";
      return;
    }
    port_ = free_port();
    if (!run("initdb -D {0}/data -U postgres -A trust --no-sync -E UTF8 --locale=C.UTF-8")) {
      missing_ = "initdb failed";
      return;
    }
    start();
  }
  ~PostgresqlServer() {
    if (runs_) stop();
    std::error_code ignored;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
  }
  PostgresqlServer(const PostgresqlServer&) = delete;
  PostgresqlServer& operator=(const PostgresqlServer&) = delete;

  // Why no server runs; empty: it runs.
  const std::string& missing() const { return missing_; }
  std::string url() const { return fmt::format("postgresql://postgres:secret@127.0.0.1:{}/postgres", port_); }

  void start() {
    runs_ =
        run("pg_ctl -D {0}/data -w -l {0}/log -o \"-p {1} -k {0} -c listen_addresses=127.0.0.1 -c fsync=off\" start");
    if (!runs_) missing_ = "the server did not start";
  }
  void stop() { runs_ = !run("pg_ctl -D {0}/data -w -m immediate stop"); }

 private:
  bool run(const std::string& command) const {
    const std::string filled =
        fmt::format("{}/{} > /dev/null 2>&1", programs_, fmt::format(fmt::runtime(command), folder_, port_));
    const std::string script = folder_ + "/command";
    std::ofstream(script) << "cd /\n" << filled << "\n";
    const std::string shell = geteuid() == 0 ? "runuser -u postgres -- sh " : "sh ";
    return std::system((shell + script).c_str()) == 0;
  }

  static int free_port() {
    const int socket_number = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    bind(socket_number, reinterpret_cast<const sockaddr*>(&address), size);
    getsockname(socket_number, reinterpret_cast<sockaddr*>(&address), &size);
    close(socket_number);
    return ntohs(address.sin_port);
  }

  std::string programs_, folder_, missing_;
  int port_ = 0;
  bool runs_ = false;
};

}  // namespace bodkin
