#pragma once

#include <memory>
#include <optional>

#include "views/path_offset.h"
#include "views/view.h"

namespace bodkin::views {

// The view along the planned path: the rings are the plan, the dot is the tip, and the line from it leads to the
// shaft's position at the skin. Next to it the needle's deviation, and the next action.
class Bullseye : public View {
  Q_OBJECT
 public:
  explicit Bullseye(QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void show_frame(const Frame& frame, const Changes& changes) override;

  // The planned path is hidden from the person: the view says so, rather than that there is none.
  void set_path_hidden(bool hidden);

  // Position in pixels of an offset from the path (mm, to the viewer's right and up). The outer ring represents three
  // times the target's tolerance; larger offsets are drawn on it.
  QPointF place(const Eigen::Vector2d& offset) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPointF middle() const;
  static QString name_of(Side side);
  double radius() const;  // pixels, of the outer ring

  std::optional<PathOffset> offset_;  // empty: no plan or no needle
  bool has_plan_ = false, is_hidden_ = false;
  double tolerance_ = 3.0;  // mm
  QString hint_;
};

}  // namespace bodkin::views
