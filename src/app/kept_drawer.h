#pragma once

#include "scene/volume_order.h"

namespace bodkin::app {

// What draws volumes in this person's windows, from one start to the next; at first automatic.
scene::VolumeDrawer kept_volume_drawer();
void keep_volume_drawer(scene::VolumeDrawer drawer);

}  // namespace bodkin::app
