#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "fem/solid/contact_body.h"

namespace bodkin::station {

// Prepares more of a static deformable body while a hand moves: where the needle aims and no corridor covers its
// path, one is made on a background thread and returned when it is ready. One at a time; where the needle aims
// meanwhile is checked afterwards. A corridor of contact points, which is for one line and made in a fraction of a
// second, waits until the needle aims at the same place in two updates, and nothing is said of it, since elsewhere a
// needle has its own line (BodyPort::stream_points). All calls from one thread, none of which
// waits.
class CorridorKeeper {
 public:
  // A corridor for the tick (HapticTick::add_corridor), and a sentence for the person.
  struct News {
    std::optional<anatomy::PreparedCorridor> ready;
    std::optional<std::string> sentence;
  };

  // `patient`: with its first corridor, and a resistance that has a deformable body. `length`: mm, how deep needles
  // go. `room`: how many more corridors the tick can take. `kept`: of contact points, from prepare_body(), or null.
  CorridorKeeper(std::shared_ptr<const anatomy::Case> patient, std::shared_ptr<const fem::BodyDescription> body,
                 double length, std::size_t room, std::shared_ptr<const fem::ContactBody> kept = {});

  // Aborts a corridor that is being made.
  ~CorridorKeeper();
  CorridorKeeper(const CorridorKeeper&) = delete;
  CorridorKeeper& operator=(const CorridorKeeper&) = delete;

  // To be called several times a second with the newest tick and its needle.
  News update(const Pose& needle, std::uint64_t tick);
  bool is_preparing() const noexcept { return making_.valid(); }

 private:
  bool has_points() const { return corridors_.front().body->has_contact_points(); }
  std::optional<anatomy::NeedlePath> uncovered(const Pose& needle) const;

  std::shared_ptr<const anatomy::Case> patient_;
  std::shared_ptr<const fem::BodyDescription> body_;
  double length_;
  std::size_t room_;
  std::vector<anatomy::PreparedCorridor> corridors_;
  std::optional<anatomy::NeedlePath> refused_;  // the last path about which no corridor could be made
  anatomy::NeedlePath wanted_;                  // path of the corridor that is being made
  bool said_full_ = false;
  std::shared_ptr<const fem::ContactBody> kept_;  // of the thread that makes corridors, one at a time
  std::optional<anatomy::NeedlePath> aimed_;      // by the needle in the last update, where nothing is prepared
  std::atomic<bool> given_up_{false};
  std::future<anatomy::PreparedCorridor> making_;  // the last member: its thread uses the others
};

}  // namespace bodkin::station
