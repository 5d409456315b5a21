#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "app/pages/cards.h"

class QLineEdit;
class QListWidget;

namespace bodkin::app {

// All commands by name: type some letters of one, Enter executes it.
class Palette : public Card {
  Q_OBJECT
 public:
  struct Entry {
    QString text, keys;  // name of the command, and its key; may be empty
    std::function<void()> work;
  };

  explicit Palette(QWidget* parent);
  void show_entries(std::vector<Entry> entries);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  void filter();
  void do_current();

  std::vector<Entry> entries_;
  QLineEdit* words_;
  QListWidget* list_;
};

// Every word of `query` begins a word of `text`, ignoring case: "end see" fits "end, and see the result".
bool matches_query(const QString& text, const QString& query);

}  // namespace bodkin::app
