#pragma once

#include <memory>
#include <optional>

#include "views/path_offset.h"
#include "views/view.h"

namespace bodkin::views {

// Looking down the planned path: the rings are the plan, the dot is the tip, the line from it leads to where the
// shaft passes the skin. Beside it how far and how much the needle is off, and what to do now.
class Bullseye : public View {
  Q_OBJECT
 public:
  explicit Bullseye(QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void show_frame(const Frame& frame, const Changes& changes) override;

  // The planned path is kept from the person: the view says that, and not that there is none.
  void set_path_hidden(bool hidden);

  // Where an offset from the path (mm, to the viewer's right and up) is drawn, pixels. The outer ring stands for
  // three times the target's tolerance; what is farther lies on it.
  QPointF place(const Eigen::Vector2d& offset) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPointF middle() const;
  static QString name_of(Side side);
  double radius() const;  // pixels, of the outer ring

  std::optional<PathOffset> offset_;  // none: there is no plan or no needle
  bool has_plan_ = false, is_hidden_ = false;
  double tolerance_ = 3.0;  // mm
  QString hint_;
};

}  // namespace bodkin::views
