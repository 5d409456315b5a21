#include "app/models/body_place.h"

#include "station/hand_session.h"

namespace bodkin::app {

BodyPlace usual_place(const anatomy::NeedlePath& path) {
  const haptics::WorkspaceSettings workspace = station::workspace_about(path);
  return {workspace.centre, workspace.rotation};
}

void BodyMover::begin(const BodyPlace& usual) {
  usual_ = now_ = usual;
  before_.clear();
}

void BodyMover::begin_step() {
  if (before_.empty() || !(before_.back() == now_)) before_.push_back(now_);
}

bool BodyMover::undo() {
  while (!before_.empty() && before_.back() == now_) before_.pop_back();  // taken, but not moved
  if (before_.empty()) return false;
  now_ = before_.back();
  before_.pop_back();
  return true;
}

void BodyMover::reset() {
  begin_step();
  now_ = usual_;
}

}  // namespace bodkin::app
