#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

#include "core/single_producer_ring.h"

namespace bodkin {

// Hands the newest of several large objects from the thread that makes them to one other, which may be in a hurry.
// As LatestValue, but nothing is copied: what changes hands is who owns it, and what the taker no longer needs goes
// back to the maker, who destroys it. take(), give_back() and waits() are wait-free, and neither allocate, free,
// lock nor destroy. The maker's end is wait-free but for the objects that it destroys.
template <typename Value>
class HandOver {
 public:
  HandOver() : left_(most_left) {}
  ~HandOver() {
    const std::unique_ptr<Value> untaken(waiting_.load(std::memory_order_acquire));
    free_left();
  }
  HandOver(const HandOver&) = delete;
  HandOver& operator=(const HandOver&) = delete;

  // Maker only: the newest. One that still waits is never taken; it is destroyed here, and so is what was left.
  void offer(std::unique_ptr<Value> value) noexcept {
    const std::unique_ptr<Value> untaken(waiting_.exchange(value.release(), std::memory_order_acq_rel));
    free_left();
  }
  // Maker only: destroys what has been given back.
  void free_left() noexcept {
    Value* left = nullptr;
    while (left_.pop(left)) std::unique_ptr<Value>(left).reset();
  }

  // Taker only: what waits, or null.
  std::unique_ptr<Value> take() noexcept {
    return std::unique_ptr<Value>(waits() ? waiting_.exchange(nullptr, std::memory_order_acq_rel) : nullptr);
  }
  // Taker only: what it does not need any more, not null. Of those that it took it keeps two at most when it takes
  // another.
  void give_back(std::unique_ptr<Value> value) noexcept { left_.push(value.release()); }

  // Whether one waits that was not taken. Of what the other thread does meanwhile it may hear later.
  bool waits() const noexcept { return waiting_.load(std::memory_order_relaxed) != nullptr; }

 private:
  // Those that the taker keeps when the maker has just looked, and those of its offer then and of its next one,
  // before it looks again.
  static constexpr std::size_t most_left = 4;

  std::atomic<Value*> waiting_{nullptr};
  SingleProducerRing<Value*> left_;
};

}  // namespace bodkin
