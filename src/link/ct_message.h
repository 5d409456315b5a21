#pragma once

#include <memory>

#include "link/message.h"

#include "anatomy/volume.h"

namespace bodkin::link {

// A CT as a packed IMAGE `CT` of 16-bit HU, RAS mm, packed piece by piece by a thread with other tasks: the image of
// a patient has a hundred megabytes and more.
class CtMessage {
 public:
  // `ct` must outlive the last call of proceed().
  explicit CtMessage(const anatomy::CtVolume& ct);

  // Packs the next piece of 1 MiB; a few milliseconds. True when the message is complete.
  bool proceed();
  // Null until it is complete. Shared by several clients.
  const std::shared_ptr<const Bytes>& packed() const { return packed_; }

 private:
  const anatomy::CtVolume* ct_;
  Bytes bytes_;
  std::size_t next_ = 0;   // voxel
  std::uint64_t crc_ = 0;  // of the packed part of the body
  std::shared_ptr<const Bytes> packed_;
};

}  // namespace bodkin::link
