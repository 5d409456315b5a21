#pragma once

#include <string>
#include <string_view>

#include "tracking/grey_picture.h"

#include "imaging/image_rgb.h"

namespace bodkin::tracking {

// The bytes of a JPEG file. `quality`: 1 to 100.
std::string encode_jpeg(const GreyPicture& picture, int quality);
std::string encode_jpeg(const imaging::ImageRgb& picture, int quality);
// The picture in the bytes of a JPEG file; of a colour picture the grey one decodes the luma alone, in a third of the
// time. Throws InputError naming `origin` when they are not a sound JPEG of at most 64 million pixels.
GreyPicture decode_jpeg_grey(std::string_view bytes, const std::string& origin);
imaging::ImageRgb decode_jpeg(std::string_view bytes, const std::string& origin);

}  // namespace bodkin::tracking
