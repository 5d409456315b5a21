#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "report/plot.h"
#include "study/profile.h"

namespace bodkin::report {

// Whether a diagnostic (forces/diagnostics.h) is a position on the needle's line, mm, comparable with its depth: the
// wall of a tracking wall, the reference of a leash.
bool is_place_on_line(std::string_view diagnostic);

// The tissue at the tip over time, tick by tick, without names.
std::vector<PlotBand> bands_over_time(std::span<const anatomy::TissueId> tissues, double dt,
                                      const anatomy::TissueLibrary& library);

// A profile over time, in the style of Alamilla 2018: the tip's depth below the skin with the wall if the model has
// one, and below it the force. The wall is not drawn while it exerts no force.
std::vector<Plot> profile_against_time(const study::Profile& profile, const anatomy::TissueLibrary& library);

}  // namespace bodkin::report
