#pragma once

#include <QKeySequence>
#include <QString>
#include <cstdint>
#include <optional>
#include <span>

namespace bodkin::app {

// Everything that a key, a button, a script or a test can request from the window.
enum class Command : std::uint8_t {
  show_keys,
  back,  // closes the open card, or pauses
  open_patient,
  save_picture,
  full_screen,
  toggle_theme,
  leave_program,
  show_palette,
  toggle_sound,
  tour,
  next_view,
  previous_view,
  begin,  // on the start page
  hold,
  push_in,
  draw_out,
  push_in_finely,
  draw_out_finely,
  turn_back,  // about its axis, while the key is held
  turn_clockwise,
  withdraw,
  leave_needle,
  take_out_needle,
  press_plunger,  // while the key is held
  turn_finger,
  turn_stylet,
  turn_manometer,
  turn_breath,
  again,
  end,
  arm,
  move_body,
  undo_body,
  reset_body,
  show_numbers,
  show_ladder,
  show_dock,
  toggle_ultrasound,
  toggle_volume,
  fill,
  of_the_view,  // executed by the view with the focus
  of_the_page   // executed by the shown page
};

// The order of looking up a key: in the view with the focus, then on the page, then in the window.
enum class KeyScope : std::uint8_t {
  window,
  start,
  practise,
  view3d,
  slice,
  chart,
  plan,
  scan,
  review,
  models,
  devices,
  atlas,
  volume,
  ultrasound,
  segment,
  training,
  camera
};

struct KeyBinding {
  KeyScope scope;
  const char* keys;  // as QKeySequence reads it, "Ctrl+O"
  Command command;
  const char* text;  // its effect, English, for tr()
  bool reserved;     // no view may use it
};

std::span<const KeyBinding> key_table() noexcept;

// The scopes in which a key is looked up, in this order, when `scope` has the focus.
std::span<const KeyScope> chain_of(KeyScope scope) noexcept;

// The command of a key in one scope; empty if it has none.
std::optional<Command> command_of(KeyScope scope, const QKeySequence& keys);
// Reserved keys of the window and of `page`: they are looked up before any view sees them.
std::optional<Command> reserved_command(KeyScope page, const QKeySequence& keys);

// The texts of the table in the language of the window.
QString text_of(const KeyBinding& binding);
QString name_of(KeyScope scope);

}  // namespace bodkin::app
