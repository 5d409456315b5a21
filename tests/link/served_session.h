#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "link/session_feed.h"
#include "station/station.h"
#include "tests/io/scratch_folder.h"
#include "tests/session/slab_case.h"

#include "haptics/drivers/simulated.h"

namespace bodkin::link {

// Three layers for a simulated hand.
inline anatomy::Case served_slabs() {
  using namespace anatomy;
  Case patient = slab_case({{tissue::skin, 2.0}, {tissue::fat, 12.0}, {tissue::muscle, 36.0}});
  patient.description.device.peak_force = 9.0;
  return patient;
}

// Runs a station on a thread, fed to a server, until the simulated hand or a client ends it.
class ServedSession {
 public:
  // `hand`: settings of the simulated one. `port`: 0: any that is free.
  explicit ServedSession(const char* hand, const anatomy::Case& patient = served_slabs(), std::uint16_t port = 0)
      : server_(settings(port)) {
    folder_.write("case.xml", "<case/>");
    station::StationOptions options;
    options.patient = patient;
    options.case_folder = folder_.path();
    options.device = {&haptics::simulated_driver(), "", hand};
    options.output = file();
    options.longest = 30.0;
    feed_ = std::make_unique<SessionFeed>(server_, screen_, std::nullopt, 60.0);
    station_ = std::make_unique<station::Station>(std::move(options), *feed_);
  }
  ~ServedSession() {
    station_->end();
    if (thread_.joinable()) thread_.join();
  }
  ServedSession(const ServedSession&) = delete;
  ServedSession& operator=(const ServedSession&) = delete;

  void start() {
    thread_ = std::thread([this] {
      result_ = station_->run();
      finished_ = true;
    });
  }
  void join() { thread_.join(); }
  bool finished() const { return finished_; }
  std::filesystem::path file() const { return folder_.path() / "session.bodkin"; }
  Server& server() { return server_; }
  std::uint16_t port() const { return server_.port(); }
  const station::StationResult& result() const { return result_; }
  // When it has ended.
  const SessionCommands& commands() const { return feed_->commands(); }

 private:
  static ServerSettings settings(std::uint16_t port) {
    ServerSettings settings;
    settings.port = port;
    return settings;
  }

  ScratchFolder folder_;
  Server server_;
  station::StationObserver screen_;
  std::unique_ptr<SessionFeed> feed_;
  std::unique_ptr<station::Station> station_;
  station::StationResult result_;
  std::atomic<bool> finished_{false};
  std::thread thread_;
};

}  // namespace bodkin::link
