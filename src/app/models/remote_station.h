#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/models/station_link.h"
#include "link/client.h"
#include "views/open_case.h"

namespace bodkin::app {

using namespace views;

// A station that runs elsewhere, as `bodkin serve` shows it over OpenIGTLink: its news as those of a station of this
// program, and the window's commands on their way there. A connection that ends is made again, and the news go on
// where the session then is. Nobody waits for the network.
class RemoteStation {
 public:
  // `patient`: the case that the station has, from this machine's disk; another one ends with a sentence in the news.
  // `starts`: asks for a session, once, where none runs.
  RemoteStation(const link::ClientSettings& server, std::shared_ptr<const OpenCase> patient, bool starts);
  ~RemoteStation();
  RemoteStation(const RemoteStation&) = delete;
  RemoteStation& operator=(const RemoteStation&) = delete;

  void command(station::StationCommand command);
  // How its ultrasound machine is set; the probe is the station's.
  void set_scan_order(const station::ScanOrder& order);
  // The session is to end and be saved there.
  void end();

  // Whose displacements poll() is to bring when the station's body deforms: points near the planned entry, LPS mm at
  // rest.
  void follow_points(std::vector<Vec3> points);

  // Moves what is new since the last call into `news`, as StationLink::poll() has it.
  void poll(StationNews& news);

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace bodkin::app
