#include "tracking/tool_camera.h"

#include <chrono>
#include <exception>
#include <optional>
#include <utility>

#include "tracking/grey_picture.h"
#include "tracking/lens_watch.h"
#include "tracking/tracker.h"

#include "haptics/tick_clock.h"

namespace bodkin::tracking {

namespace {
constexpr std::chrono::milliseconds nap{2};
constexpr int pictures_before_doubt = 30;  // without a marker, until it is said why
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
  GreyPicture last;  // while none has shown a marker
  int without_markers = 0;
  bool any_marker = false;
  while (!stop.stop_requested()) {
    if (sightings_->is_waiting()) {
      std::this_thread::sleep_for(nap);
      continue;
    }
    const std::optional<SourcePicture> picture = footage_.source->next();
    if (!picture) {
      if (!any_marker && last.width > 0) sightings_->warn(why_nothing_was_found(name_, last));
      return;
    }
    const std::vector<TrackedPose>& poses = tracker.track(picture->grey, picture->time);
    lens.add(poses);
    without_markers = tracker.markers().empty() ? without_markers + 1 : 0;
    any_marker = any_marker || without_markers == 0;
    if (!any_marker) last = picture->grey;
    sightings_->warn(without_markers >= pictures_before_doubt ? why_nothing_was_found(name_, picture->grey)
                                                              : lens.warning());
    sightings_->publish(poses, picture->time, haptics::monotonic_seconds());
  }
}

}  // namespace bodkin::tracking
