#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace bodkin {

// Passes the newest value from one thread to one other; values not read in time are overwritten. Three slots: the
// writer fills one, the reader looks at another, and one atomic byte exchanges the third between them. Both ends are
// wait-free: write() and read() take a bounded number of steps, never lock and never allocate (as long as copying a
// Value does not). The writer pays one copy of the value, the reader none. For values none of which may be lost, see
// SingleProducerRing.
template <typename Value>
class LatestValue {
 public:
  // `first` is read until the first write.
  explicit LatestValue(const Value& first = Value()) : slots_{Slot{first}, Slot{first}, Slot{first}} {}

  // Writer only.
  void write(const Value& value) noexcept {
    slots_[writing_].value = value;
    writing_ =
        exchanged_.exchange(static_cast<std::uint8_t>(writing_ | fresh), std::memory_order_acq_rel) & slot_mask;
  }

  // Reader only: the newest value, which stays as it is until the next read().
  const Value& read() noexcept {
    if (is_fresh()) reading_ = exchanged_.exchange(reading_, std::memory_order_acq_rel) & slot_mask;
    return slots_[reading_].value;
  }

  // Reader only: whether read() would return an unread value.
  bool is_fresh() const noexcept { return (exchanged_.load(std::memory_order_relaxed) & fresh) != 0; }

 private:
  static constexpr std::uint8_t slot_mask = 3;
  static constexpr std::uint8_t fresh = 4;
  static constexpr std::size_t cache_line = 64;

  struct alignas(cache_line) Slot {
    Value value;
  };

  std::array<Slot, 3> slots_;
  alignas(cache_line) std::atomic<std::uint8_t> exchanged_{2};  // the slot in between, and whether it is unread
  alignas(cache_line) std::uint8_t writing_ = 0;
  alignas(cache_line) std::uint8_t reading_ = 1;
};

}  // namespace bodkin
