#include "link/ct_message.h"

#include <algorithm>

#include "link/contents.h"

namespace bodkin::link {

namespace {

constexpr std::size_t piece = 1 << 19;  // voxels

}  // namespace

CtMessage::CtMessage(const anatomy::CtVolume& ct) : ct_(&ct) {
  const Bytes before = volume_header(ct.grid);
  bytes_.reserve(header_size + before.size() + sizeof(std::int16_t) * ct.voxels.size());
  bytes_.assign(header_size, 0);
  bytes_.insert(bytes_.end(), before.begin(), before.end());
  crc_ = crc64(before);
}

bool CtMessage::proceed() {
  if (packed_ != nullptr) return true;
  const std::size_t end = std::min(next_ + piece, ct_->voxels.size()), begin = bytes_.size();
  for (; next_ < end; ++next_) {
    const auto value = static_cast<std::uint16_t>(ct_->voxels[next_]);
    bytes_.push_back(static_cast<std::uint8_t>(value & 0xFFU));
    bytes_.push_back(static_cast<std::uint8_t>(value >> 8U));
  }
  crc_ = crc64(std::span(bytes_).subspan(begin), crc_);
  if (next_ < ct_->voxels.size()) return false;
  const Bytes header = pack_header({1, "IMAGE", "CT", time_now(), bytes_.size() - header_size, crc_});
  std::copy(header.begin(), header.end(), bytes_.begin());
  packed_ = std::make_shared<const Bytes>(std::move(bytes_));
  return true;
}

}  // namespace bodkin::link
