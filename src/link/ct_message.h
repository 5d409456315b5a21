#pragma once

#include <memory>

#include "link/message.h"

#include "anatomy/volume.h"

namespace bodkin::link {

// A CT as a packed IMAGE `CT` of 16-bit HU, RAS mm, made a piece at a time by whoever has other things to do: the
// image of a patient has a hundred megabytes and more.
class CtMessage {
 public:
  // `ct` must outlive the last call of proceed().
  explicit CtMessage(const anatomy::CtVolume& ct);

  // Packs the next piece of 1 MiB; a few milliseconds. True when the whole is there.
  bool proceed();
  // Null until then. Several clients share it.
  const std::shared_ptr<const Bytes>& packed() const { return packed_; }

 private:
  const anatomy::CtVolume* ct_;
  Bytes bytes_;
  std::size_t next_ = 0;   // voxel
  std::uint64_t crc_ = 0;  // of what is there of the body
  std::shared_ptr<const Bytes> packed_;
};

}  // namespace bodkin::link
