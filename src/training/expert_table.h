#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "training/expert_set.h"
#include "training/score.h"

namespace bodkin::training {

// The file of a person's own experts at a procedure: experts/PROCEDURE.csv in the data folder.
std::filesystem::path own_expert_file(const std::string& procedure);

// The experts with whom attempts at a procedure are compared: a person's own if there are any, otherwise those that
// come with Bodkin, measured with the default thresholds. Experts measured with thresholds other than the procedure's
// are not used. Throws InputError when the person's own table cannot be read.
std::optional<ExpertSet> experts_of(const Procedure& procedure);

// An expert's attempt to be added to a table.
struct ExpertAttempt {
  std::string digest;  // of its session; no attempt is in a table twice
  Score score;
};

struct ExpertsAdded {
  std::size_t added = 0, known = 0;  // known: they were already in the table
  std::size_t attempts = 0;          // in the table now
};

// Adds attempts to the table in `file`, which is created if missing, and replaced atomically; it records the
// thresholds of the measurement. Throws InputError for an invalid table or one written by another version of Bodkin,
// and for attempts with other thresholds than those in it, SystemError when it cannot be written.
ExpertsAdded add_experts(const std::filesystem::path& file, std::span<const ExpertAttempt> attempts);

}  // namespace bodkin::training
