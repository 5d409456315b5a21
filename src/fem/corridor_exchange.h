#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "anatomy/condensed_body.h"
#include "core/hand_over.h"
#include "fem/embedded_needle.h"

namespace bodkin {

// Hands newer and newer corridors of one body from the thread that makes them to the haptic thread: the body pressed
// into another shape (fem/moving/moving_body.h), or more of it than before. Each comes with a needle in it that is
// ready to go, whatever the number of its nodes, so that the haptic end exchanges a pointer: wait-free, and without
// copying, allocating or freeing anything.
//
// A needle that touches nothing takes a new corridor at once. One that is in goes over to it node by node, one a
// tick, for the triangle of ContactFactor belongs to one compliance and all constraints have to be added anew: too
// much for one tick. Then it holds the same nodes with the same forces (EmbeddedNeedle::follow), so that no force
// jumps.
//
// What has been punctured stays so, by the nodes' names in the mesh (CondensedBody::mesh_nodes), as long as the new
// corridor has them.
class CorridorExchange {
 public:
  // The first corridor, and what EmbeddedNeedle wants. Throws InputError as EmbeddedNeedle does, and for a corridor
  // whose nodes have no names. `first` must not be null.
  CorridorExchange(std::shared_ptr<const CondensedBody> first, const ContactTissues& tissues,
                   const EmbeddedNeedleSettings& settings, double dt);

  // Maker only, which is any one thread but the haptic one: the newest corridor. One that still waits is dropped.
  // Throws as the constructor; then nothing changes. Returns the corridor's number(), counted from 1.
  std::uint32_t offer(std::shared_ptr<const CondensedBody> corridor);
  // Maker only: frees the corridor that the needle has left, if it has; offer() does so too.
  void free_left() noexcept { waiting_.free_left(); }

  // Haptic thread only. The needle, its corridor and that corridor's number, 0 for the first: what the nodes in
  // EmbeddedNeedle::node_forces() are nodes of. References stay valid until the next corridor is taken.
  EmbeddedNeedle& needle() noexcept { return held_->needle; }
  const EmbeddedNeedle& needle() const noexcept { return held_->needle; }
  const CondensedBody& body() const noexcept { return *held_->body; }
  std::uint32_t number() const noexcept { return held_->number; }
  bool newer_waits() const noexcept { return coming_ != nullptr || waiting_.waits(); }
  // Between two ticks: takes the newest corridor, if there is one and the needle touches nothing. True when it did;
  // the needle then has to begin() before it touches anything.
  bool take_newest() noexcept;
  // After every tick of a needle: when it touches something and there is a newer corridor that has all nodes that it
  // holds, it goes over to that, which takes as many ticks as it holds nodes. True in the tick in which it has: then
  // needle() is another object, with the forces that the last step() found.
  bool go_on_in_newest() noexcept;
  // A new insertion, as EmbeddedNeedle::begin(), in the newest corridor. It ends the one before, wherever the needle
  // is.
  void begin(const Vec3& entry, const Vec3& direction) noexcept;

 private:
  struct NeedleInCorridor {
    NeedleInCorridor(std::shared_ptr<const CondensedBody> corridor, const ContactTissues& tissues,
                     const EmbeddedNeedleSettings& settings, double dt, std::uint32_t number);

    std::shared_ptr<const CondensedBody> body;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> names;  // of the nodes in the mesh, ascending, and the nodes
    std::uint32_t number;
    EmbeddedNeedle needle;
  };

  bool exchange() noexcept;
  void leave(std::unique_ptr<NeedleInCorridor> left) noexcept;
  static void remember_punctures(const NeedleInCorridor& from, NeedleInCorridor& to) noexcept;

  ContactTissues tissues_;
  EmbeddedNeedleSettings settings_;
  double dt_;
  std::uint32_t offered_ = 0;
  std::unique_ptr<NeedleInCorridor> held_;    // of the haptic thread
  std::unique_ptr<NeedleInCorridor> coming_;  // likewise: newer, and not yet the needle's
  bool follows_ = false;                      // the needle in it is on the way
  HandOver<NeedleInCorridor> waiting_;
};

}  // namespace bodkin
