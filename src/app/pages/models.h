#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/models/live_profile.h"
#include "app/models/parameter_model.h"
#include "app/page.h"
#include "views/frame.h"
#include "views/profile_chart.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QPushButton;
class QSlider;

namespace bodkin::app {

using namespace views;

// The settings of the force model, one number per step, with the new and the old force along the planned path. The
// settings apply to the following attempts after the user confirms them.
class ModelsPage : public Page {
  Q_OBJECT
 public:
  // `frame`: the newest frame of the practice; `apply`: applies settings to the running attempt, if possible.
  ModelsPage(std::function<const Frame&()> frame, std::function<bool(const ModelSettings&)> apply,
             QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void enter() override;
  void leave() override;
  void advance(double clock) override;
  bool press(const QKeySequence& keys) override;

  const ParameterModel* model() const { return model_.get(); }

  void load(const QString& file);
  void save(const QString& file);

 signals:
  // These settings apply from now on.
  void settings_chosen(const bodkin::app::ModelSettings& settings);

 private:
  static constexpr int slider_steps = 1000;

  QWidget* make_side();
  QWidget* make_question();
  QWidget* make_value();
  QWidget* make_buttons();
  QPushButton* make_button(const QString& text, const char* name, const QString& tip);
  void show_steps();
  void show_step();
  void show_curve();
  void apply_settings();
  void show_applied();
  void go(int step);
  void change(double value, bool continues);
  void show_message(const QString& sentence, bool is_trouble);

  std::function<const Frame&()> frame_;
  std::function<bool(const ModelSettings&)> apply_;
  bool is_applied_ = true;  // the running attempt, if any, has them
  std::shared_ptr<const OpenCase> patient_;
  std::unique_ptr<ParameterModel> model_;
  std::unique_ptr<LiveProfile> profile_;
  std::shared_ptr<const ForceCurve> now_, reference_;
  int step_ = 0;
  bool is_shown_ = false;     // widgets are being set from the model, not the other way round
  bool is_dragging_ = false;  // of the slider, after its first change
  QListWidget* list_;
  QComboBox* models_;
  QCheckBox* all_;
  QLabel *number_, *question_, *instruction_, *name_, *range_, *cue_, *source_, *figures_, *felt_, *line_;
  QSlider* slider_;
  QDoubleSpinBox* value_;
  ProfileChart* chart_;
  QPushButton *undo_, *redo_, *back_, *next_, *use_;
};

}  // namespace bodkin::app
