#include "app/pages/training.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QVBoxLayout>
#include <QVariant>
#include <chrono>

#include "report/learning_plot.h"
#include "views/language.h"
#include "views/theme.h"

#include "training/plan.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr int most_remembered = 8;  // plans of files

QLabel* training_label(const char* name, const char* role) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setProperty("role", QLatin1String(role));
  label->setWordWrap(true);
  return label;
}

QString without_words(const training::PlanAids& aids) {
  QStringList missing;
  const auto add = [&](bool shown, const QString& word) {
    if (!shown) missing << word;
  };
  add(aids.overlay, TrainingPage::tr("planned path"));
  add(aids.slices, TrainingPage::tr("slices"));
  add(aids.inside, TrainingPage::tr("view of the inside"));
  add(aids.ladder, TrainingPage::tr("tissues by depth"));
  add(aids.needle, TrainingPage::tr("picture of the needle"));
  add(aids.sound, TrainingPage::tr("sound"));
  add(aids.hints, TrainingPage::tr("hints"));
  QString words = missing.isEmpty() ? TrainingPage::tr("everything is shown")
                                    : TrainingPage::tr("without %1").arg(missing.join(QStringLiteral(", ")));
  if (aids.ultrasound) words += TrainingPage::tr("; with ultrasound");
  return words;
}

}  // namespace

LearningCurve::LearningCurve(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("training.curve"));
  setAccessibleName(tr("Learning curve"));
  setMinimumHeight(250);
}

void LearningCurve::show_attempts(const std::vector<training::AttemptSummary>& attempts) {
  attempts_ = attempts.size();
  picture_ = {};
  if (!attempts.empty()) {
    const std::string bytes = report::draw_learning_curve(attempts).png(2.0);
    picture_.loadFromData(reinterpret_cast<const uchar*>(bytes.data()), static_cast<uint>(bytes.size()));
  }
  update();
}

void LearningCurve::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  if (picture_.isNull()) {
    painter.setPen(Theme::now().second);
    painter.drawText(rect(), Qt::AlignCenter, tr("The learning curve appears here after the first attempt."));
    return;
  }
  const QSize size = picture_.size().scaled(this->size(), Qt::KeepAspectRatio);
  const QRect place(QPoint((width() - size.width()) / 2, 0), size);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawPixmap(place, picture_);
}

TrainingPage::TrainingPage(QWidget* parent) : Page(PageId::training, KeyScope::training, false, parent) {
  setFocusPolicy(Qt::StrongFocus);
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(0);
  columns->addWidget(make_side());
  columns->addWidget(make_standing(), 1);
}

TrainingPage::~TrainingPage() = default;

QWidget* TrainingPage::make_side() {
  auto* side = new QWidget;
  side->setObjectName(QStringLiteral("panel"));
  side->setAttribute(Qt::WA_StyledBackground);
  side->setFixedWidth(320);
  auto* rows = new QVBoxLayout(side);
  rows->setContentsMargins(18, 20, 18, 18);
  rows->setSpacing(10);
  auto* heading = training_label("training.heading", "heading");
  heading->setText(tr("Follow a plan"));
  rows->addWidget(heading);
  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("training.plans"));
  list_->setAccessibleName(tr("Plans"));
  list_->setToolTip(tr("Plans that come with Bodkin, and those that were opened before"));
  list_->setWordWrap(true);
  list_->setStyleSheet(QStringLiteral(
      "QListWidget { border: none; outline: none; background: transparent; } QListWidget::item { padding: 9px 8px; "
      "border-radius: 6px; } QListWidget::item:hover, QListWidget::item:selected { background: "
      "rgba(77, 163, 255, 45); }"));
  connect(list_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item == nullptr || item->data(Qt::UserRole).toString() == plan_) return;
    plan_ = item->data(Qt::UserRole).toString();
    look();
  });
  rows->addWidget(list_, 1);
  auto* open = new QPushButton(tr("Open a plan..."));
  open->setObjectName(QStringLiteral("training.open"));
  open->setAccessibleName(tr("Open a plan"));
  open->setToolTip(tr("Open a plan that a teacher has written"));
  connect(open, &QPushButton::clicked, this, &TrainingPage::open_plan);
  rows->addWidget(open);
  auto* who = training_label("training.who", "second");
  who->setText(tr("Your label. No name is needed: trainee-07"));
  rows->addWidget(who);
  trainee_ = new QLineEdit(QSettings().value(QStringLiteral("training/trainee")).toString());
  trainee_->setObjectName(QStringLiteral("training.trainee"));
  trainee_->setAccessibleName(tr("Label of the trainee"));
  trainee_->setToolTip(tr("Results are kept under this label; letters, digits, blanks, '_', '-' and '.'"));
  trainee_->setMaxLength(64);
  connect(trainee_, &QLineEdit::editingFinished, this, &TrainingPage::look);
  connect(trainee_, &QLineEdit::textChanged, this, [this] { follow_->setEnabled(!trainee_->text().isEmpty()); });
  rows->addWidget(trainee_);
  follow_ = new QPushButton(tr("Begin     Enter"));
  follow_->setObjectName(QStringLiteral("training.follow"));
  follow_->setAccessibleName(tr("Begin, or continue"));
  follow_->setToolTip(tr("The next attempt of this plan"));
  follow_->setProperty("role", QStringLiteral("primary"));
  follow_->setMinimumHeight(40);
  connect(follow_, &QPushButton::clicked, this, &TrainingPage::follow);
  rows->addWidget(follow_);
  return side;
}

