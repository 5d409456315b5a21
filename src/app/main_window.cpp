#include "app/main_window.h"

#include "app/theme.h"

namespace bodkin::app {

MainWindow::MainWindow() {
  setObjectName(QStringLiteral("window"));
  setWindowTitle(QStringLiteral("Bodkin"));
  setStyleSheet(Theme::now().style_sheet());
  setMinimumSize(1024, 640);
  resize(1280, 720);
}

}  // namespace bodkin::app
