#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "anatomy/tissue.h"

namespace bodkin::forces {

// Events of a needle, as the force models detect them.
enum class EventKind : std::uint8_t {
  contact,   // the tip touched the body
  puncture,  // a tissue was punctured; value = its own force at that moment, N; felt = the whole force on the hand
  loss_of_resistance,  // punctured from ligamentum flavum into the epidural space; value = drop of resistance, N
  bone_contact,        // the tip met bone; value = 0
  bone_left,           // the tip came off the bone
  tissue_entered,      // the tip's tissue changed; value = 0
  withdrawn,           // the needle left the body
  force_limited,       // the governor intervened; value = requested force, N
  fault,               // a value was not finite or a device failed; force ramps to zero
  points_passed,       // the needle has passed the contact points of its line in a deformable body; value = 0
  line_taken,  // contact points of another line than before; value = -1 the planned path, -2 the needle's own line;
               // in older versions the tick at which a corridor of mesh nodes was requested
  moving_body_met,     // the needle begins or continues in a body that moves independently of it; value = 1
  moving_body_failed,  // the solver of the body that a probe presses failed: the static one is used; value = 0
  fluid_returned,      // cerebrospinal fluid comes back through the needle; value = flow, mm^3/s
  pressure_lost,       // the syringe's plunger yields; value = drop of pressure, MPa
  hub_contact,         // the needle is inserted to its full length, the hub lies on the skin; value = 0
  needle_buckled,      // the needle bows outside the body and its tip stops; value = force that it bears, N
  points_taken,   // more contact points of the needle's own line are known; value = their number, or -1 less their
                  // number when no more will follow
  points_late,    // the needle is where a contact point is still being computed; value = mm past that point
  palpated,       // a fingertip has palpated a place on the skin; tissue = bone if there is bone under it, else skin;
                  // value = its firmness, N/mm
  stylet_out,     // removed from the needle in the body; value = 0
  stylet_in,      // reinserted; value = 0
  manometer_on,   // the manometer is connected; value = 0
  manometer_off,  // removed; value = height of its column, mm of fluid
  pressure_read,  // the column of the manometer has settled; value = its height, mm of fluid
  fluid_collected,  // each whole millilitre, and when the drip ends; value = collected in this insertion, mm^3
  hand_lost,        // a tracked hand is no longer seen, and the needle rests at its last position; value = 0
  hand_seen,        // it is seen again, and the needle follows it; value = s for which it was not seen
  points_coupled    // the needle's points are coupled to a body in which a probe now holds other nodes; value = their
                    // number
};

struct Event {
  EventKind kind;
  anatomy::TissueId tissue;
  double depth;       // mm along the insertion line
  double value;       // see EventKind
  double felt = 0.0;  // N along the needle, of a puncture; 0: not known
};

// Events of one tick, in order. Holds at most `capacity`; further events are counted but not stored. Most ticks have
// none, so only the present events are written and copied.
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
