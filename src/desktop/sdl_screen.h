#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "station/screen_event.h"
#include <Eigen/Core>

#include "imaging/image_rgb.h"

namespace bodkin::desktop {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
};

using station::ScreenEvent;
using station::ScreenKey;

// A window with a picture that is drawn anew each time, by SDL 2 and its SDL_ttf, which are loaded when the first one
// is opened. All of it is for one thread. Places are pixels from the upper left corner of a picture of the size that
// was asked for, which is stretched to the window.
class SdlScreen {
 public:
  enum class Size { small, normal, large, huge };  // of text: 13, 16, 26 and 48 pixels
  enum class Align { left, right, middle };

  // Throws InputError where there is no display, SystemError where SDL or its font is not installed.
  SdlScreen(const std::string& title, int width, int height);
  ~SdlScreen();
  SdlScreen(const SdlScreen&) = delete;
  SdlScreen& operator=(const SdlScreen&) = delete;

  // Why no screen can be opened here, in one sentence; empty where one can.
  static std::string obstacle();

  // The next thing that was done; false when there is none.
  bool next(ScreenEvent& event);

  void clear(Colour colour);
  void fill(double x, double y, double width, double height, Colour colour);
  // Two pixels wide, with smooth edges.
  void line(std::span<const Eigen::Vector2f> points, Colour colour);
  // The same of lines that do not hang together: two points each.
  void segments(std::span<const Eigen::Vector2f> ends, Colour colour);
  // `x` is where the text begins, ends or has its middle, `y` its upper edge.
  void text(double x, double y, const std::string& words, Size size, Colour colour, Align align = Align::left);
  // A picture, stretched to the place.
  void picture(double x, double y, double width, double height, const imaging::ImageRgb& image);
  // Shows what was drawn.
  void present();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bodkin::desktop
