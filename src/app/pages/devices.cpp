#include "app/pages/devices.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <cmath>

#include "views/language.h"
#include "views/theme.h"
#include "views/workspace_picture.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr int list_width = 360;       // pixels
constexpr int item_text_width = 280;  // pixels, of a device's words in the list
constexpr int item_padding = 8;       // pixels, as in the list's style sheet

QColor lamp_colour(DeviceRow::Lamp lamp) {
  switch (lamp) {
    case DeviceRow::Lamp::good:
      return Theme::now().good;
    case DeviceRow::Lamp::off:
      return Theme::now().second;
    case DeviceRow::Lamp::trouble:
      return Theme::now().caution;
  }
  return {};
}

// Filled if the device is present, a ring if not: visible by shape too.
QIcon lamp_icon(DeviceRow::Lamp lamp) {
  QPixmap picture(14, 14);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor colour = lamp_colour(lamp);
  painter.setPen(QPen(colour, 2.0));
  painter.setBrush(lamp == DeviceRow::Lamp::good ? QBrush(colour) : QBrush(Qt::NoBrush));
  if (lamp == DeviceRow::Lamp::trouble) {
    const QPointF corners[] = {{7.0, 2.0}, {12.5, 12.0}, {1.5, 12.0}};
    painter.drawConvexPolygon(corners, 3);
  } else {
    painter.drawEllipse(QPointF(7.0, 7.0), 4.5, 4.5);
  }
  painter.end();
  return QIcon(picture);
}

QString full_name(const DeviceRow& row) {
  return row.is_mouse() ? QString() : QString::fromStdString(row.driver + ":" + row.identity);
}

QLabel* add_words(QVBoxLayout* rows, const char* name, const char* role) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setProperty("role", QLatin1String(role));
  label->setWordWrap(true);
  rows->addWidget(label);
  return label;
}

}  // namespace

DevicesPage::DevicesPage(QWidget* parent) : Page(PageId::devices, KeyScope::devices, false, parent) {
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(0);
  columns->addWidget(make_side());
  columns->addWidget(make_detail(), 1);
}

DevicesPage::~DevicesPage() = default;

QPushButton* DevicesPage::button(const QString& text, const char* name, const QString& tip) {
  auto* made = new QPushButton(text);
  made->setObjectName(QLatin1String(name));
  made->setAccessibleName(text);
  made->setToolTip(tip);
  return made;
}

QWidget* DevicesPage::make_side() {
  auto* side = new QWidget;
  side->setObjectName(QStringLiteral("panel"));
  side->setAttribute(Qt::WA_StyledBackground);
  side->setFixedWidth(list_width);
  auto* rows = new QVBoxLayout(side);
  rows->setContentsMargins(16, 20, 16, 16);
  rows->setSpacing(10);
  add_words(rows, "devices.heading", "heading")->setText(tr("Devices"));
  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("devices.list"));
  list_->setAccessibleName(tr("Devices"));
  list_->setToolTip(tr("Devices that can hold the needle; a filled lamp means that one is connected"));
  list_->setWordWrap(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setStyleSheet(
      QStringLiteral("QListWidget { border: none; outline: none; } QListWidget::item { padding: 8px; border-radius: "
                     "6px; } QListWidget::item:hover, QListWidget::item:selected { background: rgba(77, 163, 255, "
                     "45); }"));
  connect(list_, &QListWidget::currentRowChanged, this, [this] { show_row(); });
  rows->addWidget(list_, 1);
  looking_ = add_words(rows, "devices.looking", "second");
  QPushButton* const look = button(tr("Look again"), "devices.look", tr("Ask every driver what is connected"));
  connect(look, &QPushButton::clicked, this, &DevicesPage::look_for_devices);
  rows->addWidget(look);
  return side;
}

