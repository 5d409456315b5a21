#include "io/deferred_termination.h"

#include <array>
#include <atomic>
#include <csignal>
#include <mutex>

#include <unistd.h>

#include "core/error.h"

namespace bodkin::io {
namespace {

constexpr std::array<int, 3> ending_signals = {SIGINT, SIGTERM, SIGHUP};

std::atomic<int> noted{0};
static_assert(std::atomic<int>::is_always_lock_free);

std::mutex holders_lock;
int holders = 0;
std::array<bool, ending_signals.size()> taken{};

extern "C" void note_ending_signal(int signal) {
  noted.store(signal);
}

}  // namespace

DeferredTermination::DeferredTermination() {
  const std::lock_guard lock(holders_lock);
  if (holders++ > 0) return;
  for (std::size_t i = 0; i < ending_signals.size(); ++i) {
    struct sigaction before {};
    taken[i] = sigaction(ending_signals[i], nullptr, &before) == 0 && (before.sa_flags & SA_SIGINFO) == 0 &&
               before.sa_handler == SIG_DFL;
    if (!taken[i]) continue;
    struct sigaction own {};
    own.sa_handler = &note_ending_signal;
    sigemptyset(&own.sa_mask);
    sigaction(ending_signals[i], &own, nullptr);
  }
}

DeferredTermination::~DeferredTermination() {
  const std::lock_guard lock(holders_lock);
  if (--holders > 0) return;
  for (std::size_t i = 0; i < ending_signals.size(); ++i) {
    if (taken[i]) std::signal(ending_signals[i], SIG_DFL);
  }
  if (const int signal = noted.exchange(0); signal != 0) kill(getpid(), signal);
}

int DeferredTermination::pending() noexcept {
  return noted.load();
}

Progress until_interrupted(const Progress& progress) {
  return [progress](std::string_view stage, double fraction) {
    if (DeferredTermination::pending() != 0) throw SystemError("interrupted; nothing was made");
    if (progress) progress(stage, fraction);
  };
}

}  // namespace bodkin::io
