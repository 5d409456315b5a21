#include "app/pages/palette.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace bodkin::app {

namespace {

constexpr int entry_role = Qt::UserRole;

QStringList palette_words(const QString& text) {
  static const QRegularExpression between(QStringLiteral("[^\\w-]+"), QRegularExpression::UseUnicodePropertiesOption);
  return text.split(between, Qt::SkipEmptyParts);
}

}  // namespace

bool matches_query(const QString& text, const QString& query) {
  const QStringList has = palette_words(text), wanted = palette_words(query);
  return std::all_of(wanted.begin(), wanted.end(), [&has](const QString& word) {
    return std::any_of(has.begin(), has.end(),
                       [&word](const QString& each) { return each.startsWith(word, Qt::CaseInsensitive); });
  });
}

Palette::Palette(QWidget* parent) : Card("palette", parent), words_(new QLineEdit), list_(new QListWidget) {
  words_->setObjectName(QStringLiteral("palette.words"));
  words_->setPlaceholderText(tr("What do you want to do?"));
  words_->setAccessibleName(words_->placeholderText());
  words_->setToolTip(tr("Type part of its name; arrows choose, Enter runs it, Esc closes"));
  list_->setObjectName(QStringLiteral("palette.list"));
  list_->setAccessibleName(tr("Commands"));
  list_->setToolTip(tr("Click to run it"));
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setMinimumHeight(320);
  list_->setStyleSheet(QStringLiteral("QListWidget { border: none; }"));
  rows()->addWidget(words_);
  rows()->addWidget(list_);
  words_->installEventFilter(this);
  connect(words_, &QLineEdit::textChanged, this, &Palette::filter);
  connect(list_, &QListWidget::itemClicked, this, &Palette::do_current);
}

void Palette::show_entries(std::vector<Entry> entries) {
  entries_ = std::move(entries);
  words_->clear();
  filter();
  setVisible(true);
  raise();
  words_->setFocus(Qt::PopupFocusReason);
}

void Palette::filter() {
  list_->clear();
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!matches_query(entries_[i].text, words_->text())) continue;
    const QString keys = entries_[i].keys.isEmpty() ? QString() : QStringLiteral("      %1").arg(entries_[i].keys);
    auto* const item = new QListWidgetItem(entries_[i].text + keys, list_);  // the list owns it
    item->setData(entry_role, static_cast<int>(i));
  }
  list_->setCurrentRow(0);
}

void Palette::do_current() {
  const QListWidgetItem* const item = list_->currentItem();
  if (item == nullptr) return;
  const std::function<void()> work = entries_[static_cast<std::size_t>(item->data(entry_role).toInt())].work;
  hide();
  parentWidget()->setFocus(Qt::OtherFocusReason);
  work();
}

bool Palette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == words_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) return do_current(), true;  // no page shall see it
    const int way = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
    if (way != 0 && list_->count() > 0) {
      list_->setCurrentRow(std::clamp(list_->currentRow() + way, 0, list_->count() - 1));
      return true;
    }
  }
  return Card::eventFilter(watched, event);
}

void Palette::mousePressEvent(QMouseEvent* /*event*/) {
  hide();
}

}  // namespace bodkin::app
