#pragma once

#include <array>
#include <functional>

#include "app/page.h"
#include "views/frame.h"
#include "views/opacity_curve.h"
#include "views/volume_view.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSlider;

namespace bodkin::app {

using namespace views;

// The volume view as large as the window, with its controls: mode, preset, opacity curve, two sliders.
class VolumePage : public Page {
  Q_OBJECT
 public:
  // `frame`: the newest frame of the practice, with the needle and plan to draw.
  explicit VolumePage(std::function<const Frame&()> frame, QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void enter() override;
  void advance(double clock) override;
  bool press(const QKeySequence& keys) override;

  VolumeView& view() { return *view_; }
  void set_preset(imaging::TransferPreset preset);

 private:
  QWidget* make_panel();
  QSlider* make_slider(QWidget* parent, const char* name, const QString& text, const QString& tip, int low, int high);
  void show_preset(imaging::TransferPreset preset);
  void use_sliders();
  void use_curve(const imaging::TransferFunction& function);
  void show_look();
  void show_drawer();

  std::function<const Frame&()> frame_;
  VolumeView* view_;
  OpacityCurve* curve_ = nullptr;
  std::array<QPushButton*, 4> modes_{}, presets_{};
  std::array<QPushButton*, 3> drawers_{};
  QLabel* drawn_by_ = nullptr;
  QSlider *shift_ = nullptr, *density_ = nullptr;
  QCheckBox *shaded_ = nullptr, *tissues_ = nullptr;
  imaging::TransferFunction base_;  // before the sliders' changes
  bool entered_ = false;
};

}  // namespace bodkin::app
