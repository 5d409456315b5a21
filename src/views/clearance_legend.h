#pragma once

#include <QWidget>

namespace bodkin::views {

// What the colours of the skin mean while a path is planned, and how far the map is.
class ClearanceLegend : public QWidget {
  Q_OBJECT
 public:
  explicit ClearanceLegend(QWidget* parent = nullptr);

  // A sentence below the colours; empty: none.
  void say(const QString& sentence);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString said_;
};

}  // namespace bodkin::views
