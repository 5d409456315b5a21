#pragma once

#include <memory>
#include <optional>

#include "views/view.h"

namespace bodkin::views {

// Shows a danger and the next action; while there is none, nothing is drawn and clicks pass through. Never a dialog.
// A click acknowledges it.
class Banner : public View {
  Q_OBJECT
 public:
  explicit Banner(QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void show_frame(const Frame& frame, const Changes& changes) override;

  const std::optional<Warning>& warning() const { return warning_; }
  // Wide enough for its text.
  QSize sizeHint() const override;

 signals:
  void acknowledged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  std::optional<Warning> warning_;
};

}  // namespace bodkin::views
