#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/pages/models.h"

namespace bodkin::app {

using namespace views;

namespace {

QLabel* step_label(const char* name, const char* role) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setProperty("role", QLatin1String(role));
  label->setWordWrap(true);
  return label;
}

}  // namespace

ModelsPage::ModelsPage(std::function<const Frame&()> frame, std::function<bool(const ModelSettings&)> apply,
                       QWidget* parent)
    : Page(PageId::models, KeyScope::models, true, parent), frame_(std::move(frame)), apply_(std::move(apply)) {
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
  felt_ = step_label("models.felt", "second");
  rows->addWidget(felt_);
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
  models_->setToolTip(tr("Choose another model of the force along the needle, with its own steps"));
  models_->setFocusPolicy(Qt::NoFocus);
  connect(models_, qOverload<int>(&QComboBox::activated), this, [this] {
    if (model_ == nullptr) return;
    model_->choose_model(models_->currentData().toString().toStdString());
    step_ = 0;
    show_steps();
    apply_settings();
  });
  rows->addWidget(models_);
  all_ = new QCheckBox(tr("All values, not only the eleven main ones"));
  all_->setObjectName(QStringLiteral("models.all"));
  all_->setAccessibleName(all_->text());
  all_->setToolTip(tr("Every value of every tissue on the planned path"));
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
  value_->setToolTip(tr("Type a value, which may be outside the slider's range"));
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
  below->addWidget(range_ = step_label("models.range", "second"), 3);
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
  undo_ = make_button(tr("Undo   Ctrl+Z"), "models.undo", tr("Undo the last change (Ctrl+Z)"));
  connect(undo_, &QPushButton::clicked, this, [this] {
    model_->undo();
    show_steps();
    apply_settings();
  });
  redo_ = make_button(tr("Redo"), "models.redo", tr("Redo the last undone change (Ctrl+Shift+Z)"));
  connect(redo_, &QPushButton::clicked, this, [this] {
    model_->redo();
    show_steps();
    apply_settings();
  });
  auto* reset =
      make_button(tr("Reset this step"), "models.reset", tr("Restore the value that the patient came with"));
  connect(reset, &QPushButton::clicked, this, [this] {
    if (model_ == nullptr || model_->steps().empty()) return;
    model_->reset(static_cast<std::size_t>(step_));
    show_step();
    show_curve();
    apply_settings();
  });
  back_ = make_button(tr("Back   ←"), "models.back", tr("Previous step"));
  connect(back_, &QPushButton::clicked, this, [this] { go(step_ - 1); });
  next_ = make_button(tr("Next step   →"), "models.next", tr("The next number"));
  next_->setProperty("role", QStringLiteral("primary"));
  connect(next_, &QPushButton::clicked, this, [this] { go(step_ + 1); });
  use_ = make_button(tr("Practise with this"), "models.use", tr("Begin a new attempt with these values"));
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

}  // namespace bodkin::app
