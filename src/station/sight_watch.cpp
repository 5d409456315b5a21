#include "station/sight_watch.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace bodkin::station {

namespace {
constexpr double a_moment = 0.5;  // s
}

std::string SightWatch::follow(const StationStatus& status, const haptics::DeviceServo& servo) {
  for (const session::SessionEvent& event : status.events) {
    if (event.event.kind == forces::EventKind::hand_lost) {
      ++times_;
      is_unseen_ = true;
      reported_ = false;
      since_ = status.time;
    } else if (event.event.kind == forces::EventKind::hand_seen) {
      unseen_ += event.event.value;
      is_unseen_ = false;
    }
  }
  if (!is_unseen_ || reported_ || status.time - since_ < a_moment) return {};
  reported_ = true;
  return fmt::format("{:.1f} s: the needle is not seen and rests where it was: {}", status.time, servo.explain());
}

std::string SightWatch::summary(double end) const {
  if (times_ == 0) return {};
  const double all = unseen_ + (is_unseen_ ? std::max(0.0, end - since_) : 0.0);
  return fmt::format(
      "the needle was not seen {} {}, {:.2f} s in all; it rested where it was, and 'bodkin report' shows when",
      times_, times_ == 1 ? "time" : "times", all);
}

std::vector<std::string> notes_of_pictures(const DeviceChoice& device, const haptics::DeviceServo& servo) {
  if (!device.is_seen()) return {};
  std::string known = servo.explain();
  if (known.empty()) return {};
  return {std::move(known)};
}

}  // namespace bodkin::station
