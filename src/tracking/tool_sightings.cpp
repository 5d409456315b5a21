#include "tracking/tool_sightings.h"

#include <algorithm>
#include <map>
#include <utility>

#include "tracking/station_footage.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::tracking {

namespace {

constexpr double late_margin = 0.005;    // s, so that a picture that is later than all before is waited for seldom
constexpr std::size_t delays_kept = 60;  // pictures, two seconds of a usual camera
constexpr double one_clock = 1.0;        // s by which a picture may be old; more: its time is of another clock

std::size_t place_of(const std::vector<MarkerBody>& bodies, const std::string& name) {
  const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const auto& body) { return body.name == name; });
  return static_cast<std::size_t>(found - bodies.begin());
}

UnknownPlace why_unseen(TrackingStatus status, UnknownPlace lost, UnknownPlace uncertain) {
  if (status == TrackingStatus::lost) return lost;
  return status == TrackingStatus::uncertain ? uncertain : UnknownPlace::no;
}

struct Announcements {
  std::mutex lock;
  std::map<std::string, std::weak_ptr<ToolSightings>> by_source;
};

Announcements& announcements() {
  static Announcements all;
  return all;
}

std::string whole_name(const std::string& source) {
  std::error_code code;
  return std::filesystem::weakly_canonical(source, code).string();
}

}  // namespace

std::string ToolFeed::trouble() const {
  const std::lock_guard guard(lock_);
  if (!end_.empty()) return end_;
  if (unseen() != UnknownPlace::no && !warning_.empty()) return warning_;
  switch (unseen()) {
    case UnknownPlace::no:
      break;
    case UnknownPlace::tool_lost:
      return fmt::format("no marker of the {} is seen; keep its markers in the picture", tool_);
    case UnknownPlace::tool_uncertain:
      return fmt::format("the {} is seen badly, its pose is uncertain; hold it still, in better light", tool_);
    case UnknownPlace::mannequin_lost:
      return "no marker of the mannequin's board is seen; keep it in the picture";
    case UnknownPlace::mannequin_uncertain:
      return "the mannequin's board is seen badly, its pose is uncertain; uncover it";
  }
  return {};
}

std::string ToolFeed::note() const {
  const std::lock_guard guard(lock_);
  return note_;
}

ToolSightings::ToolSightings(std::vector<MarkerBody> bodies, const Similarity& mannequin_from_patient, bool live)
    : bodies_(std::move(bodies)), place_(mannequin_from_patient), live_(live) {
  mannequin_ = place_of(bodies_, "mannequin");
  if (mannequin_ == bodies_.size())
    throw InputError("no body is called \"mannequin\", in which the patient is placed; name one so in the bodies");
}

std::shared_ptr<ToolFeed> ToolSightings::follow(const std::string& tool) {
  const std::size_t body = place_of(bodies_, tool);
  if (body == bodies_.size() || body == mannequin_) {
    std::string names;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (i != mannequin_) names += (names.empty() ? "" : ", ") + bodies_[i].name;
    }
    throw InputError(fmt::format("no tool among the bodies is called \"{}\"; expected {}", tool,
                                 names.empty() ? "one besides the mannequin" : names));
  }
  auto feed = std::make_shared<ToolFeed>(tool, live_);
  const std::lock_guard guard(lock_);
  for (const std::vector<ToolSighting>& picture : kept_) publish(*feed, picture[body]);
  feed->delay_.store(delay_);
  {
    const std::lock_guard inner(feed->lock_);
    feed->warning_ = warning_;
    feed->note_ = note_;
    if (end_) feed->end_ = *end_;
  }
  if (end_) {
    feed->failed_.store(!end_->empty());
    feed->ended_.store(true);
  }
  followers_.push_back({body, feed});
  return feed;
}

ToolSighting ToolSightings::sighting(std::size_t body, const std::vector<TrackedPose>& poses, double time) const {
  const TrackedPose &tool = poses[body], &mannequin = poses[mannequin_];
  ToolSighting found;
  found.time = time;
  found.unseen = why_unseen(mannequin.status, UnknownPlace::mannequin_lost, UnknownPlace::mannequin_uncertain);
  if (found.unseen == UnknownPlace::no)
    found.unseen = why_unseen(tool.status, UnknownPlace::tool_lost, UnknownPlace::tool_uncertain);
  // The mannequin rests, so the mean over its rest gives its place better than one image.
  if (found.unseen == UnknownPlace::no)
    found.pose = tool_in_patient(bodies_[body], tool.camera_from_body, mannequin.filtered, place_);
  return found;
}

