#pragma once

#include <cstdint>

namespace bodkin {

// How one tissue resists, for every force model that asks the tissue. A tissue library (docs/case-format.md) fills
// these; a tissue that has nothing to say to a model resists with nothing there.

// How a tissue resists in the `layered` model (Heng 2004; docs/models/layered.md has the laws).
enum class LayeredKind : std::uint8_t {
  none,          // no force: air, cerebrospinal fluid, gas
  viscoelastic,  // skin, muscle, ligaments: pushes, breaks, then grips the shaft (eq. 2-5, 7)
  viscous,       // fat: drag in proportion to speed and length (eq. 6)
  rigid          // bone: a spring that never breaks (section 5.4)
};

struct LayeredTissue {
  LayeredKind kind = LayeredKind::none;
  // viscoelastic, before puncture (eq. 2, 3)
  double stiffness = 0.0;         // k, N/mm, of one element; > 0
  double viscosity = 0.0;         // rho, N s/mm, of one element; >= 0
  double element_spacing = 1.0;   // dx, mm; > 0
  double break_force = 0.0;       // H, N; > 0
  double break_force_rate = 0.0;  // L, N mm/s; >= 0; 0 = no effect of speed
  // viscoelastic, after puncture: per mm of shaft in contact (eq. 4, 5, 7)
  double shaft_stiffness = 0.0;   // k_s, N/mm^2; > 0
  double shaft_viscosity = 0.0;   // rho_s, N s/mm^2; >= 0
  double shaft_spacing = 0.5;     // dx_s, mm; > 0
  double static_friction = 0.0;   // S, N/mm; >= dynamic_friction
  double dynamic_friction = 0.0;  // D, N/mm; >= 0
  double roughness = 0.0;         // delta, [0, 1)
  // viscous (eq. 6)
  double drag = 0.0;  // rho_f, N s/mm^2; >= 0
  // rigid
  double contact_stiffness = 0.0;  // K_b, N/mm; > 0; the device's limit bounds it at load
};

// `tracking_wall` (Alamilla 2018): spring of the wall, and the force at which it begins to follow.
struct TrackingWallTissue {
  double stiffness = 0.5;  // K_t, N/mm; 0.01 to 100
  double force = 0.0;      // f_R, N; 0 to 50
};

// What `depth_profile` (Kwon 2001) does in a tissue.
enum class DepthProfileKind : std::uint8_t {
  nothing,  // air, gas, fluid: no force
  soft,     // cut: the trailing spring
  bone,     // never cut: a fixed spring
  organ     // must not be touched: no force and an event
};

struct DepthProfileTissue {
  DepthProfileKind kind = DepthProfileKind::nothing;
  double stiffness = 0.4;  // k at the skin, N/mm; 0 to 10
  double slope = 0.0;      // dk/dd, N/mm^2; -1 to 1; k is kept within 0 and 10 N/mm
};

// What a tissue, or a value of the field, does to the proxy of `volume_proxy` (Faerber).
struct ProxyProperties {
  double penetrability = 0.0;  // T_N, N, to go up the gradient; 0 to 50
  double friction = 0.0;       // T_T, N, to slide across it; 0 to 50
  double drag = 0.0;           // R_d, N, of the drag variant; 0 to 50
  double viscosity = 0.0;      // R_v, N s/mm, of the viscous variant; 0 to 10
};

// Friction per mm of shaft in contact with the tissue (Dahl, LuGre).
struct ShaftFrictionTissue {
  double coulomb = 0.0;       // Fc, N/mm; 0 to 10
  double static_force = 0.0;  // Fs, N/mm; Fc to 10; equal: Dahl, more: LuGre
  double stiffness = 0.05;    // sigma0, N/mm^2; > 0 to 100
  double viscous = 0.0;       // sigma2 or b, N s/mm^2; 0 to 1
};

// What the tissue does to a fluid that is pushed out of the needle's tip (`syringe`).
struct SyringeTissue {
  double resistance = 0.05;  // MPa s/mm^3; >= 0; large: nothing flows
  double pressure = 0.0;     // MPa gauge, in the tissue; -0.01 to 0.05
};

// What a tissue of a deformable body is made of (docs/fem.md), and what a needle meets in it (docs/fem-contact.md).
struct DeformableTissue {
  double young = 0.0;           // MPa; 1e-5 to 1e6; 0 = the library says nothing, the tissue cannot be in a mesh
  double poisson = 0.3;         // 0 to 0.49; nearer to 1/2 linear tetrahedra lock
  double friction = 0.0;        // mu_t, N/mm: Coulomb force per mm of shaft; 0 to 10
  double puncture_force = 0.0;  // F_p, N along the needle at which it gives way; 0 to 100, 0 = at once
  double stiffness = 0.0;       // k_target, N/mm, of `closest_node` alone; 0 to 100, 0 = as the mesh has it
};

}  // namespace bodkin
