#include "tracking/tool_camera.h"

#include <chrono>
#include <exception>
#include <optional>
#include <utility>

#include "tracking/lens_watch.h"
#include "tracking/marker_watch.h"
#include "tracking/tracker.h"

#include "haptics/tick_clock.h"

namespace bodkin::tracking {

namespace {
constexpr std::chrono::milliseconds nap{2};
}  // namespace

ToolCamera::ToolCamera(OpenedFootage footage, const Similarity& mannequin_from_patient, std::string name)
    : name_(std::move(name)),
      footage_(std::move(footage)),
      sightings_(std::make_shared<ToolSightings>(footage_.bodies, mannequin_from_patient, footage_.source->live())) {
  sightings_->note(sentence_of(footage_.source->notes()));
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

ToolCamera::~ToolCamera() = default;

void ToolCamera::run(const std::stop_token& stop) {
  try {
    track(stop);
    sightings_->end({});
  } catch (const std::exception& failure) {
    sightings_->end(failure.what());
  }
}

void ToolCamera::track(const std::stop_token& stop) {
  Tracker tracker(footage_.camera, footage_.bodies);
  LensWatch lens;
  MarkerWatch markers(name_);
  while (!stop.stop_requested()) {
    if (sightings_->is_waiting()) {
      std::this_thread::sleep_for(nap);
      continue;
    }
    const std::optional<SourcePicture> picture = footage_.source->next();
    if (!picture) {
      if (const std::string why = markers.warning_of_all(); !why.empty()) sightings_->warn(why);
      return;
    }
    const std::vector<TrackedPose>& poses = tracker.track(picture->grey, picture->time);
    lens.add(poses);
    markers.add(tracker, picture->grey);
    const std::string why = markers.warning();
    sightings_->warn(why.empty() ? lens.warning() : why);
    sightings_->publish(poses, picture->time, haptics::monotonic_seconds());
  }
}

}  // namespace bodkin::tracking
