#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fem/moving/conjugate_gradients.h"
#include "fem/moving/corotational_elements.h"
#include "fem/moving/node_matrix.h"
#include "fem/moving/rigid_needles.h"
#include "fem/solid/elastic_body.h"

namespace bodkin::fem {

struct CorotationalSettings {
  // s of a step, 1e-5 to 1; 0: static, every step is a Newton step towards equilibrium.
  double dt = 1.0 / 60.0;
  double density = 1000.0;  // kg/m^3, 1 to 30000; of all tissues [D: that of water]
  // Rayleigh damping, mass_damping M + stiffness_damping K: the fraction (mass_damping / w + stiffness_damping w) / 2
  // of critical damping for a mode that oscillates at w / 2 pi Hz. 1/s, 0 to 1000; s, 0 to 1 [D: a body of soft
  // tissue that oscillates at 10 Hz has a fifth of critical damping].
  double mass_damping = 2.0;
  double stiffness_damping = 0.005;
  GradientsSettings gradients;
  // Newton steps within a step, 1 to 50: the first is the semi-implicit one; the others, with the same matrix, are
  // made only while some node is out of balance by more than `balance`, N. The remainder is left to the next step.
  int most_corrections = 1;
  double balance = 1e-6;
};

// Result of a step.
struct CorotationalStep {
  bool fault = false;         // the step led to no finite positions: the body keeps its position, at rest
  int iterations = 0;         // of conjugate gradients
  int corrections = 0;        // Newton steps
  int halvings = 0;           // of Newton steps that did not lower the energy
  double unbalance = 0.0;     // N, on the free node with the largest
  double largest_move = 0.0;  // mm, of any node
};

// A dynamic body under large deformations: corotational linear tetrahedra (CorotationalElements),
//
//   M (x' - x - dt v) / dt^2 + (a M + b K) (x' - x) / dt = f(x') + loads,   v' = (x' - x) / dt
//
// implicit Euler with lumped masses, Rayleigh damping with the matrix at the beginning of the step, and without the
// first two terms when dt is 0. Each step assembles the rotated stiffness once and solves for x' by conjugate
// gradients; if the energy that this equation minimises does not fall, the step is halved. Implicit Euler dissipates
// energy, the more the longer the step.
//
// Nodes are free or prescribed; those of BodyDescription::fixed always are. Memory is allocated by the constructor;
// step() never throws, allocates, locks or reads a clock, and after the same calls gives the same result to the bit.
// Not thread-safe. docs/corotational.md
class CorotationalBody {
 public:
  // Checks body (check_body) and settings; throws InputError. `left`: needles left in the body, from entry to tip.
  CorotationalBody(const BodyDescription& body, const CorotationalSettings& settings,
                   std::span<const anatomy::NeedlePath> left = {});

  // Holds a node at a position, mm, from the next step on; and releases it. Fixed nodes stay, and positions that are
  // not finite are ignored.
  void hold(std::uint32_t node, const Vec3& place) noexcept;
  void release(std::uint32_t node) noexcept;
  bool held(std::uint32_t node) const noexcept { return held_[node] != 0; }  // or fixed
  bool fixed(std::uint32_t node) const noexcept { return held_[node] == 2; }

  // External forces, N, that act until they are cleared. They have no effect on held nodes; forces that are not
  // finite count as zero.
  void load(std::uint32_t node, const Vec3& force) noexcept;
  void clear_loads() noexcept { loads_.setZero(); }

  const CorotationalStep& step() noexcept;
  // Returns to rest, with nothing held or loaded.
  void reset() noexcept;
  // Moves all free nodes, at rest; columns in the order of the mesh. Returns false, and changes nothing, when they
  // are not finite or of another number.
  bool place(const Eigen::Matrix3Xd& places) noexcept;

  std::size_t nodes() const noexcept { return held_.size(); }
  Vec3 at_rest(std::uint32_t node) const noexcept { return rest_.col(node).head<3>(); }
  Vec3 position(std::uint32_t node) const noexcept { return places_.col(node).head<3>(); }
  Vec3 velocity(std::uint32_t node) const noexcept { return velocities_.col(node).head<3>(); }  // mm/s
  // The force that holds a held or fixed node, N on the body: at the last positions, without masses and damping.
  Vec3 holding_force(std::uint32_t node) const noexcept { return -(forces_ + loads_).col(node).head<3>(); }
  const NodeVectors& places() const noexcept { return places_; }

  double elastic_energy() const noexcept { return energy_; }  // N mm, including that of needles left in it
  double kinetic_energy() const noexcept;                     // N mm
  double mass(std::uint32_t node) const noexcept { return masses_[node]; }  // t, that is N s^2/mm

 private:
  double evaluate() noexcept;
  void begin_step() noexcept;
  bool correct(double& won) noexcept;
  double energy_won() const noexcept;
  void find_residual() noexcept;
  void go_back() noexcept;
  void add_diagonals(const NodeVectors& moved, double share, NodeVectors& sum) const noexcept;
  double damping_share() const noexcept;

  CorotationalSettings settings_;
  CorotationalElements elements_;
  RigidNeedles needles_;
  NodeMatrix matrix_;
  ConjugateGradients gradients_;
  std::vector<double> masses_;      // t
  std::vector<double> inertia_;     // by node, contribution of mass and its damping to the diagonal, N/mm
  std::vector<double> diagonal_;    // by node, inertia_ plus the contribution of needles, N/mm
  std::vector<std::uint8_t> held_;  // 0 free, 1 held, 2 fixed
  NodeVectors rest_, places_, velocities_, goals_;
  NodeVectors forces_, loads_;               // N, of the elements and from outside
  NodeVectors begin_, begin_forces_, push_;  // at the beginning of the step; m v / dt + loads, N
  NodeVectors moved_, product_;              // since the beginning of the step, mm, and the matrix times it, N
  NodeVectors before_, change_, residual_;   // a Newton step: moved_ before it, its change, its residual
  double energy_ = 0.0, begin_energy_ = 0.0;
  CorotationalStep reported_;
};

}  // namespace bodkin::fem
