#include "app/pages/start.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLinearGradient>
#include <QLocale>
#include <QMimeData>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QScrollArea>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "app/models/practice_patients.h"
#include "app/models/procedure_title.h"
#include "app/spoken_language.h"
#include "views/language.h"
#include "views/open_case.h"
#include "views/theme.h"

#include "core/error.h"
#include "io/resources.h"
#include "training/procedure_file.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr std::size_t most_patients = 2;  // beside the card for dropping
constexpr int procedure_columns = 3;

QLabel* label(const QString& text, const char* role) {
  auto* words = new QLabel(text);
  words->setProperty("role", QLatin1String(role));
  words->setWordWrap(true);
  return words;
}

// The patient at the edge of the card; nothing if the image is not installed.
class HeroPicture : public QWidget {
 public:
  HeroPicture() {
    try {
      picture_.load(QString::fromStdString(io::shared_file("app/start.png").string()));
    } catch (const SystemError&) {  // the page does not need the image
    }
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    if (picture_.isNull()) return;
    const qreal ratio = devicePixelRatioF();
    QPixmap scaled = picture_.scaled(size() * ratio, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    const QSize out = scaled.size() - size() * ratio;
    scaled = scaled.copy(out.width() / 2, out.height() / 2, qRound(width() * ratio), qRound(height() * ratio));
    QPainter painter(this);
    painter.drawPixmap(rect(), scaled);
    // Into the card without an edge.
    QLinearGradient fade(0.0, 0.0, fade_width, 0.0);
    QColor ground = Theme::now().panel;
    fade.setColorAt(0.0, ground);
    ground.setAlpha(0);
    fade.setColorAt(1.0, ground);
    painter.fillRect(QRectF(0.0, 0.0, fade_width, height()), fade);
  }

 private:
  static constexpr qreal fade_width = 160.0;  // pixels
  QPixmap picture_;
};

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("start"));
  setAcceptDrops(true);
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(0);
  columns->addWidget(make_side());
  auto* area = new QScrollArea;  // for windows in which not all of it has room
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* inner = new QWidget;
  inner->setObjectName(QStringLiteral("ground"));
  auto* main = new QVBoxLayout(inner);
  main->setContentsMargins(32, 28, 32, 20);
  main->setSpacing(14);
  main->addWidget(make_recovered());
  main->addWidget(make_plan());
  main->addWidget(make_hero(), 3);
  main->addWidget(label(tr("Procedures"), "heading"));
  main->addWidget(make_procedures());
  main->addWidget(label(tr("Patients"), "heading"));
  patients_ = new QHBoxLayout;
  patients_->setSpacing(14);
  main->addLayout(patients_, 1);
  line_ = label({}, "second");
  line_->setObjectName(QStringLiteral("start.line"));
  main->addWidget(line_);
  area->setWidget(inner);
  columns->addWidget(area, 1);
  show_patients({});
}

QWidget* StartPage::make_side() {
  auto* side = new QWidget;
  side->setObjectName(QStringLiteral("panel"));
  side->setAttribute(Qt::WA_StyledBackground);
  side->setFixedWidth(232);
  auto* rows = new QVBoxLayout(side);
  rows->setContentsMargins(14, 20, 14, 12);
  rows->setSpacing(1);
  auto* name = new QLabel(QStringLiteral("Bodkin"));
  name->setStyleSheet(QStringLiteral("font-size: 22px; font-weight: 500; padding: 4px 8px 18px 8px;"));
  rows->addWidget(name);
  entries_ = new QVBoxLayout;
  entries_->setSpacing(1);
  rows->addLayout(entries_);
  connect(make_entry(tr("Practise"), QStringLiteral("start.practise"), tr("Begin on the built-in patient")),
          &QPushButton::clicked, this, &StartPage::begin_requested);
  connect(make_entry(tr("Open a patient"), QStringLiteral("start.open"),
                     tr("A case, a DICOM folder or an image (Ctrl+O)")),
          &QPushButton::clicked, this, &StartPage::open_requested);
  rows->addStretch(1);
  add_languages(rows);
  auto* const about = new QPushButton(tr("About, version %1").arg(QStringLiteral(BODKIN_VERSION)));
  about->setObjectName(QStringLiteral("start.about"));
  about->setProperty("role", QStringLiteral("flat"));
  about->setStyleSheet(QStringLiteral("text-align: left; padding: 9px 12px;"));
  about->setAccessibleName(about->text());
  about->setToolTip(tr("Versions of Bodkin and its libraries, and the licence"));
  connect(about, &QPushButton::clicked, this, &StartPage::about_requested);
  rows->addWidget(about);
  return side;
}

