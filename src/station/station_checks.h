#pragma once

#include <cstddef>
#include <string>

#include "station/station_options.h"

#include "fem/moving/body_thread.h"
#include "fem/moving/probe_press.h"
#include "haptics/stable_stiffness.h"
#include "haptics/workspace_map.h"

namespace bodkin::station {

// The path of the procedure. Throws InputError if neither the options nor the case state one.
anatomy::NeedlePath path_of(const StationOptions& options);

// The patient's breathing; empty: none.
std::optional<anatomy::BreathField> breath_of(const anatomy::Case& patient);

// Throws InputError for a moving body without a probe or without the resistance that supports it.
void check_moving_body(const StationOptions& options);

// Of the options' moving body, which must be set.
fem::BodySolverSettings moving_settings(const StationOptions& options);

// Of the device in use; for a recording, of the recorded device.
anatomy::DeviceLimits limits_with(const DeviceChoice& choice, const haptics::DeviceAbilities& device,
                                  const anatomy::DeviceLimits& of_case);

// The initial pose of the probe. Throws InputError if the choice does not fit the patient.
Pose first_probe(const UltrasoundChoice& choice, const anatomy::Case& patient);

// "the delay leaves 2.1 N/mm along each axis", or the values of each axis if they differ.
std::string remaining_stiffness(const haptics::StableStiffness& stiffness);

// Why springs are softer than the device's published stiffness, one sentence.
std::string stiffness_sentence(const haptics::StableStiffness& stiffness);

// Along the needle the stiffness that the device renders within 30 degrees of the path, across it that of its weakest
// axis. `workspace` maps the device's frame to the patient's.
anatomy::DeviceLimits with_stiffness(const haptics::StableStiffness& stiffness,
                                     const haptics::WorkspaceSettings& workspace, const anatomy::NeedlePath& path,
                                     anatomy::DeviceLimits limits);

}  // namespace bodkin::station