void ToolSightings::publish(ToolFeed& feed, const ToolSighting& sighting) {
  feed.unseen_.store(sighting.unseen, std::memory_order_relaxed);
  if (feed.ring_.push(sighting)) feed.newest_.store(sighting.time, std::memory_order_release);
}

void ToolSightings::publish(const std::vector<TrackedPose>& poses, double time, double now) {
  if (live_ && (now - time > one_clock || now < time)) time = now;
  const std::lock_guard guard(lock_);
  if (live_) {
    // The pose between two images is known once the second one has arrived.
    if (last_ && time > *last_) delays_.push_back(std::min(now - *last_, one_clock));
    if (delays_.size() > delays_kept) delays_.erase(delays_.begin());
    delay_ = late_margin + (delays_.empty() ? now - time : *std::max_element(delays_.begin(), delays_.end()));
    last_ = time;
  } else if (kept_.size() < ToolFeed::capacity) {
    std::vector<ToolSighting>& all = kept_.emplace_back();
    for (std::size_t i = 0; i < bodies_.size(); ++i) all.push_back(sighting(i, poses, time));
  }
  std::erase_if(followers_, [](const Follower& follower) { return follower.feed.expired(); });
  for (const Follower& follower : followers_) {
    const std::shared_ptr<ToolFeed> feed = follower.feed.lock();
    if (feed == nullptr) continue;
    feed->delay_.store(delay_, std::memory_order_relaxed);
    publish(*feed, sighting(follower.body, poses, time));
  }
}

bool ToolSightings::is_waiting() const {
  if (live_) return false;
  const std::lock_guard guard(lock_);
  if (kept_.size() < ToolFeed::capacity) return false;
  bool any = false;
  for (const Follower& follower : followers_) {
    const std::shared_ptr<ToolFeed> feed = follower.feed.lock();
    any = any || (feed != nullptr && feed->ring_.is_full());
  }
  return any || followers_.empty();
}

void ToolSightings::warn(const std::string& sentence) {
  const std::lock_guard guard(lock_);
  if (sentence == warning_) return;
  warning_ = sentence;
  for (const Follower& follower : followers_) {
    if (const std::shared_ptr<ToolFeed> feed = follower.feed.lock()) {
      const std::lock_guard inner(feed->lock_);
      feed->warning_ = sentence;
    }
  }
}

void ToolSightings::note(const std::string& sentence) {
  const std::lock_guard guard(lock_);
  note_ = sentence;
  for (const Follower& follower : followers_) {
    if (const std::shared_ptr<ToolFeed> feed = follower.feed.lock()) {
      const std::lock_guard inner(feed->lock_);
      feed->note_ = sentence;
    }
  }
}

void ToolSightings::end(const std::string& failure) {
  const std::lock_guard guard(lock_);
  end_ = failure;
  for (const Follower& follower : followers_) {
    const std::shared_ptr<ToolFeed> feed = follower.feed.lock();
    if (feed == nullptr) continue;
    {
      const std::lock_guard inner(feed->lock_);
      feed->end_ = failure;
    }
    feed->failed_.store(!failure.empty(), std::memory_order_release);
    feed->ended_.store(true, std::memory_order_release);
  }
}

void announce(const std::string& source, const std::shared_ptr<ToolSightings>& sightings) {
  const std::lock_guard guard(announcements().lock);
  std::erase_if(announcements().by_source, [](const auto& entry) { return entry.second.expired(); });
  announcements().by_source[whole_name(source)] = sightings;
}

std::shared_ptr<ToolSightings> announced(const std::string& source) {
  const std::lock_guard guard(announcements().lock);
  const auto found = announcements().by_source.find(whole_name(source));
  return found == announcements().by_source.end() ? nullptr : found->second.lock();
}

}  // namespace bodkin::tracking
