#pragma once

#include <filesystem>
#include <span>

#include "link/client.h"

namespace bodkin::app {

// The folder of the patient of the station at `server`, a copy of its case: the first case in `folders` with the name
// and the tissues that the station reports. A waiting station reports only the name. At most 5 s. Throws InputError
// if there is no answer, or no case here is that patient.
std::filesystem::path patient_of_station(const link::ClientSettings& server,
                                         std::span<const std::filesystem::path> folders);

}  // namespace bodkin::app
