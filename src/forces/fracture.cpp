#include "forces/fracture.h"

#include <algorithm>

#include "forces/device_stability.h"
#include "forces/model_input.h"
#include "forces/needle_law.h"

namespace bodkin::forces {

Fracture::Fracture(const anatomy::FractureSettings& settings)
    : settings_(settings),
      membrane_(VoigtSum::cubic, settings.stiffness, 0.0, settings.spacing),
      edge_(settings.cutting_toughness * settings.width, settings.cutting_stiffness) {
  check(settings, "fracture");
}

void Fracture::begin(const Vec3& entry, const Vec3& direction) noexcept {
  channels_.enter(entry, direction);
  inside_ = false;
}

void Fracture::reset() noexcept {
  channels_.clear();
  inside_ = false;
}

double Fracture::stiffness_at_rupture() const noexcept {
  const double needed = settings_.toughness * settings_.width * settings_.thickness;
  double low = 0.0, high = settings_.spacing;
  while (stored_energy(settings_.stiffness, settings_.spacing, high) < needed) high *= 2.0;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (stored_energy(settings_.stiffness, settings_.spacing, middle) < needed ? low : high) = middle;
  }
  return membrane_.tangent(high);
}

double Fracture::step(const AxialMotion& motion, anatomy::TissueId tissue, TickEvents& events) noexcept {
  const double x = motion.depth;
  stored_ = 0.0;
  if (!usable(motion)) {
    events.push({EventKind::fault, tissue, edge_.wall(), 0.0});
    return 0.0;
  }
  if (x <= 0.0) {
    if (inside_) events.push({EventKind::withdrawn, tissue, x, 0.0});
    inside_ = false;
    return 0.0;
  }
  if (!inside_) {
    events.push({EventKind::contact, tissue, x, 0.0});
    inside_ = true;
    torn_ = channels_.deepest() > 0.0;
    edge_.start(channels_.deepest());
  }
  if (!torn_) {
    const double force = membrane_.elastic(x);
    stored_ = stored_energy(settings_.stiffness, settings_.spacing, x);
    if (stored_ < settings_.toughness * settings_.width * settings_.thickness) {
      return std::min(force, settings_.limit);
    }
    stored_ = 0.0;
    torn_ = true;
    events.push({EventKind::puncture, tissue, x, force});
    edge_.start(x - std::min(edge_.reach(), force / settings_.cutting_stiffness));  // never more than before
  }
  const double force = edge_.step(x);
  channels_.deepen(edge_.wall());
  return std::min(force, settings_.limit);
}

Fracture::Fracture(const anatomy::Case& patient, const anatomy::FractureSettings& settings, double)
    : Fracture(felt_settings(settings, patient)) {
  const anatomy::DeviceLimits& device = patient.description.device;
  is_skin_ = patient.description.haptics.mechanics == anatomy::Mechanics::physical;
  require_stable("fracture", "cutting stiffness", settings_.cutting_stiffness, device);
  require_stable("fracture", "the stiffness at which the membrane tears", stiffness_at_rupture(), device);
}

ResistanceForce Fracture::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  const double force = step(needle.motion, is_skin_ ? anatomy::tissue::skin : needle.tissue, events);
  return {.along = force, .material = torn_ ? edge_.wall() : 0.0, .in_contact = needle.motion.depth > 0.0};
}

template <>
ResistanceEntry resistance_with<anatomy::FractureSettings>() {
  return entry_of<Fracture>();
}

}  // namespace bodkin::forces
