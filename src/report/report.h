#pragma once

#include <string>

#include "report/document.h"
#include "report/material_depth.h"
#include "session/session_file.h"

#include "anatomy/case.h"
#include "training/score.h"

namespace bodkin::report {

// The report of a session: verdict with its findings, steps, measures, plots, slices with the planned and the actual
// path, tissues, events, provenance. `case_changed`: the case on disk differs from the recorded one, and the report
// says so. `depth`: of the plot of the force; throws InputError for one that the session lacks.
Document report_document(const session::Session& session, const anatomy::Case& patient, const training::Score& score,
                         bool case_changed, PlottedDepth depth = PlottedDepth::hand);

// As above, as one HTML page, see html_of().
std::string report_html(const session::Session& session, const anatomy::Case& patient, const training::Score& score,
                        bool case_changed);

}  // namespace bodkin::report
