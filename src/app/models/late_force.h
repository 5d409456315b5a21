#pragma once

namespace bodkin::app {

// Whether the user permits the whole motor force (`bodkin app --allow-late`) although the system may delay the servo.
// False until allow_late_force() is called.
bool late_force_is_allowed() noexcept;
void allow_late_force() noexcept;

}  // namespace bodkin::app
