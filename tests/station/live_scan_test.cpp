#include "station/live_scan.h"

#include <array>
#include <cmath>
#include <optional>

#include <gmock/gmock.h>

#include "imaging/ultrasound/probe.h"

namespace bodkin::station {
namespace {

using ::testing::HasSubstr;

// Skin at y = 0, air behind it, a path perpendicular to the skin.
anatomy::Case flat_patient() {
  anatomy::Case patient;
  anatomy::Grid grid;
  grid.size = {101, 61, 101};
  grid.spacing = Vec3::Constant(2.0);
  grid.origin = Vec3(-100, -81, -100);
  patient.tissues = anatomy::TissueVolume(grid, anatomy::tissue::muscle);
  for (int k = 0; k < 101; ++k) {
    for (int j = 41; j < 61; ++j) {
      for (int i = 0; i < 101; ++i) patient.tissues.at(i, j, k) = anatomy::tissue::air;
    }
  }
  patient.description.procedure.path = anatomy::NeedlePath{{0, 0, 0}, {0, -50, 0}};
  return patient;
}

class LiveHand : public ::testing::Test {
 protected:
  LiveHand() {
    choice_.settings.depth = 60.0;
    scan_.emplace(patient_, choice_,
                  imaging::ProbeOnSkin(imaging::probe_pose({0, 0, 0}, -Vec3::UnitY(), Vec3::UnitZ()), Vec3::UnitY()),
                  std::nullopt, LiveScan::Place{10.0, 20.0, 700, 600, 800.0, 100.0, 200.0});
    imaging::ScanState moment;
    moment.frame.width = moment.frame.height = 100;
    moment.frame.pixel = 0.6;
    moment.frame.corner = Vec3(-29.7, 0.3, 0.0);
    moment.frame.pixels.assign(10000, 7);
    moment.settings = choice_.settings;
    scan_->screen().take(moment);
  }
  void key(ScreenKey key, bool shift = false) {
    ScreenEvent event;
    event.kind = ScreenEvent::Kind::key;
    event.key = key;
    event.shift = shift;
    event.down = true;
    scan_->take(event);
    event.down = false;
    scan_->take(event);
  }
  void pointer(const Eigen::Vector2d& place, bool button) {
    ScreenEvent event;
    event.kind = ScreenEvent::Kind::motion;
    event.x = place.x();
    event.y = place.y();
    event.button = button;
    scan_->take(event);
  }
  void click(const Eigen::Vector2d& place) {
    ScreenEvent event;
    event.kind = ScreenEvent::Kind::button;
    event.x = place.x();
    event.y = place.y();
    event.down = true;
    scan_->take(event);
  }
  // In pixels of the window.
  Eigen::Vector2d at(double x, double y) const {
    return scan_->screen().to_screen({x, y}) + Eigen::Vector2d(10.0, 20.0);
  }
  void hold(ScreenKey key, double seconds, bool shift = false) {
    ScreenEvent event;
    event.kind = ScreenEvent::Kind::key;
    event.key = key;
    event.shift = shift;
    event.down = true;
    scan_->take(event);
    for (double gone = 0.0; gone < seconds - 1e-9; gone += 0.05) scan_->advance(0.05);
    event.down = false;
    scan_->take(event);
  }

