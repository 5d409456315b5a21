#pragma once

#include <filesystem>
#include <span>

#include "link/client.h"

namespace bodkin::app {

// The folder of the patient that the station at `server` has, a copy of its case: of `folders`, which are searched
// for cases, the first one with the name and the tissues that the station tells. A station that waits tells the name
// alone. Takes 5 s at most. Throws InputError when nobody answers, or no case here is that patient.
std::filesystem::path patient_of_station(const link::ClientSettings& server,
                                         std::span<const std::filesystem::path> folders);

}  // namespace bodkin::app
