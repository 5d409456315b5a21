#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "link/client.h"

namespace bodkin::link {

// A moment of a session elsewhere, as a teacher follows it.
struct StationMoment {
  double time = 0.0;   // s of the session
  double depth = 0.0;  // mm
  double force = 0.0;  // N
};

// A tissue that the planned path meets.
struct StationLayer {
  std::string tissue, colour;  // "Skin", "#e8b89a"
  double from = 0.0;           // mm below the entry
};

// The newest that a station has told.
struct StationView {
  std::string place;    // "room3:18944"
  ClientStatus status;  // of the connection
  bool runs = false;    // a session; else the station waits for one
  std::string patient, procedure;
  std::string tissues_digest;        // of the patient in the session
  std::vector<StationLayer> layers;  // in order; empty: the case has no planned path
  double path = 0.0;                 // mm from the entry to the target
  std::string guard, tissue;         // "active", "fat"
  std::string step;                  // the newest stage that was reached; empty: none
  std::size_t step_number = 0, steps = 0;
  std::string event;                   // the newest
  std::vector<StationMoment> moments;  // of the last 20 s, ten a second
  int picture_width = 0, picture_height = 0;
  std::vector<std::uint8_t> picture;  // the ultrasound, a byte a pixel; empty: none
  std::string reply;                  // to the last command: "SUCCESS", or what is wrong; empty: none yet
};

// Follows `bodkin serve` at one place, connects again when the connection ends, and passes commands on.
class StationWatch {
 public:
  explicit StationWatch(const ClientSettings& settings);
  ~StationWatch();
  StationWatch(const StationWatch&) = delete;
  StationWatch& operator=(const StationWatch&) = delete;

  StationView view() const;
  // <Command Name="..."/> with attributes, whose reply is in the view; lost when there is no connection.
  void command(const std::string& name, const std::vector<std::pair<std::string, std::string>>& values);

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace bodkin::link
