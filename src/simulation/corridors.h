#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "anatomy/case.h"
#include "core/hand_over.h"
#include "fem/contact_line.h"
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
// A needle that begins farther than 1.5 mm from the line of every corridor of contact points has its own line, once
// stream_points() was called: it takes the line's points as they become known there, those of its holes open. They
// are asked for while the needle is outside, up to 50 mm from the skin, and again where it turns to another line; a
// needle that touches the skin farther than 1.5 mm from that line asks for those of the line on which it does.
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
  std::shared_ptr<fem::ContactLine> stream_points(bool as_recorded) override {
    if constexpr (streams) {
      const Model& first = *shelf_->places[0].model;
      if (!first.has_contact_points()) return {};
      line_ = std::make_shared<fem::ContactLine>(first.spring());
      own_.model = std::make_unique<Model>(first, *patient_, *line_, settings_, dt_);
      own_.aimed_at = own_line;
      as_recorded_ = as_recorded;
    }
    return line_;
  }
  void approach(const Vec3& tip, const Vec3& axis) noexcept override {
    if (line_ == nullptr || ticks_outside_++ % ticks_from_look_to_look != 0) return;
    const std::optional<Vec3> entry = skin_ahead(tip, axis);
    if (!entry || runs_along(shelf_->places[0].path, *entry, axis, same_line)) return;
    if (!asked_ || !runs_along(*asked_, *entry, axis, same_aim)) ask(*entry, axis);
  }
  void take_points(double recorded) noexcept override { recorded_ = recorded; }
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
    if (begin_own_line(at, entry, direction)) return;
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
      // The points of an own line may be others by now; what was punctured there is among the holes.
      if (before != &own_) taken_->model->take_punctures(*before->model);
      announced_ = false;
    }
    give_back(std::move(left));
    taken_->model->begin(entry, direction);
    if (has_own_line_) open_holes();
  }

  forces::ResistanceForce step(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept {
    if (!announced_) {
      const bool at_rest = taken_->state == 0;
      events.push({at_rest ? forces::EventKind::corridor_taken : forces::EventKind::corridor_refreshed, needle.tissue,
                   needle.motion.depth, at_rest ? taken_->aimed_at : static_cast<double>(taken_->state)});
      announced_ = true;
    }
    if (taken_ == &own_) take_known_points(needle, events);
    forces::ResistanceForce force = model().step(needle, events);
    touches_ = force.in_contact;
    remember_hole();
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
    hole_count_ = 0;
    has_own_line_ = false;
    asked_.reset();
    ticks_outside_ = 0;
    if (own_.model) own_.model->reset();
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

  // Whether a needle can meet points of its own line.
  static constexpr bool streams = requires(Model & one) { one.begin_growing(Vec3(), Vec3(), false); };
  static constexpr double same_line = 1.5;       // mm, between a prepared line and the needle's
  static constexpr double same_aim = 1.0;        // mm, between the line asked for and that of a needle outside
  static constexpr double farthest_skin = 50.0;  // mm before the tip
  static constexpr double skin_step = 0.5;       // mm
  static constexpr int bisections = 10;
  static constexpr double same_hole = 1.0;  // mm
  static constexpr double late = 1.0;       // mm past a point's place, at which it comes late
  static constexpr std::uint32_t ticks_from_look_to_look = 10;
  static constexpr std::size_t most_holes = 128;

  struct Hole {
    Vec3 place = Vec3::Zero();
    anatomy::TissueId tissue = anatomy::tissue::air;
  };

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

  // Takes the needle's own line where the prepared one is too far from it.
  bool begin_own_line(std::size_t nearest, const Vec3& entry, const Vec3& direction) noexcept {
    if constexpr (streams) {
      if (line_ == nullptr) return false;
      if (runs_along(shelf_->places[nearest].path, entry, direction, same_line)) return false;
      if (taken_ != &own_) announced_ = false;
      taken_ = &own_;
      points_ = 0;
      complete_ = false;
      has_own_line_ = begins_ = true;
      if (!asked_ || !runs_along(*asked_, entry, direction, same_line)) ask(entry, direction);
      own_.model->begin_growing(entry, direction, is_hole(entry));
      return true;
    }
    return false;
  }

  // Those that are there, or that were in the recording.
  void take_known_points(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept {
    if constexpr (streams) {
      fem::ContactLine::Progress now{points_, complete_};
      if (!as_recorded_) {
        now = line_->progress();
      } else if (recorded_) {
        now.complete = *recorded_ < 0.0;
        const double count = now.complete ? -1.0 - *recorded_ : *recorded_;
        now.points = count > 0.0 && count <= fem::ContactLine::most_points ? static_cast<std::size_t>(count) : 0;
        line_->wait_for(now.points);
      }
      recorded_.reset();
      if (now.points != points_ || now.complete != complete_) {
        const std::size_t before = points_;
        points_ = now.points;
        complete_ = now.complete;
        own_.model->extend(points_, complete_);
        open_holes();
        const double past = needle.motion.depth - own_.model->point_depth(before);
        if (before > 0 && points_ > before && past > late) tell_late(past, needle, events);
        const auto count = static_cast<double>(points_);
        events.push(
            {forces::EventKind::points_taken, needle.tissue, needle.motion.depth, complete_ ? -1.0 - count : count});
      }
      // The needle touches a surface that is not there yet.
      if (std::exchange(begins_, false) && points_ == 0 && !complete_) tell_late(needle.motion.depth, needle, events);
    }
  }

  static void tell_late(double past, const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept {
    events.push({forces::EventKind::points_late, needle.tissue, needle.motion.depth, past});
  }

  void ask(const Vec3& entry, const Vec3& direction) noexcept {
    asked_ = anatomy::NeedlePath{entry, entry + shelf_->places[0].path.length() * direction};
    line_->ask(entry, direction);
  }

  // Where a needle outside the body would meet the skin.
  std::optional<Vec3> skin_ahead(const Vec3& tip, const Vec3& axis) const noexcept {
    const auto is_air = [this](const Vec3& place) {
      return anatomy::nearest<anatomy::TissueId>(patient_->tissues, place, anatomy::tissue::air) ==
             anatomy::tissue::air;
    };
    if (!is_air(tip)) return {};
    double inside = skin_step;
    while (inside <= farthest_skin && is_air(tip + inside * axis)) inside += skin_step;
    if (inside > farthest_skin) return {};
    double outside = inside - skin_step;
    for (int step = 0; step < bisections; ++step) {
      const double middle = 0.5 * (outside + inside);
      (is_air(tip + middle * axis) ? outside : inside) = middle;
    }
    return tip + inside * axis;
  }

  bool is_hole(const Vec3& place) const noexcept {
    for (std::size_t i = 0; i < hole_count_; ++i)
      if ((holes_[i].place - place).squaredNorm() < same_hole * same_hole) return true;
    return false;
  }

  void remember_hole() noexcept {
    if constexpr (streams) {
      const auto& found = model().puncture();
      if (found && hole_count_ < most_holes) holes_[hole_count_++] = {found->place, found->tissue};
    }
  }

  void open_holes() noexcept {
    if constexpr (streams) {
      for (std::size_t i = 0; i < hole_count_; ++i) model().open(holes_[i].place, holes_[i].tissue);
    }
  }

  static double distance(const Vec3& point, const Vec3& entry, const Vec3& direction) noexcept {
    const Vec3 from = point - entry;
    return (from - from.dot(direction) * direction).norm();
  }

  static bool runs_along(const anatomy::NeedlePath& path, const Vec3& entry, const Vec3& direction,
                         double within) noexcept {
    return distance(path.entry, entry, direction) <= within && distance(path.target, entry, direction) <= within;
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
  std::unique_ptr<Place> refreshed_;        // the newest that a needle was in
  std::unique_ptr<Place> coming_;           // a newer one
  bool follows_ = false;                    // the needle is being transferred to `coming_`
  Place* taken_ = nullptr;                  // by the needle
  std::shared_ptr<fem::ContactLine> line_;  // null: not streamed
  Place own_;                               // in its points
  bool as_recorded_ = false;
  std::optional<double> recorded_;            // of the next tick
  std::optional<anatomy::NeedlePath> asked_;  // the line whose points are asked for
  std::uint32_t ticks_outside_ = 0;
  bool begins_ = false;        // on its own line, in the next step
  bool has_own_line_ = false;  // the needle has, or had since reset()
  std::size_t points_ = 0;     // that the needle knows of
  bool complete_ = false;
  std::array<Hole, most_holes> holes_;  // of all lines
  std::size_t hole_count_ = 0;
  bool at_rest_ = false;
  bool touches_ = false;  // as of the last step
  bool announced_ = true;
};

}  // namespace bodkin::simulation
