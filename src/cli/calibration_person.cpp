#include "cli/calibration_person.h"

#include <optional>
#include <string>

#include "cli/end_on_signal.h"

namespace bodkin::cli {

station::CalibrationPerson calibration_person(Console& console, TerminalKeys& keys) {
  station::CalibrationPerson person;
  person.report = [&console](const std::string& sentence) { console.line(sentence); };
  person.progress = console.progress();
  person.after_measurement = [&console] { console.clear_bar(); };
  person.cancelled = [] { return EndOnSignal::signal() != 0; };
  if (!keys.are_there()) return person;
  person.confirmed = [&keys] {
    bool pressed = false;
    while (const std::optional<char> key = keys.next()) pressed = pressed || *key == '\n' || *key == '\r';
    return pressed;
  };
  console.line("  press Enter to begin each step, and to end it early");
  return person;
}

}  // namespace bodkin::cli
