#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>

namespace bodkin::app {

// The due time of the next frame after one that was due at `due` and began at `now`. A late frame does not delay
// later ones, or a frame in ten delayed by the system would be missing from each second; at most two are made up for.
std::chrono::steady_clock::time_point next_due(std::chrono::steady_clock::time_point due,
                                               std::chrono::steady_clock::time_point now,
                                               std::chrono::milliseconds interval);

// The only clock for drawing: 60 frames a second while the window keeps up, 30 when it has not for three frames, 60
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
