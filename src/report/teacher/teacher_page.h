#pragma once

#include <string>
#include <vector>

#include "training/plan_progress.h"
#include "training/store/cohort_table.h"
#include "training/store/result_store.h"

namespace bodkin::report {

// The teacher's pages, as self-contained HTML. All text of the store is escaped; links are relative to the site's
// root.

// A trainee's progress in a plan.
struct PlanPlace {
  std::string trainee;
  std::string plan;      // its title
  std::string progress;  // "stage 2 of 3, Without help: 2 of 3 passed in a row"
};

// `has_stations`: adds a link to the page of live stations.
std::string cohort_page(const std::vector<training::CohortRow>& rows, const std::vector<PlanPlace>& plans,
                        const std::string& place, bool has_stations = false);
// `attempts`: all of one trainee, in chronological order; at least one.
std::string trainee_page(const std::vector<training::AttemptRecord>& attempts);
// `has_report`: the session is on this computer.
std::string attempt_page(const training::AttemptRecord& attempt, bool has_report);
// One sentence.
std::string message_page(const std::string& title, const std::string& sentence);

// A text as a part of an address: everything but letters, digits, '-', '_' and '.' as %XX; and back. Empty for text
// that cannot be decoded.
std::string percent_encoded(std::string_view text);
std::optional<std::string> percent_decoded(std::string_view text);

}  // namespace bodkin::report
