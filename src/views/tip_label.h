#pragma once

#include <memory>

#include "views/view.h"

namespace bodkin::views {

// The tissue or structure at the tip, in words and in its colour: the answer to "where am I".
class TipLabel : public View {
  Q_OBJECT
 public:
  explicit TipLabel(QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void show_frame(const Frame& frame, const Changes& changes) override;

  const QString& heading() const { return heading_; }
  const QString& place() const { return place_; }
  QSize sizeHint() const override { return {250, 64}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::shared_ptr<const OpenCase> patient_;
  QString heading_, place_;
  QColor colour_;
  bool danger_ = false;
};

}  // namespace bodkin::views
