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

#include "views/language.h"
#include "views/theme.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr int slider_steps = 1000;

QLabel* step_label(const char* name, const char* role) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setProperty("role", QLatin1String(role));
  label->setWordWrap(true);
  return label;
}

QString step_words(const SettingStep& step, double value) {
  const QString number = QString::number(value, 'f', step.digits);
  return step.unit.empty() ? number : QStringLiteral("%1 %2").arg(number, QString::fromStdString(step.unit));
}

}  // namespace

ModelsPage::ModelsPage(QWidget* parent) : Page(PageId::models, KeyScope::models, true, parent) {
  setFocusPolicy(Qt::StrongFocus);
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(0);
  columns->addWidget(make_side());
  auto* main = new QVBoxLayout;
  main->setContentsMargins(32, 20, 32, 16);
  main->setSpacing(12);
  main->addWidget(make_question());
  main->addWidget(make_value());
  chart_ = new ProfileChart;
  chart_->setObjectName(QStringLiteral("models.chart"));
  auto* plot = new QWidget;
  plot->setObjectName(QStringLiteral("panel"));
  plot->setAttribute(Qt::WA_StyledBackground);
  auto* rows = new QVBoxLayout(plot);
  rows->setContentsMargins(16, 10, 12, 6);
  auto* heading = new QHBoxLayout;
  auto* title = step_label("models.chart.title", "heading");
  title->setText(tr("Force against depth"));
  heading->addWidget(title);
  figures_ = step_label("models.figures", "second");
  figures_->setAlignment(Qt::AlignRight);
  heading->addWidget(figures_, 1);
  rows->addLayout(heading);
  rows->addWidget(chart_, 1);
  main->addWidget(plot, 1);
  main->addWidget(make_buttons());
  columns->addLayout(main, 1);
}

QPushButton* ModelsPage::make_button(const QString& text, const char* name, const QString& tip) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  button->setAccessibleName(text);
  button->setToolTip(tip);
  button->setFocusPolicy(Qt::NoFocus);  // keys belong to the steps
  return button;
}

QWidget* ModelsPage::make_side() {
  auto* side = new QWidget;
  side->setObjectName(QStringLiteral("panel"));
  side->setAttribute(Qt::WA_StyledBackground);
  side->setFixedWidth(268);
  auto* rows = new QVBoxLayout(side);
  rows->setContentsMargins(14, 18, 14, 14);
  rows->setSpacing(8);
  models_ = new QComboBox;
  models_->setObjectName(QStringLiteral("models.model"));
  models_->setAccessibleName(tr("Force model"));
  models_->setToolTip(tr("Another model of the force along the needle, with its own steps"));
  models_->setFocusPolicy(Qt::NoFocus);
  for (const std::string_view name : ParameterModel::models()) {
    const QString plain = QString::fromUtf8(name.data(), static_cast<int>(name.size()));
    models_->addItem(QString(plain).replace(QLatin1Char('_'), QLatin1Char(' ')), plain);
  }
  connect(models_, qOverload<int>(&QComboBox::activated), this, [this] {
    if (model_ == nullptr) return;
    model_->choose_model(models_->currentData().toString().toStdString());
    step_ = 0;
    show_steps();
  });
  rows->addWidget(models_);
  all_ = new QCheckBox(tr("All numbers, not only the eleven"));
  all_->setObjectName(QStringLiteral("models.all"));
  all_->setAccessibleName(all_->text());
  all_->setToolTip(tr("Every number of every tissue on the planned path"));
  all_->setFocusPolicy(Qt::NoFocus);
  connect(all_, &QCheckBox::toggled, this, [this](bool on) {
    if (model_ == nullptr || is_shown_) return;
    model_->show_all(on);
    step_ = 0;
    show_steps();
  });
  rows->addWidget(all_);
  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("models.steps"));
  list_->setAccessibleName(tr("Steps"));
  list_->setToolTip(tr("Click to go to a step"));
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideRight);
  list_->setStyleSheet(
      QStringLiteral("QListWidget { border: none; background: transparent; }"
                     "QListWidget::item { padding: 7px 8px; border-radius: 6px; }"));
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (!is_shown_ && row >= 0) go(row);
  });
  rows->addWidget(list_, 1);
  auto* files = new QHBoxLayout;
  QPushButton* const open = make_button(tr("Load"), "models.load", tr("The tissues of a library file"));
  connect(open, &QPushButton::clicked, this, [this] {
    const QString file = QFileDialog::getOpenFileName(this, tr("Tissue library"), {}, tr("Tissues (*.xml)"));
    if (!file.isEmpty()) load(file);
  });
  QPushButton* const keep =
      make_button(tr("Save as"), "models.save", tr("All tissues as a library file, for 'case new --tissues' too"));
  connect(keep, &QPushButton::clicked, this, [this] {
    const QString file =
        QFileDialog::getSaveFileName(this, tr("Tissue library"), tr("tissues.xml"), tr("Tissues (*.xml)"));
    if (!file.isEmpty()) save(file);
  });
  files->addWidget(open);
  files->addWidget(keep);
  rows->addLayout(files);
  line_ = step_label("models.line", "second");
  rows->addWidget(line_);
  return side;
}

