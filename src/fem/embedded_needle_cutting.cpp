// EmbeddedNeedle: tissue that the tip cuts on its way through a layer.
#include <algorithm>

#include "fem/embedded_needle.h"

namespace bodkin::fem {

namespace {

constexpr double same_place = 1e-9;       // mm
constexpr double longest_handover = 1.0;  // mm of the tip's way in which the next point takes over the cutting force

}  // namespace

// Whether cutting the layer at the tip takes a force. In the hole of an earlier insertion it does not.
bool EmbeddedNeedle::cuts() const noexcept {
  return captured_ > 0 && tissues_[line()[captured_ - 1].tissue].cutting_force > 0.0 &&
         contacts_[captured_ - 1].whole;
}

// The same if the tip is at its greatest depth in the tissue so far.
bool EmbeddedNeedle::is_at_cut() const noexcept {
  return cuts() && contacts_[captured_ - 1].slip >= cut_ - same_place;
}

// Whether the tip, at its depth in the moved tissue, has reached the next node. In tissue that opens without a force
// the depths at rest count.
bool EmbeddedNeedle::comes_to_next() const noexcept {
  if (tip_ < depth_now(captured_)) return false;
  const double depth = line()[captured_].depth;
  if (!cuts() || depth < cut_ || constraints_.known() <= captured_) return true;
  return tip_ - displacement(captured_)(0) >= depth;
}

// A node captured by a puncture, or in the same layer as the node before it, belongs to intact tissue.
bool EmbeddedNeedle::is_whole(std::size_t index) const noexcept {
  const ContactNode& node = line()[index];
  if (node.resists) return punctured_[node.index] != punctured_before;
  return index == 0 || line()[index - 1].tissue != node.tissue || contacts_[index - 1].whole;
}

// The cutting force is friction that opposes only inward motion, on the last node of the shaft; as the tip advances
// it passes to the next node of the layer. A node's remainder fades like the force of a puncture.
void EmbeddedNeedle::update_cutting() noexcept {
  const std::size_t last = captured_ - std::min<std::size_t>(captured_, 1);
  double of_last = 0.0, of_one_before = 0.0;
  if (is_at_cut()) {
    const ContactNode& node = line()[last];
    const double force = tissues_[node.tissue].cutting_force;
    const bool two = last > 0 && line()[last - 1].tissue == node.tissue && contacts_[last - 1].whole;
    const double part =
        (contacts_[last].slip - node.depth) / std::max(std::min(node.length, longest_handover), same_place);
    of_last = two ? force * std::clamp(part, 0.0, 1.0) : force;
    of_one_before = two ? force - of_last : 0.0;
  }
  for (std::size_t i = 0; i < captured_; ++i) {
    NodeContact& contact = contacts_[i];
    const double wanted = i == last ? of_last : i + 1 == last ? of_one_before : 0.0;
    if (wanted == 0.0 && contact.cutting > 0.0) {
      const double used = std::clamp(forces_[3 * i] - contact.limit, 0.0, contact.cutting);
      contact.puncture_residual += used;
      contact.fading = contact.puncture_residual;
      contact.limit += used;
    }
    contact.cutting = std::max(0.0, wanted - contact.puncture_residual);
  }
}

// N, resistance of the tissue at the tip to being cut.
double EmbeddedNeedle::cutting_force() const noexcept {
  double sum = 0.0;
  for (std::size_t i = captured_ - std::min<std::size_t>(captured_, 2); i < captured_; ++i)
    sum += std::clamp(forces_[3 * i] - contacts_[i].limit, 0.0, contacts_[i].cutting);
  return sum;
}

}  // namespace bodkin::fem
