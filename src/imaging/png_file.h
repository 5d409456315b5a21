#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "imaging/image_rgb.h"

namespace bodkin::imaging {

// The bytes of a PNG file (8 bit RGB, lossless). The image must not be empty. Throws SystemError when memory is
// short.
std::string encode_png(const ImageRgb& image);
// The image in the bytes of a PNG file of any colour type, on white where it is transparent. Throws InputError naming
// `origin` when they are not a valid PNG of at most 64 million pixels.
ImageRgb decode_png(std::string_view bytes, const std::string& origin);

// Writes an image as a PNG file. Throws SystemError when the file cannot be written.
void write_png(const ImageRgb& image, const std::filesystem::path& file);

}  // namespace bodkin::imaging
