#include "app/pages/volume.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <QVariant>
#include <cmath>

#include "app/kept_drawer.h"
#include "views/language.h"
#include "views/theme.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr int volume_panel_width = 304, volume_gap = 8, volume_margin = 16;  // pixels
constexpr double octave = 25.0;  // steps of the density slider for twice as much

QLabel* heading(const QString& text) {
  auto* label = new QLabel(text);
  label->setProperty("role", QStringLiteral("label"));
  return label;
}

}  // namespace

VolumePage::VolumePage(std::function<const Frame&()> frame, QWidget* parent)
    : Page(PageId::volume, KeyScope::volume, true, parent),
      frame_(std::move(frame)),
      view_(new VolumeView(QStringLiteral("volume"), this)) {
  setObjectName(QStringLiteral("volume"));
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(0);
  columns->addWidget(view_, 1);
  columns->addWidget(make_panel());
  connect(view_, &VolumeView::look_changed, this, &VolumePage::show_look);
  connect(view_, &VolumeView::ready, this, [this] { curve_->set_histogram(view_->volume()->histogram); });
  connect(view_, &VolumeView::drawer_changed, this, &VolumePage::show_drawer);
  connect(view_, &VolumeView::preset_chosen, this, &VolumePage::show_preset);
  set_preset(imaging::TransferPreset::bone);
  show_look();
}

QWidget* VolumePage::make_panel() {
  auto* panel = new QWidget;
  panel->setObjectName(QStringLiteral("panel"));
  panel->setAttribute(Qt::WA_StyledBackground);
  panel->setFixedWidth(volume_panel_width);
  auto* rows = new QVBoxLayout(panel);
  rows->setContentsMargins(volume_margin, volume_margin, volume_margin, volume_margin);
  rows->setSpacing(volume_gap);
  const auto button = [&](const char* name, const QString& text, const QString& tip) {
    auto* made = new QPushButton(text);
    made->setObjectName(QLatin1String(name));
    made->setAccessibleName(text);
    made->setToolTip(tip);
    made->setCheckable(true);
    made->setFocusPolicy(Qt::NoFocus);
    return made;
  };
  rows->addWidget(heading(tr("What is seen  (M: next)")));
  auto* modes = new QGridLayout;
  modes->setSpacing(volume_gap);
  modes_ = {button("volume.mode.colour", tr("Colour"), tr("Coloured, lit tissue")),
            button("volume.mode.grey", tr("Grey"), tr("Lit tissue in the greys of a window")),
            button("volume.mode.maximum", tr("Maximum"), tr("The largest HU on each ray (MIP)")),
            button("volume.mode.sum", tr("X-ray"), tr("All voxels on each ray summed, as an X-ray does"))};
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    modes->addWidget(modes_[i], static_cast<int>(i) / 2, static_cast<int>(i) % 2);
    connect(modes_[i], &QPushButton::clicked, this,
            [this, i] { view_->set_mode(static_cast<imaging::VolumeMode>(i)); });
  }
  rows->addLayout(modes);
  rows->addSpacing(volume_gap);
  rows->addWidget(heading(tr("Preset  (P: next)")));
  auto* presets = new QGridLayout;
  presets->setSpacing(volume_gap);
  presets_ = {
      button("volume.preset.bone", tr("Bone"), tr("Bone alone")),
      button("volume.preset.soft_tissue", tr("Soft tissue"), tr("Muscle and organs, faint, with bone in them")),
      button("volume.preset.skin", tr("Skin"), tr("What the patient looks like from outside")),
      button("volume.preset.vessels", tr("Vessels"), tr("Vessels with contrast medium; bone is faint"))};
  for (std::size_t i = 0; i < presets_.size(); ++i) {
    presets->addWidget(presets_[i], static_cast<int>(i) / 2, static_cast<int>(i) % 2);
    connect(presets_[i], &QPushButton::clicked, this, [this, i] { set_preset(imaging::transfer_presets[i]); });
  }
  rows->addLayout(presets);
  rows->addSpacing(volume_gap);
  rows->addWidget(heading(tr("Opacity of each HU: drag the points")));
  curve_ = new OpacityCurve;
  curve_->setObjectName(QStringLiteral("volume.curve"));
  curve_->setAccessibleName(tr("Opacity curve"));
  curve_->setToolTip(tr("Drag a point; double click adds one, right click takes one away"));
  curve_->setFixedHeight(170);
  connect(curve_, &OpacityCurve::function_changed, this, &VolumePage::use_curve);
  rows->addWidget(curve_);
  shift_ = make_slider(panel, "volume.threshold", tr("Threshold"),
                       tr("Moves the curve: to the right, denser tissue only"), -300, 300);
  density_ =
      make_slider(panel, "volume.density", tr("Density"), tr("Makes everything more or less opaque"), -100, 100);
  shaded_ = new QCheckBox(tr("Light on edges"));
  shaded_->setObjectName(QStringLiteral("volume.shaded"));
  shaded_->setToolTip(tr("Surfaces that face you are brighter"));
  tissues_ = new QCheckBox(tr("Colours of the tissues"));
  tissues_->setObjectName(QStringLiteral("volume.tissues"));
  tissues_->setToolTip(tr("As in slices and chart, instead of colours by HU"));
  for (QCheckBox* box : {shaded_, tissues_}) {
    box->setAccessibleName(box->text());
    box->setFocusPolicy(Qt::NoFocus);
    rows->addWidget(box);
    connect(box, &QCheckBox::toggled, this, [this] {
      imaging::VolumeLook look = view_->look();
      look.shaded = shaded_->isChecked();
      look.tissue_colours = tissues_->isChecked();
      view_->set_look(look);
    });
  }
  rows->addStretch(1);
  rows->addWidget(heading(tr("Drawn by")));
  auto* drawers = new QHBoxLayout;
  drawers->setSpacing(volume_gap);
  drawers_ = {
      button("volume.drawer.automatic", tr("Automatic"), tr("By the graphics card, where there is one")),
      button("volume.drawer.card", tr("Graphics card"), tr("By OpenGL, even where the processor computes it")),
      button("volume.drawer.processor", tr("Processor"), tr("By the processor alone"))};
  for (std::size_t i = 0; i < drawers_.size(); ++i) {
    drawers_[i]->setStyleSheet(QStringLiteral("padding: 6px 4px;"));
    drawers->addWidget(drawers_[i]);
    connect(drawers_[i], &QPushButton::clicked, this, [this, i] {
      keep_volume_drawer(scene::volume_drawers[i]);
      view_->set_drawer(scene::volume_drawers[i]);
      show_drawer();
    });
  }
  rows->addLayout(drawers);
  drawn_by_ = new QLabel;
  drawn_by_->setObjectName(QStringLiteral("volume.drawn_by"));
  drawn_by_->setProperty("role", QStringLiteral("second"));
  drawn_by_->setWordWrap(true);
  rows->addWidget(drawn_by_);
  return panel;
}

