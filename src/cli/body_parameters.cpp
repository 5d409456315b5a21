#include "cli/body_parameters.h"

#include <fmt/format.h>

#include "cli/arguments.h"
#include "core/error.h"

namespace bodkin::cli {

void add_body_parameters(CLI::App& command, BodyChoice& choice) {
  add_number(command, "--height", choice.parameters.height, 1.40, 2.05, "m, 1.40 to 2.05");
  add_number(command, "--weight", choice.parameters.weight, 40.0, 160.0, "kg, 40 to 160");
  add_text(command, "--sex", choice.sex, "male or female");
}

patient::BodyParameters body_of(const BodyChoice& choice) {
  if (choice.sex != "male" && choice.sex != "female")
    throw InputError(fmt::format("--sex is '{}'; expected male or female", choice.sex));
  patient::BodyParameters parameters = choice.parameters;
  parameters.sex = choice.sex == "female" ? patient::Sex::female : patient::Sex::male;
  patient::check_body(parameters);
  return parameters;
}

}  // namespace bodkin::cli
