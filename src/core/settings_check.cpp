#include "core/settings_check.h"

#include "core/error.h"

namespace bodkin {

void refuse_setting(std::string_view origin, std::string_view sentence) {
  throw InputError((origin.empty() ? "" : std::string(origin) + ": ") + std::string(sentence));
}

void check_tick(std::string_view origin, double dt) {
  check_range(origin, "tick", dt, {1e-6, 0.1}, "s");
}

}  // namespace bodkin
