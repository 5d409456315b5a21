#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/models/station_link.h"
#include "link/client.h"
#include "views/open_case.h"

namespace bodkin::app {

using namespace views;

// A station in another process (`bodkin serve`), followed over OpenIGTLink: receives its news in the form of a local
// station's and sends the window's commands. A lost connection is restored, and the news continue at the present
// state of the session. No call waits for the network.
class RemoteStation {
 public:
  // `patient`: the station's case, from this machine's disk; a different one ends with a sentence in the news.
  // `starts`: requests a session, once, if none is running.
  RemoteStation(const link::ClientSettings& server, std::shared_ptr<const OpenCase> patient, bool starts);
  ~RemoteStation();
  RemoteStation(const RemoteStation&) = delete;
  RemoteStation& operator=(const RemoteStation&) = delete;

  void command(station::StationCommand command);
  // The settings of its ultrasound machine; the probe is the station's.
  void set_scan_setup(const station::ScanSetup& setup);
  // Asks the station to end and save the session.
  void end();

  // Points whose displacements poll() reports when the station's body deforms: points near the planned entry, LPS mm
  // at rest.
  void follow_points(std::vector<Vec3> points);

  // Moves the news since the last call into `news`, as StationLink::poll() does.
  void poll(StationUpdate& news);

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace bodkin::app