// A button for each language except the window's, in that language.
void StartPage::add_languages(QVBoxLayout* rows) {
  for (const QString& code : languages()) {
    if (code == spoken_language()) continue;
    // QLocale("en") would give "American English".
    auto* button =
        new QPushButton(code == QLatin1String("en") ? QStringLiteral("English") : QLocale(code).nativeLanguageName());
    button->setObjectName(QStringLiteral("start.language.%1").arg(code));
    button->setProperty("role", QStringLiteral("flat"));
    button->setStyleSheet(QStringLiteral("text-align: left; padding: 9px 12px;"));
    button->setAccessibleName(button->text());
    button->setToolTip(tr("Show the window in this language, from now on"));
    connect(button, &QPushButton::clicked, this, [this, code] { emit language_requested(code); });
    rows->addWidget(button);
  }
}

QPushButton* StartPage::make_entry(const QString& text, const QString& object, const QString& tip) {
  auto* button = new QPushButton(text);
  button->setObjectName(object);
  button->setToolTip(tip);
  button->setAccessibleName(text);
  button->setProperty("role", QStringLiteral("flat"));
  button->setStyleSheet(QStringLiteral("text-align: left; padding: 9px 12px;"));
  entries_->addWidget(button);
  return button;
}

void StartPage::add_entry(PageId page, const QString& text, const QString& tip) {
  connect(make_entry(text, QStringLiteral("start.%1").arg(QLatin1String(name_of(page))), tip), &QPushButton::clicked,
          this, [this, page] { emit page_requested(page); });
}

QWidget* StartPage::make_hero() {
  auto* hero = new QWidget;
  hero->setObjectName(QStringLiteral("hero"));
  hero->setAttribute(Qt::WA_StyledBackground);
  hero->setMinimumHeight(220);
  auto* columns = new QHBoxLayout(hero);
  columns->setContentsMargins(30, 1, 1, 1);
  auto* rows = new QVBoxLayout;
  rows->setContentsMargins(0, 24, 0, 16);
  rows->setSpacing(10);
  columns->addLayout(rows, 4);
  columns->addWidget(new HeroPicture, 5);
  rows->addWidget(label(tr("Put a needle in."), "title"));
  rows->addWidget(label(tr("Lumbar puncture, L3/L4, on the built-in patient. With the mouse, now."), "plain"));
  auto* buttons = new QHBoxLayout;
  auto* begin = new QPushButton(tr("Start lumbar puncture     Enter"));
  begin->setObjectName(QStringLiteral("start.begin"));
  begin->setToolTip(tr("The first time, the patient has to be made, which takes some seconds"));
  begin->setAccessibleName(tr("Start lumbar puncture"));
  begin->setProperty("role", QStringLiteral("primary"));
  begin->setMinimumHeight(40);
  connect(begin, &QPushButton::clicked, this, &StartPage::begin_requested);
  buttons->addWidget(begin);
  auto* tour = new QPushButton(tr("Two-minute tour     T"));
  tour->setObjectName(QStringLiteral("start.tour"));
  tour->setToolTip(tr("Look, aim, push, read: four hints that close once you have followed them"));
  tour->setAccessibleName(tr("Two-minute tour"));
  tour->setMinimumHeight(40);
  connect(tour, &QPushButton::clicked, this, &StartPage::tour_requested);
  buttons->addSpacing(8);
  buttons->addWidget(tour);
  buttons->addStretch(1);
  rows->addSpacing(8);
  rows->addLayout(buttons);
  rows->addSpacing(8);
  rows->addWidget(
      label(tr("Point at the back, click, and scroll: the needle goes in. You see the tissue that it is in, "
               "and the force that it meets."),
            "second"));
  rows->addStretch(1);
  return hero;
}

// Every procedure supplied with Bodkin, each with its own patient; a click begins.
QWidget* StartPage::make_procedures() {
  auto* const all = new QWidget;
  auto* const grid = new QGridLayout(all);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(10);
  int number = 0;
  for (const PracticePatient& patient : practice_patients()) {
    const QString name = QString::fromUtf8(patient.procedure.data(), static_cast<int>(patient.procedure.size()));
    const std::string title = procedure_title(std::string(patient.procedure));
    std::string description;
    try {
      description = training::find_shipped_procedure(std::string(patient.procedure)).description;
    } catch (const std::exception&) {  // its file is missing; choosing it reports that
    }
    QPushButton* const card =
        make_card(QStringLiteral("start.procedure.%1").arg(name), in_words(title), in_words(patient.words));
    card->setMinimumHeight(72);
    card->setMaximumHeight(84);
    card->layout()->setContentsMargins(14, 8, 12, 8);
    card->setToolTip(in_words(description));
    connect(card, &QPushButton::clicked, this, [this, name] { emit procedure_chosen(name); });
    grid->addWidget(card, number / procedure_columns, number % procedure_columns);
    ++number;
  }
  for (int column = 0; column < procedure_columns; ++column) grid->setColumnStretch(column, 1);
  return all;
}

