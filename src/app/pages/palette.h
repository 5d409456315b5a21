#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "app/pages/cards.h"

class QLineEdit;
class QListWidget;

namespace bodkin::app {

// All that can be done here, by name: type some letters of it, Enter does it.
class Palette : public Card {
  Q_OBJECT
 public:
  struct Entry {
    QString text, keys;  // what it does, and its key; may be empty
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

// Every word of `wish` begins a word of `text`, whatever the case: "end see" fits "end, and see how it went".
bool fits_wish(const QString& text, const QString& wish);

}  // namespace bodkin::app
