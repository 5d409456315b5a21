#pragma once

#include <string>
#include <utility>

#include "station/puncture_watch.h"
#include "station/station_observer.h"

#include "cli/console.h"
#include "training/taken_out.h"

namespace bodkin::cli {

class TerminalKeys;

// What a person who performs sees and presses in the terminal.
class PerformScreen : public station::StationObserver {
 public:
  // `longest`: s of the session.
  PerformScreen(Console& console, double longest);

  // Single keys from the terminal are commands while `keys` lives; may be null.
  void listen_to(TerminalKeys* keys) noexcept { keys_ = keys; }

  // The session ends as the patient's procedure has it: in a biopsy when the tip touches the mass, otherwise when the
  // needle was taken out. Without this call a person ends it.
  void end_as_practised(const anatomy::Case& patient);

  Progress progress() override { return console_.progress(); }
  void note(const std::string& sentence) override;
  void update(station::Station& station, const station::StationStatus& status) override;

 private:
  void follow_completion(station::Station& station, const station::StationStatus& status);
  void follow_taken_out(station::Station& station, const station::StationStatus& status);

  Console& console_;
  Progress line_;  // of the terminal
  double longest_;
  std::string ending_;  // name of the tissue at which it ends, touched after the skin has given way; may be empty
  station::PunctureWatch contact_;
  training::TakenOut taken_out_;
  bool has_ended_ = false;  // by itself
  TerminalKeys* keys_ = nullptr;
};

}  // namespace bodkin::cli
