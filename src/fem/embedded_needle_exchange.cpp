// EmbeddedNeedle: changes the compliance of the points when other nodes of the body are held.
#include <algorithm>
#include <utility>

#include "fem/embedded_needle.h"

namespace bodkin::fem {

namespace {

constexpr int most_prepared = 2;  // points in a tick

}  // namespace

void EmbeddedNeedle::exchange() noexcept {
  if (other_ == nullptr) return;
  other_->begin(frame_);
  exchanging_ = true;
  exchanged_ = false;
}

// Meanwhile the needle may advance or withdraw.
void EmbeddedNeedle::prepare_exchange() noexcept {
  while (other_->size() > captured_) other_->pop();
  for (int i = 0; i < most_prepared && other_->size() < captured_; ++i) {
    const ContactNode& node = line()[other_->size()];
    if (!other_->push(node.index, node.depth)) {
      exchanging_ = false;  // the equations would be singular
      return;
    }
  }
  if (other_->size() == captured_) take_exchanged();
}

void EmbeddedNeedle::take_exchanged() noexcept {
  exchanging_ = false;
  exchanged_ = true;
  const std::size_t known = constraints_.known();
  if (known > captured_) other_->add_before_tip(line()[captured_].index);
  for (std::size_t i = 0; i < known; ++i)
    if (constraints_.constrained_along(i)) other_->constrain_along(i);
  if (captured_ > 0 && contacts_[captured_ - 1].lateral_compliance >= 0.0)
    other_->constrain_last_across(contacts_[captured_ - 1].lateral_compliance);
  // The change of displacement under the same forces counts as the body's own motion.
  for (std::size_t i = 0; i < known; ++i)
    Eigen::Map<Vec3>(displacements_.data() + 3 * i) =
        Eigen::Map<const Vec3>(forces_.data() + 3 * i) + relaxing_.faded(i);
  const std::span<const double> elastic(displacements_);
  for (std::size_t i = 0; i < known; ++i) {
    const Vec3 now = constraints_.compliance().displacement(i, elastic);
    const Vec3 then = other_->compliance().displacement(i, elastic);
    carried_[line()[i].index] += frame_ * (now - then);
    moves_ = true;
  }
  std::swap(constraints_, *other_);
  relaxing_.exchange(constraints_.compliance());
  if (known == captured_ && constraints_.known() > captured_) place_tip_contact(displacement(captured_)(0));
}

}  // namespace bodkin::fem
