#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "link/client.h"

namespace bodkin::link {

// A remote session at one time, as shown to a teacher.
struct StationState {
  double time = 0.0;   // s of the session
  double depth = 0.0;  // mm
  double force = 0.0;  // N
};

// A tissue on the planned path.
struct StationLayer {
  std::string tissue, colour;  // "Skin", "#e8b89a"
  double from = 0.0;           // mm below the entry
};

// The newest data from a station.
struct StationView {
  std::string place;    // "room3:18944"
  ClientStatus status;  // of the connection
  bool runs = false;    // a session; otherwise the station waits for one
  std::string patient, procedure;
  std::string tissues_digest;        // of the patient in the session
  std::vector<StationLayer> layers;  // in order; empty: the case has no planned path
  double path = 0.0;                 // mm from the entry to the target
  std::string guard, tissue;         // "active", "fat"
  std::string step;                  // newest one reached; empty: none
  std::size_t step_number = 0, steps = 0;
  std::string event;                  // newest one
  std::vector<StationState> moments;  // of the last 20 s, ten per second
  int picture_width = 0, picture_height = 0;
  std::vector<std::uint8_t> picture;  // ultrasound, one byte per pixel; empty: none
  std::string reply;                  // to the last command: "SUCCESS", or the error; empty: none yet
};

// Follows `bodkin serve` at one address, reconnects when the connection ends, and sends commands.
class StationWatch {
 public:
  explicit StationWatch(const ClientSettings& settings);
  ~StationWatch();
  StationWatch(const StationWatch&) = delete;
  StationWatch& operator=(const StationWatch&) = delete;

  StationView view() const;
  // <Command Name="..."/> with attributes, whose reply is in the view; dropped without a connection.
  void command(const std::string& name, const std::vector<std::pair<std::string, std::string>>& values);

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace bodkin::link