QSlider* VolumePage::make_slider(QWidget* parent, const char* name, const QString& text, const QString& tip, int low,
                                 int high) {
  auto* row = new QHBoxLayout;
  auto* label = new QLabel(text);
  label->setFixedWidth(72);
  row->addWidget(label);
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setObjectName(QLatin1String(name));
  slider->setAccessibleName(text);
  slider->setToolTip(tip);
  slider->setRange(low, high);
  slider->setFocusPolicy(Qt::ClickFocus);
  row->addWidget(slider, 1);
  static_cast<QVBoxLayout*>(parent->layout())->addLayout(row);
  connect(slider, &QSlider::valueChanged, this, &VolumePage::use_sliders);
  return slider;
}

void VolumePage::set_preset(imaging::TransferPreset preset) {
  view_->choose_preset(preset);
}

void VolumePage::show_preset(imaging::TransferPreset preset) {
  base_ = imaging::preset_function(preset);
  for (QSlider* slider : {shift_, density_}) {
    const QSignalBlocker quiet(slider);
    slider->setValue(0);
  }
  curve_->set_function(base_);
  for (std::size_t i = 0; i < presets_.size(); ++i) presets_[i]->setChecked(imaging::transfer_presets[i] == preset);
}

void VolumePage::use_sliders() {
  imaging::VolumeLook look = view_->look();
  look.transfer = imaging::adjusted(base_, shift_->value(), std::exp2(density_->value() / octave));
  curve_->set_function(look.transfer);
  view_->set_look(look);
}

// The sliders adjust the curve drawn by hand from now on.
void VolumePage::use_curve(const imaging::TransferFunction& function) {
  base_ = function;
  for (QSlider* slider : {shift_, density_}) {
    const QSignalBlocker quiet(slider);
    slider->setValue(0);
  }
  imaging::VolumeLook look = view_->look();
  look.transfer = function;
  view_->set_look(look);
  for (QPushButton* button : presets_) button->setChecked(false);
}

void VolumePage::show_look() {
  const imaging::VolumeLook& look = view_->look();
  for (std::size_t i = 0; i < modes_.size(); ++i)
    modes_[i]->setChecked(look.mode == static_cast<imaging::VolumeMode>(i));
  const bool lit = look.mode == imaging::VolumeMode::colour || look.mode == imaging::VolumeMode::grey;
  for (QWidget* widget : {static_cast<QWidget*>(curve_), static_cast<QWidget*>(shift_),
                          static_cast<QWidget*>(density_), static_cast<QWidget*>(shaded_)}) {
    widget->setEnabled(lit);
  }
  tissues_->setEnabled(look.mode == imaging::VolumeMode::colour);
  const QSignalBlocker quiet_shaded(shaded_), quiet_tissues(tissues_);
  shaded_->setChecked(look.shaded);
  tissues_->setChecked(look.tissue_colours);
}

void VolumePage::show_drawer() {
  for (std::size_t i = 0; i < drawers_.size(); ++i)
    drawers_[i]->setChecked(view_->drawer() == scene::volume_drawers[i]);
  QString text;
  if (view_->drawer() == scene::VolumeDrawer::processor) {
    text = tr("The processor draws.");
  } else if (!view_->card().empty()) {
    text = tr("%1 draws.").arg(QString::fromStdString(view_->card()));
  } else if (!view_->refusal().empty()) {
    text = tr("The processor draws: %1.").arg(in_words(view_->refusal()));
  }
  drawn_by_->setText(text);
}

void VolumePage::set_case(std::shared_ptr<const OpenCase> patient) {
  view_->set_case(std::move(patient));
}

void VolumePage::enter() {
  entered_ = true;
  view_->set_drawer(kept_volume_drawer());
  show_drawer();
  view_->setFocus(Qt::OtherFocusReason);
}

void VolumePage::advance(double clock) {
  Frame frame = frame_();
  frame.clock = clock;
  Changes changes;
  changes.needle = std::exchange(entered_, false);
  view_->show_frame(frame, changes);
}

bool VolumePage::press(const QKeySequence& keys) {
  return view_->press(keys[0]);
}

}  // namespace bodkin::app
