#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace bodkin::report {

// A tissue on the path of the needle.
struct StationCardLayer {
  std::string tissue, colour;  // "Skin", "#e8b89a"
  double from = 0.0;           // mm below the entry
};

// A teacher's view of a remote station.
struct StationCard {
  std::string place;    // "room3:18944"
  std::string trouble;  // why it is not connected; empty: it is
  bool runs = false;    // a session
  std::string patient, procedure;
  std::string step;  // "2 of 7, Through the ligament"; empty: none yet
  std::string tissue, event, guard;
  std::vector<StationCardLayer> layers;           // of the planned path, in order; empty: unknown
  double path = 0.0;                              // mm from the entry to the target; 0: unknown
  double depth = 0.0, force = 0.0;                // mm, N: present values
  std::vector<std::pair<double, double>> forces;  // s, N: of the last seconds, in order
  int picture_width = 0, picture_height = 0;      // pixels
  std::vector<std::uint8_t> picture;              // ultrasound, one byte per pixel, row by row; empty: none
};

// The page of all stations, which the browser reloads every second. All text is escaped.
std::string stations_page(const std::vector<StationCard>& cards);

}  // namespace bodkin::report