QWidget* ModelsPage::make_question() {
  auto* box = new QWidget;
  auto* rows = new QVBoxLayout(box);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  rows->addWidget(number_ = step_label("models.number", "label"));
  rows->addWidget(question_ = step_label("models.question", "title"));
  question_->setStyleSheet(QStringLiteral("font-size: 20px;"));
  rows->addWidget(instruction_ = step_label("models.instruction", "second"));
  return box;
}

QWidget* ModelsPage::make_value() {
  auto* box = new QWidget;
  box->setObjectName(QStringLiteral("panel"));
  box->setAttribute(Qt::WA_StyledBackground);
  auto* rows = new QVBoxLayout(box);
  rows->setContentsMargins(16, 10, 16, 10);
  rows->setSpacing(6);
  auto* head = new QHBoxLayout;
  head->addWidget(name_ = step_label("models.name", "heading"), 1);
  value_ = new QDoubleSpinBox;
  value_->setObjectName(QStringLiteral("models.value"));
  value_->setAccessibleName(tr("Value"));
  value_->setToolTip(tr("Type a number, also one beyond the slider"));
  value_->setFocusPolicy(Qt::ClickFocus);
  value_->setKeyboardTracking(false);
  value_->setMinimumWidth(190);
  value_->setAlignment(Qt::AlignRight);
  value_->setStyleSheet(QStringLiteral("font-size: 20px;"));
  connect(value_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    if (!is_shown_) change(value, false);
  });
  head->addWidget(value_);
  rows->addLayout(head);
  slider_ = new QSlider(Qt::Horizontal);
  slider_->setObjectName(QStringLiteral("models.slider"));
  slider_->setAccessibleName(tr("Value"));
  slider_->setToolTip(tr("Drag: the solid line follows at once"));
  slider_->setRange(0, slider_steps);
  slider_->setPageStep(slider_steps / 20);
  slider_->setFocusPolicy(Qt::NoFocus);
  connect(slider_, &QSlider::sliderPressed, this, [this] { is_dragging_ = false; });
  connect(slider_, &QSlider::valueChanged, this, [this](int at) {
    if (is_shown_ || model_ == nullptr) return;
    const SettingStep& step = model_->steps()[static_cast<std::size_t>(step_)];
    const double exact = step.low + (step.high - step.low) * at / slider_steps;
    change(std::clamp(std::round(exact / step.grain) * step.grain, step.low, step.high),
           slider_->isSliderDown() && std::exchange(is_dragging_, true));
  });
  rows->addWidget(slider_);
  auto* below = new QHBoxLayout;
  below->addWidget(range_ = step_label("models.range", "second"), 1);
  cue_ = step_label("models.cue", "second");
  cue_->setAlignment(Qt::AlignRight);
  below->addWidget(cue_, 1);
  rows->addLayout(below);
  rows->addWidget(source_ = step_label("models.source", "label"));
  return box;
}

