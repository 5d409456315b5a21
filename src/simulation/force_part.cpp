#include "simulation/force_part.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/repeatable.h"
#include "forces/bevel_tip.h"
#include "forces/csf_flow.h"
#include "forces/syringe.h"

namespace bodkin::simulation {

namespace {

constexpr double longest_path = 400.0;  // mm

// The tissue pulls the tip to where its bevel would have gone, had the hand let it (BevelTip):
//
//   F = k w, |F| <= limit      w from the tip across the line to the tip of the free path
class BevelTipPart final : public ForcePart {
 public:
  explicit BevelTipPart(const anatomy::BevelTipSettings& settings)
      : settings_(settings), path_(settings.curvature, longest_path) {
    bodkin::check(settings, "bevel_tip");
  }

  void begin(const Vec3& entry, const Vec3& direction) noexcept override {
    entry_ = entry;
    direction_ = direction;
    is_new_ = true;
    aside_ = force_ = 0.0;
  }

  void step(const forces::NeedleInTissue& needle, forces::ResistanceForce& force,
            forces::TickEvents&) noexcept override {
    if (is_new_) start(needle);
    const double roll = std::remainder(roll_of(needle.side) - roll_, 2.0 * std::numbers::pi);
    roll_ += roll;
    const Vec3 free_tip = path_.step(needle.motion.depth - depth_, roll).translation();
    depth_ = needle.motion.depth;
    const Vec3 from_entry = free_tip - entry_;
    aside_ = (from_entry - from_entry.dot(direction_) * direction_).norm();
    const Vec3 way = free_tip - needle.tip;
    Vec3 pull = settings_.stiffness * (way - way.dot(direction_) * direction_);
    const double size = pull.norm();
    if (!(size <= 1e6)) return;
    if (size > settings_.limit) pull *= settings_.limit / size;
    force_ = std::min(size, settings_.limit);
    force.across += pull;
  }

  void reset() noexcept override { begin(Vec3::Zero(), Vec3::UnitZ()); }
  std::size_t publish(std::span<double> values) const noexcept override {
    values[0] = aside_;
    values[1] = force_;
    return 2;
  }

 private:
  // The frame of the entry: third axis along the line, first the side of the shaft.
  void start(const forces::NeedleInTissue& needle) noexcept {
    is_new_ = false;
    Vec3 side = needle.side - needle.side.dot(direction_) * direction_;
    side = side.norm() > 1e-6 ? Vec3(side.normalized()) : direction_.unitOrthogonal();
    side_ = side;
    Pose pose = Pose::Identity();
    pose.translation() = entry_;
    pose.linear().col(0) = side;
    pose.linear().col(1) = direction_.cross(side);
    pose.linear().col(2) = direction_;
    path_.begin(pose);
    roll_ = depth_ = 0.0;
  }
  // rad about the line, from the side at the entry.
  double roll_of(const Vec3& side) const noexcept {
    return repeatable::atan2(side.dot(direction_.cross(side_)), side.dot(side_));
  }

  anatomy::BevelTipSettings settings_;
  forces::BevelTip path_;
  Vec3 entry_ = Vec3::Zero(), direction_ = Vec3::UnitZ(), side_ = Vec3::UnitX();
  bool is_new_ = true;
  double depth_ = 0.0, roll_ = 0.0;   // mm, rad
  double aside_ = 0.0, force_ = 0.0;  // mm, N, of the last tick
};

// Fluid comes back through the needle while its tip is in cerebrospinal fluid.
class CsfFlowPart final : public ForcePart {
 public:
  CsfFlowPart(const anatomy::CsfFlowSettings& settings, const anatomy::Needle& needle, double dt)
      : settings_(settings),
        flow_(with_needle(settings, needle), dt),
        stylet_(settings.stylet),
        manometer_(settings.manometer) {}

  void begin(const Vec3&, const Vec3&) noexcept override {
    flow_.reset();
    state_ = {};
    stylet_ = settings_.stylet;
    manometer_ = settings_.manometer;
    told_ = read_ = dripping_ = false;
    told_collected_ = 0.0;
  }
  void step(const forces::NeedleInTissue& needle, forces::ResistanceForce&,
            forces::TickEvents& events) noexcept override {
    const auto tell = [&](forces::EventKind kind, double value) {
      events.push({kind, needle.tissue, needle.motion.depth, value});
    };
    if (const bool stylet = settings_.stylet != needle.stylet_moved; stylet != stylet_) {
      stylet_ = stylet;
      tell(stylet ? forces::EventKind::stylet_in : forces::EventKind::stylet_out, 0.0);
    }
    if (const bool manometer = settings_.manometer != needle.manometer_moved; manometer != manometer_) {
      manometer_ = manometer;
      tell(manometer ? forces::EventKind::manometer_on : forces::EventKind::manometer_off, state_.height);
      if (!manometer) flow_.empty_manometer();
      read_ = false;
    }
    const double open = needle.tissue == anatomy::tissue::cerebrospinal_fluid ? 1.0 : 0.0;
    state_ = manometer_ ? flow_.step_manometer(open, stylet_) : flow_.step_drip(open, stylet_);
    const bool flows = open > 0.0 && !stylet_ && state_.flow > 0.0;
    if (flows && !told_) {
      told_ = true;
      tell(forces::EventKind::fluid_returned, state_.flow);
    }
    if (manometer_ && flows && !read_ && state_.height >= settled * flow_.pressure()) {
      read_ = true;
      tell(forces::EventKind::pressure_read, state_.height);
    }
    const bool dripped = dripping_;
    dripping_ = flows && !manometer_;
    const double wholes = std::floor(state_.collected / millilitre) * millilitre;
    if ((dripped && !dripping_) || wholes > told_collected_) {
      told_collected_ = wholes;
      tell(forces::EventKind::fluid_collected, state_.collected);
    }
  }
  void reset() noexcept override { begin(Vec3::Zero(), Vec3::UnitZ()); }
  std::size_t publish(std::span<double> values) const noexcept override {
    values[0] = state_.flow;
    values[1] = state_.height;
    values[2] = state_.collected;
    return 3;
  }

