#pragma once

#include <array>
#include <memory>

#include "views/view.h"

namespace bodkin::views {

// Four numbers: force along the needle, distance to the target, angle to the plan, time in the body.
class Numbers : public View {
  Q_OBJECT
 public:
  explicit Numbers(QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void show_frame(const Frame& frame, const Changes& changes) override;

  enum Place { force, target, angle, time, places };
  // The displayed number, without its unit: "2.60", "0:22"; a dash if there is none.
  const QString& text(Place place) const { return cards_[place].text; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Card {
    QString title, text, unit;
    QColor ink;
    bool operator==(const Card&) const = default;
  };
  std::array<Card, places> cards_;
};

}  // namespace bodkin::views
