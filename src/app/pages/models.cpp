#include "app/pages/models.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "app/models/model_draft.h"
#include "views/language.h"
#include "views/theme.h"

#include "core/error.h"

namespace bodkin::app {

using namespace views;

namespace {

QString step_words(const SettingStep& step, double value) {
  const QString number = QString::number(value, 'f', step.digits);
  return step.unit.empty() ? number : QStringLiteral("%1 %2").arg(number, QString::fromStdString(step.unit));
}

}  // namespace

void ModelsPage::set_case(std::shared_ptr<const OpenCase> patient) {
  leave();
  patient_ = std::move(patient);
  profile_.reset();
  model_.reset();
  is_applied_ = true;
  now_.reset();
  reference_.reset();
  chart_->set_case(patient_);
  models_->clear();
}

void ModelsPage::enter() {
  if (patient_ == nullptr || model_ != nullptr) return;
  model_ = std::make_unique<ParameterModel>(patient_);
  profile_ = std::make_unique<LiveProfile>(patient_);
  step_ = 0;
  const bool was_kept = take_model_draft(*model_, patient_->folder);
  show_steps();
  show_message(was_kept ? tr("Your changes of the last time are restored; Ctrl+Z undoes them.") : QString(), false);
}

void ModelsPage::leave() {
  if (model_ == nullptr) return;
  try {
    keep_model_draft(*model_, patient_->folder);
  } catch (const SystemError& error) {
    show_message(in_words(error.what()), true);
  }
}

void ModelsPage::show_steps() {
  is_shown_ = true;
  const std::string_view model = model_->model();
  for (const std::string_view name : model_->models()) {
    const QString plain = QString::fromUtf8(name.data(), static_cast<int>(name.size()));
    if (models_->findData(plain) < 0)
      models_->addItem(QString(plain).replace(QLatin1Char('_'), QLatin1Char(' ')), plain);
  }
  models_->setCurrentIndex(models_->findData(QString::fromUtf8(model.data(), static_cast<int>(model.size()))));
  all_->setVisible(model == "layered");
  all_->setChecked(model_->shows_all());
  list_->clear();
  int number = 0;
  for (const SettingStep& step : model_->steps()) {
    list_->addItem(QStringLiteral("%1   %2").arg(++number).arg(in_words(step.title)));
    list_->item(number - 1)->setToolTip(in_words(step.question));
  }
  step_ = std::clamp(step_, 0, std::max(0, number - 1));
  is_shown_ = false;
  show_step();
  show_curve();
}

void ModelsPage::go(int step) {
  if (model_ == nullptr || step < 0 || step >= static_cast<int>(model_->steps().size())) return;
  step_ = step;
  show_step();
  setFocus(Qt::OtherFocusReason);
}

void ModelsPage::show_step() {
  const auto count = static_cast<int>(model_->steps().size());
  if (count == 0) return show_message(tr("This model has no settings."), false);
  is_shown_ = true;
  const SettingStep& step = model_->steps()[static_cast<std::size_t>(step_)];
  const double now = model_->value(static_cast<std::size_t>(step_));
  const double was = model_->before(static_cast<std::size_t>(step_));
  list_->setCurrentRow(step_);
  number_->setText(tr("Step %1 of %2").arg(step_ + 1).arg(count));
  question_->setText(in_words(step.question));
  instruction_->setText(
      tr("Change the value and watch the solid line: it follows at once. Dashed is the force as it was."));
  name_->setText(in_words(step.description));
  value_->setDecimals(step.digits + 1);
  value_->setRange(std::isfinite(step.range.low) ? step.range.low : -1e6,
                   std::isfinite(step.range.high) ? step.range.high : 1e6);
  value_->setSingleStep(step.grain);
  value_->setSuffix(step.unit.empty() ? QString() : QStringLiteral(" ") + QString::fromStdString(step.unit));
  value_->setValue(now);
  const double share = (now - step.low) / (step.high - step.low);
  slider_->setValue(static_cast<int>(std::lround(slider_steps * std::clamp(share, 0.0, 1.0))));
  range_->setText(tr("Slider %1 to %2; allowed is %3")
                      .arg(step_words(step, step.low), step_words(step, step.high),
                           in_words(range_words(step.range, step.unit))));
  const double grain = 0.5 * step.grain;
  const Theme& theme = Theme::now();
  const bool less = now<was - grain, more = now> was + grain;
  cue_->setText(less   ? tr("lower than it was: %1").arg(step_words(step, was))
                : more ? tr("higher than it was: %1").arg(step_words(step, was))
                       : tr("as it was"));
  cue_->setStyleSheet(QStringLiteral("color: %1;")
                          .arg((less   ? theme.accent
                                : more ? theme.caution
                                       : theme.good)
                                   .name()));
  const QString origin = step.origin == Origin::paper        ? tr("The default is printed in the model's paper.")
                         : step.origin == Origin::literature ? tr("The default is from the literature.")
                                                             : tr("The default is our choice.");
  source_->setText(step.source.empty() ? origin : in_words(step.source));
  source_->setMaximumHeight(3 * source_->fontMetrics().lineSpacing() + 4);
  undo_->setEnabled(model_->can_undo());
  redo_->setEnabled(model_->can_redo());
  back_->setEnabled(step_ > 0);
  next_->setEnabled(step_ + 1 < count);
  is_shown_ = false;
}

void ModelsPage::show_curve() {
  profile_->set(model_->now());
}

void ModelsPage::change(double value, bool continues) {
  if (model_ == nullptr || model_->steps().empty()) return;
  const std::string refusal = model_->set(static_cast<std::size_t>(step_), value, continues);
  show_message(in_words(refusal), true);
  show_step();
  show_curve();
  if (refusal.empty()) apply_settings();
}

void ModelsPage::apply_settings() {
  is_applied_ = apply_(model_->now());
  show_applied();
}

void ModelsPage::show_applied() {
  const Frame& frame = frame_();
  felt_->setVisible(is_attempt(frame.state));
  if (!is_applied_) {
    felt_->setText(tr("This takes effect from the next attempt on."));
  } else if (frame.entry) {
    felt_->setText(tr("This takes effect at once: now %1 N along the needle, %2 mm deep.")
                       .arg(frame.resistance, 0, 'f', 2)
                       .arg(frame.depth, 0, 'f', 1));
  } else {
    felt_->setText(tr("This takes effect at once; the needle is outside the body now."));
  }
}

void ModelsPage::show_message(const QString& sentence, bool is_trouble) {
  line_->setText(sentence);
  line_->setStyleSheet(is_trouble ? QStringLiteral("color: %1;").arg(Theme::now().caution.name()) : QString());
}

void ModelsPage::advance(double /*clock*/) {
  show_applied();
  if (profile_ == nullptr) return;
  if (const std::optional<double> preparation = profile_->preparation()) {
    figures_->setText(tr("Preparing the deformable body for the curve: %1 %").arg(100.0 * *preparation, 0, 'f', 0));
  }
  std::shared_ptr<const ForceCurve> curve = profile_->curve();
  if (curve == nullptr || curve == now_) return;
  now_ = std::move(curve);
  if (reference_ == nullptr) reference_ = now_;  // the first one is the patient's original model
  chart_->show_curves(now_, reference_);
  const auto give = [](const ForceCurve& of) {
    return of.first_puncture_force ? tr("first puncture %1 N, ").arg(*of.first_puncture_force, 0, 'f', 2) : QString();
  };
  figures_->setText(now_->trouble.empty() ? tr("%1strongest %2 N   (was: %3strongest %4 N)")
                                                .arg(give(*now_))
                                                .arg(now_->strongest, 0, 'f', 2)
                                                .arg(give(*reference_))
                                                .arg(reference_->strongest, 0, 'f', 2)
                                          : QString());
  if (!now_->trouble.empty()) show_message(in_words(now_->trouble), true);
}

bool ModelsPage::press(const QKeySequence& keys) {
  if (model_ == nullptr || model_->steps().empty()) return false;
  const auto is = [&keys](const char* other) { return keys == QKeySequence(QLatin1String(other)); };
  const auto by = [this](double units) {
    const SettingStep& step = model_->steps()[static_cast<std::size_t>(step_)];
    change(model_->value(static_cast<std::size_t>(step_)) + units * step.grain, false);
  };
  constexpr double ten = 10.0;
  if (is("Left")) return go(step_ - 1), true;
  if (is("Right")) return go(step_ + 1), true;
  if (is("Up")) return by(1.0), true;
  if (is("Down")) return by(-1.0), true;
  if (is("Shift+Up")) return by(ten), true;
  if (is("Shift+Down")) return by(-ten), true;
  if (is("Ctrl+Z")) return undo_->click(), true;
  if (is("Ctrl+Shift+Z")) return redo_->click(), true;
  return false;
}

void ModelsPage::load(const QString& file) {
  try {
    model_->load(file.toStdString());
    show_message(tr("Loaded %1").arg(file), false);
    show_steps();
    apply_settings();
  } catch (const std::exception& error) {
    show_message(in_words(error.what()), true);
  }
}

void ModelsPage::save(const QString& file) {
  try {
    model_->save(file.toStdString());
    show_message(tr("Saved as %1").arg(file), false);
  } catch (const std::exception& error) {
    show_message(in_words(error.what()), true);
  }
}

}  // namespace bodkin::app
