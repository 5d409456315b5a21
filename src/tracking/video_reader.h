#pragma once

#include <filesystem>
#include <memory>

#include "tracking/picture_source.h"

namespace bodkin::tracking {

// The images of a video file of any kind, each with its own presentation time, decoded by the program ffmpeg (Debian
// package ffmpeg) in a separate process. notes() says so when the rate varies. Throws InputError when the file is not
// a video, SystemError when ffmpeg is missing.
std::unique_ptr<PictureSource> open_video(const std::filesystem::path& file);

}  // namespace bodkin::tracking