 private:
  static constexpr double settled = 0.98;       // of the pressure, from where a column is read
  static constexpr double millilitre = 1000.0;  // mm^3

  static anatomy::CsfFlowSettings with_needle(anatomy::CsfFlowSettings settings, const anatomy::Needle& needle) {
    settings.needle_bore = needle.inner_diameter;
    settings.needle_length = needle.length;
    return settings;
  }

  anatomy::CsfFlowSettings settings_;
  forces::CsfFlow flow_;
  forces::CsfState state_;
  bool stylet_, manometer_;  // as they are now
  bool told_ = false;        // that fluid returned
  bool read_ = false;        // since the manometer was connected
  bool dripping_ = false;
  double told_collected_ = 0.0;  // mm^3, whole millilitres
};

// A thumb that presses the plunger (Syringe), as far as the barrel goes. Its force is the hand's, or the case's where
// no hand says otherwise:
//
//   s' = max(0, F_thumb - F) / b          b = 2 N s/mm, of the thumb: its own damping, our choice
class SyringePart final : public ForcePart {
 public:
  SyringePart(const anatomy::SyringeSettings& settings, const anatomy::TissueLibrary& library,
              const anatomy::Needle& needle, double dt)
      : settings_(settings), dt_(dt), syringe_(library, with_needle(settings, needle), dt) {}

  void begin(const Vec3&, const Vec3&) noexcept override {
    syringe_.reset();
    travel_ = highest_ = 0.0;
    told_ = false;
  }
  void step(const forces::NeedleInTissue& needle, forces::ResistanceForce&,
            forces::TickEvents& events) noexcept override {
    const double thumb = needle.thumb_force.value_or(settings_.thumb_force);
    const double wanted = std::max(0.0, thumb - syringe_.state().force) / thumb_damping;
    const double speed = travel_ < barrel ? wanted : 0.0;
    const forces::SyringeState& state = syringe_.step(speed, needle.tissue);
    travel_ = std::min(barrel, travel_ + speed * dt_);
    highest_ = std::max(highest_, state.pressure);
    if (told_ || highest_ < least_pressure || state.pressure > 0.5 * highest_ || travel_ >= barrel) return;
    told_ = true;
    events.push({forces::EventKind::pressure_lost, needle.tissue, needle.motion.depth, highest_ - state.pressure});
  }
  void reset() noexcept override { begin(Vec3::Zero(), Vec3::UnitZ()); }
  std::size_t publish(std::span<double> values) const noexcept override {
    values[0] = syringe_.state().pressure;
    values[1] = travel_;
    return 2;
  }

 private:
  static constexpr double thumb_damping = 2.0;     // N s/mm
  static constexpr double barrel = 60.0;           // mm
  static constexpr double least_pressure = 0.005;  // MPa: less is no wall that could be lost

  static anatomy::SyringeSettings with_needle(anatomy::SyringeSettings settings, const anatomy::Needle& needle) {
    settings.needle_bore = needle.inner_diameter;
    settings.needle_length = needle.length;
    return settings;
  }

  anatomy::SyringeSettings settings_;
  double dt_;
  forces::Syringe syringe_;
  double travel_ = 0.0;   // mm
  double highest_ = 0.0;  // MPa
  bool told_ = false;
};

}  // namespace

std::vector<std::unique_ptr<ForcePart>> make_force_parts(const anatomy::Case& patient, double dt) {
  const anatomy::ForceParts& parts = patient.description.haptics.parts;
  const anatomy::Needle& needle = patient.description.needle;
  std::vector<std::unique_ptr<ForcePart>> made;
  if (parts.bevel_tip) made.push_back(std::make_unique<BevelTipPart>(*parts.bevel_tip));
  if (parts.csf_flow) made.push_back(std::make_unique<CsfFlowPart>(*parts.csf_flow, needle, dt));
  if (parts.syringe) made.push_back(std::make_unique<SyringePart>(*parts.syringe, patient.library, needle, dt));
  return made;
}

std::vector<forces::DiagnosticName> force_part_diagnostics(const anatomy::ForceParts& parts) {
  std::vector<forces::DiagnosticName> names;
  if (parts.bevel_tip)
    names.insert(names.end(), {{"bevel_aside_mm", "path of the bevel beside the line"},
                               {"bevel_N", "pull of the tissue on the bevel"}});
  if (parts.csf_flow)
    names.insert(names.end(), {{"csf_flow_mm3_s", "flow of cerebrospinal fluid"},
                               {"csf_height_mm", "fluid in the manometer"},
                               {"csf_collected_mm3", "fluid that has dripped"}});
  if (parts.syringe)
    names.insert(names.end(),
                 {{"syringe_pressure_MPa", "pressure in the syringe"}, {"plunger_mm", "travel of the plunger"}});
  return names;
}

}  // namespace bodkin::simulation
