#include "forces/device_stability.h"

#include <sstream>

#include "core/error.h"
#include "core/sampled_stability.h"

namespace bodkin::forces {

namespace {

void require_rendered(const std::string& model, const std::string& what, double stiffness,
                      const anatomy::DeviceLimits& device, double rendered, const char* how, const char* setting) {
  if (stiffness <= rendered) return;
  std::ostringstream text;
  text << model << ": " << what << " is " << stiffness << " N/mm, but the device (" << device.profile
       << ") renders at most " << rendered << " N/mm stably" << how << "; lower it, or give the device its true "
       << setting;
  throw InputError(text.str());
}

}  // namespace

void require_stable(const std::string& model, const std::string& what, double stiffness,
                    const anatomy::DeviceLimits& device) {
  require_rendered(model, what, stiffness, device, device.stiffness, "", "stiffness_N_per_mm");
}

void require_stable_across(const std::string& model, const std::string& what, double stiffness,
                           const anatomy::DeviceLimits& device) {
  if (device.across() >= device.stiffness) return require_stable(model, what, stiffness, device);
  require_rendered(model, what, stiffness, device, device.across(), " on its weakest axis",
                   "lateral_stiffness_N_per_mm");
}

void require_stable_damping(const std::string& model, double stiffness, double damping,
                            const anatomy::DeviceLimits& device, double dt) {
  const double allowed = damping_allowed(stiffness, device.stiffness, dt);
  if (damping <= allowed * (1.0 + 1e-9)) return;
  std::ostringstream text;
  text << model << ": damping is " << damping << " N s/mm, but together with a spring of " << stiffness
       << " N/mm the device (" << device.profile << ") renders at most " << allowed
       << " N s/mm stably; lower damping or stiffness, or give the device its true stiffness_N_per_mm";
  throw InputError(text.str());
}

}  // namespace bodkin::forces
