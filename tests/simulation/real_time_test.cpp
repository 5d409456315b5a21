#include <cstdlib>
#include <limits>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <vector>

#include "tests/simulation/real_time_guard.h"
#include "tests/simulation/slab_patient.h"
#include <gtest/gtest.h>

#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::simulation;
namespace {

class RealTime : public testing::Test {
 protected:
  void SetUp() override {
    if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer owns malloc and the locks in this build";
  }
};

TEST_F(RealTime, the_guard_sees_an_allocation) {
  std::unique_ptr<std::vector<int>> kept;
  std::size_t calls = 0;
  {
    const RealTimeGuard guard;
    kept = std::make_unique<std::vector<int>>(100);
    calls = RealTimeGuard::heap_calls();
  }
  EXPECT_EQ(calls, 2u);
  EXPECT_EQ(kept->size(), 100u);
}

TEST_F(RealTime, the_guard_sees_aligned_memory_and_releases) {
  double* volatile block = nullptr;
  {
    const RealTimeGuard guard;
    block = static_cast<double*>(std::aligned_alloc(64, 640));
  }
  EXPECT_EQ(RealTimeGuard::heap_calls(), 1u);
  {
    const RealTimeGuard guard;
    std::free(block);
  }
  EXPECT_EQ(RealTimeGuard::heap_calls(), 1u);
}

TEST_F(RealTime, the_guard_sees_locks) {
  std::mutex mutex;
  std::shared_mutex shared;
  {
    const RealTimeGuard guard;
    const std::lock_guard lock(mutex);
    const std::shared_lock reading(shared);
  }
  EXPECT_EQ(RealTimeGuard::lock_calls(), 2u);
  EXPECT_EQ(RealTimeGuard::heap_calls(), 0u);
}

TEST_F(RealTime, the_guard_sees_nothing_outside_itself) {
  { const RealTimeGuard guard; }
  const auto unseen = std::make_unique<int>(3);
  EXPECT_EQ(*unseen, 3);
  EXPECT_EQ(RealTimeGuard::heap_calls(), 0u);
}

// Air, contact, punctures, sliding, bone, withdrawal, a second entry, a fault and a reset.
TEST_F(RealTime, the_haptic_tick_allocates_nothing_and_locks_nothing) {
  const Case patient = slab_patient();
  std::vector<TickInput> inputs;
  for (const double target : {47.0, 20.0, 25.0, -12.0, 15.0}) {
    double depth = inputs.empty() ? -5.0 : inputs.back().needle.translation().z();
    const double step = target > depth ? 0.02 : -0.02;
    for (; (target - depth) * step > 0.0; depth += step) inputs.push_back(needle_at(Vec3(0.02 * depth, 0.0, depth)));
  }
  HapticTick tick(patient);
  std::size_t events = 0;
  {
    const RealTimeGuard guard;
    for (const TickInput& input : inputs) events += tick.step(input).events.size();
    TickInput broken;
    broken.needle.translation().setConstant(std::numeric_limits<double>::quiet_NaN());
    for (int step = 0; step < 50; ++step) events += tick.step(broken).events.size();
    tick.reset();
    for (std::size_t step = 0; step < 1000; ++step) events += tick.step(inputs[step]).events.size();
  }
  EXPECT_GT(events, 12u);
  EXPECT_EQ(RealTimeGuard::heap_calls(), 0u);
  EXPECT_EQ(RealTimeGuard::lock_calls(), 0u);
}

}  // namespace
}  // namespace bodkin
