#include "app/pages/session_list.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>

#include "views/theme.h"

namespace bodkin::app {

using namespace views;

SessionList::SessionList(QWidget* parent) : QWidget(parent), list_(new QListWidget), line_(new QLabel) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(32, 24, 32, 20);
  rows->setSpacing(12);
  auto* top = new QHBoxLayout;
  auto* title = new QLabel(tr("Sessions"));
  title->setProperty("role", QStringLiteral("title"));
  top->addWidget(title);
  top->addStretch(1);
  auto* open = new QPushButton(tr("Open a file..."));
  open->setObjectName(QStringLiteral("review.open"));
  open->setAccessibleName(tr("Open a file"));
  open->setToolTip(tr("Open a session from another folder; it can also be dropped here"));
  connect(open, &QPushButton::clicked, this, &SessionList::file_dialog_requested);
  top->addWidget(open);
  rows->addLayout(top);
  auto* words = new QLabel(tr("Every attempt is kept. Choose one to see it again, moment by moment."));
  words->setProperty("role", QStringLiteral("second"));
  rows->addWidget(words);
  list_->setObjectName(QStringLiteral("review.list"));
  list_->setAccessibleName(tr("Sessions that are kept"));
  list_->setToolTip(tr("Newest first; a click opens"));
  list_->setStyleSheet(
      QStringLiteral("QListWidget { border: none; outline: none; } QListWidget::item { padding: 10px 12px; "
                     "border-radius: 6px; } QListWidget::item:hover, QListWidget::item:selected { background: "
                     "rgba(77, 163, 255, 45); }"));
  rows->addWidget(list_, 1);
  empty_ = new QLabel;
  empty_->setProperty("role", QStringLiteral("second"));
  empty_->setWordWrap(true);
  rows->addWidget(empty_);
  line_->setObjectName(QStringLiteral("review.line"));
  line_->setWordWrap(true);
  rows->addWidget(line_);
  const auto choose = [this](QListWidgetItem* item) { emit chosen(item->data(Qt::UserRole).toString()); };
  connect(list_, &QListWidget::itemClicked, this, choose);
  connect(list_, &QListWidget::itemActivated, this, choose);
}

void SessionList::show_sessions(const std::vector<KeptSession>& sessions, const std::filesystem::path& folder) {
  list_->clear();
  for (const KeptSession& session : sessions) {
    auto* item =
        new QListWidgetItem(tr("%1      %2, %3 MB")
                                .arg(QString::fromStdString(session.name), QString::fromStdString(session.modified))
                                .arg(session.size, 0, 'f', 1),
                            list_);
    item->setData(Qt::UserRole, QString::fromStdString(session.file.string()));
    item->setToolTip(QString::fromStdString(session.file.string()));
  }
  list_->setVisible(!sessions.empty());
  empty_->setVisible(sessions.empty());
  empty_->setText(
      tr("There is no session in %1 yet: practise once, or open a file that bodkin run or bodkin perform wrote.")
          .arg(QString::fromStdString(folder.string())));
}

void SessionList::show_message(const QString& sentence, bool is_trouble) {
  line_->setText(sentence);
  line_->setStyleSheet(is_trouble ? QStringLiteral("color: %1;").arg(Theme::now().danger.name()) : QString());
}

}  // namespace bodkin::app
