#pragma once

#include <QMainWindow>

namespace bodkin::app {

// The window: pages below a bar.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  MainWindow();
};

}  // namespace bodkin::app
