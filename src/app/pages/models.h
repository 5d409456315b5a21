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

// The settings of the force model, one number a step, with the force along the planned path as it is now against as
// it was. What is set here is what the next attempts feel, once the person says so.
class ModelsPage : public Page {
  Q_OBJECT
 public:
  // `frame`: the newest one of the practice; `feel`: the attempt that runs has these settings from now on, if it can.
  ModelsPage(std::function<const Frame&()> frame, std::function<bool(const ModelSettings&)> feel,
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
  // These settings are felt from now on.
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
  void feel();
  void show_felt();
  void go(int step);
  void change(double value, bool continues);
  void say(const QString& sentence, bool is_trouble);

  std::function<const Frame&()> frame_;
  std::function<bool(const ModelSettings&)> feel_;
  bool is_felt_ = true;  // by the attempt that runs, if there is one
  std::shared_ptr<const OpenCase> patient_;
  std::unique_ptr<ParameterModel> model_;
  std::unique_ptr<LiveProfile> profile_;
  std::shared_ptr<const ForceCurve> now_, reference_;
  int step_ = 0;
  bool is_shown_ = false;     // widgets take values from the model, not the other way round
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
