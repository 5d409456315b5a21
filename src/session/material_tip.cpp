#include "session/material_tip.h"

namespace bodkin::session {

MaterialTip::MaterialTip(const std::optional<anatomy::Breathing>& breathing, double dt) {
  if (!breathing) return;
  clock_.emplace(*breathing, dt);
  field_.emplace(*breathing);
}

Vec3 MaterialTip::place_of(const simulation::TickRecord& record) {
  Vec3 tip = record.input.needle.translation();
  if (!clock_) return tip;
  for (; next_ <= record.tick; ++next_) clock_->step(record.input.other.breath_held);
  return field_->material(tip, clock_->drawn_in());
}

}  // namespace bodkin::session
