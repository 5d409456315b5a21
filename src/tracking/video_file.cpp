#include "tracking/video_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "tracking/jpeg_file.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::tracking {

namespace {

constexpr int quality = 90;
constexpr std::uint32_t header_size = 224;  // bytes before the first chunk of the list "movi"

void append_number(std::string& to, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) to += static_cast<char>(value >> (8 * i) & 0xFFU);
}

void append_short(std::string& to, unsigned value) {
  to += static_cast<char>(value & 0xFFU);
  to += static_cast<char>(value >> 8U & 0xFFU);
}

}  // namespace

VideoWriter::VideoWriter(const std::filesystem::path& file, int width, int height, double rate)
    : file_(file), stream_(file, std::ios::binary), width_(width), height_(height), rate_(rate) {
  write_header();
}

void VideoWriter::write_header() {
  const auto frames = static_cast<std::uint32_t>(chunks_.size());
  const std::uint32_t pictures = chunks_.empty() ? 0 : chunks_.back().offset + chunks_.back().size + 8;
  std::string text = "RIFF";
  append_number(text, header_size - 8 + pictures + 8 + 16 * frames);
  text += "AVI LIST";
  append_number(text, 192);
  text += "hdrlavih";
  append_number(text, 56);
  append_number(text, static_cast<std::uint32_t>(std::lround(1e6 / rate_)));
  append_number(text, 0);
  append_number(text, 0);
  append_number(text, 0x10);  // it has an index
  append_number(text, frames);
  append_number(text, 0);
  append_number(text, 1);  // one stream
  append_number(text, largest_);
  append_number(text, static_cast<std::uint32_t>(width_));
  append_number(text, static_cast<std::uint32_t>(height_));
  for (int i = 0; i < 4; ++i) append_number(text, 0);
  text += "LIST";
  append_number(text, 116);
  text += "strlstrh";
  append_number(text, 56);
  text += "vidsMJPG";
  for (int i = 0; i < 3; ++i) append_number(text, 0);
  append_number(text, 1000);
  append_number(text, static_cast<std::uint32_t>(std::lround(1000.0 * rate_)));
  append_number(text, 0);
  append_number(text, frames);
  append_number(text, largest_);
  append_number(text, 0xFFFFFFFFU);
  append_number(text, 0);
  append_number(text, 0);
  append_short(text, static_cast<unsigned>(width_));
  append_short(text, static_cast<unsigned>(height_));
  text += "strf";
  append_number(text, 40);
  append_number(text, 40);
  append_number(text, static_cast<std::uint32_t>(width_));
  append_number(text, static_cast<std::uint32_t>(height_));
  append_short(text, 1);
  append_short(text, 24);
  text += "MJPG";
  append_number(text, static_cast<std::uint32_t>(width_ * height_ * 3));
  for (int i = 0; i < 4; ++i) append_number(text, 0);
  text += "LIST";
  append_number(text, 4 + pictures);
  text += "movi";
  stream_.seekp(0);
  stream_.write(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream_) throw SystemError(fmt::format("{}: cannot be written", file_.string()));
}

void VideoWriter::add(const imaging::ImageRgb& picture) {
  std::string bytes = encode_jpeg(picture, quality);
  if (bytes.size() % 2 != 0) bytes += '\0';
  const std::uint32_t offset = chunks_.empty() ? 0 : chunks_.back().offset + chunks_.back().size + 8;
  if (offset > 2000000000U)
    throw SystemError(fmt::format("{}: an AVI file holds 2 GB; make a shorter video", file_.string()));
  std::string head = "00dc";
  append_number(head, static_cast<std::uint32_t>(bytes.size()));
  stream_.write(head.data(), static_cast<std::streamsize>(head.size()));
  stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream_) throw SystemError(fmt::format("{}: cannot be written; is the disk full?", file_.string()));
  chunks_.push_back({offset, static_cast<std::uint32_t>(bytes.size())});
  largest_ = std::max(largest_, static_cast<std::uint32_t>(bytes.size()));
}

void VideoWriter::finish() {
  std::string index = "idx1";
  append_number(index, static_cast<std::uint32_t>(16 * chunks_.size()));
  for (const Chunk& chunk : chunks_) {
    index += "00dc";
    append_number(index, 0x10);  // every picture stands alone
    append_number(index, chunk.offset + 4);
    append_number(index, chunk.size);
  }
  stream_.write(index.data(), static_cast<std::streamsize>(index.size()));
  write_header();
  stream_.close();
  if (!stream_) throw SystemError(fmt::format("{}: cannot be written", file_.string()));
}

}  // namespace bodkin::tracking
