// Following the attempt of a remote station.
#include <memory>

#include "app/models/remote_station.h"
#include "app/practice.h"
#include <fmt/format.h>

namespace bodkin::app {

void Practice::begin_following() {
  feed_.reset();
  haptics_ = patient_->patient.description.haptics;
  completing_.reset();  // the station ends its session itself
  const bool is_first = attempts_++ == 0;
  link_.follow(std::make_unique<RemoteStation>(*server_, patient_, !is_first));
  link_.follow_points(points_, {});
}

bool Practice::is_decided_elsewhere() {
  if (!server_) return false;
  show_message(fmt::format("This is controlled at the station, {}:{}.", server_->host, server_->port));
  return true;
}

}  // namespace bodkin::app
