#pragma once

#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>

#include "views/open_case.h"

#include "imaging/ct_scan.h"

namespace bodkin::views {

// The overview before a scan, with the range as a box: its edges are dragged, its middle moves it, and every slice is
// drawn with its thickness, so that gaps are visible.
class ScoutWidget : public QWidget {
  Q_OBJECT
 public:
  explicit ScoutWidget(QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient);
  void set_view(imaging::ScoutView view);
  imaging::ScoutView view() const { return view_; }
  void set_protocol(const imaging::ScanProtocol& protocol);
  // The displayed slice, mm along z; empty: none.
  void set_mark(std::optional<double> z);
  // The plan and the needle, from hub to tip, drawn as lines.
  void set_lines(const std::optional<anatomy::NeedlePath>& plan, const std::optional<anatomy::NeedlePath>& needle);

  // Of the widget; z in mm.
  double y_of(double z) const;
  double z_of(double y) const;

 signals:
  void range_changed(double from, double to);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  enum class Drag { none, from, to, all };
  QRectF picture_place() const;
  QPointF place(const Vec3& point) const;
  Drag drag_at(double y) const;

  std::shared_ptr<const OpenCase> patient_;
  imaging::ScoutView view_ = imaging::ScoutView::frontal;
  imaging::Scout scout_;
  QImage picture_;
  imaging::ScanProtocol protocol_;
  std::optional<double> mark_;
  std::optional<anatomy::NeedlePath> plan_, needle_;
  Drag drag_ = Drag::none;
  double pressed_z_ = 0.0;
};

}  // namespace bodkin::views
