#pragma once

#include <string>
#include <vector>

#include "station/device_choice.h"
#include "station/station_observer.h"

#include "haptics/device_servo.h"

namespace bodkin::station {

// Whether a tracked needle is seen, for the person: a moment passes without a word, half a second does not.
class SightWatch {
 public:
  // Once a status. A sentence with the time and the driver's reason when the needle has not been seen for that long;
  // once for each time.
  std::string follow(const StationStatus& status, const haptics::DeviceServo& servo);
  // Of the whole session, `end` s long by its ticks; empty: it was always seen.
  std::string summary(double end) const;

 private:
  int times_ = 0;
  double unseen_ = 0.0;  // s, of the times that are over
  double since_ = 0.0;   // s, when the time began that is not
  bool is_unseen_ = false, was_told_ = false;
};

// What is to be known of the pictures of a camera that is the hand, such as that their rate varies: at most one
// sentence.
std::vector<std::string> notes_of_pictures(const DeviceChoice& device, const haptics::DeviceServo& servo);

}  // namespace bodkin::station
