#pragma once

#include <QWidget>
#include <filesystem>
#include <vector>

#include "app/models/kept_sessions.h"

class QLabel;
class QListWidget;

namespace bodkin::app {

// The stored sessions, newest first, for selection; others by a dialog or drag and drop.
class SessionList : public QWidget {
  Q_OBJECT
 public:
  explicit SessionList(QWidget* parent = nullptr);

  void show_sessions(const std::vector<KeptSession>& sessions, const std::filesystem::path& folder);
  // One sentence below the list; empty: none.
  void show_message(const QString& sentence, bool is_trouble);

 signals:
  void chosen(const QString& file);
  void file_dialog_requested();

 private:
  QListWidget* list_;
  QLabel* empty_;
  QLabel* line_;
};

}  // namespace bodkin::app
