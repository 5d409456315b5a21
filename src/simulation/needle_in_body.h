#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "anatomy/case.h"
#include "fem/contact_line.h"
#include "forces/events.h"
#include "forces/resistance_model.h"
#include "simulation/body_port.h"
#include "simulation/deformable_resistance.h"

namespace bodkin::simulation {

// `embedded_needle` in the tick: a DeformableShaft with the contact points of the planned line, which are part of the
// patient, or, after stream_points() was called, with those of the needle's present line.
//
// With stream_points() it takes over the points of its line as they become known, those of its earlier holes
// punctured. They are requested while the needle is outside, up to 50 mm from the skin, and again when it turns to
// another line; a needle that touches the skin farther than 1.5 mm from that line requests those of the line on which
// it does. Within 1.5 mm of the planned line the known points of that line are used. A needle that turns in the
// tissue, so that it would pass farther than 1 mm from its line within the next 10 mm, keeps the points that it has
// reached and requests new ones ahead. An event reports when the needle begins off the planned line, or again on it.
// Punctured tissue stays open from line to line.
//
// In a body with motion of its own (move_with) the tissue carries the needle; an event reports this once per
// insertion. A pressing probe holds nodes of the surface; the points, even of the planned line, are then those of a
// body in which these nodes are held: those held when the line was requested. It is requested again when other nodes
// are held and the probe has come to rest; a needle in the body keeps its points, which are coupled to the other
// nodes (ContactLine::couple).
class NeedleInBody final : public BodyPort {
 public:
  using Settings = anatomy::EmbeddedNeedleSettings;
  static constexpr forces::ResistanceTraits traits = DeformableShaft::traits;

  // `patient` must outlive this object and have the points of its planned line. Throws InputError as DeformableShaft
  // does.
  NeedleInBody(const anatomy::Case& patient, const Settings& settings, double dt);

  std::shared_ptr<fem::ContactLine> stream_points(PointTiming timing) override;
  bool move_with(const std::shared_ptr<fem::BodyMotion>& motion) override;
  std::uint64_t applied_motion_step() const noexcept override { return applied_step_; }
  void approach(const Vec3& tip, const Vec3& axis) noexcept override;
  void breathe(const anatomy::BreathField& field, double drawn_in, const Vec3& of_tip) noexcept override {
    breath_ = {&field, drawn_in, of_tip};
  }
  void change_numbers(const fem::ContactNumbers& numbers) noexcept override;
  void set_recorded_points(double recorded) noexcept override { recorded_ = recorded; }
  void set_recorded_coupling() noexcept override { recorded_coupling_ = true; }
  fem::NodeForces node_forces() const noexcept override;
  Wrench on_held() const noexcept override;
  Vec3 coupling_offset() const noexcept override;
  Pose tissue_motion() const noexcept override;

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  forces::ResistanceForce step(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept;
  void reset() noexcept;

  double firm_stiffness() const noexcept { return 0.0; }
  double stiffness_scale() const noexcept { return planned_.stiffness_scale(); }
  forces::ModelDiagnostics diagnostics() const noexcept { return model().diagnostics(); }

 private:
  static constexpr std::size_t most_holes = 128;

  struct Hole {
    Vec3 place = Vec3::Zero();
    anatomy::TissueId tissue = anatomy::tissue::air;
  };

  // The line whose points were requested.
  struct RequestedLine {
    anatomy::NeedlePath path;
    std::uint64_t held = 0;        // BodyField::held_since of the nodes held at that time; 0: none
    bool is_planned = false;       // known from the start
    bool is_continuation = false;  // continues from a position inside the body
  };

  DeformableShaft& model() noexcept { return own_ != nullptr ? *own_ : planned_; }
  const DeformableShaft& model() const noexcept { return own_ != nullptr ? *own_ : planned_; }
  void begin_own_line(const Vec3& entry, const Vec3& direction) noexcept;
  fem::ContactLine::Progress known_points(const forces::NeedleInTissue& needle) noexcept;
  fem::ContactLine::Progress points_ahead_of(const forces::NeedleInTissue& needle) noexcept;
  void extend_line_after_turn(const forces::NeedleInTissue& needle) noexcept;
  void accept_known_points(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept;
  void apply_motion(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept;
  void couple(const fem::BodyField& motion, const forces::NeedleInTissue& needle,
              forces::TickEvents& events) noexcept;
  const fem::BodyField* newest_motion() noexcept;
  bool is_requested(const Vec3& entry, const Vec3& direction, double within,
                    const fem::BodyField* motion) const noexcept;
  void request_line(const Vec3& entry, const Vec3& direction, const fem::BodyField* motion) noexcept;
  void request_planned_line() noexcept;
  void set_numbers(const fem::ContactNumbers& numbers) noexcept;
  std::optional<Vec3> skin_ahead(const Vec3& tip, const Vec3& axis) const noexcept;
  bool is_hole(const Vec3& place) const noexcept;
  void remember_hole() noexcept;
  void open_holes() noexcept;

  const anatomy::Case* patient_;
  Settings settings_;
  double dt_;
  anatomy::NeedlePath path_;                 // the planned line
  DeformableShaft planned_;                  // with its points
  std::shared_ptr<fem::ContactLine> line_;   // null: not streamed
  std::unique_ptr<DeformableShaft> own_;     // with its points; null without line_
  bool beside_plan_ = false;                 // the needle has begun farther than 1.5 mm from the planned line
  std::shared_ptr<fem::BodyMotion> motion_;  // null: only the needle moves the body
  std::uint64_t applied_step_ = 0;           // step of the body
  fem::BodyBreath breath_;
  PointTiming timing_ = PointTiming::as_known;
  std::optional<double> recorded_;  // for the next tick
  std::optional<RequestedLine> requested_;
  std::uint32_t ticks_outside_ = 0;
  std::uint32_t ticks_on_line_ = 0;  // inside, since the line was requested
  bool begins_ = false;              // in the next step
  enum class Coupling : std::uint8_t { none, requested, applied };
  Coupling coupling_ = Coupling::none;  // to other nodes than those of requested_
  std::uint64_t coupled_held_ = 0;      // as RequestedLine::held, of these nodes
  std::size_t coupled_count_ = 0;
  bool recorded_coupling_ = false;  // for the next tick
  std::size_t points_ = 0;          // known to the needle
  bool complete_ = false;
  std::array<Hole, most_holes> holes_;  // of all lines
  std::size_t hole_count_ = 0;
  bool touches_ = false;  // as of the last step
  fem::ContactChange change_;
  bool announced_ = true;        // the event about the needle's present line was sent
  bool reported_motion_ = true;  // in this insertion
};

}  // namespace bodkin::simulation
