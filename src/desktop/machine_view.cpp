#include "desktop/machine_view.h"

#include <fmt/format.h>

namespace bodkin::desktop {

namespace {

using LetterAlign = SdlScreen::Align;

constexpr Colour letter_ink{232, 238, 245}, letter_faint{142, 156, 174}, knob_blue{76, 194, 255},
    slider_track{45, 56, 72};

}  // namespace

void draw_machine(SdlScreen& screen, const station::LiveScan::Place& place,
                  const imaging::UltrasoundScreen& machine) {
  screen.picture(place.x, place.y, place.width, place.height, machine.compose());
}

void draw_sliders(SdlScreen& screen, const station::LiveScan::Place& place, const std::array<double, 8>& sliders,
                  double depth) {
  constexpr double row = station::LiveScan::slider_row, knob = 8.0;  // pixels
  const double x = place.sliders_x, wide = place.sliders_width;
  screen.fill(x + 0.5 * wide, place.sliders_y, 1.0, row * static_cast<double>(sliders.size()), letter_faint);
  for (std::size_t i = 0; i < sliders.size(); ++i) {
    const double y = place.sliders_y + row * static_cast<double>(i), middle = y + 0.5 * row;
    const double at = x + 0.5 * wide * (1.0 + sliders[i] / station::LiveScan::slider_most);
    const double from = depth * static_cast<double>(i) / static_cast<double>(sliders.size() - 1);
    screen.text(x - 20.0, y + 1.0, fmt::format("{}   {:.1f} cm", i + 1, 0.1 * from), SdlScreen::Size::small,
                letter_faint, LetterAlign::right);
    screen.fill(x, middle - 1.5, wide, 3.0, slider_track);
    screen.fill(at - 0.5 * knob, middle - 6.0, knob, 12.0, sliders[i] == 0.0 ? letter_faint : knob_blue);
    screen.text(x + wide + 70.0, y + 1.0, fmt::format("{:+.1f} dB", sliders[i]), SdlScreen::Size::small, letter_ink,
                LetterAlign::right);
  }
}

}  // namespace bodkin::desktop
