#include "imaging/ultrasound/crew.h"

namespace bodkin {

namespace {

constexpr int patience = 20000;  // looks before a thread sleeps: the parts of a picture follow each other within that

// Until `value` is no longer `old`: awake for a while, then asleep.
template <typename Number>
void wait_for_change(const std::atomic<Number>& value, Number old) noexcept {
  for (int look = 0; look < patience; ++look) {
    if (value.load(std::memory_order_acquire) != old) return;
  }
  while (value.load(std::memory_order_acquire) == old) value.wait(old, std::memory_order_acquire);
}

}  // namespace

Crew::Crew(int threads) : members_(threads) {
  helpers_.reserve(static_cast<std::size_t>(threads));
  try {
    for (int member = 1; member < threads; ++member) helpers_.emplace_back([this, member] { help(member); });
  } catch (...) {
    over_ = true;
    ++round_;
    round_.notify_all();
    for (std::thread& helper : helpers_) helper.join();
    throw;
  }
}

Crew::~Crew() {
  over_ = true;
  ++round_;
  round_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void Crew::take_part(int member) noexcept {
  for (int turn = member; turn < count_; turn += members_) work_(context_, turn);
}

void Crew::help(int member) noexcept {
  unsigned seen = 0;
  for (;;) {
    wait_for_change(round_, seen);
    ++seen;
    if (over_) return;
    take_part(member);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

void Crew::share(int count, void (*work)(void*, int) noexcept, void* context) noexcept {
  work_ = work;
  context_ = context;
  count_ = count;
  const int others = static_cast<int>(helpers_.size());
  busy_.store(others, std::memory_order_relaxed);
  if (others > 0) {
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
  }
  take_part(0);
  for (int left = busy_.load(std::memory_order_acquire); left != 0; left = busy_.load(std::memory_order_acquire))
    wait_for_change(busy_, left);
}

}  // namespace bodkin
