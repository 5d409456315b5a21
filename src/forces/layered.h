#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "anatomy/case.h"
#include "anatomy/tissue.h"
#include "core/axial_motion.h"
#include "forces/events.h"
#include "forces/resistance_model.h"
#include "forces/tissue_path.h"
#include "forces/voigt_law.h"

namespace bodkin::forces {

// Result of one tick of `layered`.
struct LayeredForce {
  double resistance = 0.0;                                    // N, positive pushes the hand out
  double stiffness = 0.0;                                     // N/mm, tangent of everything elastic that is active
  double shaft = 0.0;                                         // N of the resistance, by the friction of the shaft
  double material = std::numeric_limits<double>::infinity();  // mm, near face of the first block not yet punctured
  bool in_contact = false;  // false: the needle has left the body, the line may be released
  bool in_bone = false;     // the tip is inside bone
};

// Resistance of layered tissue along a frozen line (Heng, Wong, Leung, Chui, Sun 2004, eq. 1-16). Runs of equal
// tissue form blocks. A block resists in three ways, one after the other:
//
//   before puncture   R += push(p_t - d_l, v)       until it breaks: R >= H + L/(v + v0), tested while advancing
//   static            R += d grip(x, v)             x += the needle's advance, until |f| > S along the motion
//   dynamic           R += d slide D (1 + delta n)  until the needle stops or turns; then x = Einv(D)
//
//   p_t depth of the tip, mm; d_l depth of the block's near face; d contact length, mm; v velocity, mm/s; x
//   deformation; push, grip, Einv: forces/voigt_law.h; n roughness in [-1, 1], a function only of depth.
//
// Viscous tissue: R += rho_f v d. Rigid tissue never breaks: R += K_b (p_t - d_l), every viscous term is off, and
// fades in again over 20 ms once the tip is out. Readings and differences from the paper: docs/models/layered.md.
class Layered {
 public:
  // Throws InputError naming tissue and value when a parameter is outside its range. `one_face`: a tissue behind an
  // unpunctured face moves with that face and is not in contact yet. `device_stiffness`: N/mm > 0, the stiffness that
  // the device renders stably. `longest`: mm, the greatest depth that will be requested.
  Layered(const anatomy::TissueLibrary& library, const anatomy::LayeredSettings& settings, double device_stiffness,
          double dt, double longest, bool one_face = false);

  // A new line: nothing touched, nothing punctured.
  void begin() noexcept;
  // One tick. `layers`: tissues along the line in steps of settings.layer, known at least as far as the tip plus
  // look_ahead(). Events are appended. `grip`: factor on the friction of the shaft, 0.1 to 10
  // (forces/needle_grasp.h).
  LayeredForce step(const AxialMotion& motion, std::span<const anatomy::TissueId> layers, TickEvents& events,
                    double grip = 1.0) noexcept;

  // mm beyond the tip that must be known to distinguish a sliver from a tissue.
  double look_ahead() const noexcept { return sliver_layers_ * layer_; }
  // The smallest factor by which a tissue's stiffness had to be reduced for the device; 1 = none.
  double stiffness_scale() const noexcept { return stiffness_scale_; }

 private:
  enum class Mode : std::uint8_t { untouched, pressed, held, sliding };

  struct Law {
    anatomy::LayeredKind kind = anatomy::LayeredKind::none;
    bool rough = false;
    VoigtLaw push, grip;
    double break_force = 0.0, break_force_rate = 0.0;
    double static_friction = 0.0, dynamic_friction = 0.0, roughness = 0.0;
    double slip_strain = 0.0;        // Einv(D), mm
    double most_strain = 0.0;        // Einv(S), mm
    double breakaway_tangent = 0.0;  // dE/dx at Einv(S), N/mm^2
    double drag = 0.0;
    double contact_stiffness = 0.0;
  };

  struct Block {
    anatomy::TissueId tissue = anatomy::tissue::air;
    Mode mode = Mode::untouched;
    std::int8_t slide = 0;    // sense of sliding, -1 or +1
    int first = 0, last = 0;  // layers, as far as known
    double near = 0.0;        // mm, depth of the near face
    double strain = 0.0;      // x, mm; of a pressed face: its displacement when it was met, with the tissue before it
    double contact = 0.0;     // d, mm of shaft
    double furthest = 0.0;    // depth that sliding has reached, mm
  };

  struct Sums {
    double resistance = 0.0;
    double shaft = 0.0;               // N of the resistance, by friction
    double firm_stiffness = 0.0;      // of pressed faces and bone
    double held_stiffness = 0.0;      // of held shaft, now
    double friction_stiffness = 0.0;  // of all gripped shaft at break-away, before softening
    double first_pressed = std::numeric_limits<double>::infinity();  // near face
    bool gripped = false;
  };

  void reveal(int tip_layer, std::span<const anatomy::TissueId> layers) noexcept;
  void touch(Block& block) const noexcept;
  void press(Block& block, const Law& law, const AxialMotion& motion, Sums& sums, TickEvents& events) noexcept;
  void hold(Block& block, const Law& law, const AxialMotion& motion, double advance, Sums& sums) noexcept;
  void slide(Block& block, const Law& law, const AxialMotion& motion, Sums& sums) noexcept;
  bool breaks(const Law& law, double force, const AxialMotion& motion) const noexcept;
  double length(const Block& block) const noexcept { return (block.last - block.first + 1) * layer_; }
  double roughness(double depth) noexcept;
  void report_bone(double depth, bool in_bone, TickEvents& events) noexcept;

  double layer_, dt_, device_stiffness_;
  bool strict_, one_face_;
  int sliver_layers_;  // runs of at most this many layers may be noise
  double stiffness_scale_ = 1.0;
  std::array<Law, 256> laws_{};  // 256, by tissue id
  std::vector<Block> blocks_;    // taken at construction for the longest path

  std::size_t known_ = 0;    // blocks
  int revealed_ = -1;        // last layer that belongs to a block
  int last_punctured_ = -1;  // l_p, first layer of the deepest punctured block
  double bone_near_ = std::numeric_limits<double>::infinity();
  double last_depth_ = 0.0;
  double softening_ = 1.0;  // of held shaft, this tick
  double grip_ = 1.0;       // factor on the shaft's friction, this tick
  double viscous_ = 1.0;    // 0 in bone, fades back to 1
  bool bone_reported_ = false;
  std::int64_t rough_cell_ = std::numeric_limits<std::int64_t>::min();
  double rough_low_ = 0.0, rough_high_ = 0.0;
};

// `layered` in the tissues of a patient along the frozen line.
class LayeredResistance : public ResistanceDefaults {
 public:
  using Settings = anatomy::LayeredSettings;
  static constexpr ResistanceTraits traits = {
      .name = "layered",
      .has_shaft_friction = true,
      .uses_grip = true,
      .diagnostics = {{{"tip_N", "force at the tip"}, {"shaft_N", "friction of the shaft"}}},
  };

  LayeredResistance(const anatomy::Case& patient, const anatomy::LayeredSettings& settings, double dt);

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept;
  void reset() noexcept { model_.begin(); }

  double stiffness_scale() const noexcept { return model_.stiffness_scale(); }
  ModelDiagnostics diagnostics() const noexcept { return {found_.resistance - found_.shaft, found_.shaft}; }

 private:
  Layered model_;
  TissuePath path_;
  const anatomy::TissueVolume* volume_;
  LayeredForce found_;  // in the last tick
};

}  // namespace bodkin::forces
