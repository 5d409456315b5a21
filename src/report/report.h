#pragma once

#include <string>

#include "session/session_file.h"

#include "anatomy/case.h"
#include "training/score.h"

namespace bodkin::report {

// A session as one HTML page that stands alone: verdict with its findings, steps, measures, plots, slices with the
// planned path and the one really taken, tissues, events, provenance. Style and pictures lie inside; it refers to
// nothing outside. All text from files is escaped. `case_changed`: the case on disk is not the one that was recorded,
// which the page then says. Throws SystemError when gnuplot is missing.
std::string report_html(const session::Session& session, const anatomy::Case& patient, const training::Score& score,
                        bool case_changed);

}  // namespace bodkin::report
