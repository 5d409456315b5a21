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
#include "simulation/body_port.h"

namespace bodkin::simulation {

// The resistance of a deformable body in one of several corridors, each a region of the body with its own Model: the
// corridor that the patient came with, and more that are added while the needle moves.
//
// A needle that begins takes the corridor about the nearest line, and keeps it until the next begin, so that no force
// jumps; an event says when it is another one than before. Punctures carry over from corridor to corridor.
//
// The first corridor can be refreshed: replaced by one about another state of the body, which a probe presses, or
// about another line. The newest one is taken where a needle begins or, if Model can be transferred, by an inserted
// needle with the forces that it has (EmbeddedNeedle::follow).
//
// Model is made from (const Case&, const PreparedCorridor&, const Settings&, double dt). It has begin(), step(),
// reset(), take_punctures(other), node_forces() and ahead(), and may have holds(), begin_to_follow(other) and
// follow(other), which transfer it.
template <typename Model>
class Corridors final : public BodyPort {
 public:
  using Settings = typename Model::Settings;
  static constexpr forces::ResistanceTraits traits = Model::traits;

  // `patient` must outlive this and have a corridor.
  Corridors(const anatomy::Case& patient, const Settings& settings, double dt)
      : patient_(&patient), settings_(settings), dt_(dt), shelf_(std::make_unique<Shelf>()) {
    Corridors::add_corridor(patient.corridor);
    taken_ = &shelf_->places[0];
  }

  bool add_corridor(const anatomy::PreparedCorridor& corridor) override {
    const std::size_t at = shelf_->count.load(std::memory_order_relaxed);
    if (at == most_corridors) return false;
    shelf_->places[at] = {.model = std::make_unique<Model>(*patient_, corridor, settings_, dt_),
                          .path = corridor.path,
                          .aimed_at = corridor.aimed_at ? static_cast<double>(*corridor.aimed_at) : -1.0};
    shelf_->count.store(at + 1, std::memory_order_release);
    return true;
  }

  // A corridor that no needle has taken yet is dropped. A model that cannot be transferred cannot use any.
  bool refresh_corridor(const anatomy::PreparedCorridor& corridor) override {
    if constexpr (!transfers) return false;
    auto place = std::make_unique<Place>();
    place->model = std::make_unique<Model>(*patient_, corridor, settings_, dt_);
    place->path = corridor.path;
    place->state = corridor.state;
    shelf_->refreshed.offer(std::move(place));
    return true;
  }
  // Until reset().
  void stay_at_rest() noexcept override { at_rest_ = true; }
  fem::NodeForces node_forces() const noexcept override {
    return touches_ ? model().node_forces() : fem::NodeForces{};
  }
  Vec3 needle_ahead() const noexcept override { return touches_ ? model().ahead() : Vec3(Vec3::Zero()); }

  void begin(const Vec3& entry, const Vec3& direction) noexcept {
    std::unique_ptr<Place> left;  // destroyed by the thread that makes corridors
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
      announced_ = false;
    }
    give_back(std::move(left));
    taken_->model->begin(entry, direction);
  }

  forces::ResistanceForce step(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept {
    if (!announced_) {
      const bool at_rest = taken_->state == 0;
      events.push({at_rest ? forces::EventKind::corridor_taken : forces::EventKind::corridor_refreshed, needle.tissue,
                   needle.motion.depth, at_rest ? taken_->aimed_at : static_cast<double>(taken_->state)});
      announced_ = true;
    }
    forces::ResistanceForce force = model().step(needle, events);
    touches_ = force.in_contact;
    if constexpr (transfers) transfer_to_newest();
    return force;
  }

  void reset() noexcept {
    const std::size_t count = shelf_->count.load(std::memory_order_acquire);
    for (std::size_t i = 0; i < count; ++i) shelf_->places[i].model->reset();
    give_back(std::move(refreshed_));
    give_back(std::move(coming_));
    follows_ = touches_ = false;
    taken_ = &shelf_->places[0];
    at_rest_ = false;
    announced_ = true;
  }

  double firm_stiffness() const noexcept { return 0.0; }
  double stiffness_scale() const noexcept { return model().stiffness_scale(); }
  forces::ModelDiagnostics diagnostics() const noexcept { return model().diagnostics(); }

  // In the corridor that the needle is in, or was in last.
  Model& model() noexcept { return *taken_->model; }
  const Model& model() const noexcept { return *taken_->model; }

 private:
  // Whether a needle that is in can be transferred to another corridor.
  static constexpr bool transfers = requires(Model & one, const Model& other) { one.begin_to_follow(other); };

  struct Place {
    std::unique_ptr<Model> model;
    anatomy::NeedlePath path;
    double aimed_at = -1.0;   // tick; -1: the patient came with it
    std::uint32_t state = 0;  // of the body; 0: at rest
  };
  struct Shelf {
    std::array<Place, most_corridors> places;
    std::atomic<std::size_t> count{0};  // of places that are complete
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

  // Transfers a needle that is in the first corridor, or in a refreshed one, to the newest, one node a tick.
  void transfer_to_newest() noexcept {
    if (at_rest_ || (taken_ != refreshed_.get() && taken_ != &shelf_->places[0])) return;
    if (!follows_) {
      if (model().holds() && take_newest()) follows_ = coming_->model->begin_to_follow(model());
      return;
    }
    const fem::FollowState state = coming_->model->follow(model());
    follows_ = state == fem::FollowState::under_way;
    if (state != fem::FollowState::done) return;
    std::unique_ptr<Place> left = std::move(refreshed_);
    refreshed_ = std::move(coming_);
    taken_ = refreshed_.get();
    announced_ = false;
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
      const anatomy::NeedlePath& path = shelf_->places[i].path;
      const double away = distance(path.entry, entry, direction) + distance(path.target, entry, direction);
      if (i > 0 && away >= least) continue;
      least = away;
      nearest = i;
    }
    return nearest;
  }

  const anatomy::Case* patient_;
  Settings settings_;
  double dt_;
  std::unique_ptr<Shelf> shelf_;
  std::unique_ptr<Place> refreshed_;  // the newest that a needle was in
  std::unique_ptr<Place> coming_;     // a newer one
  bool follows_ = false;              // the needle is being transferred to `coming_`
  Place* taken_ = nullptr;            // by the needle
  bool at_rest_ = false;
  bool touches_ = false;  // as of the last step
  bool announced_ = true;
};

}  // namespace bodkin::simulation