QWidget* TrainingPage::make_standing() {
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* inner = new QWidget;
  inner->setObjectName(QStringLiteral("ground"));
  auto* rows = new QVBoxLayout(inner);
  rows->setContentsMargins(32, 20, 32, 16);
  rows->setSpacing(10);
  title_ = training_label("training.title", "title");
  progress_ = training_label("training.progress", "heading");
  stages_ = training_label("training.stages", "plain");
  line_ = training_label("training.line", "plain");
  for (QLabel* label : {title_, progress_, stages_, line_}) rows->addWidget(label);
  curve_ = new LearningCurve;
  rows->addWidget(curve_, 1);
  area->setWidget(inner);
  return area;
}

void TrainingPage::enter() {
  list_plans();
  if (plan_.isEmpty()) plan_ = QSettings().value(QStringLiteral("training/plan")).toString();
  if (plan_.isEmpty() && list_->count() > 0) plan_ = list_->item(0)->data(Qt::UserRole).toString();
  choose(plan_);
}

void TrainingPage::list_plans() {
  list_->clear();
  const auto add = [this](const QString& name, const QString& words) {
    auto* item = new QListWidgetItem(words, list_);
    item->setData(Qt::UserRole, name);
    item->setToolTip(name);
  };
  try {
    for (const std::string& name : training::shipped_plans())
      add(QString::fromStdString(name), in_words(training::read_plan(training::find_plan(name)).title));
  } catch (const std::exception& error) {
    line_->setText(in_words(error.what()));
  }
  for (const QString& file : QSettings().value(QStringLiteral("training/files")).toStringList())
    if (QFileInfo::exists(file)) add(file, QFileInfo(file).completeBaseName());
}

void TrainingPage::open_plan() {
  const QString file = QFileDialog::getOpenFileName(this, tr("A plan"), {}, tr("Plans (*.xml);;All files (*)"));
  if (!file.isEmpty()) choose(file);
}

void TrainingPage::choose(const QString& plan) {
  plan_ = plan;
  if (QFileInfo(plan).isFile()) {
    QSettings settings;
    const QString key = QStringLiteral("training/files");
    QStringList files = settings.value(key).toStringList();
    files.removeAll(plan);
    files.prepend(plan);
    while (files.size() > most_remembered) files.removeLast();
    settings.setValue(key, files);
    list_plans();
  }
  for (int i = 0; i < list_->count(); ++i)
    if (list_->item(i)->data(Qt::UserRole).toString() == plan_) list_->setCurrentRow(i);
  look();
}

// The answer arrives later: the store may be a server.
void TrainingPage::look() {
  if (looking_.valid()) {
    look_again_ = true;
    return;
  }
  look_again_ = false;
  looking_ = std::async(std::launch::async, read_standing, plan_.toStdString(), trainee_->text().toStdString());
  line_->setText(tr("Looking up how far you are."));
}

void TrainingPage::advance(double /*clock*/) {
  if (!looking_.valid() || looking_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  standing_ = looking_.get();
  if (look_again_) return look();
  show_standing();
}

void TrainingPage::show_standing() {
  const PlanStanding& now = *standing_;
  line_->setText(in_words(now.trouble));
  line_->setStyleSheet(QStringLiteral("color: %1;").arg(Theme::now().danger.name()));
  line_->setVisible(!now.trouble.empty());
  follow_->setEnabled(now.has_plan() && now.trouble.empty() && !trainee_->text().isEmpty());
  follow_->setText(now.attempts.empty() ? tr("Begin     Enter") : tr("Go on     Enter"));
  title_->setText(in_words(now.use.plan.title));
  progress_->setText(now.has_plan() ? in_words(standing_words(now)) : QString());
  progress_->setVisible(now.has_plan());
  const int at = now.has_plan() ? now.progress().stage : 0;
  const QString faint = Theme::now().second.name(), done = Theme::now().good.name();
  QString text = QStringLiteral("<table cellpadding='3'>");
  int number = 0;
  std::string procedure;
  for (const training::PlanStage& stage : now.use.plan.stages) {
    ++number;
    if (number <= at) procedure = stage.procedure;
    const QString state = number < at    ? QStringLiteral("<span style='color:%1'>%2</span>").arg(done, tr("done"))
                          : number == at ? tr("now")
                                         : QStringLiteral("<span style='color:%1'>%2</span>").arg(faint, tr("later"));
    text +=
        QStringLiteral("<tr><td>%1.&nbsp;</td><td>%2<br><span style='color:%3'>%4</span></td><td>&nbsp;%5</td></tr>")
            .arg(number)
            .arg(in_words(stage.title).toHtmlEscaped(), faint, without_words(stage.aids), state);
  }
  stages_->setText(text + QStringLiteral("</table>"));
  // The procedure of the stage to be done; if the case names it, the one practised last.
  std::vector<training::AttemptSummary> curve;
  std::string latest;
  if (procedure.empty()) {
    for (const training::AttemptSummary& each : now.of_every_kind) {
      if (each.started_at < latest) continue;
      latest = each.started_at;
      procedure = each.procedure;
    }
  }
  for (const training::AttemptSummary& each : now.of_every_kind)
    if (each.procedure == procedure) curve.push_back(each);
  curve_->show_attempts(curve);
}

void TrainingPage::follow() {
  if (!follow_->isEnabled()) return;
  QSettings().setValue(QStringLiteral("training/trainee"), trainee_->text());
  emit follow_requested(plan_, trainee_->text());
}

bool TrainingPage::press(const QKeySequence& keys) {
  if (keys != QKeySequence(Qt::Key_Return) && keys != QKeySequence(Qt::Key_Enter)) return false;
  follow();
  return true;
}

}  // namespace bodkin::app
