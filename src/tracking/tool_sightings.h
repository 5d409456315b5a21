#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "tracking/marker_body.h"
#include "tracking/registration.h"
#include "tracking/tracker.h"

#include "core/geometry.h"
#include "core/single_producer_ring.h"

namespace bodkin::tracking {

// Reasons why a tool's place in the patient is unknown in an image.
enum class UnknownPlace : std::uint8_t {
  no,  // it is known
  tool_lost,
  tool_uncertain,
  mannequin_lost,
  mannequin_uncertain
};

// A tool in one image.
struct ToolSighting {
  double time = 0.0;             // s, of the image's exposure
  Pose pose = Pose::Identity();  // LPS mm, as from tool_in_patient(); meaningless if it was not seen
  UnknownPlace unseen = UnknownPlace::tool_lost;
};

// The sightings of a tool for one follower, in order: from the camera's thread to the follower's, which never waits.
class ToolFeed {
 public:
  static constexpr std::size_t capacity = 256;  // pictures

  // `live`: present images, of which late ones are dropped; else footage, which waits for its follower.
  ToolFeed(std::string tool, bool live) : tool_(std::move(tool)), live_(live) {}

  // Follower's thread; wait-free.
  bool next(ToolSighting& sighting) noexcept { return ring_.pop(sighting); }
  bool live() const noexcept { return live_; }
  // s, largest age of a live image when the next one arrives.
  double delay() const noexcept { return delay_.load(std::memory_order_relaxed); }
  // Time of the newest image, s.
  double newest() const noexcept { return newest_.load(std::memory_order_acquire); }
  // Whether no further image will follow.
  bool ended() const noexcept { return ended_.load(std::memory_order_acquire); }
  bool failed() const noexcept { return failed_.load(std::memory_order_acquire); }
  // Of the newest image.
  UnknownPlace unseen() const noexcept { return unseen_.load(std::memory_order_relaxed); }

  // Any thread but the follower's tick: why the tool is not seen, one sentence; empty: it is seen.
  std::string trouble() const;
  // Any thread but the follower's tick: remarks for the user about the images (ToolSightings::note()); empty: none.
  std::string note() const;
  const std::string& tool() const noexcept { return tool_; }

 private:
  friend class ToolSightings;

  std::string tool_;
  bool live_;
  SingleProducerRing<ToolSighting> ring_{capacity};
  std::atomic<double> delay_{0.0}, newest_{-1e300};
  std::atomic<bool> ended_{false}, failed_{false};
  std::atomic<UnknownPlace> unseen_{UnknownPlace::tool_lost};
  mutable std::mutex lock_;  // guards the next three members
  std::string end_, warning_, note_;
};

// Gives followers the places of tools in the patient, from the poses of each image.
class ToolSightings {
 public:
  // Throws InputError when no body is named "mannequin".
  ToolSightings(std::vector<MarkerBody> bodies, const Similarity& mannequin_from_patient, bool live);

  // Adds a follower of the tool from now on, for footage from its beginning while that is stored (256 images). Throws
  // InputError when no body has that name.
  std::shared_ptr<ToolFeed> follow(const std::string& tool);

  // Camera's thread. Poses in the order of the bodies; `time`: s, of the image; `now`: s, end of its tracking, on the
  // same clock if live.
  void publish(const std::vector<TrackedPose>& poses, double time, double now);
  // Whether a follower of footage has no room for another image.
  bool is_waiting() const;
  // A warning for the user about camera and light while it applies; empty: none.
  void warn(const std::string& sentence);
  // A remark for the user about the images from now on, such as that their rate varies (PictureSource::notes()).
  void note(const std::string& sentence);
  // No further image will follow; `failure`: the reason, a sentence; empty: the footage has ended.
  void end(const std::string& failure);

  // The sighting of the tool in this image.
  ToolSighting sighting(std::size_t body, const std::vector<TrackedPose>& poses, double time) const;
  const std::vector<MarkerBody>& bodies() const { return bodies_; }
  std::size_t mannequin() const { return mannequin_; }
  const Similarity& place() const { return place_; }

 private:
  struct Follower {
    std::size_t body = 0;
    std::weak_ptr<ToolFeed> feed;
  };

  static void publish(ToolFeed& feed, const ToolSighting& sighting);

  std::vector<MarkerBody> bodies_;
  Similarity place_;
  bool live_;
  std::size_t mannequin_ = 0;
  mutable std::mutex lock_;  // guards the rest
  std::vector<Follower> followers_;
  std::vector<std::vector<ToolSighting>> kept_;  // of footage, by image and body
  std::vector<double> delays_;                   // s, of the last images
  double delay_ = 0.0;
  std::optional<double> last_;  // time of the previous image
  std::string warning_, note_;
  std::optional<std::string> end_;
};

// Registry in which followers find the sightings of images already tracked by a window of this program, by their
// source: a camera can be opened only once. Any thread.
void announce(const std::string& source, const std::shared_ptr<ToolSightings>& sightings);
std::shared_ptr<ToolSightings> announced(const std::string& source);  // null: not tracked

}  // namespace bodkin::tracking
