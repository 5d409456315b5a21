#include "app/script.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QKeyEvent>
#include <QKeySequence>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QTextStream>
#include <QThread>
#include <QVariant>
#include <QWheelEvent>
#include <algorithm>
#include <iostream>

#include "app/main_window.h"

#include "core/error.h"

namespace bodkin::app {

namespace {

constexpr int notch = 120;  // of a wheel, eighths of a degree
constexpr int drag_steps = 12;
constexpr double frame_time = 0.02;  // s

double seconds_of(const QString& text) {
  bool good = false;
  const double value = QString(text).remove(QLatin1Char('s')).toDouble(&good);
  if (!good || value < 0.0 || value > 3600.0)
    throw InputError("'" + text.toStdString() + "' is no time; expected seconds, such as 2.5s");
  return value;
}

void send_mouse(QWidget* widget, QEvent::Type type, const QPoint& at, Qt::MouseButton button, Qt::MouseButtons held) {
  QMouseEvent event(type, at, widget->mapToGlobal(at), button, held, Qt::NoModifier);
  QApplication::sendEvent(widget, &event);
}

}  // namespace

QSize parse_size(const QString& text) {
  static const QRegularExpression pattern(QStringLiteral("^([0-9]{3,5})x([0-9]{3,5})$"));
  const QRegularExpressionMatch match = pattern.match(text);
  if (!match.hasMatch()) {
    throw InputError("the size is '" + text.toStdString() +
                     "'; expected width and height in pixels, such as 1280x720");
  }
  return {match.captured(1).toInt(), match.captured(2).toInt()};
}

Script::Script(MainWindow& window, QString shots) : window_(window), shots_(std::move(shots)) {}

bool Script::run(const QString& file) {
  QFile lines(file);
  if (!lines.open(QIODevice::ReadOnly | QIODevice::Text))
    throw InputError(file.toStdString() + " cannot be read: " + lines.errorString().toStdString());
  QTextStream text(&lines);
  for (int number = 1; !text.atEnd(); ++number) {
    const QString line = text.readLine().simplified();
    if (line.isEmpty() || line.startsWith(QLatin1Char('#'))) continue;
    trouble_.clear();
    const std::string where = file.toStdString() + ":" + std::to_string(number) + ": ";
    try {
      if (step(line.split(QLatin1Char(' ')))) continue;
    } catch (const InputError& error) {
      throw InputError(where + error.what());
    }
    std::cerr << where << line.toStdString() << ": " << trouble_.toStdString() << '\n';
    return false;
  }
  return true;
}

void Script::let_pass(double seconds) {
  QElapsedTimer timer;
  timer.start();
  do {
    QApplication::processEvents(QEventLoop::AllEvents, 5);
    QThread::msleep(1);
  } while (timer.elapsed() < static_cast<qint64>(1e3 * seconds));
}

QWidget* Script::widget(const QString& name) {
  QWidget* const found = window_.objectName() == name ? &window_ : window_.findChild<QWidget*>(name);
  if (found == nullptr)
    trouble_ = QStringLiteral("no widget has the name %1").arg(name);
  else if (!found->isVisible())
    trouble_ = QStringLiteral("%1 is not visible").arg(name);
  else if (!found->isEnabled())
    trouble_ = QStringLiteral("%1 is disabled").arg(name);
  return trouble_.isEmpty() ? found : nullptr;
}

QPoint Script::place(QWidget* widget, const QString& text) const {
  if (text.isEmpty()) return widget->rect().center();
  const QStringList parts = text.split(QLatin1Char(','));
  int values[2] = {0, 0};
  for (int i = 0; i < 2; ++i) {
    bool good = parts.size() == 2;
    QString part = good ? parts[i] : text;
    const bool percent = part.endsWith(QLatin1Char('%'));
    if (percent) part.chop(1);
    double value = part.toDouble(&good);
    if (percent) value *= 0.01 * (i == 0 ? widget->width() : widget->height());
    if (!good || parts.size() != 2)
      throw InputError("'" + text.toStdString() + "' is no place; expected x,y in pixels or percent");
    values[i] = static_cast<int>(value);
  }
  return {values[0], values[1]};
}

bool Script::wait_for(const QString& state, double seconds) {
  QElapsedTimer timer;
  timer.start();
  const auto reached = [&] { return state == QLatin1String(name_of(window_.practice().state()).data()); };
  while (!reached() && timer.elapsed() < static_cast<qint64>(1e3 * seconds)) let_pass(frame_time);
  if (!reached()) {
    trouble_ = QStringLiteral("after %1 s the state is %2")
                   .arg(seconds)
                   .arg(QLatin1String(name_of(window_.practice().state()).data()));
  }
  return reached();
}

bool Script::show_page(const QString& name) {
  for (int i = 0; i < page_count; ++i) {
    const auto id = static_cast<PageId>(i);
    if (name != QLatin1String(name_of(id))) continue;
    window_.show_page(id);
    let_pass(2.0 * frame_time);
    return true;
  }
  throw InputError("'" + name.toStdString() + "' is no page");
}

bool Script::expect(const QString& property, const QString& value) {
  const int dot = property.lastIndexOf(QLatin1Char('.'));
  QWidget* const found = widget(property.left(dot));
  if (found == nullptr) return false;
  const QString now = found->property(property.mid(dot + 1).toLatin1().constData()).toString();
  if (now != value) trouble_ = QStringLiteral("it is '%1'").arg(now);
  return now == value;
}

void Script::press(const QString& keys, double seconds) {
  const QKeySequence sequence(keys);
  if (sequence.isEmpty()) throw InputError("'" + keys.toStdString() + "' is no key");
  const int code = sequence[0];
  const auto modifiers = Qt::KeyboardModifiers(code & static_cast<int>(Qt::KeyboardModifierMask));
  const int key = code & ~static_cast<int>(Qt::KeyboardModifierMask);
  QWidget* const focus = window_.focusWidget() != nullptr ? window_.focusWidget() : &window_;
  QKeyEvent down(QEvent::KeyPress, key, modifiers);
  QApplication::sendEvent(focus, &down);
  let_pass(seconds);
  QKeyEvent up(QEvent::KeyRelease, key, modifiers);
  QApplication::sendEvent(focus, &up);
}

bool Script::type(const QString& name, const QString& text) {
  QWidget* const target = widget(name);
  if (target == nullptr) return false;
  target->setFocus(Qt::OtherFocusReason);
  for (const QChar& letter : text) {
    QKeyEvent down(QEvent::KeyPress, 0, Qt::NoModifier, QString(letter));
    QApplication::sendEvent(target, &down);
  }
  return true;
}

bool Script::shoot(const QString& name) {
  QDir().mkpath(shots_);
  let_pass(2.0 * frame_time);
  const QString file = QDir(shots_).filePath(name);
  if (window_.grab().save(file)) return true;
  trouble_ = QStringLiteral("%1 cannot be written").arg(file);
  return false;
}

bool Script::step(const QStringList& words) {
  const QString& verb = words.front();
  const auto count = words.size();
  const auto word = [&](int i) { return i < count ? words[i] : QString(); };
  if (verb == QLatin1String("wait") && count == 2) return let_pass(seconds_of(words[1])), true;
  if (verb == QLatin1String("wait") && count == 3) return wait_for(words[1], seconds_of(words[2]));
  if (verb == QLatin1String("expect") && count >= 3) return expect(words[1], words.mid(2).join(QLatin1Char(' ')));
  if (verb == QLatin1String("page") && count == 2) return show_page(words[1]);
  if (verb == QLatin1String("shot") && count == 2) return shoot(words[1]);
  if (verb == QLatin1String("key") && count == 2) return press(words[1], frame_time), true;
  if (verb == QLatin1String("hold") && count == 3) return press(words[1], seconds_of(words[2])), true;
  if (verb == QLatin1String("type") && count >= 3) return type(words[1], words.mid(2).join(QLatin1Char(' ')));
  const bool click = verb == QLatin1String("click") && (count == 2 || count == 3);
  const bool move = verb == QLatin1String("move") && count == 3;
  const bool drag = verb == QLatin1String("drag") && count == 4;
  const bool wheel = verb == QLatin1String("wheel") && (count == 3 || count == 4);
  if (!click && !move && !drag && !wheel) {
    throw InputError("'" + words.join(QLatin1Char(' ')).toStdString() +
                     "' is no step; expected click, move, drag, wheel, key, hold, type, wait, page, expect or shot");
  }
  QWidget* const target = widget(words[1]);
  if (target == nullptr) return false;
  if (wheel) {
    const QString modifier = word(3);
    const Qt::KeyboardModifiers held = modifier == QLatin1String("Shift")  ? Qt::ShiftModifier
                                       : modifier == QLatin1String("Ctrl") ? Qt::ControlModifier
                                       : modifier == QLatin1String("Alt")  ? Qt::AltModifier
                                                                           : Qt::NoModifier;
    const QPoint at = target->rect().center();
    const int notches = words[2].toInt();
    for (int i = 0; i < std::abs(notches); ++i) {
      QWheelEvent event(at, target->mapToGlobal(at), {}, {0, notches > 0 ? notch : -notch}, Qt::NoButton, held,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(target, &event);
      let_pass(frame_time);
    }
    return true;
  }
  const QPoint at = place(target, word(2));
  if (!click) send_mouse(target, QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
  if (click || drag) send_mouse(target, QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
  QPoint end = at;
  if (drag) {
    const QPoint to = place(target, words[3]);
    for (int i = 1; i <= drag_steps; ++i) {
      end = at + (to - at) * i / drag_steps;
      send_mouse(target, QEvent::MouseMove, end, Qt::NoButton, Qt::LeftButton);
      let_pass(frame_time);
    }
  }
  if (click || drag) send_mouse(target, QEvent::MouseButtonRelease, end, Qt::LeftButton, Qt::NoButton);
  let_pass(frame_time);
  return true;
}

}  // namespace bodkin::app
