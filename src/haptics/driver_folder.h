#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bodkin::haptics {

// The folder of third-party drivers: the one named by the environment variable BODKIN_DRIVERS, or bodkin/drivers in
// this program's library folder. A path that is not absolute is ignored, so that the working folder is never
// searched.
std::filesystem::path driver_folder();

// The files NAME.so of that folder, in the order of their names; none if the folder does not exist. They are not
// loaded.
std::vector<std::string> driver_files();

}  // namespace bodkin::haptics
