#pragma once

#include <string>

#include "station/station_observer.h"

#include "cli/console.h"

namespace bodkin::cli {

class TerminalKeys;

// What a person who performs sees and presses in the terminal.
class PerformScreen : public station::StationObserver {
 public:
  // `longest`: s of the session.
  PerformScreen(Console& console, double longest);

  // Single keys from the terminal are commands while `keys` lives; may be null.
  void listen_to(TerminalKeys* keys) noexcept { keys_ = keys; }

  Progress progress() override { return console_.progress(); }
  void note(const std::string& sentence) override;
  void update(station::Station& station, const station::StationStatus& status) override;

 private:
  Console& console_;
  Progress line_;  // of the terminal
  double longest_;
  TerminalKeys* keys_ = nullptr;
};

}  // namespace bodkin::cli
