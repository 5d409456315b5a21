#pragma once

#include <chrono>
#include <functional>

namespace bodkin::haptics {

// Runs `call` on its own thread and waits for it no longer than `limit`. Returns false when it has not returned by
// then: the thread is abandoned, and if the call does return later, it runs `late` (may be empty). Both must own
// everything they use and must not throw; their results may be read only after true. Throws std::system_error when
// the system has no thread left.
bool returns_within(std::chrono::milliseconds limit, std::function<void()> call, std::function<void()> late);

}  // namespace bodkin::haptics
