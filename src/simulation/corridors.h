#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>

#include "anatomy/case.h"
#include "forces/events.h"
#include "simulation/resistance.h"

namespace bodkin {

// A resistance of a deformable body with the corridors that were prepared for it so far: the one that the patient
// came with, and more that are added while the needle moves. Each has a Model of its own, made where it is added; the
// tick takes another one only where a needle begins, outside the body, so that no force jumps. Of those that are
// there it takes the one that was prepared about the nearest line, and says so where it is another than before.
// Tissue that gave way in one has given way in the others.
//
// Model is made from (const Case&, const PreparedCorridor&, const Settings&, double dt), and can begin(), step(),
// reset() and take_punctures(other).
template <typename Model, typename Settings>
class Corridors {
 public:
  static constexpr std::size_t most = 8;

  // `patient` must outlive this and have a corridor.
  Corridors(const Case& patient, const Settings& settings, double dt)
      : patient_(&patient), settings_(settings), dt_(dt), shelf_(std::make_unique<Shelf>()) {
    add(patient.corridor);
  }

  // Not for two threads at once, but beside the tick. False: there are as many as can be.
  bool add(const PreparedCorridor& corridor) {
    const std::size_t at = shelf_->count.load(std::memory_order_relaxed);
    if (at == most) return false;
    shelf_->places[at] = {std::make_unique<Model>(*patient_, corridor, settings_, dt_), corridor.path,
                          corridor.aimed_at ? static_cast<double>(*corridor.aimed_at) : -1.0};
    shelf_->count.store(at + 1, std::memory_order_release);
    return true;
  }

  void begin(const Vec3& entry, const Vec3& direction) noexcept {
    const std::size_t before = taken_;
    taken_ = nearest_to(entry, direction);
    if (taken_ != before) {
      model().take_punctures(*shelf_->places[before].model);
      told_ = false;
    }
    model().begin(entry, direction);
  }

  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept {
    if (!told_) {
      events.push({EventKind::corridor_taken, needle.tissue, needle.motion.depth, shelf_->places[taken_].aimed_at});
      told_ = true;
    }
    return model().step(needle, events);
  }

  void reset() noexcept {
    const std::size_t count = shelf_->count.load(std::memory_order_acquire);
    for (std::size_t i = 0; i < count; ++i) shelf_->places[i].model->reset();
    taken_ = 0;
    told_ = true;
  }

  // The one that the needle took last.
  Model& model() noexcept { return *shelf_->places[taken_].model; }
  const Model& model() const noexcept { return *shelf_->places[taken_].model; }

 private:
  struct Place {
    std::unique_ptr<Model> model;
    NeedlePath path;
    double aimed_at = -1.0;  // tick, -1: the patient came with it
  };
  struct Shelf {
    std::array<Place, most> places;
    std::atomic<std::size_t> count{0};  // of places that the tick may look at
  };

  static double distance(const Vec3& point, const Vec3& entry, const Vec3& direction) noexcept {
    const Vec3 from = point - entry;
    return (from - from.dot(direction) * direction).norm();
  }

  std::size_t nearest_to(const Vec3& entry, const Vec3& direction) const noexcept {
    const std::size_t count = shelf_->count.load(std::memory_order_acquire);
    std::size_t nearest = 0;
    double least = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const NeedlePath& path = shelf_->places[i].path;
      const double away = distance(path.entry, entry, direction) + distance(path.target, entry, direction);
      if (i > 0 && away >= least) continue;
      least = away;
      nearest = i;
    }
    return nearest;
  }

  const Case* patient_;
  Settings settings_;
  double dt_;
  std::unique_ptr<Shelf> shelf_;
  std::size_t taken_ = 0;
  bool told_ = true;
};

}  // namespace bodkin
