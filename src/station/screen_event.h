#pragma once

namespace bodkin::station {

// The keys with a function; the others are `other`.
enum class ScreenKey {
  other,
  space,
  escape,
  question,
  up,
  down,
  left,
  right,
  page_up,
  page_down,
  a,
  c,
  d,
  e,
  f,
  g,
  h,
  i,
  j,
  k,
  l,
  m,
  n,
  o,
  q,
  r,
  s,
  t,
  u,
  w,
  x,
  zero,
  one,
  two,
  three,
  four,
  five,
  six,
  seven,
  eight
};

// A person's action in the window. Pixels, right and down.
struct ScreenEvent {
  enum class Kind { motion, button, leave, wheel, key, focus_lost, close };
  Kind kind = Kind::close;
  double x = 0.0, y = 0.0;  // motion, button: position of the pointer
  double steps = 0.0;       // wheel: forwards
  ScreenKey key = ScreenKey::other;
  bool down = false;    // key, button: pressed, not released
  bool shift = false;   // held
  bool button = false;  // motion: a mouse button is held
};

}  // namespace bodkin::station
