#pragma once

#include <QPoint>
#include <QRectF>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "views/chart_columns.h"
#include "views/view.h"

namespace bodkin::views {

// A tissue that the needle has passed, mm of depth.
struct TissueBand {
  double from = 0.0, to = 0.0;
  anatomy::TissueId tissue = anatomy::tissue::air;
};

// The tissues met by the tip, by depth. Contains nothing deeper, to give nothing away.
class CrossedTissues {
 public:
  // mm below the skin; others are ignored. The section passed since the previous sample is also of this tissue.
  void add(double depth, anatomy::TissueId tissue);
  void clear() { by_depth_.clear(); }
  std::vector<TissueBand> bands() const;

  static constexpr double step = 0.1;  // mm

 private:
  std::vector<anatomy::TissueId> by_depth_;  // 255: not met
};

// The force on the needle against depth or time, with the tissues met by the tip and flags for events. Hovering reads
// values, a drag zooms in, a double click resets; the menu of the right button has the rest.
class ForceChart : public View {
  Q_OBJECT
 public:
  enum class Axis { depth, time };

  explicit ForceChart(QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void show_frame(const Frame& frame, const Changes& changes) override;

  void set_axis(Axis axis);
  Axis axis() const { return axis_; }
  // The tissues met by the tip, as bands and by their names.
  void show_tissues(bool shown);
  // In addition to the force its parts along and across the needle.
  void show_components(bool shown);
  // A number of the force model by its position in Frame::diagnostic_names, on a scale of its own; empty: none.
  void show_diagnostic(std::optional<std::size_t> index);

  // A time of a finished session, marked by a line; empty: the newest sample has a dot instead. A click then requests
  // another time.
  struct Cursor {
    double time = 0.0, depth = 0.0, force = 0.0;  // s, mm, N
    bool operator==(const Cursor&) const = default;
  };
  void set_cursor(const std::optional<Cursor>& cursor);
  // End of the time axis, s; empty: slightly beyond the newest sample.
  void set_end_of_time(std::optional<double> end);
  // The curve of another session, in a second colour; empty: none.
  void compare_with(std::span<const station::HandSample> samples);

  // Position of a point of the axis and a force, pixels.
  QPointF place(double along, double force) const;
  // The beginning of the visible part of the axis, mm or s.
  double from() const;
  double to() const;

 signals:
  // Of the axis, mm or s, while there is a cursor.
  void place_chosen(double along);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  // One number against both axes. Data of the withdrawal are separate: they would hide those of the insertion.
  struct Trace {
    ChartCurve inwards{0.05}, outwards{0.05}, in_time{0.01};

    void add(double time, double depth, bool out, double value);
    void lift();
    void clear();
  };
  struct Flag {
    double depth = 0.0, time = 0.0;
    QString words;
    bool bad = false;
  };
  struct Zoom {
    double from = 0.0, to = 0.0;
  };

  void clear();
  void take(const Frame& frame);
  void flag(const Frame& frame, const session::SessionEvent& event);
  QRectF plot() const;
  double top() const;
  double bottom() const;
  double along_at(double x) const;

  void draw_ground(QPainter& painter) const;
  void draw_bands(QPainter& painter) const;
  void draw_trace(QPainter& painter, const Trace& trace, const QColor& colour, double width) const;
  void draw_curve(QPainter& painter, const ChartCurve& curve, const QColor& colour, double width,
                  const ChartColumn& scale) const;
  void draw_flags(QPainter& painter) const;
  void draw_legend(QPainter& painter) const;
  void draw_pointer(QPainter& painter) const;
  void draw_cursor(QPainter& painter) const;
  void open_menu(const QPoint& at);

  std::shared_ptr<const OpenCase> patient_;
  Axis axis_ = Axis::depth;
  bool components_ = false, tissues_shown_ = true;
  std::optional<std::size_t> diagnostic_;
  std::vector<QString> diagnostic_titles_;

  Trace force_, along_, across_, number_, other_;
  std::optional<Cursor> cursor_;
  std::optional<double> end_of_time_;  // s
  CrossedTissues met_;
  std::vector<Flag> flags_;
  double depth_ = 0.0, time_ = 0.0, now_ = 0.0;  // mm, s, N of the last sample
  bool in_body_ = false;
  bool out_ = false;      // the needle is being withdrawn
  double turning_ = 0.0;  // mm, the farthest in the present direction
  double planned_ = 0.0;  // mm, length of the planned path

  bool stale_ = true;
  double drawn_ = -1.0;  // s on the frame's clock

  std::optional<Zoom> zoom_;
  std::optional<QPoint> pointer_, pressed_;
};

}  // namespace bodkin::views
