#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "link/client.h"
#include "link/server.h"

// Shared by several measurements.
namespace link_soak {

// A server at any free port.
bodkin::link::ServerSettings free_port();
// A client of it that retries soon.
bodkin::link::ClientSettings client_of(std::uint16_t port);
// A socket connected to this port of this machine; -1: nobody listens.
int connect_to(std::uint16_t port);

// The quantile `share` (0 to 1) of the values; 0 if there are none.
double percentile(std::vector<double> values, double share);
// Memory of this process, MiB.
double memory_held();

// A folder with a case, "slabs", in layers like the back of a lumbar puncture; removed at the end.
class CaseFolder {
 public:
  CaseFolder();
  ~CaseFolder();
  CaseFolder(const CaseFolder&) = delete;
  CaseFolder& operator=(const CaseFolder&) = delete;
  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

// Arguments of `bodkin` for a session in which a simulated hand is in tissue for `seconds` s (at least 1).
std::string serve_arguments(double seconds, const std::string& session);

// Floods, stalls, sends halves and garbage in turn, and connects again whenever it is dropped, until this ends.
class HostileClient {
 public:
  explicit HostileClient(std::uint16_t port);

 private:
  std::jthread thread_;
};

}  // namespace link_soak
