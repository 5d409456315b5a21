#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

namespace bodkin::views {

// The course of a session as one or two lanes: tissues at the tip, and events as flags with text. A click or drag
// requests a time, a click on a flag its exact time.
class Timeline : public QWidget {
  Q_OBJECT
 public:
  struct Band {
    double from = 0.0, to = 0.0;  // s
    QColor colour;
    QString title;
  };
  struct Event {
    double time = 0.0;  // s
    QString words;
    bool is_bad = false;
  };
  struct Lane {
    QColor colour;  // of the session
    std::vector<Band> bands;
    std::vector<Event> events;
  };

  explicit Timeline(QWidget* parent = nullptr);

  // `begin`, `end`: s of the axis.
  void set_lanes(std::vector<Lane> lanes, double begin, double end);
  void set_time(double time);
  double time() const { return time_; }
  // Position of a time, and of the flag of an event, pixels.
  double x_of(double time) const;
  QPoint place_of_event(std::size_t lane, std::size_t event) const;

  QSize sizeHint() const override;

 signals:
  void seek_requested(double time);  // s

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  double time_at(double x) const;
  double lane_top(std::size_t lane) const;
  // The event whose flag is under the pointer.
  const Event* event_at(const QPoint& at) const;
  void draw_lane(QPainter& painter, std::size_t index) const;

  std::vector<Lane> lanes_;
  double begin_ = 0.0, end_ = 1.0, time_ = 0.0;
  std::optional<QPoint> pointer_;
};

}  // namespace bodkin::views
