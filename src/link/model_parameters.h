#pragma once

#include <string>

#include "link/command.h"

#include "forces/model_settings.h"

namespace bodkin::link {

// The parameters of a force model by name, for clients: those of one part, which is "resistance", "constraint",
// "compensation" or the name of a tissue ("skin"), from their declarations (core/parameter.h).

// JSON: {"model", "part", "parts": names of all, "parameters": [{"name", "value", "unit", "low", "high", "choices",
// "description", "origin"}]}; an infinite bound is left out. Throws InputError for another part.
std::string parameters_json(const forces::ModelSettings& settings, const std::string& part);

// Sets one of them to the value in `text`. Throws InputError, without effect, when there is no such part or
// parameter, when the text is not a value of it, and when it is out of range or contradicts another one.
void set_parameter(forces::ModelSettings& settings, const std::string& part, const std::string& name,
                   const std::string& text);

// As above, for SetModelParameter with Part, Parameter and Value. Returns the reply for the client.
std::string set_parameter(forces::ModelSettings& settings, const Command& command);

}  // namespace bodkin::link
