#pragma once

#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "desktop/body_view.h"
#include "desktop/mouse_driver.h"
#include "desktop/sdl_screen.h"
#include "desktop/ultrasound_pane.h"

namespace bodkin::desktop {

// What the window shows at one time.
struct WindowScene {
  double time = 0.0;    // s since the session began
  double force = 0.0;   // N on the needle
  double depth = 0.0;   // mm
  std::string tissue;   // at the tip
  std::string state;    // of the guard
  std::string hold;     // "held", "clutch" or empty
  std::string message;  // the guard's last word
  double beside = 0.0;  // mm from the tip to the planned path
  double angle = 0.0;   // deg between the needle and that path
  Pose needle = Pose::Identity();
  bool armed = false;
  bool faulted = false;
  std::span<const float> displacements;              // of the BodyView's points; may be empty
  const station::LivePicture* ultrasound = nullptr;  // may be null
  bool probe_is_held = false;                        // by a second hand
};

// The window of the mouse: takes what the person does with mouse and keyboard, and shows the force. A device of
// mouse_driver() that is opened while it lives follows its pointer. All of it is for one thread.
class MouseWindow {
 public:
  // Throws InputError where there is no display, SystemError where SDL is not installed.
  // `with_ultrasound`: leaves room for show_ultrasound(). `has_mouse`: the mouse is the device, and its help is
  // shown.
  explicit MouseWindow(std::string title, bool with_ultrasound = false, bool has_mouse = true);
  // A deformable body that is shown beside the curve, from now on; may be null.
  void show_body(std::unique_ptr<BodyView> body) { body_ = std::move(body); }
  // The ultrasound beside all that, from now on, at ultrasound_x, 0; the window is then drawn 60 times a second.
  void show_ultrasound(std::unique_ptr<UltrasoundPane> pane) { pane_ = std::move(pane); }
  static constexpr double ultrasound_x = 948.0;
  // May be null.
  UltrasoundPane* ultrasound() noexcept { return pane_.get(); }

  // Why no window can be opened here, in one sentence; empty where one can.
  static std::string obstacle() { return SdlScreen::obstacle(); }

  // Handles the events since the last call. To be called at least every 20 ms.
  void poll();
  // A key that is a command, as the terminal's Keys give it: space, 'a', 'c', 'd', or 'q' for Escape and for closing.
  std::optional<char> next_key();
  // Draws, 30 times a second at most; 60 times with an ultrasound.
  void show(const WindowScene& scene);

 private:
  void handle(const ScreenEvent& event);
  void press(ScreenKey key, bool down);
  void draw(const WindowScene& scene);
  void draw_force(const WindowScene& scene);
  void draw_curve();
  void draw_body(const WindowScene& scene);
  void draw_side(const WindowScene& scene);

  struct Sample {
    double time, force;  // s, N
  };

  std::string title_;
  SdlScreen screen_;
  haptics::PointerInput input_;
  std::shared_ptr<PointerFeed> feed_ = std::make_shared<PointerFeed>();
  std::optional<Eigen::Vector2d> pointer_;  // where it was, while it is in the window
  std::deque<char> keys_;
  std::deque<Sample> history_;
  std::unique_ptr<BodyView> body_;
  std::unique_ptr<UltrasoundPane> pane_;
  bool has_mouse_;
  std::chrono::steady_clock::time_point shown_{};
};

}  // namespace bodkin::desktop
