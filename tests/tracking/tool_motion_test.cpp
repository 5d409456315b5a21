// A tracked tool between images, and while it is not seen.
#include "tracking/tool_motion.h"

#include <algorithm>
#include <cmath>

#include "tracking/footage_scene.h"
#include "tracking/station_footage.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin::tracking {
namespace {

constexpr double tick = 0.001;  // s

// A mannequin and a needle in front of a camera, the tip at a given x; the patient's frame is the mannequin's.
class Seen {
 public:
  explicit Seen(bool live)
      : sightings({cube_body("mannequin", 0, 60.0, 0.0), cube_body("needle", 12, 60.0, 150.0)}, {}, live) {
    feed = sightings.follow("needle");
  }

  static std::vector<TrackedPose> poses(double x, TrackingStatus needle = TrackingStatus::ok,
                                        TrackingStatus mannequin = TrackingStatus::ok) {
    std::vector<TrackedPose> made(2);
    made[0].status = mannequin;
    made[1].status = needle;
    made[0].camera_from_body.translation() = made[0].filtered.translation() = Vec3(0, 0, 700);
    made[1].camera_from_body.translation() = Vec3(x, 0, 700);
    return made;
  }
  void show(double time, double x, double now, TrackingStatus needle = TrackingStatus::ok) {
    sightings.publish(poses(x, needle), time, now);
  }

  ToolSightings sightings;
  std::shared_ptr<ToolFeed> feed;
  ToolMotion motion;
};

double x_of(const ToolMotion::Place& place) {
  return place.pose.translation().x();
}

TEST(ToolSightings, are_where_the_overlay_draws_the_tool_and_name_what_is_not_seen) {
  Seen seen(true);
  const auto& sightings = seen.sightings;
  std::vector<TrackedPose> poses = Seen::poses(12.0);
  poses[0].camera_from_body.translation().x() = 0.4;  // noise of one image, absent from the mean at rest
  const ToolSighting found = sightings.sighting(1, poses, 3.0);
  EXPECT_EQ(found.unseen, UnknownPlace::no);
  const Pose expected = tool_in_patient(sightings.bodies()[1], poses[1].camera_from_body, poses[0].filtered, {});
  EXPECT_LT((found.pose.matrix() - expected.matrix()).norm(), 1e-12);
  using enum TrackingStatus;
  EXPECT_EQ(sightings.sighting(1, Seen::poses(0, lost), 0).unseen, UnknownPlace::tool_lost);
  EXPECT_EQ(sightings.sighting(1, Seen::poses(0, uncertain), 0).unseen, UnknownPlace::tool_uncertain);
  EXPECT_EQ(sightings.sighting(1, Seen::poses(0, ok, lost), 0).unseen, UnknownPlace::mannequin_lost);
  EXPECT_EQ(sightings.sighting(1, Seen::poses(0, lost, uncertain), 0).unseen, UnknownPlace::mannequin_uncertain);
}

TEST(ToolSightings, every_follower_knows_what_is_to_be_known_of_the_pictures) {
  Seen seen(true);
  EXPECT_EQ(seen.feed->note(), "");
  seen.sightings.note("the exposure of this camera cannot be fixed; keep the light steady");
  seen.show(1.0, 0.0, 1.0);
  EXPECT_EQ(seen.feed->trouble(), "") << "it is no trouble";
  EXPECT_THAT(seen.feed->note(), testing::HasSubstr("exposure"));
  EXPECT_EQ(seen.sightings.follow("needle")->note(), seen.feed->note()) << "one that comes later";
}

TEST(ToolSightings, a_tool_that_is_none_of_the_bodies_is_refused_with_those_that_are) {
  Seen seen(true);
  try {
    seen.sightings.follow("scalpel");
    ADD_FAILURE() << "followed";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("\"scalpel\"; expected needle"));
  }
  EXPECT_THROW(seen.sightings.follow("mannequin"), InputError);
  EXPECT_THROW(ToolSightings({cube_body("needle", 12, 60.0, 150.0)}, {}, true), InputError);
}

TEST(ToolMotion, footage_is_played_in_the_time_of_its_pictures_however_they_are_spaced) {
  Seen seen(false);
  const double times[] = {0.0, 0.03, 0.1, 0.11, 0.25, 0.3};
  for (const double time : times) seen.show(time, 40.0 * time * time, 0.0);
  seen.sightings.end({});
  const Pose first = seen.sightings.sighting(1, Seen::poses(0.0), 0.0).pose;
  seen.motion.start(first, 0.0);
  const double origin = first.translation().x();
  double now = 0.0;
  ToolMotion::Place place;
  for (int n = 0; n < 400 && !place.over; ++n) {
    place = seen.motion.step(*seen.feed, now, n == 0 ? 0.0 : tick);
    now = n * tick;
    const double* const after = std::upper_bound(std::begin(times), std::end(times), now);
    if (after == std::end(times)) continue;
    const double t0 = *(after - 1), t1 = *after, x0 = 40.0 * t0 * t0, x1 = 40.0 * t1 * t1;
    EXPECT_TRUE(place.seen);
    EXPECT_NEAR(x_of(place) - origin, x0 + (x1 - x0) * (now - t0) / (t1 - t0), 1e-9) << now;
  }
  EXPECT_TRUE(place.over);
  EXPECT_NEAR(x_of(place) - origin, 40.0 * 0.09, 1e-9) << "the last picture";
}

