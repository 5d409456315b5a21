#pragma once

#include <cstddef>
#include <string>

#include "station/station_options.h"

#include "fem/moving/body_thread.h"
#include "fem/moving/probe_press.h"
#include "haptics/stable_stiffness.h"
#include "haptics/workspace_map.h"

namespace bodkin::station {

// Where the hand is to work. Throws InputError where neither the options nor the case say so.
anatomy::NeedlePath path_of(const StationOptions& options);

// How the patient breathes; nothing: nobody does.
std::optional<anatomy::BreathField> breath_of(const anatomy::Case& patient);

// Throws InputError for a moving body without a probe or without the resistance that feels it.
void check_moving_body(const StationOptions& options);

// Of the options' moving body, which must be one.
fem::BodySolverSettings moving_settings(const StationOptions& options);

// Of the device that is held; with a recording, of the device that was held then.
anatomy::DeviceLimits limits_with(const DeviceChoice& choice, const haptics::DeviceAbilities& device,
                                  const anatomy::DeviceLimits& of_case);

// Where the probe is at first. Throws InputError where the choice does not go with the patient.
Pose first_probe(const UltrasoundChoice& choice, const anatomy::Case& patient);

// "the delay leaves 2.1 N/mm along each axis", or where the axes differ each with its own.
std::string what_is_left(const haptics::StableStiffness& stiffness);

// Why springs are softer than the device's published stiffness, one sentence.
std::string stiffness_sentence(const haptics::StableStiffness& stiffness);

// Along the needle what the device bears within 30 degrees of the path, across it what its weakest axis does.
// `workspace` takes the device's frame to the patient's.
anatomy::DeviceLimits with_stiffness(const haptics::StableStiffness& stiffness,
                                     const haptics::WorkspaceSettings& workspace, const anatomy::NeedlePath& path,
                                     anatomy::DeviceLimits limits);

}  // namespace bodkin::station
