#pragma once

#include <memory>
#include <string>
#include <thread>

#include "tracking/station_footage.h"
#include "tracking/tool_sightings.h"

namespace bodkin::tracking {

// Tracks the tools of a teaching station on its own thread, for followers that need no image: of a camera the newest
// images, of footage each one, as soon as there is room for it.
class ToolCamera {
 public:
  // Throws InputError as ToolSightings does. `name`: of the source, for sentences.
  ToolCamera(OpenedFootage footage, const Similarity& mannequin_from_patient, std::string name);
  ~ToolCamera();
  ToolCamera(const ToolCamera&) = delete;
  ToolCamera& operator=(const ToolCamera&) = delete;

  const std::shared_ptr<ToolSightings>& sightings() const { return sightings_; }

 private:
  void run(const std::stop_token& stop);
  void track(const std::stop_token& stop);

  std::string name_;
  OpenedFootage footage_;
  std::shared_ptr<ToolSightings> sightings_;
  std::jthread thread_;  // the last member: it uses the others
};

}  // namespace bodkin::tracking
