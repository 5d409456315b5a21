#pragma once

#include <string>
#include <utility>

#include "station/puncture_watch.h"
#include "station/station_observer.h"

#include "cli/console.h"
#include "training/needle_withdrawal.h"

namespace bodkin::cli {

class TerminalKeys;

// Display and keys of `bodkin perform` in the terminal.
class PerformScreen : public station::StationObserver {
 public:
  // `longest`: s of the session.
  PerformScreen(Console& console, double longest);

  // Interprets single keys from the terminal as commands during the lifetime of `keys`; may be null.
  void listen_to(TerminalKeys* keys) noexcept { keys_ = keys; }

  // Ends the session as the patient's procedure defines: in a biopsy when the tip touches the mass, otherwise when
  // the needle was withdrawn. Without this call the user ends it.
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
  std::string ending_;  // tissue whose contact ends the session, after puncture of the skin; may be empty
  station::PunctureWatch contact_;
  training::NeedleWithdrawal taken_out_;
  bool has_ended_ = false;  // automatically
  TerminalKeys* keys_ = nullptr;
};

}  // namespace bodkin::cli
