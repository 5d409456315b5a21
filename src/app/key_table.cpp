#include "app/key_table.h"

#include <QCoreApplication>
#include <array>

namespace bodkin::app {

namespace {

// Texts are marked for translation here and translated in text_of().
#define BODKIN_TEXT_OF(text) QT_TRANSLATE_NOOP("Keys", text)

constexpr std::array table = {
    KeyBinding{KeyScope::window, "F1", Command::show_keys, BODKIN_TEXT_OF("the keys of this screen"), true},
    KeyBinding{KeyScope::window, "?", Command::show_keys, BODKIN_TEXT_OF("the keys of this screen"), true},
    KeyBinding{KeyScope::window, "Esc", Command::back, BODKIN_TEXT_OF("back, or pause"), true},
    KeyBinding{KeyScope::window, "Ctrl+O", Command::open_patient, BODKIN_TEXT_OF("open a patient"), true},
    KeyBinding{KeyScope::window, "Ctrl+S", Command::save_picture, BODKIN_TEXT_OF("save a picture of the window"),
               true},
    KeyBinding{KeyScope::window, "F6", Command::next_view, BODKIN_TEXT_OF("next view"), true},
    KeyBinding{KeyScope::window, "Shift+F6", Command::previous_view, BODKIN_TEXT_OF("view before"), true},
    KeyBinding{KeyScope::window, "F11", Command::full_screen, BODKIN_TEXT_OF("full screen"), true},
    KeyBinding{KeyScope::window, "Ctrl+T", Command::toggle_theme, BODKIN_TEXT_OF("light or dark"), true},
    KeyBinding{KeyScope::window, "Ctrl+Q", Command::leave_program, BODKIN_TEXT_OF("leave Bodkin"), true},
    KeyBinding{KeyScope::start, "Return", Command::begin, BODKIN_TEXT_OF("start"), false},
    KeyBinding{KeyScope::start, "Enter", Command::begin, BODKIN_TEXT_OF("start"), false},
    KeyBinding{KeyScope::practise, "Space", Command::hold, BODKIN_TEXT_OF("hold the needle, take it up again"), true},
    KeyBinding{KeyScope::practise, "PgDown", Command::push_in, BODKIN_TEXT_OF("push in"), true},
    KeyBinding{KeyScope::practise, "PgUp", Command::draw_out, BODKIN_TEXT_OF("draw back"), true},
    KeyBinding{KeyScope::practise, "Shift+PgDown", Command::push_in_finely, BODKIN_TEXT_OF("push in slowly"), true},
    KeyBinding{KeyScope::practise, "Shift+PgUp", Command::draw_out_finely, BODKIN_TEXT_OF("draw back slowly"), true},
    KeyBinding{KeyScope::practise, "W", Command::withdraw, BODKIN_TEXT_OF("withdraw to above the skin"), true},
    KeyBinding{KeyScope::practise, "A", Command::again, BODKIN_TEXT_OF("save and try again"), true},
    KeyBinding{KeyScope::practise, "E", Command::end, BODKIN_TEXT_OF("end, and see how it went"), true},
    KeyBinding{KeyScope::practise, "V", Command::arm, BODKIN_TEXT_OF("arm again after a fault"), true},
    KeyBinding{KeyScope::practise, "F2", Command::show_numbers, BODKIN_TEXT_OF("numbers on, off"), false},
    KeyBinding{KeyScope::practise, "F3", Command::show_ladder, BODKIN_TEXT_OF("depth ladder on, off"), false},
    KeyBinding{KeyScope::practise, "F4", Command::show_dock, BODKIN_TEXT_OF("researchers' numbers on, off"), false},
    KeyBinding{KeyScope::practise, "U", Command::toggle_ultrasound, BODKIN_TEXT_OF("ultrasound on, off"), false},
    KeyBinding{KeyScope::practise, "Return", Command::fill, BODKIN_TEXT_OF("this view large, small"), false},
    KeyBinding{KeyScope::view3d, "0", Command::of_the_view, BODKIN_TEXT_OF("the view of the procedure"), false},
    KeyBinding{KeyScope::view3d, "1", Command::of_the_view, BODKIN_TEXT_OF("from behind"), false},
    KeyBinding{KeyScope::view3d, "2", Command::of_the_view, BODKIN_TEXT_OF("from the front"), false},
    KeyBinding{KeyScope::view3d, "3", Command::of_the_view, BODKIN_TEXT_OF("from the left"), false},
    KeyBinding{KeyScope::view3d, "4", Command::of_the_view, BODKIN_TEXT_OF("from the right"), false},
    KeyBinding{KeyScope::view3d, "5", Command::of_the_view, BODKIN_TEXT_OF("from the head"), false},
    KeyBinding{KeyScope::view3d, "6", Command::of_the_view, BODKIN_TEXT_OF("from the feet"), false},
    KeyBinding{KeyScope::view3d, "P", Command::of_the_view, BODKIN_TEXT_OF("skin, cut-away, bones, see-through"),
               false},
    KeyBinding{KeyScope::view3d, "Left", Command::of_the_view, BODKIN_TEXT_OF("turn"), false},
    KeyBinding{KeyScope::view3d, "Right", Command::of_the_view, BODKIN_TEXT_OF("turn"), false},
    KeyBinding{KeyScope::view3d, "Up", Command::of_the_view, BODKIN_TEXT_OF("turn"), false},
    KeyBinding{KeyScope::view3d, "Down", Command::of_the_view, BODKIN_TEXT_OF("turn"), false},
    KeyBinding{KeyScope::view3d, "+", Command::of_the_view, BODKIN_TEXT_OF("nearer"), false},
    KeyBinding{KeyScope::view3d, "-", Command::of_the_view, BODKIN_TEXT_OF("farther"), false},
    KeyBinding{KeyScope::view3d, "Y", Command::of_the_view,
               BODKIN_TEXT_OF("stereo: off, side by side, coloured glasses"), false},
    KeyBinding{KeyScope::slice, "Up", Command::of_the_view, BODKIN_TEXT_OF("next slice"), false},
    KeyBinding{KeyScope::slice, "Down", Command::of_the_view, BODKIN_TEXT_OF("slice before"), false},
    KeyBinding{KeyScope::slice, "[", Command::of_the_view, BODKIN_TEXT_OF("window before"), false},
    KeyBinding{KeyScope::slice, "]", Command::of_the_view, BODKIN_TEXT_OF("next window"), false},
    KeyBinding{KeyScope::slice, "M", Command::of_the_view, BODKIN_TEXT_OF("measure a distance"), false},
    KeyBinding{KeyScope::slice, "Q", Command::of_the_view, BODKIN_TEXT_OF("measure an angle"), false},
    KeyBinding{KeyScope::slice, "X", Command::of_the_view, BODKIN_TEXT_OF("delete the measure under the pointer"),
               false},
    KeyBinding{KeyScope::slice, "C", Command::of_the_view, BODKIN_TEXT_OF("run through the slices"), false},
    KeyBinding{KeyScope::slice, "F", Command::of_the_view, BODKIN_TEXT_OF("follow the tip, or stay"), false},
    KeyBinding{KeyScope::slice, "T", Command::of_the_view, BODKIN_TEXT_OF("thickness of the slab"), false},
};

constexpr std::array window_chain = {KeyScope::window};
constexpr std::array start_chain = {KeyScope::start, KeyScope::window};
constexpr std::array practise_chain = {KeyScope::practise, KeyScope::window};
constexpr std::array view3d_chain = {KeyScope::view3d, KeyScope::practise, KeyScope::window};
constexpr std::array slice_chain = {KeyScope::slice, KeyScope::practise, KeyScope::window};
constexpr std::array chart_chain = {KeyScope::chart, KeyScope::practise, KeyScope::window};

const KeyBinding* find(KeyScope scope, const QKeySequence& keys) {
  for (const KeyBinding& binding : table) {
    if (binding.scope == scope && keys.matches(QKeySequence(QLatin1String(binding.keys))) == QKeySequence::ExactMatch)
      return &binding;
  }
  return nullptr;
}

}  // namespace

std::span<const KeyBinding> key_table() noexcept {
  return table;
}

std::span<const KeyScope> chain_of(KeyScope scope) noexcept {
  switch (scope) {
    case KeyScope::start:
      return start_chain;
    case KeyScope::practise:
      return practise_chain;
    case KeyScope::view3d:
      return view3d_chain;
    case KeyScope::slice:
      return slice_chain;
    case KeyScope::chart:
      return chart_chain;
    case KeyScope::window:
      break;
  }
  return window_chain;
}

std::optional<Command> command_of(KeyScope scope, const QKeySequence& keys) {
  const KeyBinding* const binding = find(scope, keys);
  if (binding == nullptr) return std::nullopt;
  return binding->command;
}

std::optional<Command> reserved_command(KeyScope page, const QKeySequence& keys) {
  for (const KeyScope scope : {page, KeyScope::window}) {
    if (const KeyBinding* const binding = find(scope, keys); binding != nullptr && binding->reserved)
      return binding->command;
  }
  return std::nullopt;
}

QString text_of(const KeyBinding& binding) {
  return QCoreApplication::translate("Keys", binding.text);
}

QString name_of(KeyScope scope) {
  switch (scope) {
    case KeyScope::window:
      return QCoreApplication::translate("Keys", "Everywhere");
    case KeyScope::start:
      return QCoreApplication::translate("Keys", "Start");
    case KeyScope::practise:
      return QCoreApplication::translate("Keys", "Needle");
    case KeyScope::view3d:
      return QCoreApplication::translate("Keys", "Patient in 3-D");
    case KeyScope::slice:
      return QCoreApplication::translate("Keys", "Slices");
    case KeyScope::chart:
      return QCoreApplication::translate("Keys", "Chart");
  }
  return {};
}

}  // namespace bodkin::app
