#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/geometry.h"

namespace bodkin::session {

// The tool of a second hand while the first one holds the needle.
enum class SecondRole {
  plunger,  // of the syringe on the needle
  probe     // of an ultrasound machine
};

// "plunger"
constexpr std::string_view name_of(SecondRole role) noexcept {
  return role == SecondRole::plunger ? "plunger" : "probe";
}

// The role of that name; empty for an unknown name.
constexpr std::optional<SecondRole> second_role(std::string_view name) noexcept {
  for (const SecondRole role : {SecondRole::plunger, SecondRole::probe}) {
    if (name == name_of(role)) return role;
  }
  return std::nullopt;
}

// A second hand in a session, a hundred times a second.
struct SecondSample {
  double time = 0.0;  // s of the session: the newest tick of the needle, times dt
  // Of the tool, third axis out of its tip, mm. Plunger: operator's frame (haptics/device.h). Probe: patient, LPS.
  Vec3 position = Vec3::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  double force = 0.0;     // N of the model: on the thumb, upwards; or along the probe, out of the skin
  double pressure = 0.0;  // MPa gauge, in the syringe; plunger only
  double volume = 0.0;    // mm^3 expelled from the barrel; plunger only
};

// The second hand of a session.
struct SecondHeader {
  SecondRole role = SecondRole::plunger;
  std::string device;  // JSON: device, driver, identity, settings
};

}  // namespace bodkin::session
