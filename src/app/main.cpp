// bodkin-app: the trainer in a window.
#include <QApplication>

#include "app/main_window.h"

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("bodkin"));
  bodkin::app::MainWindow window;
  window.show();
  return QApplication::exec();
}
