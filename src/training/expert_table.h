#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "training/expert_set.h"
#include "training/score.h"

namespace bodkin::training {

// Where a person's own experts at a procedure are kept: experts/PROCEDURE.csv in the data folder.
std::filesystem::path own_expert_file(const std::string& procedure);

// The experts that attempts at a procedure are compared with: a person's own where there are some, or else those that
// come with Bodkin, who were measured with the default thresholds. Experts who were measured with other thresholds
// than the procedure states are not compared with. Throws InputError for a table of one's own that cannot be read.
std::optional<ExpertSet> experts_of(const Procedure& procedure);

// An expert's attempt on its way into a table.
struct ExpertAttempt {
  std::string digest;  // of its session; no attempt is in a table twice
  Score score;
};

struct ExpertsAdded {
  std::size_t added = 0, known = 0;  // known: they were in the table before
  std::size_t attempts = 0;          // in the table now
};

// Adds attempts to the table in `file`, which is made where it is missing, and replaced as a whole; it says with
// which thresholds they were measured. Throws InputError for a table that another version of Bodkin wrote or that is
// none, for attempts with other thresholds than those in it, SystemError when it cannot be written.
ExpertsAdded add_experts(const std::filesystem::path& file, std::span<const ExpertAttempt> attempts);

}  // namespace bodkin::training
