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

// Why a tool's place in the patient is not known in a picture.
enum class Unseen : std::uint8_t {
  no,  // it is known
  tool_lost,
  tool_uncertain,
  mannequin_lost,
  mannequin_uncertain
};

// A tool in one picture.
struct ToolSighting {
  double time = 0.0;             // s, of the picture: when it was taken
  Pose pose = Pose::Identity();  // LPS mm, as tool_in_patient() has it; meaningless where it was not seen
  Unseen unseen = Unseen::tool_lost;
};

// What one follower gets of a tool, in order: from the camera's thread to the follower's, which never waits.
class ToolFeed {
 public:
  static constexpr std::size_t capacity = 256;  // pictures

  // `live`: pictures of now, of which late ones are dropped; else footage, which waits for its follower.
  ToolFeed(std::string tool, bool live) : tool_(std::move(tool)), live_(live) {}

  // Follower's thread; wait-free.
  bool next(ToolSighting& sighting) noexcept { return ring_.pop(sighting); }
  bool live() const noexcept { return live_; }
  // s by which a live picture is old, at most, when the one after it has come.
  double delay() const noexcept { return delay_.load(std::memory_order_relaxed); }
  // Time of the newest picture, s.
  double newest() const noexcept { return newest_.load(std::memory_order_acquire); }
  // No picture comes after the newest one.
  bool ended() const noexcept { return ended_.load(std::memory_order_acquire); }
  bool failed() const noexcept { return failed_.load(std::memory_order_acquire); }
  // Of the newest picture.
  Unseen unseen() const noexcept { return unseen_.load(std::memory_order_relaxed); }

  // Any thread but the follower's tick: why nothing is known of the tool, one sentence; empty: it is seen.
  std::string trouble() const;
  // Any thread but the follower's tick: what a user should know of the pictures themselves (ToolSightings::note());
  // empty: nothing.
  std::string note() const;
  const std::string& tool() const noexcept { return tool_; }

 private:
  friend class ToolSightings;

  std::string tool_;
  bool live_;
  SingleProducerRing<ToolSighting> ring_{capacity};
  std::atomic<double> delay_{0.0}, newest_{-1e300};
  std::atomic<bool> ended_{false}, failed_{false};
  std::atomic<Unseen> unseen_{Unseen::tool_lost};
  mutable std::mutex lock_;  // guards the three below
  std::string end_, warning_, note_;
};

// Tells followers where tools are in the patient, by the poses of each picture.
class ToolSightings {
 public:
  // Throws InputError when no body is called "mannequin".
  ToolSightings(std::vector<MarkerBody> bodies, const Similarity& mannequin_from_patient, bool live);

  // A follower of the tool from now on, and of footage from its beginning while that is kept (256 pictures). Throws
  // InputError when no body has that name.
  std::shared_ptr<ToolFeed> follow(const std::string& tool);

  // Camera's thread. Poses in the order of the bodies; `time`: s, of the picture; `now`: s, when it has been tracked,
  // of the same clock where it is live.
  void publish(const std::vector<TrackedPose>& poses, double time, double now);
  // A follower of footage has no room for another picture.
  bool is_waiting() const;
  // What a user should know of camera and light while it is so; empty: nothing.
  void warn(const std::string& sentence);
  // What a user should know of the pictures from now on, such as that their rate varies (PictureSource::notes()).
  void note(const std::string& sentence);
  // No picture comes any more; `failure`: why, a sentence; empty: the footage is over.
  void end(const std::string& failure);

  // Where the tool is in this picture.
  ToolSighting sighting(std::size_t body, const std::vector<TrackedPose>& poses, double time) const;
  const std::vector<MarkerBody>& bodies() const { return bodies_; }
  std::size_t mannequin() const { return mannequin_; }
  const Similarity& place() const { return place_; }

 private:
  struct Follower {
    std::size_t body = 0;
    std::weak_ptr<ToolFeed> feed;
  };

  static void tell(ToolFeed& feed, const ToolSighting& sighting);

  std::vector<MarkerBody> bodies_;
  Similarity place_;
  bool live_;
  std::size_t mannequin_ = 0;
  mutable std::mutex lock_;  // guards the rest
  std::vector<Follower> followers_;
  std::vector<std::vector<ToolSighting>> kept_;  // of footage, by picture and body
  std::vector<double> delays_;                   // s, of the last pictures
  double delay_ = 0.0;
  std::optional<double> last_;  // time of the picture before
  std::string warning_, note_;
  std::optional<std::string> end_;
};

// Where followers find the sightings of pictures that a window of this program is tracking already, by their source:
// a camera can be opened once. Any thread.
void announce(const std::string& source, const std::shared_ptr<ToolSightings>& sightings);
std::shared_ptr<ToolSightings> announced(const std::string& source);  // null: nobody tracks them

}  // namespace bodkin::tracking
