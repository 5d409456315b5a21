#pragma once

#include <memory>

#include "app/hand/mouse_hand.h"

#include "core/latest_value.h"
#include "haptics/bodkin_driver.h"
#include "haptics/workspace_map.h"

namespace bodkin::app {

// Between the window and the loop of the device.
struct MouseFeed {
  explicit MouseFeed(const haptics::WorkspaceSettings& lies) : workspace(lies) {}

  haptics::WorkspaceSettings workspace;  // of the session: how the device's space lies in the patient
  LatestValue<HandWish> wishes;          // the window's
  LatestValue<HandReport> reports;       // the loop's
};

// A device that is opened from now on follows this feed, for as long as the feed lives; there is one mouse.
void connect_mouse(const std::shared_ptr<MouseFeed>& feed);

// The mouse of the window as a device: a MouseHand that feels the force of the session, so that on bone the needle
// stays and the hand goes on.
const bodkin_driver& mouse_driver() noexcept;

}  // namespace bodkin::app