QWidget* DevicesPage::make_detail() {
  auto* detail = new QWidget;
  auto* rows = new QVBoxLayout(detail);
  rows->setContentsMargins(32, 20, 32, 20);
  rows->setSpacing(10);
  title_ = add_words(rows, "devices.title", "title");
  state_ = add_words(rows, "devices.state", "plain");
  sentence_ = add_words(rows, "devices.sentence", "second");
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  use_ = button(tr("Use for practising"), "devices.use", tr("Use this device for the following attempts"));
  use_->setProperty("role", QStringLiteral("primary"));
  connect(use_, &QPushButton::clicked, this, [this] {
    if (const DeviceRow* const row = selected())
      emit use_requested(QString::fromStdString(row->driver), QString::fromStdString(row->identity));
  });
  check_ = button(tr("Check"), "devices.check", tr("Ten seconds without force: how well does it answer?"));
  connect(check_, &QPushButton::clicked, this, [this] { begin(false); });
  calibrate_ = button(tr("Calibrate"), "devices.calibrate", tr("Up to five steps, one after the other"));
  connect(calibrate_, &QPushButton::clicked, this, [this] { begin(true); });
  for (QPushButton* each : {use_, check_, calibrate_}) buttons->addWidget(each);
  buttons->addStretch(1);
  rows->addLayout(buttons);
  picture_ = new WorkspacePicture;
  picture_->setObjectName(QStringLiteral("devices.workspace"));
  rows->addWidget(picture_, 3);
  steps_ = add_words(rows, "devices.steps", "plain");
  task_ = add_words(rows, "devices.task", "heading");
  bar_ = new QProgressBar;
  bar_->setObjectName(QStringLiteral("devices.bar"));
  bar_->setTextVisible(false);
  bar_->setRange(0, 1000);
  rows->addWidget(bar_);
  auto* course = new QHBoxLayout;
  go_on_ = button(tr("Begin this step"), "devices.go_on", tr("Begin the step, or end its motions early"));
  connect(go_on_, &QPushButton::clicked, this, [this] { work_.go_on(); });
  cancel_ = button(tr("Cancel"), "devices.cancel", tr("Release the device; nothing is saved"));
  connect(cancel_, &QPushButton::clicked, this, [this] { work_.cancel(); });
  course->addWidget(go_on_);
  course->addWidget(cancel_);
  course->addStretch(1);
  rows->addLayout(course);
  verdict_ = add_words(rows, "devices.verdict", "plain");
  profile_ = add_words(rows, "devices.profile", "second");
  rows->addStretch(1);
  return detail;
}

void DevicesPage::enter() {
  if (!has_looked_) look_for_devices();
}

void DevicesPage::leave() {
  work_.cancel();
}

void DevicesPage::look_for_devices() {
  has_looked_ = true;
  finder_.start();
}

void DevicesPage::set_used(const QString& device) {
  used_ = device;
  version_ = 0;  // the list names it
}

void DevicesPage::select(int row) {
  list_->setCurrentRow(row);
}

const DeviceRow* DevicesPage::selected() const {
  const int row = list_->currentRow();
  return row < 0 || row >= static_cast<int>(rows_.size()) ? nullptr : &rows_[static_cast<std::size_t>(row)];
}

void DevicesPage::show_rows() {
  const int kept = std::max(0, list_->currentRow());
  rows_ = finder_.rows();
  const QSignalBlocker quiet(list_);
  list_->clear();
  list_->ensurePolished();  // for the font of the style sheet
  for (const DeviceRow& row : rows_) {
    QString text = in_words(row.title) + QLatin1Char('\n') + in_words(row.state);
    if (full_name(row) == used_ && row.can_open()) text += tr(", used for practising");
    auto* item = new QListWidgetItem(lamp_icon(row.lamp), text, list_);
    item->setToolTip(in_words(row.sentence));
    // The list's own height of an item ignores the padding of the style sheet, which makes a long name need another
    // line.
    const QRect words = list_->fontMetrics().boundingRect(QRect(0, 0, item_text_width, 1000), Qt::TextWordWrap, text);
    item->setSizeHint(QSize(item_text_width, words.height() + 4 * item_padding));
  }
  list_->setCurrentRow(std::min(kept, list_->count() - 1));
  const std::string asking = finder_.asking();
  looking_->setText(asking.empty() ? QString() : tr("Asking %1...").arg(QString::fromStdString(asking)));
  show_row();
}

void DevicesPage::show_row() {
  const DeviceRow* const row = selected();
  if (row == nullptr) return;
  title_->setText(in_words(row->title));
  state_->setText(in_words(row->state));
  state_->setStyleSheet(QStringLiteral("color: %1;").arg(lamp_colour(row->lamp).name()));
  sentence_->setText(row->is_mouse() ? tr("It needs no setup: the wheel pushes the needle, and the resistance is "
                                          "shown as the distance by which the hand is ahead of the needle.")
                                     : in_words(row->sentence));
  sentence_->setVisible(!sentence_->text().isEmpty());
  use_->setEnabled(row->can_open() && full_name(*row) != used_);
  use_->setText(row->can_open() && full_name(*row) == used_ ? tr("Used for practising") : tr("Use for practising"));
  show_profile();
  show_status();
}

