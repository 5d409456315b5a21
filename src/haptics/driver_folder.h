#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bodkin::haptics {

// Where other people's drivers are looked for: the folder that the environment variable BODKIN_DRIVERS names, or
// bodkin/drivers in the library folder that belongs to this program. A path that is not absolute counts as none, so
// that nothing is looked for in the working folder.
std::filesystem::path driver_folder();

// The files NAME.so of that folder, in the order of their names; none where there is no such folder. They are not
// loaded.
std::vector<std::string> driver_files();

}  // namespace bodkin::haptics
