#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "anatomy/tissue.h"

namespace bodkin::forces {

// What can happen to a needle, as the force models notice it.
enum class EventKind : std::uint8_t {
  contact,             // the tip touched the body
  puncture,            // a tissue gave way; value = its own force at which it broke, N; felt = all that the hand felt
  loss_of_resistance,  // ligamentum flavum gave way into the epidural space; value = drop of resistance, N
  bone_contact,        // the tip met bone; value = 0
  bone_left,           // the tip came off the bone
  tissue_entered,      // the tip's tissue changed; value = 0
  withdrawn,           // the needle left the body
  force_limited,       // the governor had to intervene; value = force asked for, N
  fault,               // a value was not finite or a device failed; force ramps to zero
  points_passed,       // the needle is past the contact points of its line in a deformable body; value = 0
  line_taken,          // contact points of another line than before; value = -1 the planned path, -2 the needle's own
                       // line; of older versions the tick that a corridor of mesh nodes was aimed at
  moving_body_met,     // the needle begins or continues in a body that moves by itself; value = 1
  moving_body_failed,  // the solver of the body that a probe presses failed: the static one is used; value = 0
  fluid_returned,      // cerebrospinal fluid comes back through the needle; value = flow, mm^3/s
  pressure_lost,       // the syringe's plunger gives way; value = drop of pressure, MPa
  hub_contact,         // the needle is in to its whole length, the hub lies on the skin; value = 0
  needle_buckled,      // the needle bows outside the body and its tip stays; value = force that it bears, N
  points_taken,        // more contact points of the needle's own line are there; value = their number, once no more
                       // will come -1 less their number
  points_late,      // the needle is where a contact point is still being computed; value = mm past the point's place
  palpated,         // a fingertip has felt a place on the skin; tissue = bone where it lies under it, else skin;
                    // value = how firm it is, N/mm
  stylet_out,       // of the needle in the body; value = 0
  stylet_in,        // put back; value = 0
  manometer_on,     // the manometer is connected; value = 0
  manometer_off,    // taken off; value = height of the column in it, mm of fluid
  pressure_read,    // the column in the manometer has settled; value = its height, mm of fluid
  fluid_collected,  // each whole millilitre, and when the drip ends; value = collected in this insertion, mm^3
  hand_lost,        // of a tracked hand: it is not seen any more, and the needle rests where it was; value = 0
  hand_seen,        // it is seen again, and the needle is where it is; value = s for which it was not
  points_coupled    // the needle's points are those of a body of which a probe holds other nodes than before; value =
                    // how many it holds
};

struct Event {
  EventKind kind;
  anatomy::TissueId tissue;
  double depth;       // mm along the insertion line
  double value;       // see EventKind
  double felt = 0.0;  // N along the needle, of a puncture; 0: not known
};

// Events of one tick, in order. Holds at most `capacity`; more are counted, not kept. Most ticks have none, so only
// the events that there are get written and copied.
class TickEvents {
 public:
  static constexpr std::size_t capacity = 16;

  TickEvents() noexcept {}  // NOLINT(modernize-use-equals-default,*-member-init): no event is read before it is there
  TickEvents(const TickEvents& other) noexcept { *this = other; }
  TickEvents& operator=(const TickEvents& other) noexcept {
    size_ = other.size_;
    lost_ = other.lost_;
    for (std::size_t i = 0; i < size_; ++i) events_[i] = other.events_[i];
    return *this;
  }

  void push(const Event& event) noexcept {
    if (size_ < capacity) {
      events_[size_++] = event;
    } else {
      ++lost_;
    }
  }
  void clear() noexcept {
    size_ = 0;
    lost_ = 0;
  }
  const Event* begin() const noexcept { return events_.data(); }
  const Event* end() const noexcept { return events_.data() + size_; }
  std::span<Event> all() noexcept { return {events_.data(), size_}; }
  std::size_t size() const noexcept { return size_; }
  std::size_t lost() const noexcept { return lost_; }

 private:
  std::array<Event, capacity> events_;  // the first size_
  std::size_t size_ = 0;
  std::size_t lost_ = 0;
};

}  // namespace bodkin::forces
