// The keys of the window: their commands in each context, and the release of held keys.
#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QStackedWidget>

#include "app/main_window.h"
#include "app/pages/practise.h"

namespace bodkin::app {

using namespace views;

namespace {

// A list or a slider in use by keys receives letters, Space and Escape itself: its property "keeps_keys" says so.
bool keeps_keys(const QWidget* widget) {
  for (; widget != nullptr && !widget->isWindow(); widget = widget->parentWidget()) {
    if (widget->property("keeps_keys").toBool()) return true;
  }
  return false;
}

}  // namespace

KeyScope MainWindow::page_scope() const {
  if (page_ != nullptr) return page_->scope();
  return pages_->currentWidget() == practise_ ? KeyScope::practise : KeyScope::start;
}

std::vector<KeyScope> MainWindow::scopes_of_keys() const {
  const KeyScope page = page_scope();
  if (page != KeyScope::practise) return {page, KeyScope::window};
  std::vector<KeyScope> scopes = {page, KeyScope::view3d, KeyScope::slice};
  if (has_ultrasound_) scopes.push_back(KeyScope::ultrasound);
  if (practise_->has_volume()) scopes.push_back(KeyScope::volume);
  scopes.push_back(KeyScope::window);
  return scopes;
}

bool MainWindow::press(const QKeySequence& keys, bool before_views) {
  const KeyScope page = page_scope();
  if (before_views) {
    const std::optional<Command> command = reserved_command(page, keys);
    if (command == Command::of_the_page) return page_->press(keys);
    return command ? (run(*command), true) : false;
  }
  for (const KeyScope scope : chain_of(page)) {
    const std::optional<Command> command = command_of(scope, keys);
    if (command == Command::of_the_page) return page_ != nullptr && page_->press(keys);
    if (command) return run(*command), true;
  }
  return false;
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  // The release of a held key elsewhere is not reported.
  if (event->type() == QEvent::WindowDeactivate && watched == this) {
    practice_.hold_key(0, false);
    practice_.hold_turn(0);
    practice_.press_plunger(false);
  }
  const bool is_press = event->type() == QEvent::KeyPress, is_release = event->type() == QEvent::KeyRelease;
  auto* const widget = qobject_cast<QWidget*>(watched);
  if ((!is_press && !is_release) || widget == nullptr || widget->window() != this || widget != focus_or_self())
    return QMainWindow::eventFilter(watched, event);
  const auto* const key = static_cast<QKeyEvent*>(event);
  if (is_release) {
    if ((key->key() == Qt::Key_PageDown || key->key() == Qt::Key_PageUp) && !key->isAutoRepeat())
      practice_.hold_key(0, false);
    if ((key->key() == Qt::Key_Comma || key->key() == Qt::Key_Period) && !key->isAutoRepeat()) practice_.hold_turn(0);
    if (key->key() == Qt::Key_B && !key->isAutoRepeat()) practice_.press_plunger(false);
    return QMainWindow::eventFilter(watched, event);
  }
  const Qt::KeyboardModifiers modifiers = key->modifiers() & ~Qt::KeypadModifier;
  // While typing, a key means its letter.
  const bool is_typing =
      qobject_cast<QLineEdit*>(widget) != nullptr || qobject_cast<QAbstractSpinBox*>(widget) != nullptr;
  const bool is_letter = !key->text().isEmpty() && key->text().front().isPrint() &&
                         (modifiers & (Qt::ControlModifier | Qt::AltModifier)) == 0;
  if (is_typing && is_letter) return QMainWindow::eventFilter(watched, event);
  const bool is_function_key = key->key() >= Qt::Key_F1 && key->key() <= Qt::Key_F35;
  const bool is_plain = (modifiers & (Qt::ControlModifier | Qt::AltModifier)) == 0 && !is_function_key;
  if (is_plain && keeps_keys(widget)) return QMainWindow::eventFilter(watched, event);
  // A character that needs Shift ("?") stands for itself.
  const bool is_sign =
      key->key() < 0x80 && key->key() > Qt::Key_Space && !(key->key() >= Qt::Key_A && key->key() <= Qt::Key_Z);
  const int code = key->key() + static_cast<int>(is_sign ? modifiers & ~Qt::ShiftModifier : modifiers);
  return press(QKeySequence(code), true) || QMainWindow::eventFilter(watched, event);
}

QWidget* MainWindow::focus_or_self() {
  QWidget* const focus = focusWidget();
  return focus != nullptr ? focus : this;
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  const int code = event->key() + static_cast<int>(event->modifiers() & ~Qt::KeypadModifier);
  if (!press(QKeySequence(code), false)) QMainWindow::keyPressEvent(event);
}

}  // namespace bodkin::app