void DevicesPage::show_profile() {
  const DeviceRow* const row = selected();
  QStringList lines;
  try {
    if (row != nullptr && !row->is_mouse()) {
      for (const std::string& line : kept_calibration(row->driver)) lines << in_words(line);
      if (lines.isEmpty() && row->can_open()) lines << tr("Not calibrated: the middle of its workspace is a guess.");
    }
  } catch (const std::exception& error) {  // the file of calibrations is damaged
    lines << in_words(error.what());
  }
  profile_->setText(lines.join(QLatin1Char('\n')));
}

void DevicesPage::begin(bool calibration) {
  const DeviceRow* const row = selected();
  if (row == nullptr || row->is_mouse()) return;
  worked_on_ = list_->currentRow();
  try {
    const station::DeviceChoice choice = choice_of(*row);
    calibration ? work_.calibrate(choice) : work_.check(choice);
    verdict_->clear();
  } catch (const std::exception& error) {
    verdict_->setText(in_words(error.what()));
  }
  show_status();
}

void DevicesPage::advance(double /*clock*/) {
  if (finder_.version() != version_) {
    version_ = finder_.version();
    show_rows();
  }
  const bool busy = work_.status().is_busy;
  if (busy || was_busy_) show_status();
  if (was_busy_ && !busy) show_profile();
  was_busy_ = busy;
}

void DevicesPage::show_status() {
  const DeviceWork::Status status = work_.status();
  const DeviceRow* const row = selected();
  const bool here = worked_on_ >= 0 && worked_on_ == list_->currentRow();
  const bool can_work = row != nullptr && row->can_open() && !row->is_mouse() && !status.is_busy;
  check_->setEnabled(can_work);
  calibrate_->setEnabled(can_work);
  const bool runs = here && status.is_busy, calibrates = runs && status.task == DeviceWork::Task::calibrate;
  bar_->setVisible(runs);
  cancel_->setVisible(runs);
  go_on_->setVisible(calibrates && !status.steps.empty());
  go_on_->setText(status.stage.empty() ? tr("Begin this step") : tr("Enough"));
  bar_->setValue(static_cast<int>(std::lround(1000.0 * status.fraction)));
  picture_->setVisible(row != nullptr && !row->is_mouse());
  picture_->show_hand(here ? status.abilities : haptics::DeviceAbilities{},
                      runs && status.is_open ? std::optional<Pose>(status.hand) : std::nullopt,
                      runs ? status.force : 0.0);
  task_->setVisible(runs);
  steps_->setVisible(calibrates && !status.steps.empty());
  if (calibrates && status.step < status.steps.size()) {
    QStringList names;
    for (std::size_t i = 0; i < status.steps.size(); ++i) {
      const std::string_view name = station::name_of(status.steps[i]);
      const QString text = QString::fromUtf8(name.data(), static_cast<int>(name.size()));
      names << (i == status.step ? QStringLiteral("<b style='color:%1'>%2</b>").arg(Theme::now().accent.name(), text)
                                 : (i < status.step ? text + tr(" (done)") : text));
    }
    steps_->setText(tr("Step %1 of %2: ").arg(status.step + 1).arg(status.steps.size()) +
                    names.join(QStringLiteral("  &middot;  ")));
    const std::string_view task = station::task_of(status.steps[status.step]);
    task_->setText(QString::fromUtf8(task.data(), static_cast<int>(task.size())));
  } else {
    task_->setText(in_words(status.stage));
  }
  const bool over = here && !status.is_busy && (!status.verdict.empty() || !status.trouble.empty());
  verdict_->setVisible(over || !verdict_->text().isEmpty());
  if (!here) return verdict_->clear();
  if (!over) return;
  verdict_->setText(in_words(status.trouble.empty() ? status.verdict : status.trouble));
  verdict_->setStyleSheet(
      QStringLiteral("color: %1;")
          .arg((status.trouble.empty() && status.went_well ? Theme::now().good : Theme::now().caution).name()));
}

}  // namespace bodkin::app
