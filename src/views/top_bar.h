#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "views/view.h"

class QLabel;
class QPushButton;

namespace bodkin::views {

enum class Stage : std::uint8_t { patient, scan, plan, practise, review };
inline constexpr int stage_count = 5;

// The bar above all pages: procedure and patient, the stages, and the chips of device and servo. A chip opens its
// page. Narrow windows reduce the chips to their colours and shapes.
class TopBar : public View {
  Q_OBJECT
 public:
  explicit TopBar(QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void show_frame(const Frame& frame, const Changes& changes) override;

  void set_stage(Stage stage);
  // Greys out a stage that cannot be reached now.
  void allow(Stage stage, bool allowed);

  // Without a signal: ultrasound could not be switched on, or was switched on by other means.
  void set_ultrasound(bool on);

  static constexpr int bar_height = 48;  // pixels

 signals:
  void home_requested();  // the mark and name were clicked
  void stage_chosen(bodkin::views::Stage stage);
  void device_page_requested();
  void servo_page_requested();
  void ultrasound_toggled(bool on);
  void help_requested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum class Lamp : std::uint8_t { off, good, caution, danger };
  struct Chip {
    QPushButton* button = nullptr;
    QString words;
    Lamp lamp = Lamp::off;
  };
  QPushButton* make_chip(const char* name, const QString& what);
  void show_chip(Chip& chip, const QString& words, Lamp lamp, const QString& tip);
  void refresh_chip(const Chip& chip);
  void refresh_style();

  QPushButton* home_ = nullptr;
  QLabel* procedure_ = nullptr;
  QLabel* patient_ = nullptr;
  std::array<QPushButton*, stage_count> stages_{};
  Chip device_, servo_;
  QPushButton* ultrasound_ = nullptr;
  std::uint64_t late_ = 0;  // ticks when the attempt began
};

}  // namespace bodkin::views
