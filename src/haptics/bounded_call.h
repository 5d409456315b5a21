#pragma once

#include <chrono>
#include <functional>

namespace bodkin::haptics {

// Runs `call` on a thread of its own and waits for it no longer than `limit`. False when it had not returned by then:
// the thread is left to itself, and should the call come back after all, `late` is run on it (may be empty). Both
// must own whatever they touch, must not throw, and their results may be read only after true. Throws
// std::system_error when the system has no thread left.
bool returns_within(std::chrono::milliseconds limit, std::function<void()> call, std::function<void()> late);

}  // namespace bodkin::haptics
