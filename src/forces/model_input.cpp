#include "forces/model_input.h"

#include <sstream>

#include "core/error.h"

namespace bodkin {

void check_setting(std::string_view model, std::string_view setting, std::string_view unit, double value, double low,
                   double high) {
  if (value >= low && value <= high) return;
  std::ostringstream text;
  text << model << ": " << setting << " is " << value << ' ' << unit << ", expected " << low << " to " << high << ' '
       << unit << "; change " << setting << " to a value in that range";
  throw InputError(text.str());
}

}  // namespace bodkin
