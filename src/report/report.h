#pragma once

#include <string>

#include "report/document.h"
#include "report/material_depth.h"
#include "session/session_file.h"

#include "anatomy/case.h"
#include "training/score.h"

namespace bodkin::report {

// The report of a session: verdict with its findings, steps, measures, plots, slices with the planned path and the
// one really taken, tissues, events, provenance. `case_changed`: the case on disk is not the one that was recorded,
// which the report then says. `depth`: of the plot of the force; throws InputError for one that the session lacks.
Document report_document(const session::Session& session, const anatomy::Case& patient, const training::Score& score,
                         bool case_changed, PlottedDepth depth = PlottedDepth::hand);

// The same as one HTML page, see html_of().
std::string report_html(const session::Session& session, const anatomy::Case& patient, const training::Score& score,
                        bool case_changed);

}  // namespace bodkin::report
