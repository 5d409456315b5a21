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
#include "fem/solid/elastic_body.h"

namespace bodkin {

// Prepares more of a deformable body while a hand moves: where the needle aims and no corridor covers its way, one is
// made in the background, on another thread, and handed out when it is done. One at a time; what the needle aims at
// in the meantime is looked at afterwards. All calls from one thread, none of which waits.
class CorridorKeeper {
 public:
  // What there is to say, and what to give to the tick (HapticTick::add_corridor).
  struct News {
    std::optional<PreparedCorridor> ready;
    std::optional<std::string> sentence;
  };

  // `patient`: with its first corridor, and a resistance that has a deformable body. `room`: how many more corridors
  // can be used. `length`: mm, how deep needles go.
  CorridorKeeper(std::shared_ptr<const Case> patient, std::shared_ptr<const BodyDescription> body, double length,
                 std::size_t room);

  // A corridor that is being made is given up.
  ~CorridorKeeper();
  CorridorKeeper(const CorridorKeeper&) = delete;
  CorridorKeeper& operator=(const CorridorKeeper&) = delete;

  // To be called some times a second with the newest tick and its needle.
  News look(const Pose& needle, std::uint64_t tick);
  bool is_preparing() const noexcept { return making_.valid(); }

 private:
  std::optional<NeedlePath> uncovered(const Pose& needle) const;

  std::shared_ptr<const Case> patient_;
  std::shared_ptr<const BodyDescription> body_;
  double length_;
  std::size_t room_;
  std::vector<PreparedCorridor> corridors_;
  std::optional<NeedlePath> refused_;  // the last path about which there could be no corridor
  NeedlePath wanted_;                  // of the one that is being made
  bool said_full_ = false;
  std::atomic<bool> given_up_{false};
  std::future<PreparedCorridor> making_;  // the last member: its thread uses the others
};

}  // namespace bodkin
