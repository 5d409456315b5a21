// Moving the body in the workspace of the device.
#include "app/practice.h"

namespace bodkin::app {

bool Practice::may_move_body() {
  if (patient_ == nullptr || !is_attempt(state())) return false;
  if (!maker_.is_touching()) return true;
  show_message("Draw the needle out of the body first, then move the body.");
  return false;
}

// The mouse has no workspace: it aims at the skin.
void Practice::send_body() {
  if (feed_ == nullptr) link_.move_body(mover_.now());
}

void Practice::begin_body_drag() {
  if (may_move_body()) mover_.begin_step();
}

void Practice::place_body(const BodyPlace& place) {
  if (!may_move_body()) return;
  mover_.place(place);
  send_body();
}

void Practice::undo_body() {
  if (!may_move_body()) return;
  if (!mover_.undo()) return show_message("The body is back where it was at first.");
  send_body();
}

void Practice::reset_body() {
  if (!may_move_body()) return;
  mover_.reset();
  send_body();
}

}  // namespace bodkin::app
