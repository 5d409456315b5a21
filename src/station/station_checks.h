#pragma once

#include <cstddef>
#include <string>

#include "station/station_options.h"

#include "fem/moving/probe_press.h"
#include "haptics/stable_stiffness.h"

namespace bodkin::station {

// Where the hand is to work. Throws InputError where neither the options nor the case say so.
anatomy::NeedlePath path_of(const StationOptions& options);

// Throws InputError for a moving body without a probe or without the resistance that feels it.
void check_moving_body(const StationOptions& options);

// What a session keeps of its moving body, JSON.
std::string moving_body_record(const fem::ProbeFace& face, std::size_t nodes);

// Of the device that is held; with a recording, of the device that was held then.
anatomy::DeviceLimits limits_with(const DeviceChoice& choice, const haptics::DeviceAbilities& device,
                                  const anatomy::DeviceLimits& of_case);

// Where the probe is at first. Throws InputError where the choice does not go with the patient.
Pose first_probe(const UltrasoundChoice& choice, const anatomy::Case& patient);

// Why springs are softer than the device's published stiffness, one sentence.
std::string stiffness_sentence(const haptics::StableStiffness& stiffness);

}  // namespace bodkin::station
