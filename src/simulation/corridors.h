#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "anatomy/case.h"
#include "core/hand_over.h"
#include "fem/embedded_needle.h"
#include "forces/events.h"
#include "forces/resistance_model.h"

namespace bodkin {

// A resistance of a deformable body with the corridors that were prepared for it so far: the one that the patient
// came with, and more that are added while the needle moves. Each has a Model of its own, made where it is added; the
// tick takes another one only where a needle begins, outside the body, so that no force jumps. Of those that are
// there it takes the one that was prepared about the nearest line, and says so where it is another than before.
// Tissue that gave way in one has given way in the others.
//
// In place of the first corridor there can be one about another state of the body, pressed by a probe, or about
// another line in it, of which the newest is taken: where a needle begins or, by a Model that can follow another one,
// while it is in, with the forces that it has (EmbeddedNeedle::follow).
//
// Model is made from (const Case&, const PreparedCorridor&, const Settings&, double dt), and can begin(), step(),
// reset() and take_punctures(other); it may be able to holds(), begin_to_follow(other) and follow(other).
template <typename Model>
class Corridors {
 public:
  using Settings = typename Model::Settings;
  static constexpr ResistanceTraits traits = Model::traits;
  // There can be one about another state of the body.
  static constexpr bool is_refreshable = requires(Model & one, const Model& other) { one.begin_to_follow(other); };

  static constexpr std::size_t most = 8;

  // `patient` must outlive this and have a corridor.
  Corridors(const Case& patient, const Settings& settings, double dt)
      : patient_(&patient), settings_(settings), dt_(dt), shelf_(std::make_unique<Shelf>()) {
    add(patient.corridor);
    taken_ = &shelf_->places[0];
  }

  // Not for two threads at once, but beside the tick. False: there are as many as can be.
  bool add(const PreparedCorridor& corridor) {
    const std::size_t at = shelf_->count.load(std::memory_order_relaxed);
    if (at == most) return false;
    shelf_->places[at] = {.model = std::make_unique<Model>(*patient_, corridor, settings_, dt_),
                          .path = corridor.path,
                          .aimed_at = corridor.aimed_at ? static_cast<double>(*corridor.aimed_at) : -1.0};
    shelf_->count.store(at + 1, std::memory_order_release);
    return true;
  }

  // As add(), from the same thread: the first corridor about the newest state of the body. One that no needle has
  // taken yet is dropped.
  void refresh(const PreparedCorridor& corridor) {
    auto place = std::make_unique<Place>();
    place->model = std::make_unique<Model>(*patient_, corridor, settings_, dt_);
    place->path = corridor.path;
    place->state = corridor.state;
    shelf_->refreshed.offer(std::move(place));
  }
  // The tick only: needles that begin from now on find the first corridor at rest again, until reset().
  void stay_at_rest() noexcept { at_rest_ = true; }

  void begin(const Vec3& entry, const Vec3& direction) noexcept {
    std::unique_ptr<Place> left;  // is not destroyed here: the maker of corridors does that
    const std::size_t at = nearest_to(entry, direction);
    follows_ = false;
    if (at == 0 && !at_rest_) {
      take_newest();
      if (coming_ != nullptr) {
        left = std::move(refreshed_);
        refreshed_ = std::move(coming_);
      }
    }
    Place* const before = taken_;
    taken_ = at == 0 && !at_rest_ && refreshed_ != nullptr ? refreshed_.get() : &shelf_->places[at];
    if (taken_ != before) {
      taken_->model->take_punctures(*before->model);
      told_ = false;
    }
    give_back(std::move(left));
    taken_->model->begin(entry, direction);
  }

  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept {
    if (!told_) {
      const bool at_rest = taken_->state == 0;
      events.push({at_rest ? EventKind::corridor_taken : EventKind::corridor_refreshed, needle.tissue,
                   needle.motion.depth, at_rest ? taken_->aimed_at : static_cast<double>(taken_->state)});
      told_ = true;
    }
    ResistanceForce force = model().step(needle, events);
    if constexpr (is_refreshable) go_on_in_newest();
    return force;
  }

  void reset() noexcept {
    const std::size_t count = shelf_->count.load(std::memory_order_acquire);
    for (std::size_t i = 0; i < count; ++i) shelf_->places[i].model->reset();
    give_back(std::move(refreshed_));
    give_back(std::move(coming_));
    follows_ = false;
    taken_ = &shelf_->places[0];
    at_rest_ = false;
    told_ = true;
  }

  double firm_stiffness() const noexcept { return 0.0; }
  double stiffness_scale() const noexcept { return model().stiffness_scale(); }
  ModelDiagnostics diagnostics() const noexcept { return model().diagnostics(); }

  // The one that the needle took last.
  Model& model() noexcept { return *taken_->model; }
  const Model& model() const noexcept { return *taken_->model; }

 private:
  struct Place {
    std::unique_ptr<Model> model;
    NeedlePath path;
    double aimed_at = -1.0;   // tick, -1: the patient came with it
    std::uint32_t state = 0;  // of the body, 0: at rest
  };
  struct Shelf {
    std::array<Place, most> places;
    std::atomic<std::size_t> count{0};  // of places that the tick may look at
    HandOver<Place> refreshed;          // on its way to the tick
  };

  void give_back(std::unique_ptr<Place> left) noexcept {
    if (left != nullptr) shelf_->refreshed.give_back(std::move(left));
  }

  bool take_newest() noexcept {
    std::unique_ptr<Place> newest = shelf_->refreshed.take();
    if (newest == nullptr) return false;
    give_back(std::move(coming_));
    coming_ = std::move(newest);
    return true;
  }

  // A needle that is in, in the first corridor, whatever state of the body that is of.
  void go_on_in_newest() noexcept {
    if (at_rest_ || (taken_ != refreshed_.get() && taken_ != &shelf_->places[0])) return;
    if (!follows_) {
      if (model().holds() && take_newest()) follows_ = coming_->model->begin_to_follow(model());
      return;
    }
    const FollowState state = coming_->model->follow(model());
    follows_ = state == FollowState::under_way;
    if (state != FollowState::done) return;
    std::unique_ptr<Place> left = std::move(refreshed_);
    refreshed_ = std::move(coming_);
    taken_ = refreshed_.get();
    told_ = false;
    give_back(std::move(left));
  }

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
  std::unique_ptr<Place> refreshed_;  // the newest of those that a needle was in
  std::unique_ptr<Place> coming_;     // a newer one
  bool follows_ = false;              // the needle is on its way into it
  Place* taken_ = nullptr;            // by the needle
  bool at_rest_ = false;
  bool told_ = true;
};

}  // namespace bodkin