// A one-line card above the others, with buttons on the right.
struct StartPage::Offer {
  QWidget* card;
  QLabel* words;
  QHBoxLayout* row;

  QPushButton* add(const QString& text, const char* name, const QString& tip) const {
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    button->setAccessibleName(text);
    button->setToolTip(tip);
    row->addWidget(button);
    return button;
  }
};

StartPage::Offer StartPage::make_offer() {
  auto* card = new QWidget;
  card->setObjectName(QStringLiteral("hero"));
  card->setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(card);
  row->setContentsMargins(18, 10, 14, 10);
  QLabel* const words = label({}, "plain");
  row->addWidget(words, 1);
  card->hide();
  return {card, words, row};
}

QWidget* StartPage::make_recovered() {
  const Offer offer = make_offer();
  recovered_ = offer.card;
  recovered_words_ = offer.words;
  connect(offer.add(tr("Review"), "start.recovered.review", tr("See the part that was recorded")),
          &QPushButton::clicked, this, [this] { emit review_requested(recovered_file_); });
  connect(offer.add(tr("Forget"), "start.recovered.forget", tr("Do not offer it again; the file stays")),
          &QPushButton::clicked, this, [this] { emit forget_requested(recovered_file_); });
  return recovered_;
}

QWidget* StartPage::make_plan() {
  const Offer offer = make_offer();
  plan_ = offer.card;
  plan_words_ = offer.words;
  plan_words_->setObjectName(QStringLiteral("start.plan"));
  connect(offer.add(tr("Go on"), "start.plan.continue", tr("The next attempt of the plan")), &QPushButton::clicked,
          this, &StartPage::plan_continued);
  connect(offer.add(tr("Stop following"), "start.plan.leave", tr("Do not offer it again; results stay in the store")),
          &QPushButton::clicked, this, &StartPage::plan_left);
  return plan_;
}

void StartPage::offer_plan(const QString& words) {
  plan_->setVisible(!words.isEmpty());
  plan_words_->setText(words);
}

void StartPage::offer_recovered(const QString& file) {
  recovered_file_ = file;
  recovered_->setVisible(!file.isEmpty());
  recovered_words_->setText(
      tr("The last session was cut off. What had been recorded is safe: %1").arg(QFileInfo(file).completeBaseName()));
}

QPushButton* StartPage::make_card(const QString& name, const QString& title, const QString& words) {
  auto* card = new QPushButton;
  card->setObjectName(name);
  card->setAccessibleName(title);
  card->setToolTip(words);
  card->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  card->setMinimumHeight(86);
  card->setMaximumHeight(110);
  auto* rows = new QVBoxLayout(card);
  rows->setContentsMargins(16, 12, 16, 12);
  rows->setSpacing(4);
  rows->addStretch(1);
  rows->addWidget(label(title, "heading"));
  rows->addWidget(label(words, "second"));
  rows->addStretch(1);
  for (QLabel* child : card->findChildren<QLabel*>()) child->setAttribute(Qt::WA_TransparentForMouseEvents);
  return card;
}

void StartPage::show_patients(const std::vector<std::filesystem::path>& folders) {
  while (QLayoutItem* item = patients_->takeAt(0)) {
    if (item->widget() != nullptr) {
      item->widget()->hide();
      item->widget()->deleteLater();  // it may be the card that was clicked
    }
    delete item;
  }
  const auto add = [this](QPushButton* card) {
    patients_->addWidget(card, 1);
    return card;
  };
  connect(add(make_card(QStringLiteral("start.patient.built_in"), tr("Synthetic lumbar torso"),
                        tr("45 years, 1.72 m, 72 kg. Built in"))),
          &QPushButton::clicked, this, &StartPage::begin_requested);
  std::size_t shown = 0;
  for (const std::filesystem::path& folder : folders) {
    if (++shown > most_patients) break;
    const QString path = QString::fromStdString(folder.string());
    connect(add(make_card(QStringLiteral("start.patient.%1").arg(shown),
                          QString::fromStdString(folder.filename().string()), tr("Opened before"))),
            &QPushButton::clicked, this, [this, path] { emit patient_chosen(path); });
  }
  QPushButton* const drop = add(
      make_card(QStringLiteral("start.drop"), tr("Drop a DICOM folder or an image here"), tr("or click to choose")));
  drop->setProperty("role", QStringLiteral("drop"));
  connect(drop, &QPushButton::clicked, this, &StartPage::open_requested);
}

void StartPage::show_message(const QString& sentence, bool is_trouble) {
  line_->setText(sentence);
  line_->setStyleSheet(is_trouble ? QStringLiteral("color: %1;").arg(Theme::now().danger.name()) : QString());
}

void StartPage::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void StartPage::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty() && urls.front().isLocalFile()) emit patient_chosen(urls.front().toLocalFile());
}

}  // namespace bodkin::app
