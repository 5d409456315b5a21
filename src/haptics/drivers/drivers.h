#pragma once

#include <span>
#include <string_view>

#include "haptics/bodkin_driver.h"

namespace bodkin::haptics {

// The drivers that come with Bodkin, in the order in which a program looks for devices.
std::span<const bodkin_driver* const> built_in_drivers() noexcept;

// The built-in driver of that name; null when no driver has it.
const bodkin_driver* find_driver(std::string_view name) noexcept;

}  // namespace bodkin::haptics
