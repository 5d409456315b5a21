#pragma once

#include <optional>
#include <string>

#include "fem/moving/probe_press.h"

namespace CLI {
class App;
}

namespace bodkin::cli {

// Adds --body.
void add_body_option(CLI::App& command, std::string& body);

// The value of --body: the probe's face for a moving body, none for a static one. Throws InputError naming --body.
std::optional<fem::ProbeFace> parse_body(const std::string& body);

}  // namespace bodkin::cli
