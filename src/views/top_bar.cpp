#include "views/top_bar.h"

#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "views/language.h"
#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr int wide_enough_for_words = 1200;  // pixels
constexpr double worrying_success = 0.98;    // share of ticks in time

constexpr std::array<const char*, stage_count> stage_names = {
    QT_TRANSLATE_NOOP("bodkin::views::TopBar", "Patient"), QT_TRANSLATE_NOOP("bodkin::views::TopBar", "Scan"),
    QT_TRANSLATE_NOOP("bodkin::views::TopBar", "Plan"), QT_TRANSLATE_NOOP("bodkin::views::TopBar", "Practise"),
    QT_TRANSLATE_NOOP("bodkin::views::TopBar", "Review")};
constexpr std::array<const char*, stage_count> stage_objects = {
    "top.stage.patient", "top.stage.scan", "top.stage.plan", "top.stage.practise", "top.stage.review"};

// A needle, from the lower left with its hub at the upper right.
QPixmap needle_mark(const QColor& colour, qreal ratio) {
  constexpr int size = 22;
  QPixmap pixmap(QSize(size, size) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(2.5, 19.5), QPointF(11.0, 11.0));
  painter.setPen(QPen(colour, 6.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(12.5, 9.5), QPointF(17.0, 5.0));
  return pixmap;
}

}  // namespace

TopBar::TopBar(QWidget* parent) : View(parent) {
  setFixedHeight(bar_height);
  setAttribute(Qt::WA_OpaquePaintEvent);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 0, 12, 0);
  row->setSpacing(8);

  home_ = new QPushButton(QStringLiteral("Bodkin"), this);
  home_->setObjectName(QStringLiteral("top.home"));
  home_->setToolTip(tr("Start page"));
  home_->setAccessibleName(tr("Start page"));
  home_->setFlat(true);
  home_->setIconSize(QSize(22, 22));
  connect(home_, &QPushButton::clicked, this, &TopBar::home_requested);
  row->addWidget(home_);

  auto* names = new QVBoxLayout;
  names->setSpacing(0);
  procedure_ = new QLabel(this);
  procedure_->setObjectName(QStringLiteral("top.procedure"));
  patient_ = new QLabel(this);
  patient_->setObjectName(QStringLiteral("top.patient"));
  names->addStretch();
  names->addWidget(procedure_);
  names->addWidget(patient_);
  names->addStretch();
  row->addLayout(names);
  row->addStretch(1);

  for (std::size_t i = 0; i < stages_.size(); ++i) {
    auto* button = new QPushButton(tr(stage_names[i]), this);
    button->setObjectName(QString::fromLatin1(stage_objects[i]));
    button->setToolTip(tr(stage_names[i]));
    button->setAccessibleName(tr(stage_names[i]));
    button->setCheckable(true);
    button->setAutoExclusive(true);
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QPushButton::clicked, this, [this, i] { emit stage_chosen(static_cast<Stage>(i)); });
    stages_[i] = button;
    row->addWidget(button);
  }
  row->addStretch(1);

  device_.button = make_chip("top.device", tr("Device"));
  connect(device_.button, &QPushButton::clicked, this, &TopBar::device_page_requested);
  servo_.button = make_chip("top.servo", tr("Force loop"));
  connect(servo_.button, &QPushButton::clicked, this, &TopBar::servo_page_requested);
  row->addWidget(device_.button);
  row->addWidget(servo_.button);

  ultrasound_ = new QPushButton(tr("Ultrasound"), this);
  ultrasound_->setObjectName(QStringLiteral("top.ultrasound"));
  ultrasound_->setCheckable(true);
  ultrasound_->setFocusPolicy(Qt::TabFocus);
  ultrasound_->setToolTip(tr("Ultrasound next to the needle (U); a new attempt begins"));
  ultrasound_->setAccessibleName(tr("Ultrasound"));
  connect(ultrasound_, &QPushButton::clicked, this, &TopBar::ultrasound_toggled);
  row->addWidget(ultrasound_);

  auto* help = new QPushButton(QStringLiteral("?"), this);
  help->setObjectName(QStringLiteral("top.help"));
  help->setToolTip(tr("Keys of this page (F1)"));
  help->setAccessibleName(tr("Help"));
  connect(help, &QPushButton::clicked, this, &TopBar::help_requested);
  row->addWidget(help);

  show_chip(device_, tr("No device"), Lamp::off, tr("No device is open"));
  show_chip(servo_, tr("Stopped"), Lamp::off, tr("The force loop is not running"));
  set_stage(Stage::patient);
  refresh_style();
}

