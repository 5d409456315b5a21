#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "desktop/mouse_window.h"
#include "station/station_observer.h"

#include "cli/console.h"

namespace bodkin::desktop {
class Keys;
}  // namespace bodkin::desktop

namespace bodkin::cli {

// What a person who performs sees and presses: the terminal and, for the mouse and for ultrasound, a window.
class PerformScreen : public station::StationObserver {
 public:
  // `ultrasound`: to be shown; empty: none. `has_mouse`: the mouse holds the needle. `longest`: s of the session.
  PerformScreen(Console& console, std::optional<station::UltrasoundChoice> ultrasound, bool has_mouse,
                double longest);
  ~PerformScreen() override;

  // Single keys from the terminal are commands while `keys` lives; may be null.
  void listen_to(desktop::Keys* keys) noexcept { keys_ = keys; }

  Progress progress() override { return console_.progress(); }
  void note(const std::string& sentence) override;
  // Opens the window, if there is one.
  std::vector<Vec3> prepare(const anatomy::Case& patient, const fem::BodyDescription* body) override;
  std::chrono::milliseconds interval() const override;
  void update(station::Station& station, const station::StationStatus& status) override;

 private:
  Console& console_;
  Progress line_;  // of the terminal
  std::optional<station::UltrasoundChoice> ultrasound_;
  bool has_mouse_;
  double longest_;
  desktop::Keys* keys_ = nullptr;
  std::unique_ptr<desktop::MouseWindow> window_;
};

}  // namespace bodkin::cli
