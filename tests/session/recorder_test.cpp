#include "session/recorder.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/session/session_samples.h"
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>

#include "haptics/deadline_clock.h"

namespace bodkin {

using namespace bodkin::haptics;
using namespace bodkin::session;
using namespace bodkin::simulation;
namespace {

TEST(Ring, hands_over_every_value_in_order_between_two_threads) {
  SingleProducerRing<std::uint64_t> ring(64);
  constexpr std::uint64_t count = 200000;
  std::thread producer([&] {
    for (std::uint64_t value = 0; value < count;) {
      if (ring.push(value)) {
        ++value;
      } else {
        std::this_thread::yield();
      }
    }
  });
  std::uint64_t expected = 0, value = 0;
  while (expected < count) {
    if (!ring.pop(value)) {
      std::this_thread::yield();
      continue;
    }
    ASSERT_EQ(value, expected);
    ++expected;
  }
  producer.join();
  EXPECT_FALSE(ring.pop(value));
}

TEST(Ring, refuses_when_it_is_full_and_takes_again_when_it_is_not) {
  SingleProducerRing<int> ring(3);
  EXPECT_TRUE(ring.push(1) && ring.push(2) && ring.push(3));
  EXPECT_FALSE(ring.push(4));
  int value = 0;
  EXPECT_TRUE(ring.pop(value));
  EXPECT_EQ(value, 1);
  EXPECT_TRUE(ring.push(4));
}

TEST(Recorder, saves_what_a_servo_pushes) {
  const ScratchSession scratch;
  std::uint64_t seen = 0;
  {
    Recorder recorder(SessionWriter(scratch.path(), sample_header(), false), [&](const TickRecord&) { ++seen; });
    for (std::uint64_t tick = 0; tick < 3000; ++tick) recorder.push(sample_record(tick));
    recorder.finish();
    EXPECT_EQ(recorder.lost(), 0u);
  }
  const Session session = read_session(scratch.path());
  EXPECT_TRUE(session.finished);
  ASSERT_EQ(session.ticks.size(), 3000u);
  EXPECT_EQ(seen, 3000u);
  EXPECT_EQ(bytes_of(session.ticks[2999]), bytes_of(sample_record(2999)));
}

TEST(Recorder, counts_what_it_could_not_take_and_never_waits) {
  const ScratchSession scratch;
  Recorder recorder(SessionWriter(scratch.path(), sample_header(), false), {}, 8);
  const TickRecord record = sample_record(0);
  TickRecord next = record;
  for (std::uint64_t tick = 0; tick < 5000; ++tick) {
    next.tick = tick;
    recorder.push(next);
  }
  recorder.finish();
  EXPECT_GT(recorder.lost(), 0u);
  EXPECT_EQ(read_session(scratch.path()).ticks.size() + recorder.lost(), 5000u);
}

// Status of a recording process that will be killed, in memory shared with its parent.
struct ProcessStatus {
  std::atomic<std::uint64_t> pushed{0};
  std::atomic<std::int64_t> written_at{0};     // ns of the steady clock, when the recorder last took a record
  std::atomic<std::int64_t> longest_stall{0};  // ns between two records taken: the disk or the system held it up
};

std::int64_t now_ns() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

// A recording process that dies by SIGKILL at a random moment. Everything pushed a second before is on disk; waits
// for the disk are added to that time.
TEST(Recorder, a_killed_process_loses_at_most_the_last_second) {
  void* const shared =
      mmap(nullptr, sizeof(ProcessStatus), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(shared, MAP_FAILED);
  Random random(static_cast<std::uint64_t>(getpid()));
  for (int trial = 0; trial < 6; ++trial) {
    const ScratchSession scratch;
    ProcessStatus* const status = std::construct_at(static_cast<ProcessStatus*>(shared));
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      status->written_at.store(now_ns());
      Recorder recorder(SessionWriter(scratch.path(), sample_header(), true), [status](const TickRecord&) {
        const std::int64_t now = now_ns(), stall = now - status->written_at.exchange(now);
        status->longest_stall.store(std::max(stall, status->longest_stall.load()));
      });
      DeadlineClock clock(0.001);
      clock.start();
      for (std::uint64_t tick = 0;; ++tick) {
        clock.wait();
        recorder.push(sample_record(tick));
        status->pushed.store(tick + 1);
      }
    }
    while (status->pushed.load() < 100) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const auto life = std::chrono::milliseconds(static_cast<int>(random.uniform(900.0, 2200.0)));
    std::uint64_t a_second_ago = 0;
    const auto end = std::chrono::steady_clock::now() + life;
    std::vector<std::pair<std::chrono::steady_clock::time_point, std::uint64_t>> history;
    while (std::chrono::steady_clock::now() < end) {
      history.emplace_back(std::chrono::steady_clock::now(), status->pushed.load());
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ASSERT_EQ(kill(child, SIGKILL), 0);
    const auto death = std::chrono::steady_clock::now();
    const std::int64_t stall = std::max(status->longest_stall.load(), now_ns() - status->written_at.load());
    ASSERT_EQ(waitpid(child, nullptr, 0), child);
    for (const auto& [when, count] : history) {
      if (death - when >= std::chrono::seconds(1) + std::chrono::nanoseconds(stall)) a_second_ago = count;
    }
    const Session session = read_session(scratch.path());
    EXPECT_FALSE(session.finished);
    EXPECT_GE(session.ticks.size(), a_second_ago) << "of " << status->pushed.load();
    for (std::size_t tick = 0; tick < session.ticks.size(); ++tick) {
      ASSERT_EQ(session.ticks[tick].tick, tick);
      ASSERT_EQ(bytes_of(session.ticks[tick]), bytes_of(sample_record(tick)));
    }
  }
  munmap(shared, sizeof(ProcessStatus));
}

TEST(DeadlineClock, keeps_the_pace_and_counts_what_is_late) {
  DeadlineClock clock(0.002);
  const auto begin = std::chrono::steady_clock::now();
  clock.start();
  for (int tick = 0; tick < 100; ++tick) clock.wait();
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(199));
  EXPECT_EQ(clock.deadlines(), 100u);
  const std::uint64_t before = clock.missed();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  clock.wait();
  EXPECT_GT(clock.missed(), before);
  EXPECT_GE(clock.worst_lateness(), 0.015);
}

TEST(RealTimePriority, the_memory_stays_locked_until_the_last_one_ends) {
  if (sanitized) GTEST_SKIP() << "a sanitizer lets no memory be locked";
  auto first = std::make_unique<LockedMemory>();
  if (!first->is_locked()) GTEST_SKIP() << "the system does not lock the memory of this test";
  auto second = std::make_unique<LockedMemory>();
  const auto locked = [] {
    std::ifstream status("/proc/self/status");
    std::string text{std::istreambuf_iterator<char>(status), {}};
    return std::stol(text.substr(text.find("VmLck:") + 6));
  };
  EXPECT_GT(locked(), 0);
  first.reset();
  EXPECT_GT(locked(), 0);
  second.reset();
  EXPECT_EQ(locked(), 0);
}

TEST(DeadlineClock, does_not_catch_up_what_is_late) {
  DeadlineClock clock(0.004);
  clock.start();
  clock.wait();
  std::this_thread::sleep_for(std::chrono::milliseconds(44));  // eleven deadlines go by
  const auto begin = std::chrono::steady_clock::now();
  for (int tick = 0; tick < 11; ++tick) clock.wait();
  // The first one is late; between it and the next there is half a period at least, then a whole one each.
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(37));
}

}  // namespace
}  // namespace bodkin