QPushButton* TopBar::make_chip(const char* name, const QString& what) {
  auto* button = new QPushButton(this);
  button->setObjectName(QString::fromLatin1(name));
  button->setProperty("chip", true);
  button->setAccessibleName(what);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

void TopBar::refresh_style() {
  const Theme& theme = Theme::now();
  home_->setIcon(QIcon(needle_mark(theme.accent, devicePixelRatioF())));
  const QString checked = theme.is_dark ? QStringLiteral("#1B3350") : QStringLiteral("#D6E6F8");
  setStyleSheet(QStringLiteral(R"(
QPushButton { background: %1; color: %2; border: 1px solid %3; border-radius: 6px; padding: 5px 10px; }
QPushButton:hover, QPushButton:focus { border-color: %4; }
QPushButton:disabled { color: %5; }
QPushButton#top\.ultrasound:checked { background: %6; border-color: %4; }
QPushButton#top\.home { background: transparent; border-color: transparent; font-size: 15px; font-weight: 500; }
QPushButton#top\.home:focus { border-color: %4; }
QPushButton[chip="true"] { border-radius: 13px; padding: 4px 10px; }
QPushButton[autoExclusive="true"] { background: transparent; border-color: transparent; color: %5; padding: 5px 16px; }
QPushButton[autoExclusive="true"]:checked { background: %6; border-color: %4; color: %2; }
QPushButton[autoExclusive="true"]:focus { border-color: %4; }
QLabel { background: transparent; }
QLabel#top\.procedure { color: %2; font-weight: 500; }
QLabel#top\.patient { color: %5; font-size: 11px; }
)")
                    .arg(theme.raised.name(), theme.text.name(), theme.line.name(), theme.accent.name(),
                         theme.second.name(), checked));
  refresh_chip(device_);
  refresh_chip(servo_);
}

void TopBar::set_case(std::shared_ptr<const OpenCase> patient) {
  procedure_->setText(patient == nullptr ? QString() : in_words(patient->procedure));
  patient_->setText(patient == nullptr ? QString() : in_words(patient->title));
}

void TopBar::set_stage(Stage stage) {
  stages_[static_cast<std::size_t>(stage)]->setChecked(true);
}

void TopBar::allow(Stage stage, bool allowed) {
  stages_[static_cast<std::size_t>(stage)]->setEnabled(allowed);
}

void TopBar::set_ultrasound(bool on) {
  ultrasound_->setChecked(on);
}

void TopBar::show_frame(const Frame& frame, const Changes& changes) {
  if (changes.theme) refresh_style();
  if (changes.attempt) late_ = frame.late_ticks;
  const QString device = in_words(frame.device);
  if (device.isEmpty()) {
    show_chip(device_, tr("No device"), Lamp::off, tr("No device is open"));
  } else if (frame.state == State::device_lost) {
    show_chip(device_, tr("%1 lost").arg(device), Lamp::danger,
              tr("The device was disconnected; click to reconnect it"));
  } else {
    show_chip(device_, device, Lamp::good, tr("%1 holds the needle").arg(device));
  }
  if (frame.timings == nullptr) {
    show_chip(servo_, tr("Stopped"), Lamp::off, tr("The force loop is not running"));
  } else if (frame.guard == haptics::GuardState::faulted) {
    const std::string_view why = haptics::text_of(frame.fault);
    show_chip(
        servo_, tr("No force"), Lamp::danger,
        tr("The guard took the force away: %1").arg(QString::fromUtf8(why.data(), static_cast<int>(why.size()))));
  } else if (frame.recent_success < worrying_success) {
    const std::uint64_t late = frame.late_ticks - std::min(late_, frame.late_ticks);
    show_chip(servo_, tr("%1 late").arg(late), Lamp::caution,
              tr("%1 of 100 ticks were in time lately").arg(100.0 * frame.recent_success, 0, 'f', 0));
  } else {
    const QString rate = frame.rate >= 1000.0 ? tr("%1 kHz").arg(frame.rate / 1000.0) : tr("%1 Hz").arg(frame.rate);
    show_chip(servo_, rate, Lamp::good, tr("The force loop runs in time"));
  }
}

void TopBar::show_chip(Chip& chip, const QString& words, Lamp lamp, const QString& tip) {
  if (chip.button->toolTip() != tip) {
    chip.button->setToolTip(tip);
    chip.button->setAccessibleDescription(tip);
  }
  if (words == chip.words && lamp == chip.lamp && !chip.button->icon().isNull()) return;
  chip.words = words;
  chip.lamp = lamp;
  refresh_chip(chip);
}

// Each lamp has its own shape: disc, triangle, square, empty ring.
void TopBar::refresh_chip(const Chip& chip) {
  constexpr int size = 12;
  const Theme& theme = Theme::now();
  const qreal ratio = devicePixelRatioF();
  QPixmap pixmap(QSize(size, size) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  switch (chip.lamp) {
    case Lamp::good:
      painter.setBrush(theme.good);
      painter.drawEllipse(QPointF(6.0, 6.0), 4.0, 4.0);
      break;
    case Lamp::caution: {
      painter.setBrush(theme.caution);
      const QPointF triangle[] = {{6.0, 1.0}, {11.0, 10.5}, {1.0, 10.5}};
      painter.drawConvexPolygon(triangle, 3);
      break;
    }
    case Lamp::danger:
      painter.setBrush(theme.danger);
      painter.drawRect(QRectF(1.5, 1.5, 9.0, 9.0));
      break;
    case Lamp::off:
      painter.setPen(QPen(theme.second, 1.5));
      painter.drawEllipse(QPointF(6.0, 6.0), 4.0, 4.0);
      break;
  }
  painter.end();
  chip.button->setIcon(QIcon(pixmap));
  chip.button->setIconSize(QSize(size, size));
  chip.button->setText(width() >= wide_enough_for_words ? chip.words : QString());
}

void TopBar::resizeEvent(QResizeEvent* /*event*/) {
  refresh_chip(device_);
  refresh_chip(servo_);
}

void TopBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), Theme::now().panel);
  painter.fillRect(QRect(0, height() - 1, width(), 1), Theme::now().line);
  // The stages belong together.
  constexpr int around = 3;
  const QRectF group = QRectF(stages_.front()->geometry().united(stages_.back()->geometry()))
                           .adjusted(-around - 0.5, -around - 0.5, around + 0.5, around + 0.5);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Theme::now().line, 1.0));
  painter.setBrush(Theme::now().ground);
  painter.drawRoundedRect(group, corner + around, corner + around);
}

}  // namespace bodkin::views