QWidget* ModelsPage::make_buttons() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  undo_ = make_button(tr("Undo   Ctrl+Z"), "models.undo", tr("The last change back"));
  connect(undo_, &QPushButton::clicked, this, [this] {
    model_->undo();
    show_steps();
  });
  redo_ = make_button(tr("Redo"), "models.redo", tr("What was undone again (Ctrl+Shift+Z)"));
  connect(redo_, &QPushButton::clicked, this, [this] {
    model_->redo();
    show_steps();
  });
  auto* reset = make_button(tr("Reset this step"), "models.reset", tr("The value that the patient came with"));
  connect(reset, &QPushButton::clicked, this, [this] {
    if (model_ == nullptr || model_->steps().empty()) return;
    model_->reset(static_cast<std::size_t>(step_));
    show_step();
    show_curve();
  });
  back_ = make_button(tr("Back   ←"), "models.back", tr("The step before"));
  connect(back_, &QPushButton::clicked, this, [this] { go(step_ - 1); });
  next_ = make_button(tr("Next step   →"), "models.next", tr("The next number"));
  next_->setProperty("role", QStringLiteral("primary"));
  connect(next_, &QPushButton::clicked, this, [this] { go(step_ + 1); });
  use_ = make_button(tr("Practise with this"), "models.use", tr("A new attempt begins, which feels these numbers"));
  connect(use_, &QPushButton::clicked, this, [this] {
    if (model_ == nullptr) return;
    emit settings_chosen(model_->now());
    emit practise_requested();
  });
  row->addWidget(undo_);
  row->addWidget(redo_);
  row->addWidget(reset);
  row->addStretch(1);
  row->addWidget(use_);
  row->addWidget(back_);
  row->addWidget(next_);
  return box;
}

void ModelsPage::set_case(std::shared_ptr<const OpenCase> patient) {
  patient_ = std::move(patient);
  profile_.reset();
  model_.reset();
  now_.reset();
  reference_.reset();
  chart_->set_case(patient_);
}

void ModelsPage::enter() {
  if (patient_ == nullptr || model_ != nullptr) return;
  model_ = std::make_unique<ParameterModel>(patient_);
  profile_ = std::make_unique<LiveProfile>(patient_);
  step_ = 0;
  show_steps();
  say({}, false);
}

void ModelsPage::show_steps() {
  is_shown_ = true;
  const std::string_view model = model_->model();
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
  if (count == 0) return say(tr("This model has no numbers."), false);
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
                           QString::fromStdString(range_words(step.range, step.unit))));
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
  say(in_words(refusal), true);
  show_step();
  show_curve();
}

void ModelsPage::say(const QString& sentence, bool is_trouble) {
  line_->setText(sentence);
  line_->setStyleSheet(is_trouble ? QStringLiteral("color: %1;").arg(Theme::now().caution.name()) : QString());
}

void ModelsPage::advance(double /*clock*/) {
  if (profile_ == nullptr) return;
  std::shared_ptr<const ForceCurve> curve = profile_->curve();
  if (curve == nullptr || curve == now_) return;
  now_ = std::move(curve);
  if (reference_ == nullptr) reference_ = now_;  // the first one is that of the patient as he came
  chart_->show_curves(now_, reference_);
  const auto give = [this](const ForceCurve& of) {
    return of.first_give ? tr("first give %1 N, ").arg(*of.first_give, 0, 'f', 2) : QString();
  };
  figures_->setText(now_->trouble.empty() ? tr("%1strongest %2 N   (was: %3strongest %4 N)")
                                                .arg(give(*now_))
                                                .arg(now_->strongest, 0, 'f', 2)
                                                .arg(give(*reference_))
                                                .arg(reference_->strongest, 0, 'f', 2)
                                          : QString());
  if (!now_->trouble.empty()) say(in_words(now_->trouble), true);
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
    say(tr("Loaded %1").arg(file), false);
    show_steps();
  } catch (const std::exception& error) {
    say(in_words(error.what()), true);
  }
}

void ModelsPage::save(const QString& file) {
  try {
    model_->save(file.toStdString());
    say(tr("Saved as %1").arg(file), false);
  } catch (const std::exception& error) {
    say(in_words(error.what()), true);
  }
}

}  // namespace bodkin::app
