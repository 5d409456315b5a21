#pragma once

#include <string>

#include "training/score.h"

namespace bodkin::training {

// Version of the form below; share/bodkin/score.schema.json describes it.
inline constexpr int score_version = 1;

// A score as one JSON object of the published form, indented. Times in s, lengths in mm, forces in N; what an attempt
// does not have is null. `session`: the file that was scored.
std::string score_json(const Score& score, const Attempt& attempt, const std::string& session);

// One row of a table of attempts: the names of its columns, and the values of one score. Fields that a score does not
// have are empty.
std::string score_csv_header();
std::string score_csv_row(const Score& score, const std::string& attempt);

}  // namespace bodkin::training
