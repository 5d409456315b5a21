#pragma once

#include <QPoint>
#include <QSize>
#include <QString>
#include <QStringList>

class QWidget;

namespace bodkin::app {

class MainWindow;

// "1280x720"; throws InputError for anything else.
QSize parse_size(const QString& text);

// Simulates the user of the window, line by line, for tests, for the figures of the pages and for demonstrations:
//
//   click NAME [x,y]           the widget of this name, in its middle or at a place
//   move NAME x,y              the pointer goes there
//   drag NAME x,y x,y          with the left button
//   wheel NAME n [modifier]    notches, positive: away from the person; Shift, Ctrl or Alt
//   key KEYS                   "Ctrl+T", "PgDown"; hold KEYS 2s keeps them down
//   wait STATE 10s             until the state is reached, or the script has failed; wait 0.5s waits
//   page NAME                  another page: start, practise, plan, scan, review, ...
//   expect NAME.property VALUE a property of a widget, as text
//   shot FILE                  a picture of the window
//
// A place is in pixels from the widget's upper left corner, or in percent of its size: 50%,40%. Lines that begin with
// # and empty lines are ignored.
class Script {
 public:
  // `shots`: folder of the screenshots.
  Script(MainWindow& window, QString shots);

  // False, and a sentence on standard error with file and line, if a line fails. Throws InputError for an unreadable
  // file and for an unknown command.
  bool run(const QString& file);

 private:
  bool step(const QStringList& words);
  QWidget* widget(const QString& name);
  QPoint place(QWidget* widget, const QString& text) const;
  void let_pass(double seconds);
  bool wait_for(const QString& state, double seconds);
  bool expect(const QString& property, const QString& value);
  void press(const QString& keys, double seconds);
  bool show_page(const QString& name);
  bool type(const QString& name, const QString& text);
  bool shoot(const QString& name);

  MainWindow& window_;
  QString shots_, trouble_;
};

}  // namespace bodkin::app
