#include "station/body_glide.h"

namespace bodkin::station {

bool BodyGlide::touches(const HandSnapshot& needle) {
  return needle.output.in_contact && needle.output.depth > 0.0;
}

void BodyGlide::send(const Vec3& middle, const Mat3& rotation, haptics::ServoTick& servo) {
  haptics::ServoCommand command;
  command.kind = haptics::ServoCommand::Kind::move_body;
  command.middle = middle;
  command.rotation = rotation;
  servo.command(command);
  place_->move_body(middle, rotation);
}

void BodyGlide::request(const Vec3& middle, const Mat3& rotation, double time, haptics::ServoTick& servo,
                        const haptics::WorkspaceSettings& begin) {
  if (!place_) place_.emplace(begin);
  time_ = time;
  send(middle, rotation, servo);
}

void BodyGlide::follow(const HandSnapshot& needle, double time, haptics::ServoTick& servo) {
  if (!place_ || !place_->is_body_moving()) return;
  place_->step(Pose::Identity(), time - time_);
  time_ = time;
  if (!place_->is_body_moving() || !touches(needle)) return;
  const haptics::WorkspaceSettings here = place_->settings();
  send(here.centre, here.rotation, servo);
}

}  // namespace bodkin::station
