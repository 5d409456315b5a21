// Window texts about an attempt: the next action, refused commands, the station's notes.
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/practice.h"
#include <fmt/format.h>

namespace bodkin::app {

namespace {

constexpr double least_shown = 4.0, shown_for_letter = 0.06;  // s
constexpr std::size_t longest_log = 200;

}  // namespace

void Practice::show_message(const std::string& sentence) {
  message_ = sentence;
  message_time_ = std::max(least_shown, shown_for_letter * static_cast<double>(sentence.size()));
}

// The time begins with the first frame that shows it: a requested action, such as saving an image, may have taken
// longer.
void Practice::begin_saying() {
  if (message_time_ > 0.0) message_until_ = clock_ + std::exchange(message_time_, 0.0);
}

bool Practice::shows_message() const {
  return message_time_ > 0.0 || clock_ < message_until_;
}

void Practice::take_note(const std::string& sentence) {
  log_.push_back(sentence);
  if (log_.size() <= longest_log) return;
  log_.erase(log_.begin());
  noted_ -= std::min<std::size_t>(noted_, 1);
  reported_ -= std::min<std::size_t>(reported_, 1);
}

// All of them go to the researchers' dock. The person gets the relevant ones in turn, each when it can be read: none
// about a mouse, which is not a device, and none that begins with a time, which come from the guard.
void Practice::show_notes() {
  if (!is_attempt(state())) return;
  frame_.notes = std::span(log_).subspan(std::min(noted_, log_.size()));
  noted_ = log_.size();
  if (feed_ != nullptr) reported_ = log_.size();
  while (reported_ < log_.size() && !shows_message()) {
    const std::string& note = log_[reported_++];
    if (!note.empty() && (note.front() < '0' || note.front() > '9')) show_message(note);
  }
}

std::string Practice::hint() const {
  if (!connection_.empty()) return connection_;
  if (const std::optional<double> left = taken_out_.remaining(); left && is_attempt(state()))
    return fmt::format("The needle is out. The attempt ends in {:.0f} s, unless it goes in again.", std::ceil(*left));
  if (shows_message()) return message_;
  if (is_attempt(state()) && link_.news().needle.past_points) return frame_.message;
  if (feed_ != nullptr && control_.is_turning())
    return fmt::format("The needle is turned by {:.0f}° about its axis.", control_.goal().turn / degree);
  const bool is_above = state() == State::ready || state() == State::aiming;
  if (frame_.other_hand.finger && (is_above || state() == State::touching))
    return "Press with the finger. W, then H: the needle.";
  switch (state()) {
    case State::preparing:
      return "The patient is being prepared.";
    case State::ready:
      if (feed_ == nullptr) return "Bring the needle to the ring on the skin, and push.";
      if (stage_ && !stage_->aids.overlay) return "Point at the skin where you want to go in, and click.";
      return "Point at the ring on the skin and click, or just scroll.";
    case State::aiming:
      return control_.is_down() ? "The needle goes to the skin."
                                : "Click to put the needle on the skin. Drag the hub to tilt.";
    case State::touching:
      if (feed_ == nullptr) return "Pressing on skin. Push until it gives.";
      return "Pressing on skin. Scroll to push until it gives.";
    case State::in_tissue:
      if (has_syringe()) return "Hold B: press the plunger. E ends. F1 keys";
      if (has_fluid()) return "S: stylet out. R: manometer. E ends. F1 keys";
      if (feed_ == nullptr) return "Push or draw back. E ends. F1 keys";
      return "Scroll to push or draw back. Space holds. F1 keys";
    case State::reached:
      if (has_fluid() && frame_.other_hand.stylet_in)
        return fmt::format("Target reached at {:.1f} mm. S: stylet out.", frame_.depth);
      return fmt::format("Target reached at {:.1f} mm. E ends.", frame_.depth);
    case State::held:
      return "Held. Space takes the needle up again.";
    case State::faulted:
      return "The guard took the force away. V arms again.";
    case State::device_lost:
      return "The device does not answer.";
    default:
      return {};
  }
}

}  // namespace bodkin::app
