#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "imaging/image_rgb.h"

namespace bodkin {

// Pictures with text are composed as SVG: rasters (slices) lie in it as PNG, everything else stays vectors, so that
// text is sharp at any size. svg_to_png() makes a plain picture of one when asked.

// Text made safe for XML and HTML, between tags and inside quotes. Characters that XML forbids become spaces.
std::string escape_markup(std::string_view text);
std::string base64(std::string_view bytes);
// "data:TYPE;base64,..."
std::string data_uri(std::string_view type, std::string_view bytes);
// "#rrggbb"
std::string css_colour(std::uint32_t colour);

// An SVG document of `width` x `height` px around `content`, on `background` (a CSS colour).
std::string svg_document(double width, double height, std::string_view content, std::string_view background);

// The picture as the bytes of a PNG file, `zoom` pixels per SVG px (runs rsvg-convert). Throws SystemError when that
// program is missing or fails.
std::string svg_to_png(std::string_view svg, double zoom);

}  // namespace bodkin
