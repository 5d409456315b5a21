#include "desktop/machine_view.h"

#include <fmt/format.h>

namespace bodkin {

namespace {

using LetterAlign = SdlScreen::Align;

constexpr Colour letter_ink{232, 238, 245}, letter_faint{142, 156, 174}, letter_warn{245, 185, 66},
    letter_yellow{255, 216, 77}, letter_blue{76, 194, 255}, slider_track{45, 56, 72};

Colour colour_of(ScreenWords::Role role) {
  switch (role) {
    case ScreenWords::Role::plain:
      return letter_ink;
    case ScreenWords::Role::warning:
      return letter_warn;
    case ScreenWords::Role::caliper:
      return letter_yellow;
    case ScreenWords::Role::marker:
      return letter_blue;
    case ScreenWords::Role::faint:
      break;
  }
  return letter_faint;
}

LetterAlign align_of(ScreenWords::Align align) {
  return align == ScreenWords::Align::left     ? LetterAlign::left
         : align == ScreenWords::Align::middle ? LetterAlign::middle
                                               : LetterAlign::right;
}

}  // namespace

void draw_machine(SdlScreen& screen, const LiveScan::Place& place, const UltrasoundScreen& machine) {
  screen.picture(place.x, place.y, place.width, place.height, machine.compose());
  for (const ScreenWords& words : machine.words()) {
    screen.text(place.x + words.x, place.y + words.y, words.words, SdlScreen::Size::small, colour_of(words.role),
                align_of(words.align));
  }
}

void draw_sliders(SdlScreen& screen, const LiveScan::Place& place, const std::array<double, 8>& sliders,
                  double depth) {
  constexpr double row = LiveScan::slider_row, knob = 8.0;  // pixels
  const double x = place.sliders_x, wide = place.sliders_width;
  screen.fill(x + 0.5 * wide, place.sliders_y, 1.0, row * static_cast<double>(sliders.size()), letter_faint);
  for (std::size_t i = 0; i < sliders.size(); ++i) {
    const double y = place.sliders_y + row * static_cast<double>(i), middle = y + 0.5 * row;
    const double at = x + 0.5 * wide * (1.0 + sliders[i] / LiveScan::slider_most);
    const double from = depth * static_cast<double>(i) / static_cast<double>(sliders.size() - 1);
    screen.text(x - 20.0, y + 1.0, fmt::format("{}   {:.1f} cm", i + 1, 0.1 * from), SdlScreen::Size::small,
                letter_faint, LetterAlign::right);
    screen.fill(x, middle - 1.5, wide, 3.0, slider_track);
    screen.fill(at - 0.5 * knob, middle - 6.0, knob, 12.0, sliders[i] == 0.0 ? letter_faint : letter_blue);
    screen.text(x + wide + 70.0, y + 1.0, fmt::format("{:+.1f} dB", sliders[i]), SdlScreen::Size::small, letter_ink,
                LetterAlign::right);
  }
}

}  // namespace bodkin
