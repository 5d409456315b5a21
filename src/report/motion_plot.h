#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "report/plot.h"
#include "study/profile.h"

namespace bodkin::report {

// Whether a diagnostic (forces/diagnostics.h) is a place on the needle's line, mm, to be compared with its depth: the
// wall of a tracking wall, the reference of a leash.
bool is_place_on_line(std::string_view diagnostic);

// The tissue at the tip over time, tick by tick, without names.
std::vector<PlotBand> bands_over_time(std::span<const anatomy::TissueId> tissues, double dt,
                                      const anatomy::TissueLibrary& library);

// A profile over time, as Alamilla 2018 draws it: the tip's depth below the skin with the wall where the model has
// one, and below it the force. Where the wall holds nothing it is not drawn.
std::vector<Plot> profile_against_time(const study::Profile& profile, const anatomy::TissueLibrary& library);

}  // namespace bodkin::report
