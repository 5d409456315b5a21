#include "app/frame_clock.h"

#include <algorithm>
#include <cmath>

namespace bodkin::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int slow_interval = 33;                      // ms
constexpr double too_slow = 25.0, quick_again = 12.0;  // ms a frame
constexpr int slow_frames = 3, quick_frames = 60;      // the latter at 30 a second
constexpr int most_behind = 2;                         // frames that are made up for

}  // namespace

Clock::time_point next_due(Clock::time_point due, Clock::time_point now, std::chrono::milliseconds interval) {
  return std::max(due + interval, now - most_behind * interval);
}

FrameClock::FrameClock(QObject* parent) : QObject(parent) {
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &FrameClock::tick);
}

void FrameClock::start() {
  begin_ = due_ = Clock::now();
  timer_.start(interval_);
}

double FrameClock::now() const {
  return std::chrono::duration<double>(Clock::now() - begin_).count();
}

void FrameClock::tick() {
  wait_for_next();  // first, as an action of a frame may open a dialog, during which frames continue
  const Clock::time_point began = Clock::now();
  emit frame(now());
  const double took = std::chrono::duration<double, std::milli>(Clock::now() - began).count();
  slow_ = took > too_slow ? slow_ + 1 : 0;
  quick_ = took < quick_again ? quick_ + 1 : 0;
  if (slow_ >= slow_frames) interval_ = slow_interval;
  if (quick_ >= quick_frames) interval_ = quick_interval;
}

void FrameClock::wait_for_next() {
  const Clock::time_point now = Clock::now();
  due_ = next_due(due_, now, std::chrono::milliseconds(interval_));
  const double left = std::chrono::duration<double, std::milli>(due_ - now).count();
  timer_.start(static_cast<int>(std::lround(std::max(0.0, left))));
}

}  // namespace bodkin::app