  anatomy::Case patient_ = flat_patient();
  UltrasoundChoice choice_;
  std::optional<LiveScan> scan_;
};

TEST_F(LiveHand, a_drag_moves_the_probe_with_the_pointer) {
  pointer(at(0.0, 30.0), false);
  pointer(at(10.0, 30.0), true);  // 10 mm towards the orientation marker
  EXPECT_NEAR((scan_->pose().translation() - Vec3(0, 0, 10)).norm(), 0.0, 0.5);
  pointer(at(10.0, 35.0), true);  // 5 mm across
  EXPECT_NEAR(std::abs(scan_->pose().translation().x()), 5.0, 0.5);
  EXPECT_NEAR(scan_->pose().translation().y(), 0.0, 1.0);
  pointer(at(0.0, 30.0), false);  // no button, no motion
  EXPECT_NEAR(std::abs(scan_->pose().translation().x()), 5.0, 0.5);
}

TEST_F(LiveHand, beyond_the_skin_the_reason_is_said_and_nothing_stops) {
  for (int i = 0; i < 60; ++i) {
    pointer(at(0.0, 30.0), false);
    pointer(at(10.0, 30.0), true);
  }
  EXPECT_THAT(scan_->message(), HasSubstr("no skin"));
  EXPECT_LT(scan_->pose().translation().z(), 103.0);
  pointer(at(0.0, 30.0), false);
  pointer(at(-10.0, 30.0), true);
  EXPECT_EQ(scan_->message(), "");
}

TEST_F(LiveHand, wheel_and_knobs_stay_in_their_ranges) {
  using Key = ScreenKey;
  ScreenEvent wheel;
  wheel.kind = ScreenEvent::Kind::wheel;
  wheel.steps = 4.0;
  scan_->take(wheel);
  EXPECT_NEAR(scan_->pose().translation().y(), -2.0, 1e-9);
  wheel.shift = true;
  scan_->take(wheel);
  EXPECT_NEAR(scan_->settings().depth, 80.0, 1e-9);
  for (int i = 0; i < 300; ++i) {
    for (const Key knob : {Key::d, Key::g, Key::r, Key::o, Key::q}) key(knob, i >= 100);
  }
  EXPECT_EQ(scan_->settings().depth, 10.0);
  EXPECT_EQ(scan_->settings().gain, -40.0);
  EXPECT_EQ(scan_->settings().dynamic_range, 20.0);
  EXPECT_EQ(scan_->settings().focus, 5.0);
  EXPECT_EQ(scan_->settings().frequency, choice_.probe.lowest);
  check(scan_->settings(), choice_.probe);
}

TEST_F(LiveHand, arrows_turn_the_probe_while_they_are_held) {
  using Key = ScreenKey;
  hold(Key::up, 1.0);
  EXPECT_NEAR(std::acos(-scan_->pose().linear()(1, 1)) / degree, 30.0, 1.0);
  hold(Key::down, 1.0);
  hold(Key::right, 1.0);
  EXPECT_NEAR(std::acos(scan_->pose().linear()(2, 0)) / degree, 30.0, 1.0);
  EXPECT_NEAR(scan_->pose().linear()(1, 1), -1.0, 1e-9);
  hold(Key::left, 1.0);
  hold(Key::right, 1.0, true);
  EXPECT_NEAR(std::acos(-scan_->pose().linear()(1, 1)) / degree, 30.0, 1.0);
  scan_->advance(1.0);
  EXPECT_NEAR(std::acos(-scan_->pose().linear()(1, 1)) / degree, 30.0, 1.0);
}

TEST_F(LiveHand, letters_slide_the_probe_while_they_are_held) {
  using Key = ScreenKey;
  hold(Key::j, 0.5);  // to the left of the image, where the orientation marker is
  EXPECT_NEAR((scan_->pose().translation() - Vec3(0, 0, 10)).norm(), 0.0, 0.5);
  hold(Key::l, 0.5);
  hold(Key::k, 0.25);
  EXPECT_NEAR(std::abs(scan_->pose().translation().x()), 5.0, 0.5);
  hold(Key::i, 0.25);
  EXPECT_NEAR(scan_->pose().translation().norm(), 0.0, 0.5);
}

TEST_F(LiveHand, sliders_are_moved_by_keys) {
  using Key = ScreenKey;
  EXPECT_FALSE(scan_->sliders_shown());
  key(Key::three);
  key(Key::three);
  key(Key::eight, true);
  EXPECT_TRUE(scan_->sliders_shown());
  const std::array<double, 8> expected = {0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0, -2.0};
  EXPECT_EQ(scan_->settings().sliders, expected);
  for (int i = 0; i < 30; ++i) key(Key::one);
  for (int i = 0; i < 30; ++i) key(Key::two, true);
  EXPECT_EQ(scan_->settings().sliders[0], 20.0);
  EXPECT_EQ(scan_->settings().sliders[1], -20.0);
  check(scan_->settings(), choice_.probe);
  key(Key::zero);
  EXPECT_EQ(scan_->settings().sliders, (std::array<double, 8>{}));
  key(Key::t);
  EXPECT_FALSE(scan_->sliders_shown());
}

// The rows of the sliders are 18 pixels high, from (800, 100) on; 200 pixels are -20 to 20 dB.
TEST_F(LiveHand, sliders_are_moved_by_the_mouse) {
  click({850.0, 145.0});  // the sliders are not shown yet
  EXPECT_EQ(scan_->settings().sliders, (std::array<double, 8>{}));
  key(ScreenKey::t);
  click({850.0, 145.0});
  EXPECT_EQ(scan_->settings().sliders[2], -10.0);
  const Pose before = scan_->pose();
  pointer({925.0, 220.0}, true);  // the third slider remains held wherever the pointer moves
  EXPECT_EQ(scan_->settings().sliders[2], 5.0);
  pointer({2000.0, 220.0}, true);
  EXPECT_EQ(scan_->settings().sliders[2], 20.0);
  EXPECT_TRUE(scan_->pose().isApprox(before)) << "the probe went along";
  pointer({900.0, 109.0}, false);
  pointer({950.0, 109.0}, true);  // pressed outside it, the slider is not held
  EXPECT_EQ(scan_->settings().sliders[2], 20.0);
  EXPECT_EQ(scan_->settings().sliders[0], 0.0);
  ScreenEvent wheel;
  wheel.kind = ScreenEvent::Kind::wheel;
  wheel.steps = -3.0;
  pointer({900.0, 100.0 + 7.5 * 18.0}, false);
  scan_->take(wheel);
  EXPECT_EQ(scan_->settings().sliders[7], -3.0);
  EXPECT_EQ(scan_->pose().translation().y(), before.translation().y());
}

TEST_F(LiveHand, calipers_and_marks_are_set_where_the_pointer_is) {
  using Key = ScreenKey;
  key(Key::c);
  EXPECT_TRUE(scan_->screen().frozen());
  click(at(-10.0, 20.0));
  click(at(10.0, 20.0));
  ASSERT_EQ(scan_->screen().calipers().size(), 1U);
  EXPECT_NEAR(scan_->screen().calipers()[0].length(), 20.0, 1e-9);
  pointer(at(3.0, 9.0), true);  // no motion of the probe during a measurement
  EXPECT_EQ(scan_->pose().translation(), Vec3::Zero());
  key(Key::m);
  ASSERT_EQ(scan_->screen().markers().size(), 1U);
  EXPECT_NEAR((scan_->screen().markers()[0].place - Eigen::Vector2d(3.0, 9.0)).norm(), 0.0, 1e-9);
  key(Key::x);
  EXPECT_TRUE(scan_->screen().calipers().empty());
  key(Key::f);
  EXPECT_FALSE(scan_->screen().frozen());
}

TEST_F(LiveHand, the_needle_goes_in_and_out) {
  using Key = ScreenKey;
  EXPECT_FALSE(scan_->needle());
  key(Key::n);
  ASSERT_TRUE(scan_->needle());
  EXPECT_NEAR(scan_->needle()->pose.translation().y(), -25.0, 1e-9);
  hold(Key::page_down, 1.0);
  EXPECT_NEAR(scan_->needle()->pose.translation().y(), -40.0, 0.5);
  EXPECT_THAT(scan_->needle_words(), HasSubstr("40 mm"));
  key(Key::n);
  EXPECT_FALSE(scan_->needle());
  key(Key::s);
  EXPECT_TRUE(scan_->take_save());
  EXPECT_FALSE(scan_->take_save());
  key(Key::question);
  EXPECT_TRUE(scan_->help());
  key(Key::escape);
  EXPECT_FALSE(scan_->help());
  EXPECT_FALSE(scan_->ended());
  key(Key::escape);
  EXPECT_TRUE(scan_->ended());
}

}  // namespace
}  // namespace bodkin::station
