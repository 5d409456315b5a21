#pragma once

#include <memory>

#include "app/hand/mouse_hand.h"

#include "core/latest_value.h"
#include "haptics/bodkin_driver.h"
#include "haptics/workspace_map.h"

namespace bodkin::app {

// Data exchanged between the window and the loop of the device.
struct MouseFeed {
  explicit MouseFeed(const haptics::WorkspaceSettings& lies) : workspace(lies) {}

  haptics::WorkspaceSettings workspace;  // of the session: placement of the device's workspace in the patient
  LatestValue<HandGoal> goals;           // written by the window
  LatestValue<HandReport> reports;       // written by the loop
};

// Devices opened from now on follow this feed, for its lifetime; there is one mouse.
void connect_mouse(const std::shared_ptr<MouseFeed>& feed);

// The mouse of the window as a device: a MouseHand that feels the force of the session, so that on bone the needle
// stops while the hand moves on.
const bodkin_driver& mouse_driver() noexcept;

}  // namespace bodkin::app
