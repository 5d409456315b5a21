#pragma once

#include "scene/volume_request.h"

namespace bodkin::app {

// This person's choice of a renderer for volumes, kept between starts; initially automatic.
scene::VolumeDrawer kept_volume_drawer();
void keep_volume_drawer(scene::VolumeDrawer drawer);

}  // namespace bodkin::app
