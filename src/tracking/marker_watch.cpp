#include "tracking/marker_watch.h"

#include <algorithm>
#include <set>

#include "tracking/station_footage.h"
#include <fmt/format.h>

namespace bodkin::tracking {

namespace {
constexpr int pictures_before_doubt = 30;
constexpr std::size_t most_named = 6;  // markers
}  // namespace

void MarkerWatch::add(const Tracker& tracker, const GreyImage& picture) {
  ++pictures_;
  const std::vector<TrackedPose>& poses = tracker.poses();
  seen_.resize(poses.size(), false);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    seen_[i] = seen_[i] || poses[i].markers > 0;
    any_body_ = any_body_ || seen_[i];
  }
  std::set<int> foreign;
  for (const FoundMarker& marker : tracker.markers()) {
    if (std::none_of(tracker.bodies().begin(), tracker.bodies().end(),
                     [&](const MarkerBody& body) { return body.face_of(marker.id) != nullptr; }))
      foreign.insert(marker.id);
  }

  without_ = tracker.markers().empty() ? without_ + 1 : 0;
  any_marker_ = any_marker_ || without_ == 0;
  if (!any_marker_) last_ = picture;
  if (without_ == 0) nothing_.clear();
  // Not in every image: it costs two searches of the whole image.
  if (without_ > 0 && without_ % pictures_before_doubt == 0) nothing_ = why_nothing_was_found(source_, picture);

  const bool is_lost = std::any_of(poses.begin(), poses.end(),
                                   [](const TrackedPose& pose) { return pose.status == TrackingStatus::lost; });
  if (!is_lost) {
    lost_ = 0;
    foreign_.clear();
    strange_.clear();
  } else {
    ++lost_;
    for (const int id : foreign) ++foreign_[id];
    if (lost_ % pictures_before_doubt == 0) {
      strange_ = sentence_about(foreign_, pictures_before_doubt);
      foreign_.clear();
    }
  }
  for (const int id : foreign) ++all_foreign_[id];
}

// Only of markers in at least half of the images: false detections are transient.
std::string MarkerWatch::sentence_about(const Counts& foreign, int pictures) const {
  std::string ids;
  std::size_t named = 0, all = 0;
  for (const auto& [id, count] : foreign) {
    if (2 * count < pictures) continue;
    if (++all > most_named) continue;
    ids += fmt::format("{}{}", named++ == 0 ? "" : ", ", id);
  }
  if (all == 0) return {};
  return fmt::format(
      "{}: markers are seen that are on no body ({}{}); name the file of the bodies that carry them, or keep those "
      "of 'bodkin markers --pdf' in view",
      source_, ids, all > named ? ", ..." : "");
}

std::string MarkerWatch::warning() const {
  return nothing_.empty() ? strange_ : nothing_;
}

std::string MarkerWatch::warning_of_all() const {
  if (!any_marker_ && last_.width > 0) return why_nothing_was_found(source_, last_);
  if (std::all_of(seen_.begin(), seen_.end(), [](bool seen) { return seen; })) return {};
  return sentence_about(all_foreign_, pictures_);
}

}  // namespace bodkin::tracking
