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
// with, or of the needle's own.
//
// A needle that begins farther than 1.5 mm from the planned line has its own line, once stream_points() was called:
// it takes the line's points as they become known there, those of its holes open. They are asked for while the needle
// is outside, up to 50 mm from the skin, and again where it turns to another line; a needle that touches the skin
// farther than 1.5 mm from that line asks for those of the line on which it does. An event says when the needle is on
// another line than before. What has given way stays open from line to line.
//
// Where the body moves by itself (move_with) the tissue takes the needle along; an event says so once in an
// insertion. A probe that presses holds nodes of the surface, and the points are then those of a body whose nodes
// these are, on the planned line too: of those that were held when the line was asked for, and it is asked for again
// when others are and the probe has come to rest, as long as the needle is outside.
class NeedleInBody final : public BodyPort {
 public:
  using Settings = anatomy::EmbeddedNeedleSettings;
  static constexpr forces::ResistanceTraits traits = DeformableShaft::traits;

  // `patient` must outlive this and have the points of its planned line. Throws InputError as DeformableShaft does.
  NeedleInBody(const anatomy::Case& patient, const Settings& settings, double dt);

  std::shared_ptr<fem::ContactLine> stream_points(bool as_recorded) override;
  bool move_with(const std::shared_ptr<fem::BodyMotion>& motion) override;
  std::uint64_t motion_taken() const noexcept override { return motion_taken_; }
  void approach(const Vec3& tip, const Vec3& axis) noexcept override;
  void breathe(const anatomy::BreathField& field, double drawn_in, const Vec3& of_tip) noexcept override {
    breath_ = {&field, drawn_in, of_tip};
  }
  void change_numbers(const fem::ContactNumbers& numbers) noexcept override;
  void take_points(double recorded) noexcept override { recorded_ = recorded; }
  fem::NodeForces node_forces() const noexcept override;
  Vec3 needle_ahead() const noexcept override;
  Vec3 tissue_motion() const noexcept override;

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

  DeformableShaft& model() noexcept { return on_own_line_ ? *own_ : planned_; }
  const DeformableShaft& model() const noexcept { return on_own_line_ ? *own_ : planned_; }
  void begin_own_line(const Vec3& entry, const Vec3& direction) noexcept;
  void take_known_points(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept;
  void take_motion(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept;
  const fem::BodyField* newest_motion() noexcept;
  bool is_asked(const Vec3& entry, const Vec3& direction, double within, const fem::BodyField* motion) const noexcept;
  void ask(const Vec3& entry, const Vec3& direction, const fem::BodyField* motion) noexcept;
  void set_numbers(const fem::ContactNumbers& numbers) noexcept;
  std::optional<Vec3> skin_ahead(const Vec3& tip, const Vec3& axis) const noexcept;
  bool is_hole(const Vec3& place) const noexcept;
  void remember_hole() noexcept;
  void open_holes() noexcept;

  const anatomy::Case* patient_;
  Settings settings_;
  double dt_;
  anatomy::NeedlePath path_;                // the planned line
  DeformableShaft planned_;                 // in its points
  std::shared_ptr<fem::ContactLine> line_;  // null: not streamed
  std::unique_ptr<DeformableShaft> own_;    // in its points
  bool on_own_line_ = false;
  std::shared_ptr<fem::BodyMotion> motion_;  // null: the body moves by the needle alone
  std::uint64_t motion_taken_ = 0;           // step of the body
  fem::BodyBreath breath_;
  bool as_recorded_ = false;
  std::optional<double> recorded_;            // of the next tick
  std::optional<anatomy::NeedlePath> asked_;  // the line whose points are asked for
  std::uint64_t asked_held_ = 0;              // BodyField::held_since of the nodes that were held then; 0: none
  std::uint32_t ticks_outside_ = 0;
  bool begins_ = false;     // on its own line, in the next step
  std::size_t points_ = 0;  // that the needle knows of
  bool complete_ = false;
  std::array<Hole, most_holes> holes_;  // of all lines
  std::size_t hole_count_ = 0;
  bool touches_ = false;  // as of the last step
  fem::ContactChange change_;
  bool announced_ = true;    // the line that the needle is on
  bool told_motion_ = true;  // of this insertion
};

}  // namespace bodkin::simulation
