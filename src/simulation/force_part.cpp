#include "simulation/force_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "core/repeatable.h"
#include "forces/bevel_tip.h"
#include "forces/csf_flow.h"
#include "forces/syringe.h"

namespace bodkin::simulation {

namespace {

constexpr double longest_path = 400.0;  // mm

// The tissue pulls the tip towards the free path of its bevel (BevelTip):
//
//   F = k w, |F| <= limit      w from the tip across the line to the tip of the free path
class BevelTipPart final : public ForcePart {
 public:
  static constexpr std::array<forces::DiagnosticName, 2> diagnostics = {
      {{"bevel_aside_mm", "path of the bevel beside the line"}, {"bevel_N", "pull of the tissue on the bevel"}}};

  BevelTipPart(const anatomy::BevelTipSettings& settings, const anatomy::Case& /*patient*/, double /*dt*/)
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

  std::size_t publish(std::span<double> values) const noexcept override {
    values[0] = aside_;
    values[1] = force_;
    return diagnostics.size();
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

// Settings for flow through the needle of the case.
template <typename Settings>
Settings with_needle(Settings settings, const anatomy::Needle& needle) {
  settings.needle_bore = needle.inner_diameter;
  settings.needle_length = needle.length;
  return settings;
}

// Fluid returns through the needle while its tip is in cerebrospinal fluid.
class CsfFlowPart final : public ForcePart {
 public:
  static constexpr std::array<forces::DiagnosticName, 3> diagnostics = {
      {{"csf_flow_mm3_s", "flow of cerebrospinal fluid"},
       {"csf_height_mm", "fluid in the manometer"},
       {"csf_collected_mm3", "fluid that has dripped"}}};

  CsfFlowPart(const anatomy::CsfFlowSettings& settings, const anatomy::Case& patient, double dt)
      : settings_(settings),
        flow_(with_needle(settings, patient.description.needle), dt),
        stylet_(settings.stylet),
        manometer_(settings.manometer) {}

  void begin(const Vec3&, const Vec3&) noexcept override {
    flow_.reset();
    state_ = {};
    stylet_ = settings_.stylet;
    manometer_ = settings_.manometer;
    reported_ = read_ = dripping_ = false;
    reported_collected_ = 0.0;
  }
  void step(const forces::NeedleInTissue& needle, forces::ResistanceForce&,
            forces::TickEvents& events) noexcept override {
    const auto report = [&](forces::EventKind kind, double value) {
      events.push({kind, needle.tissue, needle.motion.depth, value});
    };
    if (const bool stylet = settings_.stylet != needle.stylet_moved; stylet != stylet_) {
      stylet_ = stylet;
      report(stylet ? forces::EventKind::stylet_in : forces::EventKind::stylet_out, 0.0);
    }
    if (const bool manometer = settings_.manometer != needle.manometer_moved; manometer != manometer_) {
      manometer_ = manometer;
      report(manometer ? forces::EventKind::manometer_on : forces::EventKind::manometer_off, state_.height);
      if (!manometer) flow_.empty_manometer();
      read_ = false;
    }
    const double open = needle.tissue == anatomy::tissue::cerebrospinal_fluid ? 1.0 : 0.0;
    state_ = manometer_ ? flow_.step_manometer(open, stylet_) : flow_.step_drip(open, stylet_);
    const bool flows = open > 0.0 && !stylet_ && state_.flow > 0.0;
    if (flows && !reported_) {
      reported_ = true;
      report(forces::EventKind::fluid_returned, state_.flow);
    }
    if (manometer_ && flows && !read_ && state_.height >= settled * flow_.pressure()) {
      read_ = true;
      report(forces::EventKind::pressure_read, state_.height);
    }
    const bool dripped = dripping_;
    dripping_ = flows && !manometer_;
    const double wholes = std::floor(state_.collected / millilitre) * millilitre;
    if ((dripped && !dripping_) || wholes > reported_collected_) {
      reported_collected_ = wholes;
      report(forces::EventKind::fluid_collected, state_.collected);
    }
  }
  std::size_t publish(std::span<double> values) const noexcept override {
    values[0] = state_.flow;
    values[1] = state_.height;
    values[2] = state_.collected;
    return diagnostics.size();
  }

 private:
  static constexpr double settled = 0.98;       // of the pressure, above which a column is read
  static constexpr double millilitre = 1000.0;  // mm^3

  anatomy::CsfFlowSettings settings_;
  forces::CsfFlow flow_;
  forces::CsfState state_;
  bool stylet_, manometer_;  // as they are now
  bool reported_ = false;    // that fluid returned
  bool read_ = false;        // since the manometer was connected
  bool dripping_ = false;
  double reported_collected_ = 0.0;  // mm^3, whole millilitres
};

// A thumb that presses the plunger (Syringe) to the end of the barrel. Its force is the hand's, or else the case's:
//
//   s' = max(0, F_thumb - F) / b          b = 2 N s/mm, of the thumb: its own damping, our choice
class SyringePart final : public ForcePart {
 public:
  static constexpr std::array<forces::DiagnosticName, 2> diagnostics = {
      {{"syringe_pressure_MPa", "pressure in the syringe"}, {"plunger_mm", "travel of the plunger"}}};

  SyringePart(const anatomy::SyringeSettings& settings, const anatomy::Case& patient, double dt)
      : settings_(settings),
        dt_(dt),
        syringe_(patient.library, with_needle(settings, patient.description.needle), dt) {}

  void begin(const Vec3&, const Vec3&) noexcept override {
    syringe_.reset();
    travel_ = highest_ = 0.0;
    reported_ = false;
  }
  void step(const forces::NeedleInTissue& needle, forces::ResistanceForce&,
            forces::TickEvents& events) noexcept override {
    const double thumb = needle.thumb_force.value_or(settings_.thumb_force);
    const double wanted = std::max(0.0, thumb - syringe_.state().force) / thumb_damping;
    const double speed = travel_ < barrel ? wanted : 0.0;
    const forces::SyringeState& state = syringe_.step(speed, needle.tissue);
    travel_ = std::min(barrel, travel_ + speed * dt_);
    highest_ = std::max(highest_, state.pressure);
    if (reported_ || highest_ < least_pressure || state.pressure > 0.5 * highest_ || travel_ >= barrel) return;
    reported_ = true;
    events.push({forces::EventKind::pressure_lost, needle.tissue, needle.motion.depth, highest_ - state.pressure});
  }
  std::size_t publish(std::span<double> values) const noexcept override {
    values[0] = syringe_.state().pressure;
    values[1] = travel_;
    return diagnostics.size();
  }

 private:
  static constexpr double thumb_damping = 2.0;     // N s/mm
  static constexpr double barrel = 60.0;           // mm
  static constexpr double least_pressure = 0.005;  // MPa: less is no loss of resistance

  anatomy::SyringeSettings settings_;
  double dt_;
  forces::Syringe syringe_;
  double travel_ = 0.0;   // mm
  double highest_ = 0.0;  // MPa
  bool reported_ = false;
};

// The list of these parts, in the order in which they publish: calls visit(std::type_identity<Part>, settings) for
// those that the case has.
void for_each_part(const anatomy::ForceParts& parts, const auto& visit) {
  if (parts.bevel_tip) visit(std::type_identity<BevelTipPart>(), *parts.bevel_tip);
  if (parts.csf_flow) visit(std::type_identity<CsfFlowPart>(), *parts.csf_flow);
  if (parts.syringe) visit(std::type_identity<SyringePart>(), *parts.syringe);
}

}  // namespace

std::vector<std::unique_ptr<ForcePart>> make_force_parts(const anatomy::Case& patient, double dt) {
  std::vector<std::unique_ptr<ForcePart>> made;
  for_each_part(patient.description.haptics.parts,
                [&]<typename Part>(std::type_identity<Part>, const auto& settings) {
                  made.push_back(std::make_unique<Part>(settings, patient, dt));
                });
  return made;
}

std::vector<forces::DiagnosticName> force_part_diagnostics(const anatomy::ForceParts& parts) {
  std::vector<forces::DiagnosticName> names;
  for_each_part(parts, [&names]<typename Part>(std::type_identity<Part>, const auto&) {
    names.insert(names.end(), Part::diagnostics.begin(), Part::diagnostics.end());
  });
  return names;
}

}  // namespace bodkin::simulation
