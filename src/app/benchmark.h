#pragma once

#include <QString>
#include <string>
#include <vector>

namespace bodkin::app {

class MainWindow;

// A row of the benchmark: the measured and the required value.
struct BenchmarkRow {
  std::string name;
  double value = 0.0;
  std::string unit;
  double wanted = 0.0;
  bool at_most = true;  // or at least

  bool is_reached() const { return at_most ? value <= wanted : value >= wanted; }
};

// Measures the window's speed on this machine: it opens the patient that comes with Bodkin, moves the needle, turns
// the camera, looks into the volume and shows augmented reality, as a person would, `seconds` for each. CPU times are
// those of the whole process including the servo, all threads, per drawn frame. Throws SystemError when the window
// gets no patient or no needle.
std::vector<BenchmarkRow> measure_window(MainWindow& window, double seconds);

// Machine and rows as a table for a terminal.
std::string benchmark_table(const std::vector<BenchmarkRow>& rows, const MainWindow& window);

}  // namespace bodkin::app
