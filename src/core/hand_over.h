#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

#include "core/single_producer_ring.h"

namespace bodkin {

// Passes the newest of a series of large objects from a producer thread to one real-time consumer thread. Unlike
// LatestValue it copies nothing: ownership moves, and objects that the consumer has finished with return to the
// producer, which destroys them. take(), give_back() and waits() are wait-free and never allocate, free, lock or
// destroy. The producer's functions are wait-free except for destroying objects.
template <typename Value>
class HandOver {
 public:
  HandOver() : returned_(most_returned) {}
  ~HandOver() {
    const std::unique_ptr<Value> untaken(waiting_.load(std::memory_order_acquire));
    free_returned();
  }
  HandOver(const HandOver&) = delete;
  HandOver& operator=(const HandOver&) = delete;

  // Producer only: publishes `value`. A value that was not taken yet is destroyed, and so are returned ones.
  void offer(std::unique_ptr<Value> value) noexcept {
    const std::unique_ptr<Value> untaken(waiting_.exchange(value.release(), std::memory_order_acq_rel));
    free_returned();
  }
  // Producer only: destroys the values that were given back.
  void free_returned() noexcept {
    Value* left = nullptr;
    while (returned_.pop(left)) std::unique_ptr<Value>(left).reset();
  }

  // Consumer only: the waiting value, or null.
  std::unique_ptr<Value> take() noexcept {
    return std::unique_ptr<Value>(waits() ? waiting_.exchange(nullptr, std::memory_order_acq_rel) : nullptr);
  }
  // Consumer only: returns a value it no longer needs, not null. When it calls take() it must hold at most two.
  void give_back(std::unique_ptr<Value> value) noexcept { returned_.push(value.release()); }

  // Whether a value waits. The answer may lag behind the other thread.
  bool waits() const noexcept { return waiting_.load(std::memory_order_relaxed) != nullptr; }

 private:
  // Two held by the consumer when the producer last looked, one offered then and one offered next.
  static constexpr std::size_t most_returned = 4;

  std::atomic<Value*> waiting_{nullptr};
  SingleProducerRing<Value*> returned_;
};

}  // namespace bodkin
