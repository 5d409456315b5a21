#include "app/models/late_force.h"

#include <atomic>

namespace bodkin::app {

namespace {

std::atomic<bool> late_force_allowed{false};

}  // namespace

bool late_force_is_allowed() noexcept {
  return late_force_allowed.load();
}

void allow_late_force() noexcept {
  late_force_allowed.store(true);
}

}  // namespace bodkin::app