TEST(ToolMotion, footage_that_is_tracked_slowly_is_waited_for_and_loses_nothing) {
  Seen seen(false);
  seen.show(0.0, 0.0, 0.0);
  const Pose first = seen.sightings.sighting(1, Seen::poses(0.0), 0.0).pose;
  seen.motion.start(first, 0.0);
  for (int n = 0; n < 500; ++n) seen.motion.step(*seen.feed, n * tick, tick);
  seen.show(0.1, 10.0, 0.0);  // tracked half a second late
  double before = x_of(seen.motion.step(*seen.feed, 0.5, tick));
  for (int n = 0; n < 99; ++n) {
    const double x = x_of(seen.motion.step(*seen.feed, 0.5, tick));
    EXPECT_NEAR(x - before, 0.1, 1e-6) << "the hand's own speed";
    before = x;
  }
}

TEST(ToolMotion, a_needle_that_is_not_seen_rests_at_its_last_place_and_is_caught_up_with) {
  for (const TrackingStatus bad : {TrackingStatus::lost, TrackingStatus::uncertain}) {
    Seen seen(false);
    // Hidden from 0.1 s to 0.3 s; meanwhile it moves 30 mm.
    for (int n = 0; n <= 20; ++n) {
      const double time = 0.05 * n;
      const bool hidden = n > 2 && n < 6;
      seen.show(time, hidden ? 500.0 : 100.0 * time, 0.0, hidden ? bad : TrackingStatus::ok);
    }
    const Pose first = seen.sightings.sighting(1, Seen::poses(0.0), 0.0).pose;
    seen.motion.start(first, 0.0);
    double before = 0.0, unseen = 0.0;
    for (int n = 0; n < 900; ++n) {
      const double time = n * tick;
      const ToolMotion::Place place = seen.motion.step(*seen.feed, time, n == 0 ? 0.0 : tick);
      const double x = x_of(place) - first.translation().x();
      if (!place.seen) unseen += tick;
      if (time > 0.1 && time < 0.3) {
        EXPECT_FALSE(place.seen) << time;
        EXPECT_NEAR(x, 10.0, 1e-6) << "where it was seen last, at " << time;
      }
      if (place.seen) {
        EXPECT_NEAR(x, 100.0 * time, 0.06) << "where it is, at " << time;
      }
      EXPECT_LE(x - before, 300.0 * tick + 1e-9) << time;
      before = x;
    }
    // The gap, and 20 mm at 300 mm/s behind a needle that continues at 100 mm/s.
    EXPECT_NEAR(unseen, 0.2 + 0.1, 0.01);
  }
}

TEST(ToolMotion, a_live_needle_keeps_the_speed_of_the_hand_though_pictures_come_at_odd_times) {
  Seen seen(true);
  Random random(5);
  const double speed = 60.0, start = 1000.0;
  double next = start, arrives = start + 0.02;
  double taken = next;
  Pose first = seen.sightings.sighting(1, Seen::poses(0.0), 0.0).pose;
  seen.motion.start(first, 0.0);
  double before = 0.0, worst = 0.0, most_late = 0.0;
  int judged = 0;
  for (int n = 0; n < 6000; ++n) {
    const double now = start + n * tick;
    if (now >= arrives) {
      seen.show(taken, speed * (taken - start), now);
      next = taken + random.uniform(0.02, 0.05);  // a camera whose rate varies
      taken = next;
      arrives = std::max(taken + random.uniform(0.02, 0.06), now + tick);
    }
    const ToolMotion::Place place = seen.motion.step(*seen.feed, now, tick);
    const double x = x_of(place) - first.translation().x();
    if (n > 3000) {
      worst = std::max(worst, std::abs((x - before) / tick / speed - 1.0));
      most_late = std::max(most_late, now - start - x / speed);
      EXPECT_TRUE(place.seen);
      ++judged;
    }
    before = x;
  }
  EXPECT_GT(judged, 2000);
  EXPECT_LT(worst, 0.06) << "share of its speed";
  EXPECT_LT(most_late, 0.05 + 0.06 + 0.01) << "s: a picture's way and the time to the next one";
}

TEST(ToolMotion, a_camera_from_which_nothing_comes_shows_no_needle) {
  Seen seen(true);
  for (int n = 0; n < 10; ++n) seen.show(10.0 + 0.03 * n, 1.0, 10.0 + 0.03 * n + 0.02);
  seen.motion.start(seen.sightings.sighting(1, Seen::poses(1.0), 0.0).pose, 0.0);
  bool was_seen = false;
  ToolMotion::Place place;
  for (int n = 0; n < 1000; ++n) {
    place = seen.motion.step(*seen.feed, 10.3 + n * tick, tick);
    was_seen = was_seen || place.seen;
  }
  EXPECT_TRUE(was_seen);
  EXPECT_FALSE(place.seen);
  EXPECT_FALSE(place.over);
  seen.sightings.end("/dev/video0 does not answer any more");
  EXPECT_TRUE(seen.feed->failed());
  EXPECT_EQ(seen.feed->trouble(), "/dev/video0 does not answer any more");
}

}  // namespace
}  // namespace bodkin::tracking
