#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>

namespace bodkin::app {

// When the frame after one is due that was due at `due` and began at `now`. One that comes late does not delay those
// after it, or a frame in ten that the system holds up would be missing from each second; two are made up for at
// most.
std::chrono::steady_clock::time_point next_due(std::chrono::steady_clock::time_point due,
                                               std::chrono::steady_clock::time_point now,
                                               std::chrono::milliseconds interval);

// The one clock that draws: 60 frames a second while the window keeps up, 30 when it has not for three frames, 60
// again after two quick seconds.
class FrameClock : public QObject {
  Q_OBJECT
 public:
  explicit FrameClock(QObject* parent = nullptr);

  void start();
  void stop() { timer_.stop(); }
  // s since start().
  double now() const;

 signals:
  void frame(double clock);

 private:
  static constexpr int quick_interval = 16;  // ms

  void tick();
  void wait_for_next();

  QTimer timer_;
  int interval_ = quick_interval;  // ms
  std::chrono::steady_clock::time_point begin_, due_;
  int slow_ = 0, quick_ = 0;
};

}  // namespace bodkin::app
