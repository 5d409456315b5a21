#pragma once

#include <QWidget>

namespace bodkin::views {

// The meaning of the skin's colours while a path is planned, and the progress of the map.
class ClearanceLegend : public QWidget {
  Q_OBJECT
 public:
  explicit ClearanceLegend(QWidget* parent = nullptr);

  // A sentence below the colours; empty: none.
  void show_message(const QString& sentence);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString message_;
};

}  // namespace bodkin::views
