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

// `embedded_needle` in the tick: a DeformableShaft in the contact points of the planned line, which the patient came
// with, or, once stream_points() was called, of whatever line the needle is on.
//
// Then it takes the points of its line as they become known, those of its holes open. They are asked for while the
// needle is outside, up to 50 mm from the skin, and again where it turns to another line; a needle that touches the
// skin farther than 1.5 mm from that line asks for those of the line on which it does. Within 1.5 mm of the planned
// line the points are those of that one, which are known. A needle that turns in the tissue, so that it would pass
// farther than 1 mm from its line within the next 10 mm, keeps the points that it has reached and asks for those
// ahead of it now. An event says when the needle begins beside the planned line, or again on it. What has given way
// stays open from line to line.
//
// Where the body moves by itself (move_with) the tissue takes the needle along; an event says so once in an
// insertion. A probe that presses holds nodes of the surface, and the points are then those of a body whose nodes
// these are, on the planned line too: of those that were held when the line was asked for. It is asked for again when
// others are and the probe has come to rest; where the needle is in the body it keeps its points, which are coupled
// with the other nodes (ContactLine::couple).
class NeedleInBody final : public BodyPort {
 public:
  using Settings = anatomy::EmbeddedNeedleSettings;
  static constexpr forces::ResistanceTraits traits = DeformableShaft::traits;

  // `patient` must outlive this and have the points of its planned line. Throws InputError as DeformableShaft does.
  NeedleInBody(const anatomy::Case& patient, const Settings& settings, double dt);

  std::shared_ptr<fem::ContactLine> stream_points(PointTiming timing) override;
  bool move_with(const std::shared_ptr<fem::BodyMotion>& motion) override;
  std::uint64_t motion_taken() const noexcept override { return motion_taken_; }
  void approach(const Vec3& tip, const Vec3& axis) noexcept override;
  void breathe(const anatomy::BreathField& field, double drawn_in, const Vec3& of_tip) noexcept override {
    breath_ = {&field, drawn_in, of_tip};
  }
  void change_numbers(const fem::ContactNumbers& numbers) noexcept override;
  void take_points(double recorded) noexcept override { recorded_ = recorded; }
  void take_coupling() noexcept override { recorded_coupling_ = true; }
  fem::NodeForces node_forces() const noexcept override;
  Wrench on_held() const noexcept override;
  Vec3 needle_ahead() const noexcept override;
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

  // The line whose points are asked for.
  struct Asked {
    anatomy::NeedlePath path;
    std::uint64_t held = 0;   // BodyField::held_since of the nodes that were held then; 0: none
    bool is_planned = false;  // known from the beginning
    bool leads_on = false;    // from a place inside the body
  };

  DeformableShaft& model() noexcept { return own_ != nullptr ? *own_ : planned_; }
  const DeformableShaft& model() const noexcept { return own_ != nullptr ? *own_ : planned_; }
  void begin_own_line(const Vec3& entry, const Vec3& direction) noexcept;
  fem::ContactLine::Progress known_points(const forces::NeedleInTissue& needle) noexcept;
  fem::ContactLine::Progress points_ahead_of(const forces::NeedleInTissue& needle) noexcept;
  void lead_on_where_it_turned(const forces::NeedleInTissue& needle) noexcept;
  void take_known_points(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept;
  void take_motion(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept;
  void couple(const fem::BodyField& motion, const forces::NeedleInTissue& needle,
              forces::TickEvents& events) noexcept;
  const fem::BodyField* newest_motion() noexcept;
  bool is_asked(const Vec3& entry, const Vec3& direction, double within, const fem::BodyField* motion) const noexcept;
  void ask(const Vec3& entry, const Vec3& direction, const fem::BodyField* motion) noexcept;
  void ask_planned() noexcept;
  void set_numbers(const fem::ContactNumbers& numbers) noexcept;
  std::optional<Vec3> skin_ahead(const Vec3& tip, const Vec3& axis) const noexcept;
  bool is_hole(const Vec3& place) const noexcept;
  void remember_hole() noexcept;
  void open_holes() noexcept;

  const anatomy::Case* patient_;
  Settings settings_;
  double dt_;
  anatomy::NeedlePath path_;                 // the planned line
  DeformableShaft planned_;                  // in its points
  std::shared_ptr<fem::ContactLine> line_;   // null: not streamed
  std::unique_ptr<DeformableShaft> own_;     // in its points; null with it
  bool beside_plan_ = false;                 // the needle has begun farther than 1.5 mm from the planned line
  std::shared_ptr<fem::BodyMotion> motion_;  // null: the body moves by the needle alone
  std::uint64_t motion_taken_ = 0;           // step of the body
  fem::BodyBreath breath_;
  PointTiming timing_ = PointTiming::as_known;
  std::optional<double> recorded_;  // of the next tick
  std::optional<Asked> asked_;
  std::uint32_t ticks_outside_ = 0;
  std::uint32_t ticks_on_line_ = 0;  // inside, since the line was asked for
  bool begins_ = false;              // in the next step
  enum class Coupling : std::uint8_t { none, asked, taken };
  Coupling coupling_ = Coupling::none;  // with other nodes than those of asked_
  std::uint64_t coupled_held_ = 0;      // as Asked::held, of these nodes
  std::size_t coupled_count_ = 0;
  bool recorded_coupling_ = false;  // in the next tick
  std::size_t points_ = 0;          // that the needle knows of
  bool complete_ = false;
  std::array<Hole, most_holes> holes_;  // of all lines
  std::size_t hole_count_ = 0;
  bool touches_ = false;  // as of the last step
  fem::ContactChange change_;
  bool announced_ = true;    // the line that the needle is on
  bool told_motion_ = true;  // of this insertion
};

}  // namespace bodkin::simulation
