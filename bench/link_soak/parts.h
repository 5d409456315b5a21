#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "link/client.h"
#include "link/server.h"

// What several measurements need.
namespace link_soak {

// A server at any port that is free.
bodkin::link::ServerSettings free_port();
// A client of it that tries again soon.
bodkin::link::ClientSettings client_of(std::uint16_t port);
// A socket that is connected to this port of this machine; -1: nobody listens.
int connect_to(std::uint16_t port);

// The value below which `share` (0 to 1) of all lie; 0 when there are none.
double percentile(std::vector<double> values, double share);
// MiB that this process holds.
double memory_held();

// A folder with a case, "slabs", in layers like the back of a lumbar puncture; removed in the end.
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
