#pragma once

#include <string>
#include <string_view>

#include "tracking/grey_image.h"

#include "imaging/image_rgb.h"

namespace bodkin::tracking {

// The bytes of a JPEG file. `quality`: 1 to 100.
std::string encode_jpeg(const GreyImage& picture, int quality);
std::string encode_jpeg(const imaging::ImageRgb& picture, int quality);
// The image in the bytes of a JPEG file; from a colour image the grey one decodes only the luma, in a third of the
// time. Throws InputError naming `origin` when they are not a valid JPEG of at most 64 million pixels.
GreyImage decode_jpeg_grey(std::string_view bytes, const std::string& origin);
imaging::ImageRgb decode_jpeg(std::string_view bytes, const std::string& origin);

}  // namespace bodkin::tracking
