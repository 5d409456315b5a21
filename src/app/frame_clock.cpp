#include "app/frame_clock.h"

namespace bodkin::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int quick_interval = 16, slow_interval = 33;  // ms
constexpr double too_slow = 25.0, quick_again = 12.0;   // ms a frame
constexpr int slow_frames = 3, quick_frames = 60;       // the latter at 30 a second

}  // namespace

FrameClock::FrameClock(QObject* parent) : QObject(parent) {
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(quick_interval);
  connect(&timer_, &QTimer::timeout, this, &FrameClock::tick);
}

void FrameClock::start() {
  begin_ = Clock::now();
  timer_.start();
}

double FrameClock::now() const {
  return virtual_ ? virtual_now_ : std::chrono::duration<double>(Clock::now() - begin_).count();
}

void FrameClock::tick() {
  virtual_now_ += 1.0 / 60.0;
  const Clock::time_point began = Clock::now();
  emit frame(now());
  last_ = std::chrono::duration<double, std::milli>(Clock::now() - began).count();
  slow_ = last_ > too_slow ? slow_ + 1 : 0;
  quick_ = last_ < quick_again ? quick_ + 1 : 0;
  if (slow_ >= slow_frames) timer_.setInterval(slow_interval);
  if (quick_ >= quick_frames) timer_.setInterval(quick_interval);
}

}  // namespace bodkin::app
