#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

#include "imaging/image_rgb.h"

namespace bodkin::tracking {

// Writes a video as Motion JPEG in an AVI file (RIFF AVI 1.0, with its index), readable by players and ffmpeg. At
// most 2 GB, some ten thousand images of 1280 x 720.
class VideoWriter {
 public:
  // `rate`: images/s. Throws SystemError when the file cannot be written.
  VideoWriter(const std::filesystem::path& file, int width, int height, double rate);

  // Adds an image of that size. Throws SystemError.
  void add(const imaging::ImageRgb& picture);
  // Writes index and header; add() must not be called afterwards. Throws SystemError.
  void finish();

 private:
  void write_header();

  std::filesystem::path file_;
  std::ofstream stream_;
  int width_, height_;
  double rate_;
  struct Chunk {
    std::uint32_t offset, size;
  };
  std::vector<Chunk> chunks_;
  std::uint32_t largest_ = 0;
};

}  // namespace bodkin::tracking
