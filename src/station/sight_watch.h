#pragma once

#include <string>
#include <vector>

#include "station/device_choice.h"
#include "station/station_observer.h"

#include "haptics/device_servo.h"

namespace bodkin::station {

// Reports whether a tracked needle is seen: a moment unseen is ignored, half a second is not.
class SightWatch {
 public:
  // To be called once per status. Returns a sentence with the time and the driver's reason when the needle has not
  // been seen for that long; once for each such period.
  std::string follow(const StationStatus& status, const haptics::DeviceServo& servo);
  // For the whole session, `end` s long by its ticks; empty: it was always seen.
  std::string summary(double end) const;

 private:
  int times_ = 0;
  double unseen_ = 0.0;  // s, of completed periods
  double since_ = 0.0;   // s, beginning of the present period
  bool is_unseen_ = false, reported_ = false;
};

// Remarks about the images of a camera that tracks the hand, such as that their rate varies: at most one sentence.
std::vector<std::string> notes_of_pictures(const DeviceChoice& device, const haptics::DeviceServo& servo);

}  // namespace bodkin::station
