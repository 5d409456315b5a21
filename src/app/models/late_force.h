#pragma once

namespace bodkin::app {

// Whether the user has said (`bodkin app --allow-late`) that motors may give the whole force although the system may
// hold up the servo. No, until allow_late_force() is called.
bool late_force_is_allowed() noexcept;
void allow_late_force() noexcept;

}  // namespace bodkin::app
