#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "haptics/device_profile.h"

namespace bodkin::io {

// The devices described by a table, one number per row, with the columns
// device,quantity,value,unit,source,provenance,remark. An empty value means that no number is known. The rows of a
// device need not be contiguous; `also_called` gives another name of it instead of a number. Throws InputError naming
// file and line, what was found and what was expected.
std::vector<haptics::DeviceProfile> read_device_profiles(const std::filesystem::path& file);

// The same from text already in memory; `origin` names it in messages.
std::vector<haptics::DeviceProfile> parse_device_profiles(const std::string& text, const std::string& origin);

// The devices that come with Bodkin (share/bodkin/devices.csv).
std::vector<haptics::DeviceProfile> default_device_profiles();

}  // namespace bodkin::io
