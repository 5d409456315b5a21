#pragma once

#include <string>

#include "patient/whole_body/body_shape.h"

namespace CLI {
class App;
}

namespace bodkin::cli {

// --height, --weight and --sex of a whole synthetic body.
struct BodyChoice {
  patient::BodyParameters parameters;
  std::string sex = "male";
};

void add_body_parameters(CLI::App& command, BodyChoice& choice);
// Throws InputError for a sex that is neither, and for a weight that does not fit the height.
patient::BodyParameters body_of(const BodyChoice& choice);

}  // namespace bodkin::cli
