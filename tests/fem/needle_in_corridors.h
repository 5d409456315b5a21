#pragma once

#include <memory>
#include <utility>

#include "anatomy/condensed_body.h"
#include "core/hand_over.h"
#include "fem/embedded_needle.h"

namespace bodkin::checks {

using namespace bodkin::anatomy;
using namespace bodkin::fem;

// A needle in the newest of several corridors of one body, as simulation/corridors.h moves it: at once while it is
// outside, and node by node, one a tick, while it is in.
class NeedleInCorridors {
 public:
  NeedleInCorridors(std::shared_ptr<const CondensedBody> first, const ContactTissues& tissues,
                    const EmbeddedNeedleSettings& settings)
      : tissues_(tissues), settings_(settings), held_(prepare(std::move(first))) {}

  // From any one thread: the newest corridor.
  void offer(std::shared_ptr<const CondensedBody> body) { waiting_.offer(prepare(std::move(body))); }

  EmbeddedNeedle& needle() noexcept { return held_->needle; }
  const CondensedBody& body() const noexcept { return *held_->body; }
  bool newer_waits() const noexcept { return next_ != nullptr || waiting_.waits(); }

  // A new insertion, in the newest corridor.
  void begin(const Vec3& entry, const Vec3& direction) noexcept {
    exchange();
    held_->needle.begin(entry, direction);
  }
  // Takes the newest corridor if the needle touches nothing; it then has to begin() again.
  bool take_newest() noexcept { return !held_->needle.touches() && exchange(); }
  // After every tick of a needle that is in. True in the tick in which it has moved to the newest corridor.
  bool go_on_in_newest() noexcept {
    if (!follows_) {
      if (!held_->needle.holds()) return false;
      std::unique_ptr<Corridor> taken = waiting_.take();
      if (taken == nullptr) return false;
      leave(std::exchange(next_, std::move(taken)));
      follows_ = next_->needle.begin_to_follow(held_->needle);
      return false;
    }
    const FollowState state = next_->needle.follow(held_->needle);
    follows_ = state == FollowState::under_way;
    if (state != FollowState::done) return false;
    leave(std::exchange(held_, std::move(next_)));
    return true;
  }

 private:
  struct Corridor {
    Corridor(std::shared_ptr<const CondensedBody> from, const ContactTissues& tissues,
             const EmbeddedNeedleSettings& settings)
        : body(std::move(from)), needle(*body, tissues, settings, 1e-3) {}

    std::shared_ptr<const CondensedBody> body;
    EmbeddedNeedle needle;  // refers to the body
  };

  std::unique_ptr<Corridor> prepare(std::shared_ptr<const CondensedBody> body) const {
    return std::make_unique<Corridor>(std::move(body), tissues_, settings_);
  }
  void leave(std::unique_ptr<Corridor> left) noexcept {
    if (left != nullptr) waiting_.give_back(std::move(left));
  }
  bool exchange() noexcept {
    follows_ = false;
    if (std::unique_ptr<Corridor> taken = waiting_.take()) leave(std::exchange(next_, std::move(taken)));
    if (next_ == nullptr) return false;
    next_->needle.take_punctures(held_->needle);
    leave(std::exchange(held_, std::move(next_)));
    return true;
  }

  ContactTissues tissues_;
  EmbeddedNeedleSettings settings_;
  std::unique_ptr<Corridor> held_, next_;
  bool follows_ = false;  // the needle is on its way into `next_`
  HandOver<Corridor> waiting_;
};

}  // namespace bodkin::checks
