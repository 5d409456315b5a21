#pragma once

#include <filesystem>
#include <memory>

#include "tracking/picture_source.h"

namespace bodkin::tracking {

// The pictures of a video file of any kind, each with its own time of presentation, decoded by the program ffmpeg
// (Debian package ffmpeg) in a process of its own. notes() says so when the rate varies. Throws InputError when the
// file is no video, SystemError when ffmpeg is missing.
std::unique_ptr<PictureSource> open_video(const std::filesystem::path& file);

}  // namespace bodkin::tracking
