#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

namespace bodkin {

// Passes values from one thread to one other, in order. Both ends are wait-free: push() and pop() take a bounded
// number of steps, never lock and never allocate; the memory is allocated at construction. The producer pays one copy
// of the value, the consumer another.
template <typename Value>
class SingleProducerRing {
 public:
  // Holds up to `capacity` values, > 0.
  explicit SingleProducerRing(std::size_t capacity) : slots_(capacity + 1) {}

  // Producer only. False, and the value is not stored, when the ring is full.
  bool push(const Value& value) noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    const std::size_t next = after(head);
    if (next == tail_.load(std::memory_order_acquire)) return false;
    slots_[head] = value;
    head_.store(next, std::memory_order_release);
    return true;
  }

  // Producer only: whether push() would return false now.
  bool is_full() const noexcept {
    return after(head_.load(std::memory_order_relaxed)) == tail_.load(std::memory_order_acquire);
  }

  // Consumer only. False when the ring is empty.
  bool pop(Value& value) noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (tail == head_.load(std::memory_order_acquire)) return false;
    value = slots_[tail];
    tail_.store(after(tail), std::memory_order_release);
    return true;
  }

 private:
  static constexpr std::size_t cache_line = 64;

  std::size_t after(std::size_t position) const noexcept { return position + 1 == slots_.size() ? 0 : position + 1; }

  std::vector<Value> slots_;  // capacity + 1: one stays empty to distinguish full from empty
  alignas(cache_line) std::atomic<std::size_t> head_{0};  // next to write
  alignas(cache_line) std::atomic<std::size_t> tail_{0};  // next to read
};

}  // namespace bodkin
